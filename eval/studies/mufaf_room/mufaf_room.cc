// The experiments of the MUFAF paper in its own protocol, simulated: a room of 28 cells with an
// anchor of every radio in each corner, routes of 90 steps, one a second. Prints Markdown tables on
// standard output; the same numbers every time.
//
//   mufaf_room [ROUTES]     routes per row (default 400; the paper: 1,000)
//
// Our choice, for the paper does not say: cells of 1 m, 7 x 4; path loss with shadowing whose
// correlation length is 1.5 m; the noise of a reading by radio, below; steps of 0.5 m.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "eval/metrics.h"
#include "room.h"
#include "solvers/baselines/mufaf/cell_map.h"
#include "solvers/baselines/mufaf/map_update.h"
#include "solvers/baselines/mufaf/tracking.h"

namespace walkgraph::mufaf_room {
namespace {

constexpr int kSurveySamples = 300;  // 5 minutes
constexpr int kScarceSamples = 50;   // what the update starts from

using Maps = std::vector<CellMap>;

Maps SurveyAll(Room* room, int samples) {
  Maps maps;
  for (std::size_t r = 0; r < kRadioTypes; ++r) maps.push_back(room->Survey(r, samples));
  return maps;
}

// Errors of one estimator of one radio over fresh routes, m.
std::vector<double> EstimateErrors(const CellMap& map, std::size_t radio, CellEstimator estimator,
                                   int routes, Room* room) {
  CellEstimatorSettings settings;
  settings.estimator = estimator;
  std::vector<double> errors;
  for (int i = 0; i < routes; ++i) {
    for (const Eigen::Vector2d& p : room->Route()) {
      errors.push_back((EstimatePosition(map, room->Hear(radio, p), settings) - p).norm());
    }
  }
  return errors;
}

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// One walker's position by one of the two fusions, step by step.
class Fusion {
 public:
  Fusion(bool track_to_track, std::vector<double> error_m)
      : track_to_track_(track_to_track), error_m_(std::move(error_m)) {}

  struct Position {
    Eigen::Vector2d fused_m, smoothed_m;  // before and after the alpha-beta filter
  };

  Position Advance(const std::vector<Eigen::Vector2d>& estimates) {
    std::vector<RadioFix> fixes;
    for (std::size_t r = 0; r < kRadioTypes; ++r) fixes.push_back({estimates[r], error_m_[r]});
    if (tracks_.empty()) {
      for (const RadioFix& fix : fixes) tracks_.push_back(BeginTrack(fix));
      if (!track_to_track_) tracks_ = {FuseTracks(tracks_)};
    } else if (track_to_track_) {
      for (std::size_t r = 0; r < kRadioTypes; ++r) {
        tracks_[r] = UpdateTrack(motion_.Predict(tracks_[r], 1), {fixes[r]});
      }
    } else {
      tracks_[0] = UpdateTrack(motion_.Predict(tracks_[0], 1), fixes);
    }
    const KalmanState<4> fused = FuseTracks(tracks_);
    return {fused.mean.head<2>(), smoothing_.Advance(fused.mean.head<2>(), 1)};
  }

 private:
  bool track_to_track_;
  std::vector<double> error_m_;
  ConstantVelocity motion_;
  std::vector<KalmanState<4>> tracks_;
  AlphaBetaFilter smoothing_{0.3};
};

// The mean error of every radio's estimates per axis, as its filter takes it: measured on 50
// routes.
std::vector<double> FixErrors(const Maps& maps, Room* room) {
  std::vector<double> errors;
  for (std::size_t r = 0; r < kRadioTypes; ++r) {
    errors.push_back(Mean(EstimateErrors(maps[r], r, CellEstimator::kExponential, 50, room)));
  }
  return errors;
}

void PrintEstimators(int routes) {
  std::printf("\nEstimators by radio, %d routes, mean (95th percentile), cm\n\n| estimator |",
              routes);
  for (const RoomRadio& radio : kRadios) std::printf(" %s |", radio.name);
  std::printf("\n|---|---|---|---|---|\n");
  Room room(1);
  const Maps maps = SurveyAll(&room, kSurveySamples);
  for (std::size_t e = 0; e < kCellEstimatorNames.size(); ++e) {
    std::printf("| %s |", std::string(kCellEstimatorNames[e]).c_str());
    for (std::size_t r = 0; r < kRadioTypes; ++r) {
      std::vector<double> errors =
          EstimateErrors(maps[r], r, static_cast<CellEstimator>(e), routes, &room);
      std::sort(errors.begin(), errors.end());
      std::printf(" %.1f (%.0f) |", 100 * Mean(errors), 100 * Quantile(errors, 0.95));
    }
    std::printf("\n");
  }
}

void PrintFusionByStep(int routes) {
  std::printf("\nFusions by step, %d routes, mean, cm\n\n", routes);
  std::printf("| fusion | steps 1-5 | 6-20 | 21-45 | 46-90 | all |\n|---|---|---|---|---|---|\n");
  constexpr int kEnds[] = {5, 20, 45, 90};
  for (const auto& [name, track_to_track, smoothed] :
       {std::tuple("TTTF, before the alpha-beta filter", true, false),
        {"TTTF", true, true},
        {"KSGF, before the alpha-beta filter", false, false},
        {"KSGF", false, true}}) {
    Room room(2);
    const Maps maps = SurveyAll(&room, kSurveySamples);
    const std::vector<double> fix_errors = FixErrors(maps, &room);
    std::vector<std::vector<double>> by_step(std::size(kEnds));
    std::vector<double> all;
    for (int i = 0; i < routes; ++i) {
      Fusion fusion(track_to_track, fix_errors);
      const std::vector<Eigen::Vector2d> route = room.Route();
      for (int s = 0; s < kSteps; ++s) {
        std::vector<Eigen::Vector2d> estimates;
        for (std::size_t r = 0; r < kRadioTypes; ++r) {
          estimates.push_back(EstimatePosition(
              maps[r], room.Hear(r, route[static_cast<std::size_t>(s)]), CellEstimatorSettings()));
        }
        const Fusion::Position position = fusion.Advance(estimates);
        all.push_back(((smoothed ? position.smoothed_m : position.fused_m) -
                       route[static_cast<std::size_t>(s)])
                          .norm());
        const auto range = std::upper_bound(std::begin(kEnds), std::end(kEnds), s) - kEnds;
        by_step[static_cast<std::size_t>(range)].push_back(all.back());
      }
    }
    std::printf("| %s |", name);
    for (const std::vector<double>& errors : by_step) std::printf(" %.1f |", 100 * Mean(errors));
    std::printf(" %.1f |\n", 100 * Mean(all));
  }
}

struct UpdateRun {
  double first_cm = 0, last_cm = 0;  // fused error over the first and the last 50 routes
  double map_db = 0;                 // rms error of the cells' means in the end
  double taken = 0;                  // share of the samples offered
};

// `walkers` walk at once and feed one map that begins with few samples.
UpdateRun RunUpdate(const MapUpdateSettings& settings, int walkers, int routes,
                    std::uint64_t seed) {
  Room room(seed);
  const Maps begin = SurveyAll(&room, kScarceSamples);
  const std::vector<double> fix_errors = FixErrors(begin, &room);
  std::vector<AdaptiveCellMap> maps;
  for (const CellMap& map : begin) maps.emplace_back(map, settings);
  const int window = std::min(50, routes / 2);
  std::vector<double> first, last;
  double offered = 0, taken = 0;
  for (int i = 0; i < routes; ++i) {
    std::vector<Fusion> fusions(static_cast<std::size_t>(walkers), Fusion(false, fix_errors));
    std::vector<std::vector<Eigen::Vector2d>> ways;
    for (int w = 0; w < walkers; ++w) ways.push_back(room.Route());
    for (std::size_t s = 0; s < kSteps; ++s) {
      for (std::size_t w = 0; w < ways.size(); ++w) {
        std::vector<Eigen::VectorXd> heard;
        std::vector<Eigen::Vector2d> estimates;
        for (std::size_t r = 0; r < kRadioTypes; ++r) {
          heard.push_back(room.Hear(r, ways[w][s]));
          estimates.push_back(EstimatePosition(maps[r].map(), heard[r], CellEstimatorSettings()));
        }
        const Eigen::Vector2d fused = fusions[w].Advance(estimates).smoothed_m;
        const double error = (fused - ways[w][s]).norm();
        if (i < window) first.push_back(error);
        if (i >= routes - window) last.push_back(error);
        for (std::size_t r = 0; r < kRadioTypes; ++r) {
          ++offered;
          taken += maps[r].Offer(fused, heard[r]) ? 1 : 0;
        }
      }
    }
  }
  double squares = 0;
  for (std::size_t r = 0; r < kRadioTypes; ++r) {
    for (Eigen::Index c = 0; c < kColumns * kRows; ++c) {
      const Eigen::Vector2d center = maps[r].map().centers_m()[static_cast<std::size_t>(c)];
      squares += (maps[r].map().mean_dbm().col(c) - room.Mean(r, center)).squaredNorm();
    }
  }
  const double entries = static_cast<double>(kRadioTypes) * kColumns * kRows * kAnchors;
  return {100 * Mean(first), 100 * Mean(last), std::sqrt(squares / entries), taken / offered};
}

void PrintUpdateRow(const std::string& name, const MapUpdateSettings& settings, int walkers,
                    int routes) {
  constexpr int kWorlds = 3;
  UpdateRun sum;
  for (std::uint64_t seed = 11; seed < 11 + kWorlds; ++seed) {
    const UpdateRun run = RunUpdate(settings, walkers, routes, seed);
    sum.first_cm += run.first_cm / kWorlds;
    sum.last_cm += run.last_cm / kWorlds;
    sum.map_db += run.map_db / kWorlds;
    sum.taken += run.taken / kWorlds;
  }
  std::printf("| %s | %.1f | %.1f | %.2f | %.1f %% |\n", name.c_str(), sum.first_cm, sum.last_cm,
              sum.map_db, 100 * sum.taken);
  std::fflush(stdout);
}

void PrintUpdateHeader(const char* title, const char* column, int routes) {
  std::printf("\n%s, %d routes in each of 3 worlds\n\n", title, routes);
  std::printf("| %s | first 50 routes, cm | last 50, cm | map in the end, dB rms | taken |\n",
              column);
  std::printf("|---|---|---|---|---|\n");
}

std::string Decimals(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

void PrintUpdates(int routes) {
  MapUpdateSettings settings;
  PrintUpdateHeader("Threshold mu of the kriging update, M = 6", "mu, dB", routes);
  settings.threshold_db = 0;
  PrintUpdateRow("nothing taken", settings, 1, routes);
  for (const double mu : {0.1, 0.5, 1.0, 1.3, 1.5, 1.8, 2.5, 3.5, 5.0}) {
    settings.threshold_db = mu;
    PrintUpdateRow(Decimals(mu), settings, 1, routes);
  }
  settings.threshold_db = std::numeric_limits<double>::infinity();
  PrintUpdateRow("all taken", settings, 1, routes);

  PrintUpdateHeader("Neighbours M of the kriging update, mu = 1.5 dB", "M", routes);
  settings = {};
  for (const int neighbours : {2, 4, 6, 8, 12, 20}) {
    settings.neighbours = neighbours;
    PrintUpdateRow(std::to_string(neighbours), settings, 1, routes);
  }

  PrintUpdateHeader("Interpolation and what is stored, mu = 1.5 dB, M = 6", "update", routes);
  for (const MapInterpolation way : {MapInterpolation::kKriging, MapInterpolation::kCovariance}) {
    for (const StoreRule store : {StoreRule::kObserved, StoreRule::kKriged}) {
      settings = {};
      settings.interpolation = way;
      settings.store = store;
      const std::string name =
          std::string(kMapInterpolationNames[static_cast<std::size_t>(way)]) +
          (store == StoreRule::kObserved ? ", stores what was heard" : ", stores what it says");
      PrintUpdateRow(name, settings, 1, routes);
    }
  }

  PrintUpdateHeader("Walkers that feed one map, mu = 1.5 dB, M = 6", "walkers", routes);
  for (int walkers = 1; walkers <= 5; ++walkers) {
    PrintUpdateRow(std::to_string(walkers), {}, walkers, routes);
  }
}

}  // namespace
}  // namespace walkgraph::mufaf_room

int main(int argc, char** argv) {
  const int routes = argc > 1 ? std::atoi(argv[1]) : 400;
  if (routes < 2) {
    std::fprintf(stderr, "expected the number of routes, at least 2\n");
    return 2;
  }
  walkgraph::mufaf_room::PrintEstimators(routes);
  walkgraph::mufaf_room::PrintFusionByStep(routes);
  walkgraph::mufaf_room::PrintUpdates(routes);
}
