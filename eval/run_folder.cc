#include "eval/run_folder.h"

#include <glog/logging.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "eval/files.h"
#include "eval/table.h"
#include "eval/version.h"

namespace walkgraph {
namespace {

std::string DateUtc() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text;
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

std::string ProcessorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, 10, "model name") != 0) continue;
    const std::size_t colon = line.find(": ");
    return colon == std::string::npos ? line : line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

void LogToRunFolder(const std::string& run) {
  google::SetLogDestination(google::GLOG_INFO, (run + "/log.").c_str());
}

void WriteRunDescription(const std::string& run, const std::string& command_line, int workers) {
  utsname system{};
  uname(&system);
  const double memory_gb = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-9;
  const nlohmann::ordered_json machine = {{"date", DateUtc()},
                                          {"version", Version()},
                                          {"host", system.nodename},
                                          {"system", system.release},
                                          {"architecture", system.machine},
                                          {"processor", ProcessorName()},
                                          {"cores", std::thread::hardware_concurrency()},
                                          {"memory_gb", memory_gb},
                                          {"workers", workers},
                                          {"compiler", __VERSION__}};
  WriteFileWhole(run + "/machine.json", machine.dump(1) + "\n");
  WriteFileWhole(run + "/command.txt", command_line + "\n");
}

void WriteTimings(const std::string& run, const Evaluation& evaluation) {
  std::string text = "walk,method,seconds\n";
  for (const WalkOutcome& walk : evaluation.walks) {
    if (!walk.finished) continue;
    for (std::size_t i = 0; i < evaluation.methods.size(); ++i) {
      text += walk.walk + "," + evaluation.methods[i] + "," +
              FixedDecimals(walk.methods[i].seconds, 6) + "\n";
    }
  }
  WriteFileWhole(run + "/timings.csv", text);
}

std::map<std::string, double> SecondsPerWalk(const Evaluation& evaluation) {
  std::map<std::string, double> seconds;
  int walks = 0;
  for (const WalkOutcome& walk : evaluation.walks) {
    if (!walk.finished) continue;
    ++walks;
    for (std::size_t i = 0; i < evaluation.methods.size(); ++i) {
      seconds[evaluation.methods[i]] += walk.methods[i].seconds;
    }
  }
  for (auto& [method, total] : seconds) total /= walks;
  return seconds;
}

}  // namespace walkgraph
