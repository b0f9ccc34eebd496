#include "eval/progress.h"

#include <unistd.h>

#include <cmath>
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

std::string Progress::TimeLeft() const {
  using Seconds = std::chrono::duration<double>;
  const double elapsed_s = Seconds(std::chrono::steady_clock::now() - begin_).count();
  const auto left_s = static_cast<long>(std::lround(elapsed_s * (total_ - done_) / done_));
  if (left_s < 60) return std::to_string(left_s) + " s left";
  const long minutes = left_s / 60;
  if (minutes < 60) return std::to_string(minutes) + " min left";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min left";
}

void Progress::Done(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  const std::string line = std::to_string(done_) + " of " + std::to_string(total_) + " " + what_ +
                           " done: " + name + (done_ < total_ ? ", " + TimeLeft() : "");
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
  std::fprintf(stderr, "\r[%s] %d/%d %s, %s  %.40s\033[K", bar.c_str(), done_, total_,
               what_.c_str(), TimeLeft().c_str(), name.c_str());
}

void Progress::Log(const std::string& line) const {
  if (log_path_.empty()) return;
  std::ofstream(log_path_, std::ios::app) << line << "\n";
}

}  // namespace walkgraph
