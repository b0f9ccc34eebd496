#include "eval/files.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "data/input_error.h"
#include "eval/random.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

// Everything that a run writes into its folder.
const std::vector<std::string> kResultEntries = {"run",          "trajectories", "states",
                                                 "explain",      "walks",        "scores.csv",
                                                 "summary.json", "building.json"};
// What `report` adds to a folder of results that has the page's name; anybody's names elsewhere.
const std::vector<std::string> kReportEntries = {"tables", "figures"};

std::string HexDigits(std::uint64_t hash) {
  std::array<char, 17> text;
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

std::uint64_t HashFile(const std::string& path, std::uint64_t hash) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, 0, "cannot be read", "a file");
  std::vector<char> block(1 << 16);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash = HashText(std::string_view(block.data(), static_cast<std::size_t>(in.gcount())), hash);
  }
  return hash;
}

void WriteAndRename(const std::string& temporary, const std::string& path,
                    const std::string& content) {
  const fs::path target(path);
  if (target.has_parent_path()) fs::create_directories(target.parent_path());
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) {
    const std::string reason = std::strerror(errno);
    std::remove(temporary.c_str());
    throw std::runtime_error(path + ": cannot be written: " + reason);
  }
  fs::rename(temporary, target);
}

}  // namespace

void WriteFileWhole(const std::string& path, const std::string& content) {
  WriteAndRename(path + ".tmp", path, content);
}

void WriteFileWholeVia(const std::string& scratch, const std::string& path,
                       const std::string& content) {
  static std::atomic<int> count{0};
  utsname system{};
  uname(&system);  // processes of several machines may share the folder
  const std::string temporary = scratch + "/" + system.nodename + "." + std::to_string(getpid()) +
                                "." + std::to_string(count++) + ".tmp";
  fs::create_directories(scratch);
  WriteAndRename(temporary, path, content);
}

void PrepareResultFolder(const std::string& dir) {
  std::vector<std::string> entries = kResultEntries;
  if (fs::exists(fs::path(dir) / "run")) {
    entries.insert(entries.end(), kReportEntries.begin(), kReportEntries.end());
  }
  const std::string occupied = WhyOccupied(dir, entries);
  if (!occupied.empty()) throw UsageError(occupied);
  for (const std::string& name : entries) fs::remove_all(fs::path(dir) / name);
  fs::create_directories(fs::path(dir) / "run");
}

std::string WhyOccupied(const std::string& dir, const std::vector<std::string>& allowed) {
  if (!fs::exists(dir)) return "";
  if (!fs::is_directory(dir)) return "--out=" + dir + " is a file, expected a folder";
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    const std::string name = entry.path().filename().string();
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
    return "--out=" + dir + " holds \"" + name +
           "\", expected a new folder or one with results of an earlier run";
  }
  return "";
}

std::string TextChecksum(std::string_view text) { return HexDigits(HashText(text)); }

std::string FileChecksum(const std::string& path) {
  std::uint64_t hash = HashText("");
  if (!fs::is_directory(path)) return HexDigits(HashFile(path, hash));
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    hash = HashText(file.lexically_relative(path).string(), hash);
    hash = HashFile(file.string(), hash);
  }
  return HexDigits(hash);
}

}  // namespace walkgraph
