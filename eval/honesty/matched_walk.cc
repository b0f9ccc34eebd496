#include "eval/honesty/matched_walk.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "data/angle.h"
#include "eval/honesty/planned_inputs.h"
#include "eval/honesty/random_field.h"
#include "factors/absolute_heading.h"
#include "factors/fingerprint.h"
#include "factors/heading_increment.h"
#include "factors/position_hold.h"
#include "factors/step.h"
#include "graph/map_error_states.h"
#include "graph/node_times.h"
#include "graph/walk_graph.h"

namespace walkgraph {
namespace {

constexpr double kScanS = 3;

// A factor's residual and its Jacobian by one of its blocks.
struct BlockLinearization {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
};

BlockLinearization LinearizeBlock(const FactorGraph& graph, const GraphFactor& factor,
                                  std::size_t slot) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::vector<const double*> blocks;
  for (const int block : factor.blocks) blocks.push_back(graph.value(block));
  Eigen::VectorXd residual(factor.cost->num_residuals());
  RowMajor jacobian(residual.size(), graph.block(factor.blocks[slot]).size());
  std::vector<double*> jacobians(blocks.size(), nullptr);
  jacobians[slot] = jacobian.data();
  factor.cost->Evaluate(blocks.data(), residual.data(), jacobians.data());
  return {residual, jacobian};
}

class WalkSampler {
 public:
  WalkSampler(const Site& site, const FactorSettings& settings, Evidence inputs, Random random)
      : site_(site), evidence_(std::move(inputs)), random_(random) {
    AddPlaceholders();
    walk_ = BuildWalkGraph(site, evidence_, settings, site.maps.front().floor);
  }

  MatchedWalk Sample() && {
    DrawSlowStates();
    DrawHeadings();
    DrawPositions();
    DrawMapErrors();
    DrawAbsoluteHeadings();
    DrawScans();
    return {std::move(evidence_), NodeTruth(), walk_.graph.values(), silent_scans_};
  }

 private:
  FactorGraph& graph() { return walk_.graph; }

  // Measurements whose values are not drawn yet, so that the graph has all blocks and noise models.
  void AddPlaceholders() {
    evidence_.floor = site_.maps.front().floor;
    evidence_.transmitters = site_.transmitters;
    for (const TimeNs time_ns : GraphNodeTimes(evidence_)) {
      evidence_.absolute_heading_rad.push_back(time_ns, 0);
      evidence_.absolute_heading_sigma_rad.push_back(0);
    }
    const double duration_s = SecondsBetween(evidence_.begin_ns, evidence_.end_ns);
    for (int scan = 0; (scan + 0.5) * kScanS < duration_s; ++scan) {
      const TimeNs time_ns = evidence_.begin_ns + DurationNs((scan + 0.5) * kScanS);
      evidence_.readings.push_back({time_ns, time_ns, 0, -60});
    }
  }

  // Draws a block of a factor given the others: the point whose residual is a standard normal one.
  // All factors used here are affine in the block that they predict.
  void Draw(const GraphFactor& factor, std::size_t slot) {
    const BlockLinearization at = LinearizeBlock(graph(), factor, slot);
    Eigen::VectorXd noise(at.residual.size());
    for (double& value : noise) value = random_.Normal();
    const Eigen::VectorXd move = at.jacobian.colPivHouseholderQr().solve(noise - at.residual);
    Eigen::Map<Eigen::VectorXd>(graph().value(factor.blocks[slot]), move.size()) += move;
  }

  void DrawSlowStates() {
    for (const GraphFactor& factor : graph().factors()) {
      const bool slow = std::all_of(factor.blocks.begin(), factor.blocks.end(), [this](int block) {
        const BlockKind kind = graph().block(block).id.kind;
        return IsSlowState(kind) && kind != BlockKind::kMapError;
      });
      if (slow) Draw(factor, factor.blocks.size() - 1);
    }
  }

  void DrawHeadings() {
    *graph().value(walk_.heading.front()) =
        random_.Uniform(-std::numbers::pi, std::numbers::pi);  // the graph has no prior for it
    for (const GraphFactor& factor : graph().factors()) {
      if (factor.type != HeadingIncrementFactor::kName) continue;
      // Residuals wrap: from the heading before the draw finds the unwrapped one.
      *graph().value(factor.blocks[1]) = *graph().value(factor.blocks[0]);
      Draw(factor, 1);
    }
  }

  void DrawPositions() {
    for (const GraphFactor& factor : graph().factors()) {
      if (factor.type == kPositionPriorType) Draw(factor, 0);
      if (factor.type == StepFactor::kName) Draw(factor, 2);
      if (factor.type == PositionHoldFactor::kName) Draw(factor, 1);
    }
  }

  // A field over the floor, at the places of the knots.
  void DrawMapErrors() {
    for (const MapErrorKnots& knots : walk_.map_errors) {
      const double length_m = knots.kernel.correlation_m;
      const auto x = RandomField::Exponential(length_m, random_.Fork(0));
      const auto y = RandomField::Exponential(length_m, random_.Fork(1));
      const std::vector<KnotPlace> places = KnotPlaces(knots, walk_, walk_.node_ns.back());
      for (std::size_t k = 0; k < places.size(); ++k) {
        double* error_m = graph().value(knots.state.blocks[k]);
        error_m[0] = knots.kernel.sigma_m * x.At(places[k].position_m);
        error_m[1] = knots.kernel.sigma_m * y.At(places[k].position_m);
      }
    }
  }

  void DrawAbsoluteHeadings() {
    for (const GraphFactor& factor : graph().factors()) {
      if (factor.type != AbsoluteHeadingFactor::kName) continue;
      const double sigma_rad = 1.0 / LinearizeBlock(graph(), factor, 0).jacobian(0, 0);
      const auto node = static_cast<std::size_t>(graph().block(factor.blocks[0]).id.index);
      evidence_.absolute_heading_rad.value[node] =
          *graph().value(factor.blocks[0]) - *graph().value(factor.blocks[1]) -
          site_.HeadingToBuilding() - sigma_rad * random_.Normal();
    }
  }

  void DrawScans() {
    std::vector<RadioReading> readings;
    std::size_t scan = 0;
    for (const GraphFactor& factor : graph().factors()) {
      if (factor.type != FingerprintFactor::kName) continue;
      const std::size_t before = readings.size();
      DrawScan(factor, evidence_.readings[scan++].heard_ns, &readings);
      if (readings.size() == before) ++silent_scans_;
    }
    evidence_.readings = std::move(readings);
  }

  void DrawScan(const GraphFactor& factor, TimeNs time_ns, std::vector<RadioReading>* readings) {
    const RadioMap& map = site_.maps.front();
    const std::size_t blocks = factor.blocks.size();
    const Eigen::Vector2d position = PositionAt(time_ns);
    const Eigen::Map<const Eigen::Vector2d> map_error(graph().value(factor.blocks[blocks - 3]));
    const double offset_db = *graph().value(factor.blocks[blocks - 2]);
    const double heading_rad = *graph().value(factor.blocks[blocks - 1]);
    const Eigen::Vector2d ahead = DirectionOf(heading_rad);
    const Eigen::Vector2d place = position + map_error;
    const FieldBasis basis = EvaluateBasis(map.grid, place);
    for (std::size_t i = 0; i < map.fields.size(); ++i) {
      const FieldValue field = map.EvaluateValue(static_cast<int>(i), basis);
      if (random_.Uniform() >= 1.0 / (1.0 + std::exp(-field.logit_hear))) continue;
      const BodyShadow shadow = map.ShadowOn(static_cast<int>(i), place, ahead);
      const double mean_dbm = field.mean_dbm + shadow.value_db - offset_db;
      const double rssi_dbm = random_.Normal(mean_dbm, std::exp(field.log_sigma));
      readings->push_back(
          {time_ns, time_ns, map.fields[i].transmitter, static_cast<float>(rssi_dbm)});
    }
  }

  Eigen::Vector2d PositionAt(TimeNs time_ns) {
    const NodeBracket bracket = FindBracket(walk_.node_ns, time_ns);
    const auto before = static_cast<std::size_t>(bracket.before);
    Eigen::Vector2d from = NodePosition(before);
    if (bracket.fraction <= 0) return from;
    return from + bracket.fraction * (NodePosition(before + 1) - from);
  }

  Eigen::Vector2d NodePosition(std::size_t node) {
    return Eigen::Map<const Eigen::Vector2d>(graph().value(walk_.position[node]));
  }

  Truth NodeTruth() {
    Truth truth;
    truth.frame = TruthFrame::kBuilding;
    for (std::size_t i = 0; i < walk_.node_ns.size(); ++i) {
      truth.waypoints.push_back(
          {walk_.node_ns[i], NodePosition(i), walk_.floors.At(walk_.node_ns[i])});
    }
    return truth;
  }

  const Site& site_;
  Evidence evidence_;
  Random random_;
  WalkGraph walk_;
  int silent_scans_ = 0;
};

}  // namespace

Settings MatchedSettings() {
  Settings settings;
  FactorSettings& factors = settings.factors;
  for (LossSettings* loss :
       {&factors.step.loss, &factors.heading_increment.loss, &factors.absolute_heading.loss,
        &factors.standing.loss, &factors.fingerprint.loss}) {
    loss->kind = LossKind::kNone;
  }
  factors.fingerprint.n_eff = 1000;
  factors.map_error.sigma_m = 2;
  factors.map_error.correlation_s = 1e9;  // it belongs to the places alone
  factors.gyro_bias.prior_sigma_radps = 0.003;
  factors.prior.position_sigma_m = 5;
  return settings;
}

MatchedWalk DrawMatchedWalk(const Site& site, const FactorSettings& settings, double duration_s,
                            Random random) {
  Evidence inputs = PlanInputs(duration_s, &random);
  return WalkSampler(site, settings, std::move(inputs), random).Sample();
}

}  // namespace walkgraph
