#ifndef WALKGRAPH_EVAL_PROGRESS_H_
#define WALKGRAPH_EVAL_PROGRESS_H_

#include <chrono>
#include <mutex>
#include <string>

namespace walkgraph {

// Tells on standard error how far a run is: a bar that redraws itself on a terminal, elsewhere a
// plain line at each tenth of the way, both with the time left at the mean speed so far. Also
// appends the lines to a file, if one is named.
class Progress {
 public:
  // `what` is the unit with the total before it: "walks".
  Progress(int total, std::string what, std::string log_path);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // One more is done; from any thread.
  void Done(const std::string& name);

 private:
  std::string TimeLeft() const;
  void Draw(const std::string& name) const;
  void Log(const std::string& line) const;

  const int total_;
  const std::string what_;
  const std::string log_path_;
  const bool terminal_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  int done_ = 0;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_PROGRESS_H_
