#ifndef WALKGRAPH_FACTORS_AREA_H_
#define WALKGRAPH_FACTORS_AREA_H_

#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "factors/area_field.h"
#include "factors/cost.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// People are where people walk: r = max(0, d(p)) / sigma with d the signed distance from the border
// of the area. It says nothing inside, so that it never makes a pose there look better known than
// it is, and pulls back, the harder the farther out, where plan or survey end. Block: position.
struct AreaFactor {
  static constexpr std::string_view kName = "area";
  static constexpr int kDimension = 1;
  using Blocks = BlockSizes<2>;

  AreaField field;
  double sigma_m = 1;

  template <typename T>
  bool operator()(const T* p, T* residual) const {
    const T distance_m = field.At(p[0], p[1]);
    residual[0] = distance_m > T(0) ? distance_m / sigma_m : T(0);
    return true;
  }

  // No density over positions: the same constant wherever the walk lies, left out.
  double LogNormaliser() const { return 0; }
};

// The area of a floor that the settings ask for; none where they ask for none, or where neither
// plan nor survey knows one.
std::optional<AreaField> AreaOfFloor(const Site& site, int floor, const AreaSettings& settings);

// Where people change between two floors: around the lines through the stops of the building's
// connectors that serve both. None where none is known to.
std::optional<AreaField> AreaOfConnectors(const Building& building, int from_floor, int to_floor);

// Where a walk is when: on a floor's area and, if the settings say so, between two floors near what
// connects them.
class WalkAreas {
 public:
  // Precondition: the three outlive the areas.
  WalkAreas(const Site& site, const AreaSettings& settings, const FloorPath& floors)
      : site_(site), settings_(settings), floors_(floors) {}

  // The area at a time, or nullptr where none is known. Each is made once.
  const AreaField* At(TimeNs time_ns);

 private:
  const Site& site_;
  const AreaSettings& settings_;
  const FloorPath& floors_;
  std::map<std::pair<int, int>, std::optional<AreaField>> areas_;  // by floors before and after
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_AREA_H_
