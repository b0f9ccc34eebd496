#include "factors/area.h"

#include <algorithm>
#include <cstddef>
#include <list>
#include <mutex>
#include <vector>

namespace walkgraph {
namespace {

constexpr double kSpacingM = 0.5;  // a third of the narrowest door

AreaRaster RasterOf(const Site& site, int floor, const AreaSettings& settings) {
  switch (settings.kind) {
    case AreaKind::kWalkable: {
      const Floor* plan = site.building.FindFloor(floor);
      return plan == nullptr ? AreaRaster() : WalkableRaster(*plan, kSpacingM);
    }
    case AreaKind::kSurveyed: {
      std::vector<Eigen::Vector2d> path;
      for (const SurveyPoint& point : site.path) {
        if (point.floor == floor) path.push_back(point.position_m);
      }
      return PathRaster(path, settings.reach_m, kSpacingM);
    }
    case AreaKind::kNone:
      break;
  }
  return {};
}

// Fields of the rasters that were asked for last. Every walk of a floor asks for the same one,
// which takes longer to make than to compare. What comes out is the same as if each were made anew.
class RecentFields {
 public:
  AreaField Of(const AreaRaster& raster) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = std::find_if(recent_.begin(), recent_.end(),
                                    [&raster](const Entry& e) { return e.raster == raster; });
    if (known != recent_.end()) {
      recent_.splice(recent_.begin(), recent_, known);
    } else {
      recent_.push_front({raster, AreaField(raster)});
      if (recent_.size() > kMost) recent_.pop_back();
    }
    return recent_.front().field;
  }

 private:
  static constexpr std::size_t kMost = 12;  // some megabytes
  struct Entry {
    AreaRaster raster;
    AreaField field;
  };
  std::mutex mutex_;
  std::list<Entry> recent_;  // last asked for first
};

AreaField FieldOf(const AreaRaster& raster) {
  static RecentFields fields;
  return fields.Of(raster);
}

}  // namespace

std::optional<AreaField> AreaOfFloor(const Site& site, int floor, const AreaSettings& settings) {
  const AreaRaster raster = RasterOf(site, floor, settings);
  if (!HasInside(raster)) return std::nullopt;
  return FieldOf(raster);
}

std::optional<AreaField> AreaOfConnectors(const Building& building, int from_floor, int to_floor) {
  std::vector<Eigen::Vector2d> path;
  double reach_m = 0;
  for (const Connector& connector : building.connectors) {
    const auto serves = [&connector](int floor) {
      return std::any_of(connector.stops.begin(), connector.stops.end(),
                         [floor](const ConnectorStop& stop) { return stop.floor == floor; });
    };
    if (!serves(from_floor) || !serves(to_floor)) continue;
    reach_m = std::max(reach_m, connector.radius_m);
    for (std::size_t i = 0; i + 1 < connector.stops.size(); ++i) {
      const Eigen::Vector2d& from = connector.stops[i].position;
      const Eigen::Vector2d along = connector.stops[i + 1].position - from;
      const int pieces = static_cast<int>(along.norm() / kSpacingM) + 1;
      for (int k = 0; k <= pieces; ++k) path.push_back(from + along * k / pieces);
    }
  }
  if (path.empty()) return std::nullopt;
  return FieldOf(PathRaster(path, reach_m, kSpacingM));
}

const AreaField* WalkAreas::At(TimeNs time_ns) {
  if (settings_.kind == AreaKind::kNone) return nullptr;
  const int nearest = floors_.At(time_ns);
  const std::pair<int, int> floors =
      settings_.connectors ? floors_.Between(time_ns) : std::pair(nearest, nearest);
  auto found = areas_.find(floors);
  if (found == areas_.end()) {
    std::optional<AreaField> area =
        floors.first == floors.second
            ? AreaOfFloor(site_, floors.first, settings_)
            : AreaOfConnectors(site_.building, floors.first, floors.second);
    found = areas_.emplace(floors, std::move(area)).first;
  }
  return found->second ? &*found->second : nullptr;
}

}  // namespace walkgraph
