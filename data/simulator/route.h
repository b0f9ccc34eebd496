#ifndef WALKGRAPH_DATA_SIMULATOR_ROUTE_H_
#define WALKGRAPH_DATA_SIMULATOR_ROUTE_H_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "data/simulator/plan.h"
#include "data/simulator/random.h"

namespace walkgraph {

// A corner of a path, and what kind of way leads to it.
struct RouteCorner {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double height_m = 0;
  WayKind kind = WayKind::kCorridor;
};

// Whether another path joins at an end: people are then in the middle of the way there.
struct RouteJoints {
  bool begin = false;
  bool end = false;
};

// A path along ways as a person walks it: corners are cut by arcs, and between them the person
// swings around the middle line. Parametrised by distance along the middle line, seen from above.
class Route {
 public:
  // Precondition: two corners or more, neighbours apart from each other, no half turns.
  Route(const std::vector<RouteCorner>& corners, RouteJoints joints, Random* random);

  double length_m() const { return length_m_; }
  // Distances at which the path turns.
  const std::vector<double>& turns_m() const { return turns_m_; }

  // Distance of a corner, by its index.
  double CornerAt(std::size_t index) const { return marks_[index].distance_m; }

  // Position at a distance; beyond the ends the path goes straight on.
  Eigen::Vector2d At(double distance_m) const;
  // Height there: linear between the corners, with rounded edges where stairs begin and end.
  double HeightAt(double distance_m) const;
  // Direction of walking there, radians counter-clockwise from +x, in (-pi, pi].
  double HeadingAt(double distance_m) const;
  // What the path leads over there.
  WayKind KindAt(double distance_m) const;

 private:
  struct Swing {
    double amplitude_m = 0;
    double wave_number = 0;  // rad/m
    double phase_rad = 0;
  };

  // A straight line, or an arc where the curvature is not zero.
  struct Piece {
    double begin_m = 0;  // distance at which it begins
    Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
    double curvature = 0;  // 1/m, to the left positive
  };

  // A corner on the path that was cut.
  struct Mark {
    double distance_m = 0;
    double height_m = 0;
    WayKind kind = WayKind::kCorridor;  // of the way that ends here
  };

  void CutCorners(const std::vector<RouteCorner>& corners);
  void AddMark(const Mark& mark);
  const Piece& PieceAt(double distance_m) const;
  // The first mark that does not lie before a distance; the last one behind the end.
  std::size_t MarkAfter(double distance_m) const;
  // Integral of the height from the beginning of the path, m^2.
  double HeightIntegral(double distance_m) const;
  double SwingAt(double distance_m) const;

  std::vector<Piece> pieces_;  // of the middle line
  std::vector<Mark> marks_;
  std::vector<double> height_integral_;  // at each mark
  std::vector<double> turns_m_;
  double length_m_ = 0;
  RouteJoints joints_;
  std::array<Swing, 3> swings_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_ROUTE_H_
