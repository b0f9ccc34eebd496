#include "graph/motion_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace walkgraph {
namespace {

struct Span {
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
  double seconds() const { return SecondsBetween(begin_ns, end_ns); }
};

double OverlapSeconds(const Span& a, TimeNs begin_ns, TimeNs end_ns) {
  return std::max(0.0, SecondsBetween(std::max(a.begin_ns, begin_ns), std::min(a.end_ns, end_ns)));
}

// Seconds of the span in which the person stood or handled the phone.
double StillSeconds(const Span& span, const Evidence& evidence) {
  double seconds = 0;
  for (const MotionInterval& interval : evidence.motion) {
    if (interval.state == MotionState::kWalking) continue;
    seconds += OverlapSeconds(span, interval.begin_ns, interval.end_ns);
  }
  return seconds;
}

// What the steps from index `first` on say about the span.
struct StepSum {
  double length_m = 0;
  double steps = 0;    // fractions of steps
  double seconds = 0;  // covered
};
StepSum SumSteps(const Span& span, const std::vector<StepEvidence>& steps, std::size_t first) {
  StepSum sum;
  for (std::size_t i = first; i < steps.size() && steps[i].begin_ns < span.end_ns; ++i) {
    const double duration = SecondsBetween(steps[i].begin_ns, steps[i].end_ns);
    const double overlap = OverlapSeconds(span, steps[i].begin_ns, steps[i].end_ns);
    if (overlap <= 0 || duration <= 0) continue;
    sum.length_m += steps[i].length_m * overlap / duration;
    sum.steps += overlap / duration;
    sum.seconds += overlap;
  }
  return sum;
}

double UnsteppedVariance(const Span& span, double stepped_s, const Evidence& evidence,
                         const StandingSettings& settings) {
  const double rest_s = std::max(0.0, span.seconds() - stepped_s);
  const double still_s = settings.enabled ? std::min(rest_s, StillSeconds(span, evidence)) : 0.0;
  const double unseen_m = settings.unseen_mps * (rest_s - still_s);
  return settings.sigma_mps * settings.sigma_mps * still_s + unseen_m * unseen_m;
}

}  // namespace

std::vector<NodeMotion> MotionBetweenNodes(const std::vector<TimeNs>& nodes_ns,
                                           const Evidence& evidence,
                                           const FactorSettings& settings) {
  std::vector<NodeMotion> motions;
  std::size_t first_step = 0;
  for (std::size_t i = 1; i < nodes_ns.size(); ++i) {
    const Span span{nodes_ns[i - 1], nodes_ns[i]};
    StepSum steps;
    if (settings.step.enabled) {
      while (first_step < evidence.steps.size() &&
             evidence.steps[first_step].end_ns <= span.begin_ns) {
        ++first_step;
      }
      steps = SumSteps(span, evidence.steps, first_step);
    }
    const double rest = UnsteppedVariance(span, steps.seconds, evidence, settings.standing);
    const double along = settings.step.sigma_along_m, across = settings.step.sigma_across_m;
    motions.push_back({steps.length_m, std::sqrt(along * along * steps.steps + rest),
                       std::sqrt(across * across * steps.steps + rest), steps.steps > 0});
  }
  return motions;
}

}  // namespace walkgraph
