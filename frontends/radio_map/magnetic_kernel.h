#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_KERNEL_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_KERNEL_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace walkgraph {

// A magnetic sample of a survey walk, as MagneticComponents.
struct PlacedField {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d field_ut = Eigen::Vector2d::Zero();
  std::uint32_t walk = 0;
  std::uint32_t trial = 0;
};

// Normal densities of the two components.
struct FieldDensity {
  Eigen::Array2d mean_ut = Eigen::Array2d::Zero();
  Eigen::Array2d variance_ut2 = Eigen::Array2d::Zero();
  double known = 0;  // share of the samples in the weight, from 0 (the floor as a whole) to 1
};

struct KernelModel {
  double bandwidth_m = 1;
  double prior_weight = 0.1;  // of the floor as a whole, in samples

  // Beyond it a sample says nothing of a place.
  double reach_m() const { return 3.0 * bandwidth_m; }
};

// Mean and variance of the field at a place: those of the samples under a Gaussian kernel and of a
// pseudo-sample of the whole floor.
class KernelField {
 public:
  // Samples of one walk closer than half a metre become one: a person who stands still measures one
  // place once, however long. Precondition: there is a sample.
  explicit KernelField(const std::vector<PlacedField>& samples);

  const std::vector<PlacedField>& samples() const { return samples_; }  // merged

  // From all samples or from all but those of one trial.
  FieldDensity At(const Eigen::Vector2d& place, const KernelModel& model,
                  std::optional<std::uint32_t> left_out = std::nullopt) const;

 private:
  // Column and row of the square that a place lies in; off the table where no sample is near.
  Eigen::Array2i SquareOf(const Eigen::Vector2d& place) const;

  std::vector<PlacedField> samples_;
  // Indices of the samples by square, row by row from `origin_m_`.
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  Eigen::Array2i squares_ = Eigen::Array2i::Zero();  // columns and rows
  std::vector<std::vector<std::uint32_t>> in_square_;
  FieldDensity floor_;
};

// The ladder's model with the greatest log density of samples whose trial is left out.
KernelModel SelectKernelModel(const KernelField& field);

// Root mean square of left-out residuals over their predicted sigma, by component.
Eigen::Array2d LeftOutSigmaScale(const KernelField& field, const KernelModel& model);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAGNETIC_KERNEL_H_
