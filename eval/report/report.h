#ifndef WALKGRAPH_EVAL_REPORT_REPORT_H_
#define WALKGRAPH_EVAL_REPORT_REPORT_H_

#include <string>
#include <vector>

namespace walkgraph {

// Writes one HTML page that needs nothing else (no network, no other file) from the result folders
// of `walkgraph evaluate` or `smooth`: the score table of summary.json, the distribution of errors,
// and every walk of walks/ and trajectories/ drawn on building.json, floor plans embedded. What a
// folder does not have is left out; building.json it must have. Equal input gives equal bytes.
// Throws InputError on a folder or file that cannot be read. Folders of several runs must have been
// made by one version from the same inputs: UsageError names what differs, unless
// `allow_differences`. Beside the page, in a folder of its name without extension, go the figures
// as SVG and the tables as CSV, JSON, Markdown and LaTeX.
void WriteReport(const std::vector<std::string>& result_dirs, const std::string& out_file,
                 bool allow_differences = false);

// The same for one walk of one folder: why it came out as it did (see ExplainWalk). Throws
// UsageError where the folder has no such walk.
void WriteWalkReport(const std::string& result_dir, const std::string& walk,
                     const std::string& out_file);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_REPORT_H_
