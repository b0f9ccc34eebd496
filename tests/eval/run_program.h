#ifndef WALKGRAPH_TESTS_EVAL_RUN_PROGRAM_H_
#define WALKGRAPH_TESTS_EVAL_RUN_PROGRAM_H_

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace walkgraph {

struct ProgramResult {
  int exit_code = -1;  // -1 where a signal ended it
  std::string output;  // standard output and error together
};

// Runs the walkgraph program. `on_output` is called with its process id and all output so far
// whenever some more has come.
inline ProgramResult RunWalkgraph(
    const std::vector<std::string>& arguments,
    const std::function<void(pid_t, const std::string&)>& on_output = nullptr) {
  std::vector<char*> words;
  std::string program = WALKGRAPH_BINARY;
  std::vector<std::string> copies = arguments;
  words.push_back(program.data());
  for (std::string& argument : copies) words.push_back(argument.data());
  words.push_back(nullptr);

  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("pipe");
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    execv(program.c_str(), words.data());
    _exit(127);
  }
  close(ends[1]);
  ProgramResult result;
  std::array<char, 4096> buffer;
  for (ssize_t n = 0; (n = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    result.output.append(buffer.data(), static_cast<std::size_t>(n));
    if (on_output) on_output(child, result.output);
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

// A path below the test's own temporary folder at which nothing exists.
inline std::string FreshPath(const std::string& name) {
  const std::string path = testing::TempDir() + "/walkgraph_" + std::to_string(getpid()) + "_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
                           name;
  std::filesystem::remove_all(path);
  return path;
}

inline std::string ReadText(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Every file below a result folder by its relative path, without run/.
inline std::map<std::string, std::string> ResultFiles(const std::string& dir) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(dir)) {
    const std::string name = std::filesystem::relative(entry.path(), dir).string();
    if (entry.is_regular_file() && name.compare(0, 4, "run/") != 0) {
      files[name] = ReadText(entry.path().string());
    }
  }
  return files;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_EVAL_RUN_PROGRAM_H_
