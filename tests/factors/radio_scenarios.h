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
  map.body_shadow_db = 2.5;
  map.silence_nats.assign(kCount * kCount, 0.0F);
  for (int i = 0; i < kCount * kCount; ++i) {
    map.survey_distance_m.push_back(static_cast<float>(std::abs(Normal(random, 5))));
  }
  for (std::uint32_t f = 0; f < kFields; ++f) {
    RadioMap::TransmitterField field{f, 0, 0, kCount, kCount, -95, 2.0, -4, {}, {}, {}};
    for (int i = 0; i < kCount * kCount; ++i) {
      field.mean_dbm.push_back(static_cast<float>(-70 + Normal(random, 8)));
      field.log_sigma.push_back(static_cast<float>(std::log(3.0) + std::abs(Normal(random, 0.5))));
      field.logit_hear.push_back(static_cast<float>(Normal(random, 2)));
      map.silence_nats[static_cast<std::size_t>(i)] +=
          std::log1p(std::exp(field.logit_hear.back()));
    }
    // Sixteenths of a metre, which single precision can move without rounding.
    const Eigen::Array2d source(10 + Normal(random, 10), 10 + Normal(random, 10));
    field.source_m = ((16 * source).round() / 16).matrix().cast<float>();
    map.fields.push_back(field);
  }
  return map;
}

// A square grid of control points turned by quarters about the origin and shifted.
inline FieldGrid MoveGrid(const FieldGrid& grid, const Motion& motion) {
  const double span = grid.spacing_m * (grid.columns - 1);
  FieldGrid moved = grid;
  for (int q = 0; q < motion.quarters; ++q) {
    // The old upper left corner becomes the new lower left one.
    moved.origin_m = Eigen::Vector2d(-(moved.origin_m.y() + span), moved.origin_m.x());
  }
  moved.origin_m += motion.shift_m;
  return moved;
}

// Its control values: point (r, c) goes to another one.
inline std::vector<float> MoveValues(std::vector<float> values, int n, const Motion& motion) {
  for (int q = 0; q < motion.quarters; ++q) {
    const std::vector<float> from = values;
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) values[c * n + (n - 1 - r)] = from[r * n + c];
    }
  }
  return values;
}

inline RadioMap MoveMap(const RadioMap& map, const Motion& motion) {
  const int n = map.grid.columns;
  RadioMap moved = map;
  moved.grid = MoveGrid(map.grid, motion);
  moved.silence_nats = MoveValues(map.silence_nats, n, motion);
  moved.survey_distance_m = MoveValues(map.survey_distance_m, n, motion);
  for (auto& field : moved.fields) {
    field.source_m = motion.Move(field.source_m.cast<double>()).cast<float>();
    field.mean_dbm = MoveValues(field.mean_dbm, n, motion);
    field.log_sigma = MoveValues(field.log_sigma, n, motion);
    field.logit_hear = MoveValues(field.logit_hear, n, motion);
  }
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
  double growth;

  template <typename T>
  bool operator()(T const* const* blocks, T* residual) const {
    using std::cos;
    using std::exp;
    using std::log;
    using std::sin;
    using std::sqrt;
    const Eigen::Vector2d stood(Plain(blocks[0][0]), Plain(blocks[0][1]));
    const ScalarValue away = map->SurveyDistance(EvaluateBasis(map->grid, stood));
    const T distance = Lift(away.value, away.gradient, stood, blocks[0][0], blocks[0][1]);
    const T ratio = sqrt(1.0 + growth * growth * distance * distance);
    const T x = blocks[0][0] + ratio * blocks[1][0], y = blocks[0][1] + ratio * blocks[1][1];
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
      const auto& source = map->fields[static_cast<std::size_t>(sweep.readings[i].field)].source_m;
      const T east = double{source.x()} - x, north = double{source.y()} - y;
      const T ahead = (cos(blocks[3][0]) * east + sin(blocks[3][0]) * north) /
                      sqrt(east * east + north * north + 100.0);
      residual[i] = sqrt(sweep.weight * double{sweep.readings[i].precision}) *
                    (double{sweep.readings[i].rssi_dbm} + blocks[2][0] -
                     Lift(field.mean_dbm, field.d_mean, at, x, y) - map->body_shadow_db * ahead) /
                    exp(log_sigma);
    }
    const ScalarValue silence = map->Silence(basis);
    const T cost = hearing ? Lift(silence.value, silence.gradient, at, x, y) + heard : spread;
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
    return {BlockKind::kPosition, BlockKind::kMapError, BlockKind::kRssiOffset, BlockKind::kHeading};
  }
  static constexpr double kGrowth = 0.3;  // 1/m
  explicit RadioScenario(Random* random) : map(std::make_shared<RadioMap>(MakeRandomMap(random))) {
    sweep.weight = 0.3;
    for (int f = 0; f < 4; ++f) {
      sweep.readings.push_back(
          {f, static_cast<float>(-70 + Normal(random, 10)), 0, f == 0 ? 0.3F : 1.0F});
    }
  }
  std::unique_ptr<ceres::CostFunction> Cost() const {
    if constexpr (kHearing) {
      return std::make_unique<HearingFactor>(map.get(), sweep, kGrowth);
    } else {
      return std::make_unique<FingerprintFactor>(map.get(), sweep, LossSettings{}, kGrowth);
    }
  }
  std::unique_ptr<ceres::CostFunction> Twin() const {
    auto twin = std::make_unique<ceres::DynamicAutoDiffCostFunction<RadioTwin>>(
        new RadioTwin{map.get(), sweep, kHearing, kGrowth});
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

// Written from the formulas of factors/magnetic.h, not from its code.
struct MagneticTwin {
  MagneticLook look;

  template <typename T>
  bool operator()(const T* p, const T* e, T* residual) const {
    using std::exp;
    using std::log;
    using std::sqrt;
    const T x = p[0] + e[0], y = p[1] + e[1];
    const Eigen::Vector2d at(Plain(x), Plain(y));
    const FieldBasis basis = EvaluateBasis(look.map->grid, at);
    T spread(0.0);
    for (int c = 0; c < 2; ++c) {
      const ScalarValue mean = look.map->Mean(c, basis), log_sigma = look.map->LogSigma(c, basis);
      const T sigma = exp(Lift(log_sigma.value, log_sigma.gradient, at, x, y));
      residual[c] = sqrt(look.weight) *
                    (look.field_ut[c] - Lift(mean.value, mean.gradient, at, x, y)) / sigma;
      spread += log(sigma / look.map->sigma_min_ut);
    }
    residual[2] = sqrt(look.weight) * sqrt(2.0 * spread + kRowOffset);
    return true;
  }
};

template <>
struct Scenario<MagneticFactor> {
  static constexpr bool kGaussian = false;
  static std::vector<BlockKind> kinds() {
    return {BlockKind::kPosition, BlockKind::kMagneticError};
  }
  explicit Scenario(Random* random) : map(std::make_shared<MagneticMap>()) {
    constexpr int kCount = 13;
    map->grid = {{-3, -3}, 3.0, kCount, kCount};
    map->sigma_min_ut = 1;
    for (MagneticMap::Component& component : map->components) {
      for (int i = 0; i < kCount * kCount; ++i) {
        component.mean_ut.push_back(static_cast<float>(Normal(random, 10)));
        component.log_sigma.push_back(static_cast<float>(std::abs(Normal(random, 0.5))));
      }
    }
    look = {0, map.get(), {Normal(random, 10), Normal(random, 10)}, 0.3};
  }
  std::unique_ptr<ceres::CostFunction> Cost() const {
    return std::make_unique<MagneticFactor>(look);
  }
  std::unique_ptr<ceres::CostFunction> Twin() const {
    return std::make_unique<ceres::AutoDiffCostFunction<MagneticTwin, 3, 2, 2>>(
        new MagneticTwin{look});
  }
  Scenario Moved(const Motion& motion) const {
    Scenario moved = *this;
    moved.map = std::make_shared<MagneticMap>(*map);
    moved.map->grid = MoveGrid(map->grid, motion);
    for (MagneticMap::Component& component : moved.map->components) {
      component.mean_ut = MoveValues(component.mean_ut, map->grid.columns, motion);
      component.log_sigma = MoveValues(component.log_sigma, map->grid.columns, motion);
    }
    moved.look.map = moved.map.get();
    return moved;
  }

  std::shared_ptr<MagneticMap> map;
  MagneticLook look;
};

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_FACTORS_RADIO_SCENARIOS_H_
