#include "eval/progress.h"

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <fstream>

namespace walkgraph {
namespace {

constexpr int kBarWidth = 30;
constexpr int kPlainLines = 10;

}  // namespace

Progress::Progress(int total, std::string what, std::string log_path)
    : total_(total),
      what_(std::move(what)),
      log_path_(std::move(log_path)),
      terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_ && done_ > 0) std::fputs("\n", stderr);
}

void Progress::Done(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  const std::string line =
      std::to_string(done_) + " of " + std::to_string(total_) + " " + what_ + " done: " + name;
  Log(line);
  if (terminal_) {
    Draw(name);
  } else if (done_ == total_ ||
             done_ * kPlainLines / total_ != (done_ - 1) * kPlainLines / total_) {
    std::fprintf(stderr, "%s\n", line.c_str());
  }
}

void Progress::Draw(const std::string& name) const {
  const std::size_t filled = static_cast<std::size_t>(kBarWidth * done_ / total_);
  std::string bar(filled, '#');
  bar.resize(kBarWidth, '.');
  // "\033[K" clears what a longer name left behind.
  std::fprintf(stderr, "\r[%s] %d/%d %s  %.40s\033[K", bar.c_str(), done_, total_, what_.c_str(),
               name.c_str());
}

void Progress::Log(const std::string& line) const {
  if (log_path_.empty()) return;
  std::ofstream(log_path_, std::ios::app) << line << "\n";
}

}  // namespace walkgraph
