#ifndef WALKGRAPH_EVAL_REPORT_STUDY_REPORT_H_
#define WALKGRAPH_EVAL_REPORT_STUDY_REPORT_H_

#include <string>
#include <vector>

namespace walkgraph {

// Whether a folder holds results of `walkgraph ablate`.
bool IsStudyFolder(const std::string& dir);

// Merges the folders of a study's shards, or takes one alone, and writes the page `out_file` with
// tables and figures, and beside it a folder of the same name without extension with summary.json,
// tables/ (CSV, Markdown, LaTeX) and figures/ (SVG). The page needs no other file. Throws
// InputError where walks are missing, and UsageError where the folders differ in version, inputs or
// cells, unless `allow_differences`; then each walk comes from the first folder that has it.
void WriteStudyReport(const std::vector<std::string>& dirs, const std::string& out_file,
                      bool allow_differences);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_STUDY_REPORT_H_
