#include "eval/study/run_study.h"

#include <glog/logging.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <utility>

#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/files.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/run_folder.h"
#include "eval/study/run_cells.h"
#include "eval/study/study_folder.h"
#include "eval/study/study_output.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

// The cells of one data set that share walks, evidence and sites.
struct Part {
  std::size_t dataset = 0;
  std::string name;
  std::vector<ConfigOverride> overrides;  // the study's own and the preparation's
  std::vector<std::size_t> cells;         // of the study
  std::vector<const StudyCellRecord*> names;
};

// Computes what one part lacks, on the walks of one shard.
class PartRun {
 public:
  PartRun(const Study& study, const StudyOptions& options, const Part& part, Dataset dataset,
          std::string run_dir)
      : study_(study),
        options_(options),
        part_(part),
        dataset_(std::move(dataset)),
        run_dir_(std::move(run_dir)) {}

  bool AnyMissing() const {
    for (const WalkFile& file : dataset_.walks) {
      if (!IsComplete(file.id)) return true;
    }
    return false;
  }

  void Run() {
    Load();
    PlanFolds();
    if (missing_ == 0 || options_.stopped()) return;
    const std::string what = "walks of " + study_.datasets[part_.dataset].name +
                             (part_.name == "base" ? "" : " (" + part_.name + ")");
    Progress progress(static_cast<int>(missing_), what, run_dir_ + "/progress");
    folds_.resize(walks_of_fold_.size());
    cells_.resize(walks_of_fold_.size());
    const FoldJobs jobs = {.prepare = [this](std::size_t fold) { Prepare(fold); },
                           .run =
                               [&](std::size_t fold, std::size_t walk) {
                                 RunOneWalk(fold, walk);
                                 progress.Done(walks_[walk].file.id);
                               },
                           .release =
                               [this](std::size_t fold) {
                                 folds_[fold] = Fold();
                                 cells_[fold].clear();
                               }};
    RunFolds(options_.workers, missing_of_fold_, jobs, options_.stopped);
  }

 private:
  std::string PathOf(const std::string& walk) const {
    return WalkCellsPath(options_.out, study_.datasets[part_.dataset].name, part_.name, walk);
  }

  bool IsComplete(const std::string& walk) const {
    const std::optional<WalkCells> known = ReadWalkCells(PathOf(walk));
    return known && known->cells.size() == part_.names.size() && SelectCells(*known, part_.names);
  }

  void Load() {
    Settings settings;
    ApplyOverrides(part_.overrides, &settings);
    walks_.resize(dataset_.walks.size());
    ParallelFor(options_.workers, walks_.size(), options_.stopped, [&](std::size_t i) {
      walks_[i] =
          LoadWalk(dataset_.walks[i], dataset_.building, settings.frontend, study_.floor_given);
    });
    for (const LoadedWalk& walk : walks_) {
      if (!walk.error.empty()) LOG(WARNING) << walk.file.id << ": " << walk.error;
    }
    LogNotes(walks_);
  }

  void PlanFolds() {
    std::vector<const LoadedWalk*> all;
    for (const LoadedWalk& walk : walks_) all.push_back(&walk);
    fold_of_walk_ = AssignFolds(all, study_.split, study_.folds);
    walks_of_fold_.resize(static_cast<std::size_t>(study_.folds));
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      walks_of_fold_[static_cast<std::size_t>(fold_of_walk_[i])].push_back(i);
    }
    FindMissing();
  }

  // Walks of this shard without results. Shards cut the walks in the order of their folds.
  void FindMissing() {
    const auto shard = static_cast<std::size_t>(options_.shard);
    const auto shards = static_cast<std::size_t>(options_.shards);
    const std::size_t begin = walks_.size() * (shard - 1) / shards;
    const std::size_t end = walks_.size() * shard / shards;
    missing_of_fold_.resize(walks_of_fold_.size());
    std::size_t position = 0;
    for (std::size_t fold = 0; fold < walks_of_fold_.size(); ++fold) {
      for (const std::size_t walk : walks_of_fold_[fold]) {
        const bool ours = position >= begin && position < end;
        ++position;
        if (!ours || IsComplete(walks_[walk].file.id)) continue;
        missing_of_fold_[fold].push_back(walk);
        ++missing_;
      }
    }
  }

  void Prepare(std::size_t fold) {
    std::vector<const LoadedWalk*> training, test;
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      const bool held_out = static_cast<std::size_t>(fold_of_walk_[i]) == fold;
      (held_out ? test : training).push_back(&walks_[i]);
    }
    folds_[fold] = PrepareFold(dataset_.building, training, test, part_.overrides);
    cells_[fold] = MakeFoldCells(study_, part_.cells, folds_[fold]);
  }

  void RunOneWalk(std::size_t fold, std::size_t walk) {
    const std::string path = PathOf(walks_[walk].file.id);
    const std::optional<WalkCells> earlier = ReadWalkCells(path);
    const CellsRun run =
        RunCells(cells_[fold], folds_[fold].site, walks_[walk], static_cast<int>(fold),
                 earlier ? &*earlier : nullptr, options_.stopped);
    WriteFileWholeVia(run_dir_ + "/unfinished", path, FormatWalkCells(run.walk));
    std::string timings;
    for (const auto& [cell, seconds] : run.seconds) {
      timings += study_.datasets[part_.dataset].name + "," + run.walk.walk + "," + cell + "," +
                 std::to_string(seconds) + "\n";
    }
    const std::lock_guard<std::mutex> lock(timings_mutex_);
    std::ofstream(run_dir_ + "/timings.csv", std::ios::app) << timings;
  }

  const Study& study_;
  const StudyOptions& options_;
  const Part& part_;
  const Dataset dataset_;
  const std::string run_dir_;
  std::vector<LoadedWalk> walks_;
  std::vector<int> fold_of_walk_;
  std::vector<std::vector<std::size_t>> walks_of_fold_;
  std::vector<std::vector<std::size_t>> missing_of_fold_;
  std::size_t missing_ = 0;
  std::vector<Fold> folds_;
  std::vector<std::vector<FoldCell>> cells_;  // by fold
  std::mutex timings_mutex_;
};

std::map<std::string, std::string> Checksums(const Dataset& dataset) {
  std::map<std::string, std::string> checksums;
  for (const WalkFile& file : dataset.walks) {
    try {
      checksums[file.id] = FileChecksum(file.path);
    } catch (const InputError&) {
      checksums[file.id] = "unreadable";  // a walk with status input_error
    }
  }
  return checksums;
}

// Parts in the order of their first cells, data set by data set.
std::vector<Part> PartsOf(const Study& study, const StudyRecord& record) {
  std::vector<Part> parts;
  for (std::size_t d = 0; d < study.datasets.size(); ++d) {
    const std::size_t first = parts.size();
    for (std::size_t c = 0; c < study.cells.size(); ++c) {
      const std::string& name = record.cells[c].part;
      std::size_t p = first;
      while (p < parts.size() && parts[p].name != name) ++p;
      if (p == parts.size()) {
        Part part{d, name, study.base, {}, {}};
        for (const ConfigOverride& item : PreparationOverrides(study.cells[c].overrides)) {
          part.overrides.push_back(item);
        }
        parts.push_back(std::move(part));
      }
      parts[p].cells.push_back(c);
      parts[p].names.push_back(&record.cells[c]);
    }
  }
  return parts;
}

// Creates the folder, or checks that what it holds belongs to this study.
void OpenStudyFolder(const std::string& out, const StudyRecord& record) {
  // The folder is read before the record. Shards start together, and each writes the record before
  // anything else: read the other way round, one would take another's record for a stranger's file.
  const std::string occupied = WhyOccupied(out, {"run"});
  if (const std::optional<StudyRecord> earlier = ReadStudyRecord(out)) {
    const std::string difference = DifferenceOfInputs(record, *earlier);
    if (!difference.empty()) {
      throw UsageError("--out=" + out + " holds results of another study: " + difference +
                       "; expected a new folder or the same version and inputs");
    }
  } else if (!occupied.empty()) {
    throw UsageError(occupied);
  }
  WriteFileWholeVia(out + "/run/unfinished", out + "/study.json", FormatStudyRecord(record));
}

std::string RunDir(const StudyOptions& options) {
  if (options.shards == 1) return options.out + "/run";
  return options.out + "/run/shard_" + std::to_string(options.shard) + "_of_" +
         std::to_string(options.shards);
}

}  // namespace

int RunStudy(const Study& study, const StudyOptions& options) {
  std::vector<Dataset> datasets;
  StudyRecord record = MakeStudyRecord(study);
  for (std::size_t d = 0; d < study.datasets.size(); ++d) {
    datasets.push_back(OpenDataset(study.datasets[d].path));
    record.datasets[d].checksums = Checksums(datasets.back());
  }
  OpenStudyFolder(options.out, record);
  const std::string run_dir = RunDir(options);
  fs::remove_all(run_dir + "/unfinished");  // of a process that was killed
  fs::create_directories(run_dir);
  LogToRunFolder(run_dir);
  WriteRunDescription(run_dir, options.command_line, options.workers);
  for (const Part& part : PartsOf(study, record)) {
    PartRun run(study, options, part, datasets[part.dataset], run_dir);
    if (!options.stopped() && run.AnyMissing()) run.Run();
  }
  if (options.stopped()) return kExitInterrupted;
  return FinishStudy(options.out, record);
}

}  // namespace walkgraph
