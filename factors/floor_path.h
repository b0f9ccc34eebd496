#ifndef WALKGRAPH_FACTORS_FLOOR_PATH_H_
#define WALKGRAPH_FACTORS_FLOOR_PATH_H_

#include <utility>
#include <vector>

#include "data/time.h"

namespace walkgraph {

// A time on one level, both ends included.
struct FloorStay {
  int floor = 0;
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
};

// On which floor a walk is when. Between two stays the person is on the way from level to level.
class FloorPath {
 public:
  // One floor all the time. Implicit: a walk whose floor is known is the usual case.
  FloorPath(int floor);  // NOLINT(google-explicit-constructor)
  // Throws std::invalid_argument unless there is a stay and they are in order of time without
  // overlap.
  explicit FloorPath(std::vector<FloorStay> stays);

  const std::vector<FloorStay>& stays() const { return stays_; }
  // The floor of the stay at a time, or of the nearest one (of equally near ones the earlier).
  int At(TimeNs time_ns) const;
  // Whether a time belongs to a stay.
  bool OnLevel(TimeNs time_ns) const;
  // The floors of the stays before and after a time on the way between them; elsewhere At() twice.
  std::pair<int, int> Between(TimeNs time_ns) const;
  // Each floor once, ascending.
  std::vector<int> Floors() const;
  // The floor of the longest stay.
  int Main() const;

 private:
  const FloorStay& Nearest(TimeNs time_ns) const;

  std::vector<FloorStay> stays_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_FLOOR_PATH_H_
