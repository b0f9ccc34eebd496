#ifndef WALKGRAPH_EVAL_FILES_H_
#define WALKGRAPH_EVAL_FILES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace walkgraph {

// Writes `content` beside `path` and renames it into place, so that a killed run leaves the old
// file or the new one, never half of either. Creates missing folders. Throws std::runtime_error
// with the path and the system's reason.
void WriteFileWhole(const std::string& path, const std::string& content);

// The same with the unfinished file in the folder `scratch`, on the same disk, under a name that no
// other process or thread takes: for files that several of them may write.
void WriteFileWholeVia(const std::string& scratch, const std::string& path,
                       const std::string& content);

// Makes `dir` ready for results: creates it with an empty run/ inside, removing the results of an
// earlier run. A folder that holds anything else is left alone: throws UsageError.
void PrepareResultFolder(const std::string& dir);

// What keeps `dir` from taking results: that it is a file, or a folder that holds anything but
// `allowed`. Empty where nothing does.
std::string WhyOccupied(const std::string& dir, const std::vector<std::string>& allowed);

// FNV-1a hash of a text as 16 hexadecimal digits.
std::string TextChecksum(std::string_view text);

// FNV-1a hash of a file's bytes as 16 hexadecimal digits; of a folder, that of the names and bytes
// of all files in it. Throws InputError where it cannot be read.
std::string FileChecksum(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_FILES_H_
