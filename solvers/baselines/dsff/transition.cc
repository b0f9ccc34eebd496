#include "solvers/baselines/dsff/transition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "data/angle.h"
#include "solvers/baselines/way_graph.h"

namespace walkgraph {
namespace {

constexpr double kNegligibleNats = 30;

// One way counts at least the error of one step.
double StepsOf(const DsffMotion& motion) { return std::max(1.0, motion.steps); }

}  // namespace

double RelativeSensor::LogDensity(double deviation) const {
  if (block_) return block_->LogDensity(deviation);
  const double z = deviation / sigma_;
  return -0.5 * z * z - std::log(sigma_) - 0.5 * std::log(2 * std::numbers::pi);
}

TransitionKernel MakeKernel(const DsffMotion& motion, const RelativeSensors& sensors,
                            double spacing_m, double max_distance_m) {
  const double steps = StepsOf(motion);
  TransitionKernel kernel;
  double best = -std::numeric_limits<double>::infinity();
  ForLatticeCellsNear(
      {0, 0}, max_distance_m, spacing_m, {0, 0}, [&](const ReferencePoints::Cell& offset) {
        const Eigen::Vector2d way = spacing_m * Eigen::Vector2d(offset.column, offset.row);
        const double distance_m = way.norm();
        double log_p = sensors.distance.LogDensity((distance_m - motion.distance_m) / steps);
        if (distance_m > 0 && motion.distance_m > 0) {
          log_p += sensors.heading.LogDensity(
              WrapAngle(std::atan2(way.y(), way.x()) - motion.heading_rad));
        } else {
          log_p -= std::log(2 * std::numbers::pi);
        }
        best = std::max(best, log_p);
        kernel.entries.push_back({offset, log_p});
      });
  std::erase_if(kernel.entries, [best](const TransitionKernel::Entry& entry) {
    return entry.log_probability < best - kNegligibleNats;
  });
  return kernel;
}

void LearnFromTrace(const DsffMotion& motion, const Eigen::Vector2d& way_m,
                    std::optional<double> height_error_m, RelativeSensors* sensors) {
  if (height_error_m) sensors->height.Learn(*height_error_m);
  if (motion.steps <= 0 || motion.distance_m <= 0) return;
  sensors->distance.Learn((motion.distance_m - way_m.norm()) / StepsOf(motion));
  if (way_m.norm() > 0) {
    sensors->heading.Learn(WrapAngle(motion.heading_rad - std::atan2(way_m.y(), way_m.x())));
  }
}

MapMatching::MapMatching(const Site& site, const DsffCells& cells, const Settings& settings)
    : cells_(cells), log_branch_share_(cells.size(), 0.0) {
  for (const DsffCells::FloorCells& floor : cells.floors()) {
    const Floor* plan = site.building.FindFloor(floor.floor);
    std::vector<Polygon> polygons;
    if (plan != nullptr) {
      polygons = plan->outline;
      polygons.insert(polygons.end(), plan->obstacles.begin(), plan->obstacles.end());
    }
    walls_.emplace_back(polygons);
    const WayNetwork ways = FindWays(site, floor.floor, settings.merge_m, settings.straight_rad);
    std::vector<int> branches(ways.nodes.size(), 0);
    for (const auto& [from, to] : ways.links) {
      ++branches[static_cast<std::size_t>(from)];
      ++branches[static_cast<std::size_t>(to)];
    }
    for (std::size_t n = 0; n < ways.nodes.size(); ++n) {
      if (branches[n] < 3) continue;
      floor.points.ForNear(ways.nodes[n], settings.junction_radius_m, [&](int point) {
        log_branch_share_[floor.begin + static_cast<std::size_t>(point)] = -std::log(branches[n]);
      });
    }
  }
}

bool MapMatching::Blocks(int from, int to) const {
  const DsffCells::FloorCells& floor = cells_.FloorOf(from);
  if (&floor != &cells_.FloorOf(to)) return false;
  const auto index = static_cast<std::size_t>(&floor - cells_.floors().data());
  return walls_[index].Block(cells_.PositionOf(from), cells_.PositionOf(to));
}

}  // namespace walkgraph
