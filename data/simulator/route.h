#ifndef WALKGRAPH_DATA_SIMULATOR_ROUTE_H_
#define WALKGRAPH_DATA_SIMULATOR_ROUTE_H_

#include <Eigen/Core>
#include <array>
#include <vector>

#include "data/simulator/plan.h"
#include "data/simulator/random.h"

namespace walkgraph {

// A path through the corridors as a person walks it: corners are cut by arcs, and between them the
// person swings around the middle line. Parametrised by distance along the middle line.
class Route {
 public:
  // A path of about `length_m` that begins on the link and turns at random, never back.
  Route(const Plan& plan, int first_link, double length_m, Random* random);

  double length_m() const { return length_m_; }
  // Distances at which the path turns.
  const std::vector<double>& turns_m() const { return turns_m_; }

  // Position at a distance; beyond the ends the path goes straight on.
  Eigen::Vector2d At(double distance_m) const;
  // Direction of walking there, radians counter-clockwise from +x, in (-pi, pi].
  double HeadingAt(double distance_m) const;

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

  void CutCorners(const std::vector<Eigen::Vector2d>& corners);
  const Piece& PieceAt(double distance_m) const;

  std::vector<Piece> pieces_;  // of the middle line
  std::vector<double> turns_m_;
  double length_m_ = 0;
  std::array<Swing, 3> swings_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_ROUTE_H_
