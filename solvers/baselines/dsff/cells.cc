#include "solvers/baselines/dsff/cells.h"

#include <utility>

#include "solvers/baselines/fixes.h"

namespace walkgraph {

DsffCells::DsffCells(const Site& site, const std::vector<int>& floors,
                     const ReferencePointSettings& settings) {
  for (const int floor : floors) {
    ReferencePoints points(site, floor, settings);
    if (points.empty()) continue;
    floor_of_.insert(floor_of_.end(), points.size(), floors_.size());
    const std::size_t begin = floor_of_.size() - points.size();
    floors_.push_back({floor, FloorHeight(site, floor), begin, std::move(points)});
  }
}

DsffCells::DsffCells(ReferencePoints points) : floor_of_(points.size(), 0) {
  floors_.push_back({0, 0.0, 0, std::move(points)});
}

int DsffCells::Move(int cell, const ReferencePoints::Cell& offset, std::size_t to) const {
  const FloorCells& from = FloorOf(cell);
  ReferencePoints::Cell target = from.points.cell(static_cast<std::size_t>(cell) - from.begin);
  const FloorCells& floor = floors_[to];
  if (&floor != &from) target = floor.points.CellAt(PositionOf(cell));
  target.column += offset.column;
  target.row += offset.row;
  const int point = floor.points.IndexAt(target);
  return point < 0 ? -1 : point + static_cast<int>(floor.begin);
}

}  // namespace walkgraph
