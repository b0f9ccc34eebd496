#include "data/simulator/office_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "data/formats/ilc20.h"

namespace walkgraph {
namespace {

constexpr double kCorridorHalfWidthM = 1.2;
constexpr double kRoomWidthM = 5.5;  // offices along the outer walls are about this wide
constexpr int kColumns = 3;          // of rooms in a block between the corridors
constexpr int kRows = 2;
constexpr double kFlightGapM = 1.6;  // between the middles of two flights of stairs
constexpr double kLandingM = 0.6;    // from a flight to the middle of a landing
constexpr double kCabinDepthM = 1.2;

// Where rooms and corridors begin and end along each axis, in metres.
struct Shape {
  double width_m = 44.0;
  double depth_m = 24.0;
  std::array<double, 2> corridor_y = {6.2, 17.8};
  std::array<double, 3> corridor_x = {4.2, 22.0, 39.8};
};

struct Block {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
  int columns;
  int rows;

  Eigen::Vector2d CellSize() const {
    return (high - low).cwiseQuotient(Eigen::Vector2d(columns, rows));
  }
  Eigen::Vector2d CellCorner(int column, int row) const {
    return low + CellSize().cwiseProduct(Eigen::Vector2d(column, row));
  }
};

// The block between two corridors along y: 0 is the western, 1 the eastern one.
Block InnerBlock(const Shape& shape, std::size_t index) {
  return {
      {shape.corridor_x[index] + kCorridorHalfWidthM, shape.corridor_y[0] + kCorridorHalfWidthM},
      {shape.corridor_x[index + 1] - kCorridorHalfWidthM,
       shape.corridor_y[1] - kCorridorHalfWidthM},
      kColumns,
      kRows};
}

// Rooms around the corridors, in rectangles that are divided into equal rooms.
std::vector<Block> OuterBlocks(const Shape& shape) {
  const double south = shape.corridor_y[0] - kCorridorHalfWidthM;
  const double north = shape.corridor_y[1] + kCorridorHalfWidthM;
  const double west = shape.corridor_x[0] - kCorridorHalfWidthM;
  const double east = shape.corridor_x[2] + kCorridorHalfWidthM;
  const int rooms = static_cast<int>(shape.width_m / kRoomWidthM);
  return {
      {{0.0, 0.0}, {shape.width_m, south}, rooms, 1},
      {{0.0, north}, {shape.width_m, shape.depth_m}, rooms, 1},
      {{0.0, south}, {west, north}, 1, 2},
      {{east, south}, {shape.width_m, north}, 1, 2},
  };
}

Polygon Rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

// `open` are the cells (column, row) that people walk in.
void AddRooms(const Block& block, const std::vector<std::pair<int, int>>& open, Floor* floor,
              std::vector<Wall>* walls) {
  const Eigen::Vector2d size = block.CellSize();
  for (int row = 0; row < block.rows; ++row) {
    for (int column = 0; column < block.columns; ++column) {
      if (std::find(open.begin(), open.end(), std::pair(column, row)) != open.end()) continue;
      const Eigen::Vector2d low = block.CellCorner(column, row);
      floor->obstacles.push_back(Rectangle(low, low + size));
    }
  }
  // The grid lines of the block: every wall once.
  for (int column = 0; column <= block.columns; ++column) {
    const double x = block.low.x() + size.x() * column;
    walls->push_back({{x, block.low.y()}, {x, block.high.y()}, floor->number});
  }
  for (int row = 0; row <= block.rows; ++row) {
    const double y = block.low.y() + size.y() * row;
    walls->push_back({{block.low.x(), y}, {block.high.x(), y}, floor->number});
  }
}

using OpenCells = std::array<std::vector<std::pair<int, int>>, 2>;  // by inner block

void AddFloor(const Shape& shape, const OpenCells& open, Floor floor, Plan* plan) {
  floor.max_corner = {shape.width_m, shape.depth_m};
  floor.outline.push_back(Rectangle(floor.min_corner, floor.max_corner));
  for (const Block& block : OuterBlocks(shape)) AddRooms(block, {}, &floor, &plan->walls);
  for (std::size_t i = 0; i < open.size(); ++i) {
    AddRooms(InnerBlock(shape, i), open[i], &floor, &plan->walls);
  }
  plan->building.floors.push_back(std::move(floor));
}

// Adds the nodes and links of one floor's corridors. `doors` are the places of the southern and of
// the northern corridor where something else begins; returns their nodes in the order given.
std::array<std::vector<int>, 2> AddCorridors(const Shape& shape, int floor,
                                             const std::array<std::vector<double>, 2>& doors,
                                             Plan* plan) {
  std::array<std::vector<int>, 2> door_nodes;
  std::array<std::array<int, 3>, 2> crossings{};
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<std::pair<double, int>> along;
    const double y = shape.corridor_y[side];
    for (std::size_t i = 0; i < 3; ++i) {
      crossings[side][i] = plan->AddNode(floor, {shape.corridor_x[i], y});
      along.emplace_back(shape.corridor_x[i], crossings[side][i]);
    }
    for (const double x : doors[side]) {
      door_nodes[side].push_back(plan->AddNode(floor, {x, y}));
      along.emplace_back(x, door_nodes[side].back());
    }
    std::sort(along.begin(), along.end());
    for (std::size_t i = 1; i < along.size(); ++i) {
      plan->AddLink(along[i - 1].second, along[i].second);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) plan->AddLink(crossings[0][i], crossings[1][i]);
  return door_nodes;
}

// Two flights with a landing: in from the corridor at `door`, along `inward` and back beside it.
std::vector<WayPoint> StairBends(const Eigen::Vector2d& door, double inward, double from_m,
                                 double rise_m, const GaitSettings& gait) {
  const double foot = door.y() + inward * (kCorridorHalfWidthM + kLandingM);
  const double run = std::min(0.5 * rise_m / gait.riser_m * gait.tread_m, 3.2);
  const double top = foot + inward * run;
  const double landing = top + inward * kLandingM;
  const double x = door.x();
  const double back = x + kFlightGapM;
  const double half = from_m + 0.5 * rise_m;
  return {{{x, foot}, from_m},     {{x, top}, half},    {{x, landing}, half},
          {{back, landing}, half}, {{back, top}, half}, {{back, foot}, from_m + rise_m}};
}

// What leads from each floor to others, in an office with connectors.
struct OfficeDoors {
  double west_stairs_x, lift_x, escalator_low_x, escalator_high_x, east_stairs_x;
};

OfficeDoors PlaceDoors(const Shape& shape, const BuildingSettings& settings) {
  constexpr double kFromWallM = 1.3;
  const Block west = InnerBlock(shape, 0);
  const Block east = InnerBlock(shape, 1);
  const double slope = std::tan(DegreesToRadians(RideSettings{}.escalator_slope_deg));
  const double low = east.low.x() + kFromWallM;
  const double longest = 2.0 * east.CellSize().x() - 2.0 * kFromWallM;
  OfficeDoors doors{};
  doors.west_stairs_x = west.low.x() + kFromWallM;
  doors.lift_x = west.CellCorner(2, 0).x() + 0.5 * west.CellSize().x();
  doors.escalator_low_x = low;
  doors.escalator_high_x = low + std::min(settings.floor_height_m / slope, longest);
  doors.east_stairs_x = east.CellCorner(2, 0).x() + kFromWallM;
  return doors;
}

// The nodes of one floor where its connectors begin.
struct FloorDoors {
  int west_stairs, lift, escalator_low, escalator_high, east_stairs, cabin;
};

FloorDoors AddFloorWays(const Shape& shape, const OfficeDoors& doors, int floor, Plan* plan) {
  const auto nodes =
      AddCorridors(shape, floor,
                   {std::vector<double>{doors.west_stairs_x, doors.lift_x, doors.escalator_low_x,
                                        doors.escalator_high_x},
                    std::vector<double>{doors.east_stairs_x}},
                   plan);
  const Eigen::Vector2d inside(0.0, kCorridorHalfWidthM + kCabinDepthM);
  const int lift = nodes[0][1];
  const int cabin = plan->AddNode(floor, plan->Node(lift).position_m + inside);
  plan->AddLink(lift, cabin);
  return {nodes[0][0], lift, nodes[0][2], nodes[0][3], nodes[1][0], cabin};
}

void AddStairs(int low, int high, double inward, const GaitSettings& gait, Plan* plan) {
  const double from_m = plan->HeightOf(plan->Node(low).floor);
  const double rise_m = plan->HeightOf(plan->Node(high).floor) - from_m;
  plan->AddLink(low, high, WayKind::kStairs,
                StairBends(plan->Node(low).position_m, inward, from_m, rise_m, gait));
}

void AddEscalator(int low, int high, Plan* plan) {
  const Eigen::Vector2d inside(0.0, kCorridorHalfWidthM + 1.0);
  const WayNode& foot = plan->Node(low);
  const WayNode& top = plan->Node(high);
  plan->AddLink(low, high, WayKind::kEscalator,
                {{foot.position_m + inside, plan->HeightOf(foot.floor)},
                 {top.position_m + inside, plan->HeightOf(top.floor)}});
}

// The connectors as the building file tells them: stops at the middle of where they lie.
void DescribeConnectors(const std::vector<FloorDoors>& floors, Plan* plan) {
  const Eigen::Vector2d stairs(0.5 * kFlightGapM, kCorridorHalfWidthM + kLandingM + 1.5);
  const Eigen::Vector2d escalator(0.0, kCorridorHalfWidthM + 1.0);
  Connector west{"west stairs", ConnectorKind::kStairs, {}, 3.5};
  Connector east{"east stairs", ConnectorKind::kStairs, {}, 3.5};
  Connector lift{"lift", ConnectorKind::kLift, {}, 2.0};
  for (std::size_t i = 0; i < floors.size(); ++i) {
    const FloorDoors& doors = floors[i];
    const int floor = plan->Node(doors.lift).floor;
    west.stops.push_back({floor, plan->Node(doors.west_stairs).position_m + stairs});
    east.stops.push_back({floor, plan->Node(doors.east_stairs).position_m +
                                     Eigen::Vector2d(stairs.x(), -stairs.y())});
    lift.stops.push_back({floor, plan->Node(doors.cabin).position_m});
    if (i == 0) continue;
    const WayNode& low = plan->Node(floors[i - 1].escalator_low);
    const WayNode& high = plan->Node(doors.escalator_high);
    plan->building.connectors.push_back(
        {"escalator " + std::to_string(i),
         ConnectorKind::kEscalator,
         {{low.floor, low.position_m + escalator}, {high.floor, high.position_m + escalator}},
         2.0});
  }
  for (Connector& connector : std::array{west, east, lift}) {
    if (connector.stops.size() > 1) plan->building.connectors.push_back(std::move(connector));
  }
}

void JoinFloors(const std::vector<FloorDoors>& floors, const GaitSettings& gait, Plan* plan) {
  for (std::size_t i = 0; i < floors.size(); ++i) {
    for (std::size_t j = i + 1; j < floors.size(); ++j) {
      plan->AddLink(floors[i].cabin, floors[j].cabin, WayKind::kLift);
    }
    if (i + 1 == floors.size()) break;
    AddStairs(floors[i].west_stairs, floors[i + 1].west_stairs, 1.0, gait, plan);
    AddStairs(floors[i].east_stairs, floors[i + 1].east_stairs, -1.0, gait, plan);
    AddEscalator(floors[i].escalator_low, floors[i + 1].escalator_high, plan);
  }
  DescribeConnectors(floors, plan);
}

Shape RandomShape(Random* random) {
  Shape shape;
  shape.width_m = std::round(random->Uniform(46.0, 60.0));
  shape.depth_m = std::round(random->Uniform(24.0, 29.0));
  shape.corridor_y[1] = shape.depth_m - shape.corridor_y[0];
  shape.corridor_x[1] = shape.width_m * random->Uniform(0.45, 0.55);
  shape.corridor_x[2] = shape.width_m - shape.corridor_x[0];
  return shape;
}

}  // namespace

Plan MakeSampleOffice() {
  Plan plan;
  const Shape shape;
  plan.building.name = "sample office";
  Floor floor;
  floor.name = "F1";
  AddFloor(shape, {}, std::move(floor), &plan);
  AddCorridors(shape, 0, {}, &plan);
  return plan;
}

Plan MakeOffice(const BuildingSettings& settings, const GaitSettings& gait, Random* random) {
  Plan plan;
  const Shape shape = RandomShape(random);
  const bool several = settings.floors > 1;
  const OpenCells open =
      several ? OpenCells{{{{0, 0}, {2, 0}}, {{0, 0}, {1, 0}, {2, 1}}}} : OpenCells{};
  const OfficeDoors doors = PlaceDoors(shape, settings);
  plan.building.name = "simulated office";
  std::vector<FloorDoors> floors;
  for (int i = 0; i < settings.floors; ++i) {
    Floor floor;
    floor.number = settings.lowest_floor + i;
    floor.name = Ilc20FloorName(floor.number);
    floor.height_m = settings.floor_height_m * floor.number;
    AddFloor(shape, open, std::move(floor), &plan);
    const int number = settings.lowest_floor + i;
    if (several) {
      floors.push_back(AddFloorWays(shape, doors, number, &plan));
    } else {
      AddCorridors(shape, number, {}, &plan);
    }
  }
  if (several) JoinFloors(floors, gait, &plan);
  return plan;
}

}  // namespace walkgraph
