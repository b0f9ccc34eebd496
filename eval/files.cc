#include "eval/files.h"

#include <algorithm>
#include <array>
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
constexpr std::array<std::string_view, 7> kResultEntries = {
    "run", "trajectories", "states", "walks", "scores.csv", "summary.json", "building.json"};

bool IsResultEntry(const std::string& name) {
  return std::find(kResultEntries.begin(), kResultEntries.end(), name) != kResultEntries.end();
}

}  // namespace

void WriteFileWhole(const std::string& path, const std::string& content) {
  const fs::path target(path);
  if (target.has_parent_path()) fs::create_directories(target.parent_path());
  const std::string temporary = path + ".tmp";
  {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) {
      const std::string reason = std::strerror(errno);
      std::remove(temporary.c_str());
      throw std::runtime_error(path + ": cannot be written: " + reason);
    }
  }
  fs::rename(temporary, target);
}

void PrepareResultFolder(const std::string& dir) {
  std::vector<fs::path> earlier;
  if (fs::exists(dir)) {
    if (!fs::is_directory(dir)) throw UsageError("--out=" + dir + " is a file, expected a folder");
    for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
      const std::string name = entry.path().filename().string();
      if (!IsResultEntry(name)) {
        throw UsageError("--out=" + dir + " holds \"" + name +
                         "\", expected a new folder or one with results of an earlier run");
      }
      earlier.push_back(entry.path());
    }
  }
  for (const fs::path& path : earlier) fs::remove_all(path);
  fs::create_directories(fs::path(dir) / "run");
}

std::string FileChecksum(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, 0, "cannot be read", "a file");
  std::uint64_t hash = HashText("");
  std::vector<char> block(1 << 16);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash = HashText(std::string_view(block.data(), static_cast<std::size_t>(in.gcount())), hash);
  }
  std::array<char, 17> text;
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace walkgraph
