#ifndef WALKGRAPH_FACTORS_MAGNETIC_H_
#define WALKGRAPH_FACTORS_MAGNETIC_H_

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "data/time.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The field of kMagneticSampleS of a walk on a floor that has a magnetic map.
struct MagneticLook {
  TimeNs time_ns = 0;  // the middle
  const MagneticMap* map = nullptr;
  Eigen::Vector2d field_ut = Eigen::Vector2d::Zero();  // as MagneticComponents
  double weight = 1;  // kMagneticSampleS over the correlation time, at most 1
};

// A walk's looks in order of time, without those of a phone that is being handled. None where the
// settings switch them off.
std::vector<MagneticLook> CollectMagneticLooks(const Site& site, const Evidence& evidence,
                                               const MagneticLookSettings& settings,
                                               const FloorPath& floors);

// The magnetic field is the map's at u = x + e, x position, e error of the magnetic map. With m, s
// the map's mean and spread, s_min its smallest, w the weight and z the field, c the component,
// rows 0 and 1 and row 2 are
//   sqrt(w) (z_c - m_c(u)) / s_c(u),
//   sqrt(w) sqrt(2 sum_c log(s_c(u) / s_min) + kRowOffset).
// The field repeats all over a floor: it tells places apart between which others leave the choice.
// Blocks: position, magnetic error.
class MagneticFactor : public ceres::SizedCostFunction<3, 2, 2> {
 public:
  static constexpr std::string_view kName = "magnetic";
  static constexpr int kComponents = 2;

  // `look.map` must outlive the factor.
  explicit MagneticFactor(const MagneticLook& look) : look_(look) {}

  bool Evaluate(const double* const* blocks, double* residual, double** jacobians) const override;

  double weight() const { return look_.weight; }
  // Nats that the rows cost beyond the likelihood they stand for.
  double CostConstant() const;
  // Of the weighted densities, with spread s_min: the last row holds the rest.
  double LogNormaliser() const;

 private:
  MagneticLook look_;
};

// -log p of looks at many places, up to a constant: what the factor's rows come to.
class MagneticGrid {
 public:
  MagneticGrid(const MagneticMap& map, const std::vector<Eigen::Vector2d>& places_m);
  // Nats at each place.
  std::vector<float> Evaluate(const MagneticLook& look) const;

 private:
  struct Place {
    Eigen::Array2f mean_ut, information;  // information: 1/sigma
    float spread_nats = 0;
  };
  std::vector<Place> places_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_MAGNETIC_H_
