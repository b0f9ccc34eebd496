#ifndef WALKGRAPH_FACTORS_LOSS_H_
#define WALKGRAPH_FACTORS_LOSS_H_

#include <ceres/loss_function.h>

#include <cmath>
#include <memory>

#include "factors/settings.h"

namespace walkgraph {

// The Ceres loss of a configuration; nothing for LossKind::kNone.
inline std::unique_ptr<ceres::LossFunction> MakeLoss(const LossSettings& settings) {
  switch (settings.kind) {
    case LossKind::kHuber:
      return std::make_unique<ceres::HuberLoss>(settings.scale);
    case LossKind::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(settings.scale);
    case LossKind::kNone:
      break;
  }
  return nullptr;
}

// A row of a residual under a loss of its own, for factors of many rows of which each may be an
// outlier: value = sign(z) sqrt(rho(z^2)), so that half its square is the robust cost.
struct RobustRow {
  double value = 0;
  double slope = 1;  // d value / d z
};

inline RobustRow ApplyLoss(const LossSettings& loss, double z) {
  const double magnitude = std::abs(z);
  const double a = loss.scale;
  if (loss.kind == LossKind::kHuber && magnitude > a) {
    const double value = std::sqrt(2.0 * a * magnitude - a * a);
    return {std::copysign(value, z), a / value};
  }
  if (loss.kind == LossKind::kCauchy && magnitude > 1e-6 * a) {
    const double ratio = z / a;
    const double value = a * std::sqrt(std::log1p(ratio * ratio));
    return {std::copysign(value, z), magnitude / (1.0 + ratio * ratio) / value};
  }
  return {z, 1.0};
}

// The z of a row's value: the inverse of ApplyLoss.
inline double UndoLoss(const LossSettings& loss, double value) {
  const double squared = value * value, a = loss.scale;
  if (loss.kind == LossKind::kHuber && squared > a * a) {
    return std::copysign((squared + a * a) / (2.0 * a), value);
  }
  if (loss.kind == LossKind::kCauchy) {
    return std::copysign(a * std::sqrt(std::expm1(squared / (a * a))), value);
  }
  return value;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_LOSS_H_
