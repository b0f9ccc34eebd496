#include "frontends/radio_map/reading_lag.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "frontends/radio_map/map_calibration.h"
#include "frontends/radio_map/survey_scans.h"

namespace walkgraph {
namespace {

constexpr std::array kLadder{-0.75, 0.0, 0.75, 1.5, 2.25};
constexpr LagRange kRange{kLadder.front(), kLadder.back()};

// Clocks of one phone agree to about a second: keeps a survey that says nothing about the lag, such
// as one walked in a single direction, near none.
constexpr double kPriorSigmaS = 1.0;

using Scores = Eigen::Matrix<double, kLadder.size(), 1>;

// Scores are noisy by a few nats and the top is broad: all of the ladder has a say.
double TopOfParabola(const Scores& scores) {
  Eigen::Matrix<double, kLadder.size(), 3> powers;
  for (std::size_t l = 0; l < kLadder.size(); ++l) {
    powers.row(static_cast<Eigen::Index>(l)) << 1.0, kLadder[l], kLadder[l] * kLadder[l];
  }
  const Eigen::Vector3d fit = powers.colPivHouseholderQr().solve(scores);
  if (fit[2] < 0) return std::clamp(-0.5 * fit[1] / fit[2], kRange.first_s, kRange.last_s);
  Eigen::Index best = 0;
  scores.maxCoeff(&best);
  return kLadder[static_cast<std::size_t>(best)];
}

// How well the map of each floor places walks held out of it where every reading is where the
// person was that much later; nothing where no floor has enough walks.
std::optional<double> ScoreOfLag(double lag_s, const Building& building,
                                 const std::vector<SurveyWalk>& walks,
                                 const std::vector<std::vector<std::int32_t>>& site_index,
                                 const std::vector<SurveyPoint>& path, Radio radio,
                                 const TrainerSettings& settings) {
  std::map<int, std::vector<SurveyScan>> by_floor;
  for (std::size_t w = 0; w < walks.size(); ++w) {
    if (walks[w].trajectory.empty()) continue;
    for (SurveyScan& scan : PlaceScans(walks, w, radio, site_index[w], lag_s, kRange)) {
      by_floor[scan.floor].push_back(std::move(scan));
    }
  }
  std::optional<double> sum;
  for (const auto& [floor, scans] : by_floor) {
    FloorSurvey survey{floor, radio, {}, {}};
    survey.grid = CoveringGrid(building.FindFloor(floor), path, floor, settings);
    for (const SurveyScan& scan : scans) survey.scans.push_back(&scan);
    const std::optional<double> score = PlacementScore(survey, settings);
    if (score) sum = sum.value_or(0) + *score;
  }
  return sum;
}

}  // namespace

double CalibrateReadingLag(const Building& building, const std::vector<SurveyWalk>& walks,
                           const std::vector<std::vector<std::int32_t>>& site_index,
                           const std::vector<SurveyPoint>& path, Radio radio,
                           const TrainerSettings& settings, const Executor& run) {
  Scores scores;
  std::array<std::optional<double>, kLadder.size()> of_lag;
  run(kLadder.size(), [&](std::size_t l) {
    of_lag[l] = ScoreOfLag(kLadder[l], building, walks, site_index, path, radio, settings);
  });
  bool any = false;
  for (std::size_t l = 0; l < kLadder.size(); ++l) {
    const double sigmas = kLadder[l] / kPriorSigmaS;
    scores[static_cast<Eigen::Index>(l)] = of_lag[l].value_or(0) - 0.5 * sigmas * sigmas;
    any |= of_lag[l].has_value();
  }
  if (!any) return 0.0;
  return TopOfParabola(scores);
}

Evidence AlignReadings(const Site& site, Evidence evidence) {
  std::array<TimeNs, kRadioCount> lag_ns{};
  for (std::size_t r = 0; r < kRadioCount; ++r) lag_ns[r] = DurationNs(site.reading_lag_s[r]);
  for (RadioReading& reading : evidence.readings) {
    const auto radio = static_cast<std::size_t>(evidence.transmitters[reading.transmitter].radio);
    reading.heard_ns += lag_ns[radio];
    reading.printed_ns += lag_ns[radio];
  }
  std::stable_sort(
      evidence.readings.begin(), evidence.readings.end(),
      [](const RadioReading& a, const RadioReading& b) { return a.heard_ns < b.heard_ns; });
  return evidence;
}

}  // namespace walkgraph
