#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_MAP_UPDATE_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_MAP_UPDATE_H_

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "solvers/baselines/mufaf/cell_map.h"
#include "solvers/baselines/mufaf/kriging.h"

namespace walkgraph {

enum class MapInterpolation : std::uint8_t { kKriging, kCovariance };
inline constexpr std::array<std::string_view, 2> kMapInterpolationNames = {"kriging", "covariance"};

enum class StoreRule : std::uint8_t {
  kObserved,  // what was heard
  kKriged,    // as printed: what the map said already, which brings nothing new
};
inline constexpr std::array<std::string_view, 2> kStoreRuleNames = {"observed", "kriged"};

struct MapUpdateSettings {
  MapInterpolation interpolation = MapInterpolation::kKriging;
  StoreRule store = StoreRule::kObserved;
  double threshold_db = 1.5;
  int neighbours = 6;
  int lags = 8;
  int refit_every = 50;
  int memory = 0;
};

template <typename Visitor>
void Visit(Visitor& v, MapUpdateSettings& s) {
  v.Field("interpolation", s.interpolation, "of the map where a target was: kriging or covariance");
  v.Field("store", s.store, "what joins a cell's samples: observed or kriged (as printed)");
  v.Field(
      "threshold_db", s.threshold_db,
      "norm over anchors of map minus heard under which a sample is taken, dB (the paper's mu)");
  v.Field("neighbours", s.neighbours, "nearest cells that are interpolated (the paper: 4 to 8)");
  v.Field("lags", s.lags, "bins of the measured semivariogram (our choice)");
  v.Field("refit_every", s.refit_every,
          "samples after which the semivariograms are measured anew (our choice)");
  v.Field("memory", s.memory,
          "samples that a cell remembers: an older one goes for every one that is taken beyond; 0 "
          "keeps all (the paper)");
}

// For a whole site's scans (our choice). The paper's threshold is a norm over four anchors that are
// always heard; over the dozens of transmitters of a building, each scattering by some dB, no scan
// is under it.
constexpr MapUpdateSettings SiteMapUpdate() {
  MapUpdateSettings settings;
  settings.threshold_db = 1000;
  return settings;
}

// A cell map that learns from targets it has located (AFU, the adaptive fingerprint update).
class AdaptiveCellMap {
 public:
  AdaptiveCellMap(CellMap map, const MapUpdateSettings& settings);

  const CellMap& map() const { return map_; }
  // The signals that the map has at a place.
  Eigen::VectorXd SignalsAt(const Eigen::Vector2d& position_m) const;
  // Offers what was heard where a target was located: whether it fits the map well enough to be
  // taken (equation 34), which it then is, into the nearest cell.
  bool Offer(const Eigen::Vector2d& position_m, const Eigen::VectorXd& rssi_dbm);

 private:
  void FitVariograms();

  CellMap map_;
  MapUpdateSettings settings_;
  std::vector<SphericalVariogram> variograms_;  // by anchor
  int since_fit_ = 0;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_MAP_UPDATE_H_
