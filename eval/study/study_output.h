#ifndef WALKGRAPH_EVAL_STUDY_STUDY_OUTPUT_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_OUTPUT_H_

#include <string>
#include <vector>

#include "eval/study/study_statistics.h"

namespace walkgraph {

// summary.json of a study: {"version", "split", "folds", "floor_given", "reference", "datasets":
// {name: {"walks", "sections": {section: {cell: {...}}}, "breakdown": [...], "contributions":
// {factor: {"removes_m", "interval_m"}}, "status": {cell: {status: walks}}}}}. A number that does
// not exist is null.
std::string FormatStudySummary(const StudyRecord& record,
                               const std::vector<DatasetStatistics>& statistics);

// A p-value as tables show it: none is nought.
std::string FormatP(double p);

// Writes summary.json and tables/{cells,breakdown,contributions}.{csv,md,tex} into `dir`.
void WriteStudyTables(const std::string& dir, const StudyRecord& record,
                      const std::vector<DatasetStatistics>& statistics);

// Where every walk of the study is there, writes the above and prints the table of cells; else says
// how much is missing. Returns an exit code.
int FinishStudy(const std::string& dir, const StudyRecord& record);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_OUTPUT_H_
