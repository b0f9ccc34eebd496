#include "data/formats/time_order.h"

#include <algorithm>
#include <cstdlib>

namespace walkgraph {
namespace {

bool InOrder(const std::vector<TimeNs>& time_ns, EqualTimes equal_times) {
  for (std::size_t i = 1; i < time_ns.size(); ++i) {
    if (time_ns[i] < time_ns[i - 1]) return false;
    if (time_ns[i] == time_ns[i - 1] && equal_times == EqualTimes::kDrop) return false;
  }
  return true;
}

// Marks a longest subsequence of times that never run backwards (patience sorting, O(n log n)).
std::vector<bool> LongestOrderedSubsequence(const std::vector<TimeNs>& time_ns) {
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> tail;  // tail[k]: where the best subsequence of length k + 1 ends
  std::vector<std::uint32_t> before(time_ns.size(), kNone);
  for (std::uint32_t i = 0; i < time_ns.size(); ++i) {
    const auto at = std::upper_bound(
        tail.begin(), tail.end(), time_ns[i],
        [&time_ns](TimeNs time, std::uint32_t index) { return time < time_ns[index]; });
    if (at != tail.begin()) before[i] = *(at - 1);
    if (at == tail.end()) {
      tail.push_back(i);
    } else {
      *at = i;
    }
  }
  std::vector<bool> member(time_ns.size(), false);
  for (std::uint32_t i = tail.empty() ? kNone : tail.back(); i != kNone; i = before[i]) {
    member[i] = true;
  }
  return member;
}

// Whether a sample outside the subsequence is merely late or early: close in time to the members
// that stand around it in the file.
std::vector<bool> CloseToNeighbours(const std::vector<TimeNs>& time_ns,
                                    const std::vector<bool>& member) {
  std::vector<bool> close(time_ns.size(), false);
  const auto sweep = [&](std::size_t i, std::optional<TimeNs>* neighbour) {
    if (member[i]) {
      *neighbour = time_ns[i];
    } else if (*neighbour && std::llabs(time_ns[i] - **neighbour) <= kReorderWindowNs) {
      close[i] = true;
    }
  };
  std::optional<TimeNs> before;
  for (std::size_t i = 0; i < time_ns.size(); ++i) sweep(i, &before);
  std::optional<TimeNs> after;
  for (std::size_t i = time_ns.size(); i-- > 0;) sweep(i, &after);
  return close;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> OrderByTime(const std::vector<TimeNs>& time_ns,
                                                      EqualTimes equal_times, ReadReport* report) {
  if (InOrder(time_ns, equal_times)) return std::nullopt;
  const std::vector<bool> member = LongestOrderedSubsequence(time_ns);
  const std::vector<bool> close = CloseToNeighbours(time_ns, member);
  std::vector<std::uint32_t> order;
  order.reserve(time_ns.size());
  for (std::uint32_t i = 0; i < time_ns.size(); ++i) {
    if (member[i] || close[i]) order.push_back(i);
    if (!member[i]) ++report->hazards[close[i] ? "reordered" : "backward_time"];
  }
  std::stable_sort(order.begin(), order.end(), [&time_ns](std::uint32_t a, std::uint32_t b) {
    return time_ns[a] < time_ns[b];
  });
  if (equal_times == EqualTimes::kDrop) {
    const auto unique_end = std::unique(
        order.begin(), order.end(),
        [&time_ns](std::uint32_t a, std::uint32_t b) { return time_ns[a] == time_ns[b]; });
    const auto dropped = order.end() - unique_end;
    if (dropped > 0) report->hazards["duplicate_time"] += dropped;
    order.erase(unique_end, order.end());
  }
  return order;
}

}  // namespace walkgraph
