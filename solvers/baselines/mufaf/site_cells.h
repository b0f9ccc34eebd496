#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_CELLS_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_CELLS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "frontends/radio_map/site.h"
#include "solvers/baselines/fingerprints.h"
#include "solvers/baselines/mufaf/cell_map.h"

namespace walkgraph {

// The fingerprint cells of one radio on one floor of a site, from its survey scans.
class SiteCells {
 public:
  // Scans whose middle lies in one square of a lattice of `cell_m` are the samples of a cell, at
  // the mean of their places. Readings of `max_age_s` or older do not count; an anchor (a
  // transmitter of the radio that the floor knows) that a scan did not hear stands at
  // `missing_dbm`. Variances are drawn towards the pooled one by a weight of four samples.
  SiteCells(const Site& site, int floor, Radio radio, double cell_m, double max_age_s,
            double missing_dbm);

  const CellMap& map() const { return map_; }
  // Indices of the scans of the site that are each cell's samples.
  const std::vector<std::vector<std::size_t>>& scans() const { return scans_; }
  // The anchor that a transmitter of the site is, or -1.
  std::int32_t AnchorOf(std::uint32_t transmitter) const { return anchor_[transmitter]; }
  // A scan as signals of the anchors; none where it heard no anchor.
  std::optional<Eigen::VectorXd> SignalsOf(const SignalVector& scan) const;

 private:
  std::vector<std::int32_t> anchor_;  // of each transmitter of the site, or -1
  double missing_dbm_;
  CellMap map_;
  std::vector<std::vector<std::size_t>> scans_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_CELLS_H_
