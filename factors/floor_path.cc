#include "factors/floor_path.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace walkgraph {
namespace {

// A quarter of the range, so that differences of times stay representable.
constexpr TimeNs kForeverNs = std::numeric_limits<TimeNs>::max() / 4;

TimeNs Apart(const FloorStay& stay, TimeNs time_ns) {
  return std::max<TimeNs>({0, stay.begin_ns - time_ns, time_ns - stay.end_ns});
}

}  // namespace

FloorPath::FloorPath(int floor) : stays_{{floor, -kForeverNs, kForeverNs}} {}

FloorPath::FloorPath(std::vector<FloorStay> stays) : stays_(std::move(stays)) {
  if (stays_.empty()) throw std::invalid_argument("a floor path without a stay");
  for (std::size_t i = 0; i < stays_.size(); ++i) {
    const bool ordered = i == 0 || stays_[i - 1].end_ns < stays_[i].begin_ns;
    if (stays_[i].end_ns < stays_[i].begin_ns || !ordered) {
      throw std::invalid_argument("stays on floors that are not in order of time");
    }
  }
}

const FloorStay& FloorPath::Nearest(TimeNs time_ns) const {
  return *std::min_element(stays_.begin(), stays_.end(),
                           [time_ns](const FloorStay& a, const FloorStay& b) {
                             return Apart(a, time_ns) < Apart(b, time_ns);
                           });
}

int FloorPath::At(TimeNs time_ns) const { return Nearest(time_ns).floor; }

bool FloorPath::OnLevel(TimeNs time_ns) const { return Apart(Nearest(time_ns), time_ns) == 0; }

std::pair<int, int> FloorPath::Between(TimeNs time_ns) const {
  const auto next = std::find_if(stays_.begin(), stays_.end(), [time_ns](const FloorStay& stay) {
    return stay.end_ns >= time_ns;
  });
  if (next == stays_.end()) return {stays_.back().floor, stays_.back().floor};
  const bool on_the_way = next->begin_ns > time_ns && next != stays_.begin();
  return {on_the_way ? (next - 1)->floor : next->floor, next->floor};
}

std::vector<int> FloorPath::Floors() const {
  std::set<int> floors;
  for (const FloorStay& stay : stays_) floors.insert(stay.floor);
  return {floors.begin(), floors.end()};
}

int FloorPath::Main() const {
  return std::max_element(stays_.begin(), stays_.end(),
                          [](const FloorStay& a, const FloorStay& b) {
                            return a.end_ns - a.begin_ns < b.end_ns - b.begin_ns;
                          })
      ->floor;
}

}  // namespace walkgraph
