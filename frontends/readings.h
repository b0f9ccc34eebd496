#ifndef WALKGRAPH_FRONTENDS_READINGS_H_
#define WALKGRAPH_FRONTENDS_READINGS_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "data/recording.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Every reading once, at the time it was heard, with the time of its first printing; by heard_ns,
// then transmitter. A reading is known by its transmitter and heard_ns: later printings are counted
// as "<radio>_repeat". Those heard before the recording began are dropped and counted as
// "<radio>_before_begin". A reading printed before it was heard (clocks that disagree) takes the
// time of printing and is counted as "<radio>_heard_after_printed".
std::vector<RadioReading> UniqueReadings(const Recording& recording,
                                         std::map<std::string, std::int64_t>* counts);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_READINGS_H_
