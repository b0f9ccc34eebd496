#ifndef WALKGRAPH_FACTORS_LOSS_H_
#define WALKGRAPH_FACTORS_LOSS_H_

#include <ceres/loss_function.h>

#include <cmath>
#include <memory>

#include "factors/settings.h"
#include "factors/truncated_loss.h"

namespace walkgraph {

// The Ceres loss of a configuration for a factor of one or two rows; nothing for LossKind::kNone.
inline std::unique_ptr<ceres::LossFunction> MakeLoss(const LossSettings& settings, int rows) {
  switch (settings.kind) {
    case LossKind::kHuber:
      return std::make_unique<ceres::HuberLoss>(settings.scale);
    case LossKind::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(settings.scale);
    case LossKind::kTruncated:
      return std::make_unique<TruncatedLoss>(ChiSquareThreshold(settings.scale, rows));
    case LossKind::kNone:
      break;
  }
  return nullptr;
}

// Whether a loss is for single rows of a residual: the truncated one is for whole factors.
inline bool IsForRows(const LossSettings& loss) {
  return loss.kind == LossKind::kHuber || loss.kind == LossKind::kCauchy;
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

// A whitened residual's share of the cost in single precision, for sums over many positions.
struct RobustCost {
  float nats = 0;    // half of rho
  float slope = 0;   // d nats / d z
  float weight = 1;  // slope / z: what the residual counts as in a quadratic about it
};

inline RobustCost CostUnderLoss(const LossSettings& loss, float z) {
  const float magnitude = std::abs(z), a = static_cast<float>(loss.scale);
  if (loss.kind == LossKind::kHuber && magnitude > a) {
    return {a * (magnitude - 0.5F * a), std::copysign(a, z), a / magnitude};
  }
  if (loss.kind == LossKind::kCauchy) {
    const float ratio = z / a, weight = 1.0F / (1.0F + ratio * ratio);
    return {0.5F * a * a * std::log1p(ratio * ratio), weight * z, weight};
  }
  return {0.5F * z * z, z, 1.0F};
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
