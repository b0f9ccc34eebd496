#include "data/simulator/route.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace walkgraph {
namespace {

constexpr double kCornerRadiusM = 0.9;  // fits into the corridors' width of 2.4 m
constexpr double kHeadingBaseM = 0.2;   // a third of a step either way
// People swing a few decimetres to the sides of a corridor's middle line over several metres; the
// amplitude keeps them clear of the walls.
constexpr double kSwingAmplitudeM = 0.12;
constexpr double kShortestSwingM = 4.0;
constexpr double kLongestSwingM = 14.0;
// Walks begin and end this far from crossings.
constexpr double kEndMarginM = 1.5;

int OtherEnd(const std::pair<int, int>& link, int node) {
  return link.first == node ? link.second : link.first;
}

// A link at `node` other than the one the person comes along.
int NextLink(const Plan& plan, int node, int arrived_by, Random* random) {
  std::vector<int> choices;
  for (int i = 0; i < static_cast<int>(plan.links.size()); ++i) {
    const auto& link = plan.links[static_cast<std::size_t>(i)];
    if (i != arrived_by && (link.first == node || link.second == node)) choices.push_back(i);
  }
  return choices[static_cast<std::size_t>(random->Index(static_cast<int>(choices.size())))];
}

// The corners of a random path from a point on the first link until the length is used up.
std::vector<Eigen::Vector2d> RandomCorners(const Plan& plan, int first_link, double length_m,
                                           Random* random) {
  int link = first_link;
  const auto& [from, to] = plan.links[static_cast<std::size_t>(link)];
  int target = random->Uniform() < 0.5 ? from : to;
  const Eigen::Vector2d begin = plan.nodes[static_cast<std::size_t>(from)];
  const Eigen::Vector2d end = plan.nodes[static_cast<std::size_t>(to)];
  const double margin = kEndMarginM / (end - begin).norm();
  std::vector<Eigen::Vector2d> corners;
  corners.emplace_back(begin + (end - begin) * random->Uniform(margin, 1.0 - margin));
  double left = length_m;
  while (true) {
    const Eigen::Vector2d& node = plan.nodes[static_cast<std::size_t>(target)];
    const Eigen::Vector2d leg = node - corners.back();
    if (leg.norm() >= left) {
      const double last =
          std::clamp(left, kEndMarginM, std::max(kEndMarginM, leg.norm() - kEndMarginM));
      corners.emplace_back(corners.back() + leg.normalized() * last);
      return corners;
    }
    left -= leg.norm();
    corners.push_back(node);
    link = NextLink(plan, target, link, random);
    target = OtherEnd(plan.links[static_cast<std::size_t>(link)], target);
  }
}

}  // namespace

Route::Route(const Plan& plan, int first_link, double length_m, Random* random) {
  CutCorners(RandomCorners(plan, first_link, length_m, random));
  for (Swing& swing : swings_) {
    swing.amplitude_m = random->Uniform(0.3, 1.0) * kSwingAmplitudeM;
    swing.wave_number = 2.0 * std::numbers::pi / random->Uniform(kShortestSwingM, kLongestSwingM);
    swing.phase_rad = random->Uniform(0.0, 2.0 * std::numbers::pi);
  }
}

void Route::CutCorners(const std::vector<Eigen::Vector2d>& corners) {
  constexpr double kArcLengthM = 0.5 * std::numbers::pi * kCornerRadiusM;
  Piece line;
  line.start_m = corners.front();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    line.direction = (corners[i] - corners[i - 1]).normalized();
    pieces_.push_back(line);
    const bool last = i + 1 == corners.size();
    const Eigen::Vector2d out = last ? line.direction : (corners[i + 1] - corners[i]).normalized();
    const double turn = line.direction.x() * out.y() - line.direction.y() * out.x();
    const bool corner = std::abs(turn) > 0.5;  // else straight over the crossing, or the end
    const double cut_m = corner ? kCornerRadiusM : 0.0;
    const Eigen::Vector2d end = corners[i] - cut_m * line.direction;
    line.begin_m += (end - line.start_m).norm();
    line.start_m = end;
    if (!corner) continue;
    // All corners are right angles: an arc of a quarter turn from one radius before to one behind.
    Piece arc = line;
    arc.curvature = std::copysign(1.0 / kCornerRadiusM, turn);
    pieces_.push_back(arc);
    turns_m_.push_back(line.begin_m + 0.5 * kArcLengthM);
    line.begin_m += kArcLengthM;
    line.start_m = corners[i] + cut_m * out;
  }
  length_m_ = line.begin_m;
}

const Route::Piece& Route::PieceAt(double distance_m) const {
  const auto after = std::upper_bound(
      pieces_.begin() + 1, pieces_.end(), distance_m,
      [](double distance, const Piece& piece) { return distance < piece.begin_m; });
  return *(after - 1);
}

Eigen::Vector2d Route::At(double distance_m) const {
  const Piece& piece = PieceAt(distance_m);
  const double along_m = distance_m - piece.begin_m;
  const Eigen::Vector2d left(-piece.direction.y(), piece.direction.x());
  Eigen::Vector2d point = piece.start_m + along_m * piece.direction;
  Eigen::Vector2d normal = left;
  if (piece.curvature != 0) {
    const double angle = piece.curvature * along_m;
    point = piece.start_m +
            (std::sin(angle) * piece.direction + (1.0 - std::cos(angle)) * left) / piece.curvature;
    normal = std::cos(angle) * left - std::sin(angle) * piece.direction;
  }
  double offset_m = 0;
  for (const Swing& swing : swings_) {
    offset_m += swing.amplitude_m * std::sin(swing.wave_number * distance_m + swing.phase_rad);
  }
  return point + offset_m * normal;
}

double Route::HeadingAt(double distance_m) const {
  const Eigen::Vector2d along = At(distance_m + kHeadingBaseM) - At(distance_m - kHeadingBaseM);
  return std::atan2(along.y(), along.x());
}

}  // namespace walkgraph
