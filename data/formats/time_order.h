#ifndef WALKGRAPH_DATA_FORMATS_TIME_ORDER_H_
#define WALKGRAPH_DATA_FORMATS_TIME_ORDER_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "data/read_report.h"
#include "data/time.h"

namespace walkgraph {

// Samples that arrive later than this behind their neighbours are not late but wrong.
inline constexpr TimeNs kReorderWindowNs = kNsPerSecond;

enum class EqualTimes { kDrop, kKeep };

// The samples to keep, as indices in order of time; nullopt where all are in order as they are.
//
// The largest set of samples whose times never run backwards is taken as right, so that one wild
// time costs one sample and not all that follow it. A sample outside that set is sorted into its
// place where it lies within kReorderWindowNs of its neighbours in the file (hazard "reordered"),
// and dropped otherwise ("backward_time"). Among equal times the first in the file stays where the
// others are to be dropped ("duplicate_time").
std::optional<std::vector<std::uint32_t>> OrderByTime(const std::vector<TimeNs>& time_ns,
                                                      EqualTimes equal_times, ReadReport* report);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_TIME_ORDER_H_
