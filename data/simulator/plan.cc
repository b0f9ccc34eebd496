#include "data/simulator/plan.h"

#include <algorithm>

namespace walkgraph {
namespace {

// Where rooms (odd intervals) and corridors (even ones) begin and end along each axis, in metres.
constexpr double kWidthM = 44.0;
constexpr double kDepthM = 24.0;
constexpr double kCorridorHalfWidthM = 1.2;
constexpr double kCorridorY[] = {6.2, 17.8};
constexpr double kCorridorX[] = {4.2, 22.0, 39.8};
constexpr double kRoomWidthM = 5.5;  // offices along the outer walls are about this wide

struct Block {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
  int columns;
  int rows;
};

// Everything that is not corridor, in rectangles that are divided into equal rooms.
std::vector<Block> Blocks() {
  const double south = kCorridorY[0] - kCorridorHalfWidthM;
  const double inner_south = kCorridorY[0] + kCorridorHalfWidthM;
  const double inner_north = kCorridorY[1] - kCorridorHalfWidthM;
  const double north = kCorridorY[1] + kCorridorHalfWidthM;
  const double west = kCorridorX[0] - kCorridorHalfWidthM;
  const double east = kCorridorX[2] + kCorridorHalfWidthM;
  const int outer_rooms = static_cast<int>(kWidthM / kRoomWidthM);
  std::vector<Block> blocks = {
      {{0.0, 0.0}, {kWidthM, south}, outer_rooms, 1},
      {{0.0, north}, {kWidthM, kDepthM}, outer_rooms, 1},
      {{0.0, south}, {west, north}, 1, 2},
      {{east, south}, {kWidthM, north}, 1, 2},
  };
  for (int i = 0; i < 2; ++i) {
    blocks.push_back({{kCorridorX[i] + kCorridorHalfWidthM, inner_south},
                      {kCorridorX[i + 1] - kCorridorHalfWidthM, inner_north},
                      3,
                      2});
  }
  return blocks;
}

Polygon Rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

void AddRooms(const Block& block, Floor* floor, Plan* plan) {
  const Eigen::Vector2d cells(block.columns, block.rows);
  const Eigen::Vector2d size = (block.high - block.low).cwiseQuotient(cells);
  for (int row = 0; row < block.rows; ++row) {
    for (int column = 0; column < block.columns; ++column) {
      const Eigen::Vector2d low = block.low + size.cwiseProduct(Eigen::Vector2d(column, row));
      floor->obstacles.push_back(Rectangle(low, low + size));
    }
  }
  // The grid lines of the block: every wall once.
  for (int column = 0; column <= block.columns; ++column) {
    const double x = block.low.x() + size.x() * column;
    plan->walls.push_back({{x, block.low.y()}, {x, block.high.y()}});
  }
  for (int row = 0; row <= block.rows; ++row) {
    const double y = block.low.y() + size.y() * row;
    plan->walls.push_back({{block.low.x(), y}, {block.high.x(), y}});
  }
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool Intersect(const Wall& wall, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d line = b - a;
  const Eigen::Vector2d along = wall.end - wall.begin;
  const bool wall_straddles = (Cross(line, wall.begin - a) > 0) != (Cross(line, wall.end - a) > 0);
  const bool line_straddles =
      (Cross(along, a - wall.begin) > 0) != (Cross(along, b - wall.begin) > 0);
  return wall_straddles && line_straddles;
}

}  // namespace

Plan MakeOfficePlan() {
  Plan plan;
  Floor floor;
  floor.name = "F1";
  floor.max_corner = {kWidthM, kDepthM};
  floor.outline.push_back(Rectangle(floor.min_corner, floor.max_corner));
  for (const Block& block : Blocks()) AddRooms(block, &floor, &plan);
  plan.building.name = "sample office";
  plan.building.floors.push_back(std::move(floor));
  for (const double y : kCorridorY) {
    for (const double x : kCorridorX) plan.nodes.emplace_back(x, y);
  }
  plan.links = {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {0, 3}, {1, 4}, {2, 5}};
  return plan;
}

int CountWallsBetween(const Plan& plan, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return static_cast<int>(std::count_if(plan.walls.begin(), plan.walls.end(),
                                        [&](const Wall& wall) { return Intersect(wall, a, b); }));
}

}  // namespace walkgraph
