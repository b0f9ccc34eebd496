#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_EXTENDED_MAP_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_EXTENDED_MAP_H_

#include <cstdint>
#include <vector>

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "solvers/baselines/dsff/cells.h"

namespace walkgraph {

struct ExtendedMapSettings {
  int ap_count = 0;
  bool use_magnetic = true;
  double magnetic_radius_m = 1.5;
  double magnetic_prior_samples = 4;
};

template <typename Visitor>
void Visit(Visitor& v, ExtendedMapSettings& s) {
  v.Field("ap_count", s.ap_count,
          "Wi-Fi access points used, those whose signal varies most over the survey; 0 all (the "
          "paper: 50 of 196)");
  v.Field("use_magnetic", s.use_magnetic,
          "magnetic norm and inclination as evidence (the paper's)");
  v.Field("magnetic_radius_m", s.magnetic_radius_m,
          "survey samples this near a cell make its magnetic densities, m");
  v.Field("magnetic_prior_samples", s.magnetic_prior_samples,
          "weight of the pooled magnetic variance in that of a cell, in samples");
}

// The access points whose signal varies most over the survey's Wi-Fi scans, a missing one at
// `missing_dbm`: what does not change from place to place tells nothing. A flag per transmitter of
// the site; all of them for a count of 0.
std::vector<bool> SelectAccessPoints(const Site& site, int count, double missing_dbm);

// log p of a magnetic sample at every cell: normal densities of norm and inclination, trained on
// the survey's samples near the cell. A cell without any has the density of its floor.
class MagneticEmission {
 public:
  MagneticEmission(const Site& site, const DsffCells& cells, const ExtendedMapSettings& settings);

  // Whether the survey had a magnetometer.
  bool empty() const { return densities_.empty(); }
  // Adds to `log_likelihood`, one per cell. Precondition: not empty().
  void Add(const MagneticSample& sample, std::vector<double>* log_likelihood) const;

 private:
  struct Density {
    double norm_ut = 0, norm_variance = 1;
    double inclination_rad = 0, inclination_variance = 1;
  };
  std::vector<Density> densities_;
};

// What DSFF takes as absolute evidence at the epochs of a walk, its Wi-Fi scans.
struct AbsoluteEvidence {
  std::vector<TimeNs> time_ns;
  std::vector<std::vector<double>> log_likelihood;  // by epoch and cell
};

// The radio map's normal density of every reading at every cell (weighted as in the graph, with
// what was not heard), times the magnetic one. Where there are several floors, what a scan says of
// places on each is normalised and joined by what it says of the floors (see FloorSounds).
AbsoluteEvidence GatherAbsoluteEvidence(const Site& site, const Evidence& evidence,
                                        const DsffCells& cells, std::vector<TimeNs> epochs,
                                        const FactorSettings& factors,
                                        const ExtendedMapSettings& settings, double missing_dbm);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_EXTENDED_MAP_H_
