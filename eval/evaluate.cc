#include "eval/evaluate.h"

#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

#include "data/dataset.h"
#include "data/input_error.h"
#include "eval/files.h"
#include "eval/fold.h"
#include "eval/loaded_walk.h"
#include "eval/parallel.h"
#include "eval/progress.h"
#include "eval/result_files.h"
#include "eval/run_folder.h"
#include "eval/run_walk.h"
#include "eval/summary.h"
#include "eval/summary_json.h"

namespace walkgraph {
namespace {

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// One evaluation from data set to result files.
class EvaluationRun {
 public:
  explicit EvaluationRun(const EvaluateOptions& options) : options_(options) {
    ApplyOverrides(options.overrides, &run_.settings);
    OpenDatasets();
  }

  int Run() {
    PrepareResultFolder(options_.out);
    LogToRunFolder(options_.out + "/run");
    WriteRunDescription(options_.out + "/run", options_.command_line, options_.workers);
    Load();
    PlanFolds();
    Estimate();
    return Finish();
  }

 private:
  void OpenDatasets() {
    const bool two = options_.dataset.empty();
    const Dataset test = OpenDataset(two ? options_.test : options_.dataset);
    building_ = test.building;
    files_ = test.walks;
    test_count_ = files_.size();
    if (two) {
      const Dataset train = OpenDataset(options_.train);
      building_ = train.building;
      files_.insert(files_.end(), train.walks.begin(), train.walks.end());
    }
  }

  void Load() {
    LOG(INFO) << "reading " << files_.size() << " walks";
    walks_.resize(files_.size());
    Progress progress(static_cast<int>(files_.size()), "walks read", ProgressLog());
    ParallelFor(options_.workers, files_.size(), options_.stopped, [&](std::size_t i) {
      walks_[i] = LoadWalk(files_[i], building_, run_.settings.frontend, options_.floor_given);
      progress.Done(files_[i].id);
    });
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      const LoadedWalk& walk = walks_[i];
      // Walks only to train on may be called like those to test.
      const std::string name = (i < test_count_ ? "" : "train/") + files_[i].id;
      if (!walk.checksum.empty()) run_.checksums[name] = walk.checksum;
      if (!walk.error.empty()) LOG(WARNING) << name << ": " << walk.error;
    }
    LogNotes(walks_);
  }

  void PlanFolds() {
    for (const Method* method : options_.methods) evaluation_.methods.push_back(method->name);
    walk_options_ = {options_.out, evaluation_.methods, options_.tum,
                     run_.settings.scoring.waypoint_sigma_m};
    evaluation_.walks.resize(test_count_);
    std::vector<const LoadedWalk*> tested;
    for (std::size_t i = 0; i < test_count_; ++i) tested.push_back(&walks_[i]);
    const std::vector<int> folds = AssignFolds(tested, options_.split, options_.folds);
    const bool two = options_.dataset.empty();
    walks_of_fold_.resize(two ? 1 : static_cast<std::size_t>(options_.folds));
    run_.calibrated.resize(walks_of_fold_.size());
    for (std::size_t i = 0; i < test_count_; ++i) {
      evaluation_.walks[i].walk = files_[i].id;
      evaluation_.walks[i].fold = two ? 0 : folds[i];
      walks_of_fold_[static_cast<std::size_t>(evaluation_.walks[i].fold)].push_back(i);
    }
  }

  void Estimate() {
    folds_.resize(walks_of_fold_.size());
    estimators_.resize(walks_of_fold_.size());
    Progress progress(static_cast<int>(test_count_), "walks", ProgressLog());
    const FoldJobs jobs = {.prepare = [&](std::size_t fold) { Prepare(fold); },
                           .run =
                               [&](std::size_t fold, std::size_t walk) {
                                 evaluation_.walks[walk] =
                                     RunWalk(walk_options_, folds_[fold].site, estimators_[fold],
                                             walks_[walk], evaluation_.walks[walk].fold);
                                 progress.Done(walks_[walk].file.id);
                               },
                           .release =
                               [&](std::size_t fold) {
                                 folds_[fold] = Fold();
                                 estimators_[fold].clear();
                               }};
    RunFolds(options_.workers, walks_of_fold_, jobs, options_.stopped);
  }

  void Prepare(std::size_t fold) {
    const Clock::time_point begin = Clock::now();
    std::vector<const LoadedWalk*> training, test;
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      const bool held_out =
          i < test_count_ && static_cast<std::size_t>(evaluation_.walks[i].fold) == fold;
      (held_out ? test : training).push_back(&walks_[i]);
    }
    folds_[fold] = PrepareFold(building_, training, test, options_.overrides);
    estimators_[fold] = MakeEstimators(options_.methods, folds_[fold].settings);
    run_.calibrated[fold] = ChangedValues(run_.settings, folds_[fold].settings);
    LOG(INFO) << "fold " << fold << ": " << training.size() << " walks to train on, "
              << SecondsSince(begin) << " s";
  }

  int Finish() {
    std::map<int, std::string> floor_names;
    for (const Floor& floor : building_.floors) floor_names[floor.number] = floor.name;
    const std::vector<SummarySection> sections = SummariseEvaluation(evaluation_, floor_names);
    run_.split = options_.dataset.empty() ? "train/test" : options_.split_name;
    run_.folds = static_cast<int>(walks_of_fold_.size());
    run_.floor_given = options_.floor_given;
    WriteFileWhole(options_.out + "/scores.csv", FormatScoresCsv(evaluation_));
    WriteFileWhole(options_.out + "/building.json", FormatBuildingJson(building_));
    WriteFileWhole(options_.out + "/summary.json", FormatSummaryJson(evaluation_, sections, run_));
    WriteTimings(options_.out + "/run", evaluation_);
    std::fputs(FormatSummary(sections, SecondsPerWalk(evaluation_)).c_str(), stdout);
    return ExitCode();
  }

  int ExitCode() const {
    if (options_.stopped()) return kExitInterrupted;
    return AnyTrajectory(evaluation_) ? kExitOk : kExitNoTrajectory;
  }

  std::string ProgressLog() const { return options_.out + "/run/progress"; }

  const EvaluateOptions& options_;
  RunDescription run_;
  Building building_;
  std::vector<WalkFile> files_;  // walks to test, then walks only to train on
  std::size_t test_count_ = 0;
  std::vector<LoadedWalk> walks_;
  std::vector<std::vector<std::size_t>> walks_of_fold_;
  std::vector<Fold> folds_;
  std::vector<std::vector<std::unique_ptr<Estimator>>> estimators_;  // by fold
  Evaluation evaluation_;
  WalkRunOptions walk_options_;
};

}  // namespace

int EvaluateDataset(const EvaluateOptions& options) { return EvaluationRun(options).Run(); }

}  // namespace walkgraph
