#ifndef WALKGRAPH_TESTS_DATA_TEMPORARY_FOLDER_H_
#define WALKGRAPH_TESTS_DATA_TEMPORARY_FOLDER_H_

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace walkgraph {

// A fresh folder that disappears with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    // mkdtemp() replaces the six letters at the end.
    std::string pattern = testing::TempDir() + "walkgraph_" + std::string(6, 'X');
    if (mkdtemp(pattern.data()) == nullptr) ADD_FAILURE() << "no folder " << pattern;
    path_ = pattern;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string Path(const std::string& name = "") const { return path_ / name; }

  // Makes the folders on the way.
  void Write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_DATA_TEMPORARY_FOLDER_H_
