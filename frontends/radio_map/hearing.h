#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_HEARING_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_HEARING_H_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// Probability of hearing a transmitter in one sweep: sweeps that heard it over all sweeps nearby,
// counted with a Gaussian kernel, drawn towards the transmitter's rate on the whole floor where few
// sweeps were made.
class HearingModel {
 public:
  // `sweeps_m` are the places of all sweeps of one radio on one floor; `prior_sweeps` the weight of
  // the floor-wide rate.
  HearingModel(const FieldGrid& grid, std::vector<Eigen::Vector2d> sweeps_m, double bandwidth_m,
               double prior_sweeps);

  // Fills logit_hear of a field whose rectangle is set, and its background value, from the indices
  // of the sweeps that heard it.
  void Fill(const std::vector<std::size_t>& heard, RadioMap::TransmitterField* field) const;

 private:
  struct Rectangle {  // of control points
    int column = 0, row = 0, columns = 0, rows = 0;
  };
  // The kernels of sweeps summed up at every control point of `area`, row-major.
  std::vector<double> Count(const std::vector<std::size_t>& sweeps, const Rectangle& area) const;
  double Kernel(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

  FieldGrid grid_;
  std::vector<Eigen::Vector2d> sweeps_m_;
  double bandwidth_m_;
  double prior_sweeps_;
  std::vector<double> sweep_count_;  // on the grid, row-major
  double median_count_ = 0;          // where sweeps were made
};

// Sum over fields of -log(1 - p_hear) at every control point of the grid.
std::vector<float> SilenceField(const FieldGrid& grid,
                                const std::vector<RadioMap::TransmitterField>& fields);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_HEARING_H_
