#ifndef WALKGRAPH_EVAL_FILES_H_
#define WALKGRAPH_EVAL_FILES_H_

#include <cstdint>
#include <string>

namespace walkgraph {

// Writes `content` beside `path` and renames it into place, so that a killed run leaves the old
// file or the new one, never half of either. Creates missing folders. Throws std::runtime_error
// with the path and the system's reason.
void WriteFileWhole(const std::string& path, const std::string& content);

// Makes `dir` ready for results: creates it with an empty run/ inside, removing the results of an
// earlier run. A folder that holds anything else is left alone: throws UsageError.
void PrepareResultFolder(const std::string& dir);

// FNV-1a hash of a file's bytes as 16 hexadecimal digits. Throws InputError where it cannot be
// read.
std::string FileChecksum(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_FILES_H_
