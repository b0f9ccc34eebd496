#ifndef WALKGRAPH_TESTS_FACTORS_RADIO_SCENARIOS_H_
#define WALKGRAPH_TESTS_FACTORS_RADIO_SCENARIOS_H_

#include <ceres/autodiff_cost_function.h>
#include <ceres/dynamic_autodiff_cost_function.h>

#include <memory>
#include <vector>

#include "factors/scenarios.h"

namespace walkgraph::testing {

// A map of random smooth fields on a grid from (0, 0) to (30, 30).
inline RadioMap MakeRandomMap(Random* random) {
  constexpr int kCount = 13, kFields = 6;
  RadioMap map;
  map.grid = {{-3, -3}, 3.0, kCount, kCount};
  map.sigma_min_db = 3;
  map.silence_nats.assign(kCount * kCount, 0.0F);
  for (std::uint32_t f = 0; f < kFields; ++f) {
    RadioMap::TransmitterField field{f, 0, 0, kCount, kCount, -95, 2.0, -4, {}, {}, {}};
    for (int i = 0; i < kCount * kCount; ++i) {
      field.mean_dbm.push_back(static_cast<float>(-70 + Normal(random, 8)));
      field.log_sigma.push_back(static_cast<float>(std::log(3.0) + std::abs(Normal(random, 0.5))));
      field.logit_hear.push_back(static_cast<float>(Normal(random, 2)));
      map.silence_nats[static_cast<std::size_t>(i)] +=
          std::log1p(std::exp(field.logit_hear.back()));
    }
    map.fields.push_back(field);
  }
  return map;
}

// The map turned by quarters about the origin and shifted: control point (r, c) of a square grid
// goes to another one.
inline RadioMap MoveMap(const RadioMap& map, const Motion& motion) {
  const int n = map.grid.columns;
  RadioMap moved = map;
  const auto turn = [n](const std::vector<float>& from) {
    std::vector<float> to(from.size());
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) to[c * n + (n - 1 - r)] = from[r * n + c];
    }
    return to;
  };
  const double span = map.grid.spacing_m * (n - 1);
  Eigen::Vector2d origin = map.grid.origin_m;
  for (int q = 0; q < motion.quarters; ++q) {
    // The old upper left corner becomes the new lower left one.
    origin = Eigen::Vector2d(-(origin.y() + span), origin.x());
    moved.silence_nats = turn(moved.silence_nats);
    for (auto& field : moved.fields) {
      field.mean_dbm = turn(field.mean_dbm);
      field.log_sigma = turn(field.log_sigma);
      field.logit_hear = turn(field.logit_hear);
    }
  }
  moved.grid.origin_m = origin + motion.shift_m;
  return moved;
}

// The field at a place that is a Jet: value and chain rule.
template <typename T>
T Lift(double value, const Eigen::Vector2d& gradient, const Eigen::Vector2d& at, const T& x,
       const T& y) {
  return value + gradient.x() * (x - at.x()) + gradient.y() * (y - at.y());
}
inline double Plain(double value) { return value; }
template <typename T, int N>
double Plain(const ceres::Jet<T, N>& value) {
  return value.a;
}

// Written from the formulas of factors/fingerprint.h, not from its code.
struct RadioTwin {
  const RadioMap* map;
  MapSweep sweep;
  bool hearing;

  template <typename T>
  bool operator()(T const* const* blocks, T* residual) const {
    using std::exp;
    using std::log;
    using std::sqrt;
    const T x = blocks[0][0] + blocks[1][0], y = blocks[0][1] + blocks[1][1];
    const Eigen::Vector2d at(Plain(x), Plain(y));
    const FieldBasis basis = EvaluateBasis(map->grid, at);
    T spread(0.0), heard(0.0);
    for (std::size_t i = 0; i < sweep.readings.size(); ++i) {
      const FieldValue field = map->Evaluate(sweep.readings[i].field, basis);
      const T log_sigma = Lift(field.log_sigma, field.d_log_sigma, at, x, y);
      const T p = 1.0 / (1.0 + exp(-Lift(field.logit_hear, field.d_logit_hear, at, x, y)));
      spread += log(exp(log_sigma) / map->sigma_min_db);
      heard += log(1.0 - p) - log(p);
      if (hearing) continue;
      residual[i] = sqrt(sweep.weight) *
                    (double{sweep.readings[i].rssi_dbm} + blocks[2][0] -
                     Lift(field.mean_dbm, field.d_mean, at, x, y)) /
                    exp(log_sigma);
    }
    Eigen::Vector2d slope;
    const double silence = map->Silence(basis, &slope);
    const T cost = hearing ? Lift(silence, slope, at, x, y) + heard : spread;
    residual[hearing ? 0 : sweep.readings.size()] =
        sqrt(sweep.weight) * sqrt(2.0 * cost + kRowOffset);
    return true;
  }
};

template <typename Factor>
struct RadioScenario {
  static constexpr bool kGaussian = false;
  static constexpr bool kHearing = std::is_same_v<Factor, HearingFactor>;
  static std::vector<BlockKind> kinds() {
    if (kHearing) return {BlockKind::kPosition, BlockKind::kMapError};
    return {BlockKind::kPosition, BlockKind::kMapError, BlockKind::kRssiOffset};
  }
  explicit RadioScenario(Random* random) : map(std::make_shared<RadioMap>(MakeRandomMap(random))) {
    sweep.weight = 0.3;
    for (int f = 0; f < 4; ++f) {
      sweep.readings.push_back({f, static_cast<float>(-70 + Normal(random, 10)), 0});
    }
  }
  std::unique_ptr<ceres::CostFunction> Cost() const {
    if constexpr (kHearing) {
      return std::make_unique<HearingFactor>(map.get(), sweep);
    } else {
      return std::make_unique<FingerprintFactor>(map.get(), sweep, LossSettings{});
    }
  }
  std::unique_ptr<ceres::CostFunction> Twin() const {
    auto twin = std::make_unique<ceres::DynamicAutoDiffCostFunction<RadioTwin>>(
        new RadioTwin{map.get(), sweep, kHearing});
    for (const BlockKind kind : kinds()) twin->AddParameterBlock(BlockSize(kind));
    twin->SetNumResiduals(kHearing ? 1 : static_cast<int>(sweep.readings.size()) + 1);
    return twin;
  }

  std::shared_ptr<RadioMap> map;
  MapSweep sweep;
};

template <>
struct Scenario<FingerprintFactor> : RadioScenario<FingerprintFactor> {
  using RadioScenario::RadioScenario;
  Scenario Moved(const Motion& motion) const {
    Scenario moved = *this;
    moved.map = std::make_shared<RadioMap>(MoveMap(*map, motion));
    return moved;
  }
};
template <>
struct Scenario<HearingFactor> : RadioScenario<HearingFactor> {
  using RadioScenario::RadioScenario;
  Scenario Moved(const Motion& motion) const {
    Scenario moved = *this;
    moved.map = std::make_shared<RadioMap>(MoveMap(*map, motion));
    return moved;
  }
};

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_FACTORS_RADIO_SCENARIOS_H_
