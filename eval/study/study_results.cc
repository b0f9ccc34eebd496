#include "eval/study/study_results.h"

#include <map>
#include <optional>
#include <utility>

namespace walkgraph {
namespace {

using Parts = std::map<std::string, std::vector<const StudyCellRecord*>>;

Parts PartsOf(const StudyRecord& record) {
  Parts parts;
  for (const StudyCellRecord& cell : record.cells) parts[cell.part].push_back(&cell);
  return parts;
}

std::optional<WalkCells> ReadPart(const std::vector<std::string>& dirs, const std::string& dataset,
                                  const std::string& part, const std::string& walk,
                                  const std::vector<const StudyCellRecord*>& cells) {
  for (const std::string& dir : dirs) {
    const auto known = ReadWalkCells(WalkCellsPath(dir, dataset, part, walk));
    if (!known) continue;
    if (auto selected = SelectCells(*known, cells)) return selected;
  }
  return std::nullopt;
}

// The walk's cells of all parts, in the study's order; nullopt where a part is missing.
std::optional<WalkCells> ReadWalk(const std::vector<std::string>& dirs, const StudyRecord& record,
                                  const Parts& parts, const std::string& dataset,
                                  const std::string& walk) {
  std::optional<WalkCells> whole;
  std::map<std::string, CellResult> results;
  for (const auto& [part, cells] : parts) {
    std::optional<WalkCells> read = ReadPart(dirs, dataset, part, walk, cells);
    if (!read) return std::nullopt;
    for (CellResult& result : read->cells) results[result.cell] = std::move(result);
    // The part with the evidence and map as configured describes the walk, where there is one.
    if (!whole || part == "base") whole = std::move(read);
  }
  if (!whole) return std::nullopt;
  whole->cells.clear();
  for (const StudyCellRecord& cell : record.cells) whole->cells.push_back(results.at(cell.name));
  return whole;
}

}  // namespace

StudyResults ReadStudyResults(const std::vector<std::string>& dirs, const StudyRecord& record) {
  StudyResults results;
  results.record = record;
  const Parts parts = PartsOf(record);
  for (const StudyDatasetRecord& dataset : record.datasets) {
    results.datasets.push_back({dataset.name, {}});
    for (const auto& [walk, checksum] : dataset.checksums) {
      std::optional<WalkCells> read = ReadWalk(dirs, record, parts, dataset.name, walk);
      if (read) {
        results.datasets.back().walks.push_back(std::move(*read));
      } else {
        ++results.missing;
      }
    }
  }
  return results;
}

const std::vector<WaypointError>& ScoredErrors(const WalkCells& walk, std::size_t cell) {
  const std::vector<WaypointError>& errors = walk.cells[cell].errors;
  return errors.empty() ? walk.centroid_errors : errors;
}

}  // namespace walkgraph
