#include "data/simulator/grid_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "data/input_error.h"

namespace walkgraph {
namespace {

constexpr double kClearanceM = 0.6;  // from walls: half a person and the swing of the path
constexpr double kHallWidthM = 36.0;
constexpr double kHallDepthM = 18.0;
// Connectors that a file gives a single place get flights of this length in plan.
constexpr double kSamePlaceM = 1.0;

double DistanceToWall(const Wall& wall, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = wall.end - wall.begin;
  const double share = std::clamp((point - wall.begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (wall.begin + share * along - point).norm();
}

bool HasClearance(const std::vector<Wall>& walls, const Eigen::Vector2d& point) {
  return std::all_of(walls.begin(), walls.end(), [&point](const Wall& wall) {
    return DistanceToWall(wall, point) >= kClearanceM;
  });
}

void AddEdges(const std::vector<Polygon>& rings, int floor, std::vector<Wall>* walls) {
  for (const Polygon& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d& next = ring[(i + 1) % ring.size()];
      if (next != ring[i]) walls->push_back({ring[i], next, floor});
    }
  }
}

std::vector<Polygon> OutlineOf(const Floor& floor) {
  if (!floor.outline.empty()) return floor.outline;
  const Eigen::Vector2d& low = floor.min_corner;
  const Eigen::Vector2d& high = floor.max_corner;
  return {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
}

// A grid of points of one floor: the number of each in the plan's nodes, or -1 where nobody walks.
class WayGrid {
 public:
  WayGrid(const Floor& floor, std::vector<Wall> walls, double spacing_m)
      : floor_(floor), walls_(std::move(walls)), spacing_m_(spacing_m) {
    const Eigen::Vector2d size = floor.max_corner - floor.min_corner;
    columns_ = std::max(0, static_cast<int>(std::floor(size.x() / spacing_m)));
    rows_ = std::max(0, static_cast<int>(std::floor(size.y() / spacing_m)));
    const std::vector<Polygon> outline = OutlineOf(floor);
    for (int i = 0; i < columns_ * rows_; ++i) {
      const Eigen::Vector2d point = PointAt(i);
      free_.push_back(InsidePolygons(outline, point) && !InsidePolygons(floor.obstacles, point) &&
                      HasClearance(walls_, point));
    }
  }

  // Adds the largest connected part; returns how many nodes it has.
  int AddTo(Plan* plan) const {
    const std::vector<int> part = LargestPart();
    std::vector<int> node(free_.size(), -1);
    for (const int i : part) {
      node[static_cast<std::size_t>(i)] = plan->AddNode(floor_.number, PointAt(i));
    }
    for (const int i : part) {
      for (const int j : Neighbours(i)) {
        if (j > i) {
          plan->AddLink(node[static_cast<std::size_t>(i)], node[static_cast<std::size_t>(j)]);
        }
      }
    }
    return static_cast<int>(part.size());
  }

 private:
  // The grid is centred in the floor's box.
  Eigen::Vector2d PointAt(int index) const {
    const Eigen::Vector2d size(columns_ - 1, rows_ - 1);
    const Eigen::Vector2d first =
        0.5 * (floor_.min_corner + floor_.max_corner) - 0.5 * spacing_m_ * size;
    return first + spacing_m_ * Eigen::Vector2d(index % columns_, index / columns_);
  }

  std::vector<int> Neighbours(int index) const {
    std::vector<int> found;
    const int column = index % columns_;
    const int row = index / columns_;
    constexpr std::array<std::pair<int, int>, 4> kSteps = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (const auto& [right, up] : kSteps) {
      if (column + right < 0 || column + right >= columns_ || row + up < 0 || row + up >= rows_) {
        continue;
      }
      const int other = (row + up) * columns_ + column + right;
      if (free_[static_cast<std::size_t>(other)] && Passable(index, other)) found.push_back(other);
    }
    return found;
  }

  bool Passable(int a, int b) const {
    const Eigen::Vector2d from = PointAt(a);
    const Eigen::Vector2d to = PointAt(b);
    const int parts = std::max(1, static_cast<int>(std::ceil(spacing_m_ / 0.25)));
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      if (!HasClearance(walls_, from + share * (to - from))) return false;
    }
    return true;
  }

  std::vector<int> LargestPart() const {
    std::vector<int> largest;
    std::vector<bool> seen(free_.size(), false);
    for (int i = 0; i < static_cast<int>(free_.size()); ++i) {
      if (!free_[static_cast<std::size_t>(i)] || seen[static_cast<std::size_t>(i)]) continue;
      std::vector<int> part = PartOf(i, &seen);
      if (part.size() > largest.size()) largest = std::move(part);
    }
    std::sort(largest.begin(), largest.end());
    return largest;
  }

  std::vector<int> PartOf(int start, std::vector<bool>* seen) const {
    std::vector<int> part = {start};
    (*seen)[static_cast<std::size_t>(start)] = true;
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const int other : Neighbours(part[next])) {
        if ((*seen)[static_cast<std::size_t>(other)]) continue;
        (*seen)[static_cast<std::size_t>(other)] = true;
        part.push_back(other);
      }
    }
    return part;
  }

  const Floor& floor_;
  std::vector<Wall> walls_;
  double spacing_m_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> free_;
};

// The nearest of the first `count` nodes that a connector there can be entered from; -1 where its
// floor has none. What lies on the spot itself is no way to it.
int NearestNode(const Plan& plan, int count, int floor, const Eigen::Vector2d& position) {
  constexpr double kEntranceM = 0.5;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    const WayNode& node = plan.Node(i);
    const double distance = (node.position_m - position).norm();
    if (node.floor != floor || distance < kEntranceM || distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

// From the foot to the top of stairs or an escalator; where both are one place, two flights beside
// each other lie around it.
std::vector<WayPoint> RampBends(const WayPoint& foot, const WayPoint& top,
                                const GaitSettings& gait) {
  if ((top.position_m - foot.position_m).norm() > kSamePlaceM) return {foot, top};
  const double rise_m = top.height_m - foot.height_m;
  const Eigen::Vector2d run(0.5 * rise_m / gait.riser_m * gait.tread_m, 0.0);
  const Eigen::Vector2d beside(0.0, 1.4);
  const double half_m = foot.height_m + 0.5 * rise_m;
  const Eigen::Vector2d begin = foot.position_m - 0.5 * run - 0.5 * beside;
  return {{begin, foot.height_m},
          {begin + run, half_m},
          {begin + run + beside, half_m},
          {begin + beside, top.height_m}};
}

// `count` is the number of nodes on the floors' grids.
void AddConnector(const Connector& connector, int count, const GaitSettings& gait, Plan* plan,
                  const std::string& path) {
  std::vector<std::pair<int, WayPoint>> stops;  // node that each is reached from
  for (const ConnectorStop& stop : connector.stops) {
    const int node = NearestNode(*plan, count, stop.floor, stop.position);
    if (node < 0) {
      throw InputError(path, 0,
                       "connector '" + connector.name + "' stops on floor " +
                           std::to_string(stop.floor) + ", where nobody can walk",
                       "a floor of the building");
    }
    stops.push_back({node, {stop.position, plan->HeightOf(stop.floor)}});
  }
  if (connector.kind == ConnectorKind::kLift) {
    for (auto& [node, place] : stops) {
      const int cabin = plan->AddNode(plan->Node(node).floor, place.position_m);
      plan->AddLink(node, cabin);
      node = cabin;
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
      for (std::size_t j = i + 1; j < stops.size(); ++j) {
        plan->AddLink(stops[i].first, stops[j].first, WayKind::kLift);
      }
    }
    return;
  }
  const bool stairs = connector.kind == ConnectorKind::kStairs;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    plan->AddLink(stops[i - 1].first, stops[i].first,
                  stairs ? WayKind::kStairs : WayKind::kEscalator,
                  RampBends(stops[i - 1].second, stops[i].second, gait));
  }
}

}  // namespace

Plan MakeHall(const BuildingSettings& settings) {
  Plan plan;
  Floor floor;
  floor.number = settings.lowest_floor;
  floor.name = "hall";
  floor.height_m = settings.floor_height_m * floor.number;
  floor.max_corner = {kHallWidthM, kHallDepthM};
  floor.outline = OutlineOf(floor);
  AddEdges(floor.outline, floor.number, &plan.walls);
  plan.building.name = "simulated hall";
  plan.building.floors.push_back(floor);
  const WayGrid grid(plan.building.floors.front(), plan.walls, settings.grid_spacing_m);
  if (grid.AddTo(&plan) < 2) {
    throw InputError("hall", 0, "no room for ways", "a smaller building.grid_spacing_m");
  }
  plan.scatter_m = 0.35 * settings.grid_spacing_m;
  return plan;
}

Plan MakeGivenPlan(const Building& building, const BuildingSettings& settings,
                   const GaitSettings& gait, const std::string& path) {
  Plan plan;
  plan.building = building;
  for (const Floor& floor : building.floors) {
    std::vector<Wall> walls;
    AddEdges(OutlineOf(floor), floor.number, &walls);
    AddEdges(floor.obstacles, floor.number, &walls);
    plan.walls.insert(plan.walls.end(), walls.begin(), walls.end());
    const WayGrid grid(floor, std::move(walls), settings.grid_spacing_m);
    if (grid.AddTo(&plan) < 2) {
      throw InputError(path, 0, "floor " + std::to_string(floor.number) + " has no room to walk",
                       "free space for a grid of " + std::to_string(settings.grid_spacing_m) +
                           " m, or a smaller building.grid_spacing_m");
    }
  }
  const int count = static_cast<int>(plan.nodes.size());
  for (const Connector& connector : building.connectors) {
    AddConnector(connector, count, gait, &plan, path);
  }
  return plan;
}

}  // namespace walkgraph
