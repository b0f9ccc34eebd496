#ifndef WALKGRAPH_EVAL_STUDY_STUDY_FOLDER_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_FOLDER_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/study/study.h"
#include "eval/study/walk_cells.h"

namespace walkgraph {

// The result folder of a study:
//   study.json                          what was compared, on what, by which version
//   cells/<data set>/<part>/<walk>.json a walk's results; <part> is "base" or the overrides that
//                                       made evidence or radio map anew
//   summary.json, tables/               written once every walk is there
//   run/                                log, command, machine, timings; unfinished files
// Several processes may write the same folder, each its own walks.

// A cell as study.json tells of it.
struct StudyCellRecord {
  std::string name;
  std::string method;
  std::map<std::string, std::string> overrides;
  std::string configuration;  // hash
  std::string part;           // folder below the data set's
};

struct StudyDatasetRecord {
  std::string name;
  std::map<std::string, std::string> checksums;  // by walk
};

// study.json: enough to summarise results, merge them and refuse what does not belong to them.
struct StudyRecord {
  std::string version;
  std::string split;
  int folds = 0;
  bool floor_given = true;
  std::map<std::string, std::string> base;
  std::vector<StudyDatasetRecord> datasets;
  std::vector<StudyCellRecord> cells;
  std::string reference;
  std::vector<std::string> factors;
  std::map<std::uint32_t, std::size_t> cell_of_subset;
};

// The folder that holds the walks' results of one data set and preparation.
std::string PartName(const std::vector<ConfigOverride>& preparation);

// Everything of a study but the checksums, which only its inputs have.
StudyRecord MakeStudyRecord(const Study& study);

std::string FormatStudyRecord(const StudyRecord& record);

// The record of a folder. nullopt where the folder has none. Throws InputError where it is damaged.
std::optional<StudyRecord> ReadStudyRecord(const std::string& dir);

// What makes results of `other` no results of `record`, in words that name the difference; empty
// where nothing does. Cells may differ: each carries its own configuration.
std::string DifferenceOfInputs(const StudyRecord& record, const StudyRecord& other);

// Index of the cell that the others are compared with.
std::size_t ReferenceCell(const StudyRecord& record);

std::string WalkCellsPath(const std::string& dir, const std::string& dataset,
                          const std::string& part, const std::string& walk);

// A walk's file, or nullopt where it is missing or damaged; damage is warned about once here.
std::optional<WalkCells> ReadWalkCells(const std::string& path);

// The part of `walk` that answers `cells` (all of one part), in their order; nullopt where one is
// missing or was made by another configuration.
std::optional<WalkCells> SelectCells(const WalkCells& walk,
                                     const std::vector<const StudyCellRecord*>& cells);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_FOLDER_H_
