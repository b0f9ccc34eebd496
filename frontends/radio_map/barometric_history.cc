#include "frontends/radio_map/barometric_history.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace walkgraph {
namespace {

constexpr double kSigmaPerDeviation = 1.4826;  // of a normal: sigma over median deviation
constexpr double kLeastSigmaM = 0.1;           // a second's mean of a phone's barometer

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool KnowsHeights(const Building& building) {
  return std::any_of(building.floors.begin(), building.floors.end(), [&](const Floor& floor) {
    return floor.height_m != building.floors.front().height_m;
  });
}

// From the walk whose offset says most; of the one with index `left_out` nothing is known.
std::optional<OffsetPrior> Predict(const std::vector<SurveyedOffset>& history, TimeNs unix_ns,
                                   double walk_m_per_sqrt_s, std::size_t left_out = SIZE_MAX) {
  std::optional<OffsetPrior> best;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (i == left_out) continue;
    const double apart_s = std::abs(SecondsBetween(history[i].unix_ns, unix_ns));
    const double sigma_m = std::hypot(history[i].sigma_m, walk_m_per_sqrt_s * std::sqrt(apart_s));
    if (!best || sigma_m < best->sigma_m) best = {history[i].offset_m, sigma_m};
  }
  return best;
}

// Root mean square of the sigmas by which the walks miss what the others predict, at least 1:
// several phones of one model, or weather that changes faster, show here.
double Surprise(const std::vector<SurveyedOffset>& history, double walk_m_per_sqrt_s) {
  if (history.size() < 2) return 1;
  double squares = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto prior = Predict(history, history[i].unix_ns, walk_m_per_sqrt_s, i);
    const double sigma_m = std::hypot(prior->sigma_m, history[i].sigma_m);
    squares += std::pow((history[i].offset_m - prior->mean_m) / sigma_m, 2);
  }
  return std::max(1.0, std::sqrt(squares / static_cast<double>(history.size())));
}

}  // namespace

std::optional<SurveyedOffset> MeasureBarometricOffset(const Building& building,
                                                      const SurveyWalk& walk) {
  const Evidence& evidence = *walk.evidence;
  const Stream<double>& heights = evidence.barometric_height_m;
  if (walk.trajectory.empty() || evidence.device.empty() || !evidence.begin_unix_ns ||
      !KnowsHeights(building)) {
    return std::nullopt;
  }
  std::vector<double> offsets;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights.time_ns[i] < walk.trajectory.poses.front().time_ns ||
        heights.time_ns[i] > walk.trajectory.poses.back().time_ns) {
      continue;
    }
    const Floor* floor = building.FindFloor(walk.trajectory.At(heights.time_ns[i]).floor);
    if (floor != nullptr) offsets.push_back(heights.value[i] - floor->height_m);
  }
  if (offsets.empty()) return std::nullopt;
  const double offset_m = Median(offsets);
  for (double& offset : offsets) offset = std::abs(offset - offset_m);
  const TimeNs middle_ns = (evidence.end_ns - evidence.begin_ns) / 2;
  return SurveyedOffset{evidence.device, *evidence.begin_unix_ns + middle_ns, offset_m,
                        std::max(kLeastSigmaM, kSigmaPerDeviation * Median(offsets))};
}

std::optional<OffsetPrior> PriorOfOffset(const std::vector<SurveyedOffset>& history,
                                         const Evidence& evidence, double walk_m_per_sqrt_s) {
  if (!evidence.begin_unix_ns) return std::nullopt;
  std::vector<SurveyedOffset> same;
  std::copy_if(history.begin(), history.end(), std::back_inserter(same),
               [&](const SurveyedOffset& offset) { return offset.device == evidence.device; });
  std::optional<OffsetPrior> prior = Predict(same, *evidence.begin_unix_ns, walk_m_per_sqrt_s);
  if (prior) prior->sigma_m *= Surprise(same, walk_m_per_sqrt_s);
  return prior;
}

}  // namespace walkgraph
