#include "data/simulator/walk_truth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace walkgraph {
namespace {

constexpr double kLevelM = 0.05;  // rounded edges of stairs are lower

bool OnLevel(const Plan& plan, const WalkState& state) {
  const double level_m = plan.HeightOf(plan.FloorAt(state.height_m));
  return std::abs(state.height_m - level_m) < kLevelM;
}

// When the person is in the middle of a turn or between two legs.
std::vector<TimeNs> TurnTimes(const std::vector<Leg>& legs, const std::vector<WalkState>& states) {
  std::vector<TimeNs> times;
  double leg_begin_m = 0;
  auto state = states.begin();
  for (const Leg& leg : legs) {
    for (const double turn_m : leg.route.turns_m()) {
      state = std::find_if(state, states.end(), [&](const WalkState& candidate) {
        return candidate.distance_m >= leg_begin_m + turn_m;
      });
      if (state == states.end()) return times;
      times.push_back(state->time_ns);
    }
    leg_begin_m += leg.route.length_m();
  }
  return times;
}

}  // namespace

Truth MakeTruth(const Plan& plan, const std::vector<Leg>& legs,
                const std::vector<WalkState>& states, TimeNs first_ns, double every_s) {
  std::vector<TimeNs> times = TurnTimes(legs, states);
  times.push_back(first_ns);
  times.push_back(states.back().time_ns);
  std::sort(times.begin(), times.end());
  Truth truth;
  TimeNs last_ns = first_ns;
  std::size_t next = 0;
  for (const WalkState& state : states) {
    const bool due = next < times.size() && state.time_ns >= times[next];
    const bool long_ago = SecondsBetween(last_ns, state.time_ns) >= every_s;
    if ((!due && !long_ago) || !OnLevel(plan, state)) continue;
    while (next < times.size() && state.time_ns >= times[next]) ++next;
    truth.waypoints.push_back({state.time_ns, state.position_m, plan.FloorAt(state.height_m)});
    last_ns = state.time_ns;
  }
  return truth;
}

}  // namespace walkgraph
