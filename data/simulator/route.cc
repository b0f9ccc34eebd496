#include "data/simulator/route.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace walkgraph {
namespace {

constexpr double kCornerRadiusM = 0.9;   // fits into the corridors' width of 2.4 m
constexpr double kSharpestCutRad = 0.1;  // smaller turns are walked as they are
constexpr double kHeadingBaseM = 0.2;    // a third of a step either way
// People swing a few decimetres to the sides of a corridor's middle line over several metres; the
// amplitude keeps them clear of the walls.
constexpr double kSwingAmplitudeM = 0.12;
constexpr double kShortestSwingM = 4.0;
constexpr double kLongestSwingM = 14.0;
constexpr double kJointM = 2.0;  // paths that join run into the middle line over this distance
constexpr double kRoundedEdgeM = 0.6;  // a body takes one step to begin and to end climbing

double TurnBetween(const Eigen::Vector2d& in, const Eigen::Vector2d& out) {
  return std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
}

// The arc that replaces a corner.
struct CornerArc {
  double turn_rad = 0;
  double radius_m = 0;
  double cut_m = 0;  // from where the arc begins to the corner; 0 where nothing is cut
  double length_m = 0;
};

// `room_m` is how much of either leg the arc may take.
CornerArc FitArc(const Eigen::Vector2d& leg, const Eigen::Vector2d& next_leg, double room_m) {
  CornerArc arc;
  arc.turn_rad = TurnBetween(leg, next_leg);
  if (std::abs(arc.turn_rad) <= kSharpestCutRad) return arc;
  const double tangent = std::tan(0.5 * std::abs(arc.turn_rad));
  arc.radius_m = std::min(kCornerRadiusM, room_m / tangent);
  arc.cut_m = arc.radius_m * tangent;
  arc.length_m = arc.radius_m * std::abs(arc.turn_rad);
  return arc;
}

double SmoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

Route::Route(const std::vector<RouteCorner>& corners, RouteJoints joints, Random* random)
    : joints_(joints) {
  CutCorners(corners);
  for (Swing& swing : swings_) {
    swing.amplitude_m = random->Uniform(0.3, 1.0) * kSwingAmplitudeM;
    swing.wave_number = 2.0 * std::numbers::pi / random->Uniform(kShortestSwingM, kLongestSwingM);
    swing.phase_rad = random->Uniform(0.0, 2.0 * std::numbers::pi);
  }
}

void Route::CutCorners(const std::vector<RouteCorner>& corners) {
  Piece line;
  line.start_m = corners.front().position_m;
  AddMark({0.0, corners.front().height_m, corners.front().kind});
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d corner = corners[i].position_m;
    const Eigen::Vector2d leg = corner - corners[i - 1].position_m;
    line.direction = leg.normalized();
    pieces_.push_back(line);
    const bool last = i + 1 == corners.size();
    const Eigen::Vector2d next_leg = last ? leg : corners[i + 1].position_m - corner;
    // Two corners share the leg between them; its ends need no room.
    const double room_m = std::min((i == 1 ? 1.0 : 0.5) * leg.norm(),
                                   (i + 2 >= corners.size() ? 1.0 : 0.5) * next_leg.norm());
    const CornerArc arc = FitArc(line.direction, next_leg, room_m);
    const Eigen::Vector2d end = corner - arc.cut_m * line.direction;
    line.begin_m += (end - line.start_m).norm();
    line.start_m = end;
    AddMark({line.begin_m + 0.5 * arc.length_m, corners[i].height_m, corners[i].kind});
    if (arc.cut_m == 0.0) continue;
    Piece bend = line;
    bend.curvature = std::copysign(1.0 / arc.radius_m, arc.turn_rad);
    pieces_.push_back(bend);
    turns_m_.push_back(marks_.back().distance_m);
    line.begin_m += arc.length_m;
    line.start_m = corner + arc.cut_m * next_leg.normalized();
  }
  length_m_ = line.begin_m;
}

void Route::AddMark(const Mark& mark) {
  double integral = 0;
  if (!marks_.empty()) {
    const Mark& last = marks_.back();
    integral = height_integral_.back() +
               0.5 * (mark.distance_m - last.distance_m) * (mark.height_m + last.height_m);
  }
  marks_.push_back(mark);
  height_integral_.push_back(integral);
}

const Route::Piece& Route::PieceAt(double distance_m) const {
  const auto after = std::upper_bound(
      pieces_.begin() + 1, pieces_.end(), distance_m,
      [](double distance, const Piece& piece) { return distance < piece.begin_m; });
  return *(after - 1);
}

std::size_t Route::MarkAfter(double distance_m) const {
  const auto after = std::lower_bound(
      marks_.begin() + 1, marks_.end() - 1, distance_m,
      [](const Mark& mark, double distance) { return mark.distance_m < distance; });
  return static_cast<std::size_t>(after - marks_.begin());
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
  return point + SwingAt(distance_m) * normal;
}

double Route::SwingAt(double distance_m) const {
  double offset_m = 0;
  for (const Swing& swing : swings_) {
    offset_m += swing.amplitude_m * std::sin(swing.wave_number * distance_m + swing.phase_rad);
  }
  if (joints_.begin) offset_m *= SmoothStep(distance_m / kJointM);
  if (joints_.end) offset_m *= SmoothStep((length_m_ - distance_m) / kJointM);
  return offset_m;
}

double Route::HeightIntegral(double distance_m) const {
  if (distance_m <= 0.0) return marks_.front().height_m * distance_m;
  const std::size_t after = MarkAfter(distance_m);
  const Mark& low = marks_[after - 1];
  const Mark& high = marks_[after];
  if (distance_m >= high.distance_m) {
    return height_integral_[after] + high.height_m * (distance_m - high.distance_m);
  }
  const double along = distance_m - low.distance_m;
  const double slope = (high.height_m - low.height_m) / (high.distance_m - low.distance_m);
  return height_integral_[after - 1] + along * (low.height_m + 0.5 * slope * along);
}

double Route::HeightAt(double distance_m) const {
  constexpr double kHalf = 0.5 * kRoundedEdgeM;
  return (HeightIntegral(distance_m + kHalf) - HeightIntegral(distance_m - kHalf)) / kRoundedEdgeM;
}

double Route::HeadingAt(double distance_m) const {
  const Eigen::Vector2d along = At(distance_m + kHeadingBaseM) - At(distance_m - kHeadingBaseM);
  return std::atan2(along.y(), along.x());
}

WayKind Route::KindAt(double distance_m) const { return marks_[MarkAfter(distance_m)].kind; }

}  // namespace walkgraph
