#ifndef WALKGRAPH_TESTS_BENCHMARKS_LARGE_SITE_H_
#define WALKGRAPH_TESTS_BENCHMARKS_LARGE_SITE_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "data/simulator/random.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// One floor of 200 x 150 m with as many transmitters as asked for, made without training. Signals
// fall with the logarithm of the distance (30 dB per decade) and are heard above -88 dBm;
// transmitters differ by up to 40 dB, so that a scan hears some 6 % of them, as it does in malls.
class LargeSite {
 public:
  static constexpr double kWidthM = 200, kHeightM = 150;

  explicit LargeSite(int transmitters) : random_(1) {
    Floor floor;
    floor.max_corner = {kWidthM, kHeightM};
    site.building.floors.push_back(floor);
    for (int i = 0; i < transmitters; ++i) {
      site.transmitters.push_back({Radio::kWifi, "ap" + std::to_string(100'000 + i)});
      places_.emplace_back(random_.Uniform(0, kWidthM), random_.Uniform(0, kHeightM));
      near_dbm_.push_back(random_.Uniform(-75, -35));
    }
    AddMap();
    AddSurvey();
  }

  // Half a minute along a corridor at 1.4 m/s, a scan every three seconds.
  Evidence Walk() {
    constexpr double kSeconds = 30, kSpeedMps = 1.4, kStepS = 0.5;
    constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;
    const auto at = [](double seconds) { return kStart + DurationNs(seconds); };
    Evidence evidence;
    evidence.floor = 0;
    evidence.begin_ns = at(0);
    evidence.end_ns = at(kSeconds);
    evidence.transmitters = site.transmitters;
    evidence.motion.push_back({at(0), at(kSeconds), MotionState::kWalking});
    for (double t = 0; t < kSeconds; t += kStepS) {
      evidence.steps.push_back({at(t), at(t + kStepS), kSpeedMps * kStepS});
    }
    for (double t = 0; t <= kSeconds; t += 0.1) {
      evidence.gyro_yaw_rad.push_back(at(t), 0.01 * random_.Normal());
      evidence.absolute_heading_rad.push_back(at(t), 0.1 * random_.Normal());
      evidence.absolute_heading_sigma_rad.push_back(0.1);
    }
    for (double t = 1.5; t < kSeconds; t += 3) {
      for (const SurveyReading& reading : Scan({80 + kSpeedMps * t, 70})) {
        evidence.readings.push_back({at(t), at(t), reading.transmitter, reading.rssi_dbm});
      }
    }
    return evidence;
  }

  Site site;

 private:
  static constexpr double kSpacingM = 4, kWeakestDbm = -88;

  double MeanDbm(std::size_t transmitter, const Eigen::Vector2d& at) const {
    const double distance_m = std::max(1.0, (at - places_[transmitter]).norm());
    return near_dbm_[transmitter] - 30 * std::log10(distance_m);
  }
  double RangeM(std::size_t transmitter) const {
    return std::pow(10.0, (near_dbm_[transmitter] - kWeakestDbm) / 30);
  }

  std::vector<SurveyReading> Scan(const Eigen::Vector2d& at) {
    std::vector<SurveyReading> readings;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double rssi = MeanDbm(i, at) + 4 * random_.Normal();
      if (rssi < kWeakestDbm) continue;
      readings.push_back(
          {static_cast<std::uint32_t>(i), static_cast<float>(rssi), 0, at.cast<float>()});
    }
    return readings;
  }

  // Lanes along x every 10 m, a scan every 3 m.
  void AddSurvey() {
    std::uint32_t walk = 0;
    for (double y = 5; y < kHeightM; y += 10, ++walk) {
      for (double x = 1.5; x < kWidthM; x += 3) {
        site.path.push_back({{x, y}, 0, walk});
        site.scans.push_back({DurationNs(x), walk, walk, 0, Radio::kWifi, Scan({x, y})});
      }
    }
  }

  // As the trainer makes them: 15 m around the places that hear a transmitter.
  RadioMap::TransmitterField Field(std::size_t transmitter, const FieldGrid& grid) const {
    const double reach_m = RangeM(transmitter) + 15;
    const auto first = [&](int axis) {
      const double low = places_[transmitter][axis] - reach_m - grid.origin_m[axis];
      return std::max(0, static_cast<int>(std::floor(low / kSpacingM)));
    };
    const auto count = [&](int axis, int limit) {
      const double high = places_[transmitter][axis] + reach_m - grid.origin_m[axis];
      return std::min(limit, static_cast<int>(std::ceil(high / kSpacingM)) + 1) - first(axis);
    };
    RadioMap::TransmitterField field;
    field.transmitter = static_cast<std::uint32_t>(transmitter);
    field.column = first(0);
    field.row = first(1);
    field.columns = count(0, grid.columns);
    field.rows = count(1, grid.rows);
    field.background_mean_dbm = -95;
    field.background_log_sigma = static_cast<float>(std::log(8.0));
    field.background_logit_hear = -6;
    for (int r = 0; r < field.rows; ++r) {
      for (int c = 0; c < field.columns; ++c) {
        const double mean = MeanDbm(transmitter, Control(grid, field.column + c, field.row + r));
        field.mean_dbm.push_back(static_cast<float>(mean));
        field.log_sigma.push_back(static_cast<float>(std::log(5.0)));
        field.logit_hear.push_back(static_cast<float>((mean - kWeakestDbm) / 2));
      }
    }
    return field;
  }

  static Eigen::Vector2d Control(const FieldGrid& grid, int column, int row) {
    return grid.origin_m + grid.spacing_m * Eigen::Vector2d(column, row);
  }

  void AddMap() {
    RadioMap map;
    map.grid = {{-8, -8},
                kSpacingM,
                static_cast<int>(kWidthM / kSpacingM) + 5,
                static_cast<int>(kHeightM / kSpacingM) + 5};
    map.sigma_min_db = 4;
    map.n_eff = 4;
    map.map_error_sigma_m = 2;
    for (std::size_t i = 0; i < places_.size(); ++i) map.fields.push_back(Field(i, map.grid));
    for (int r = 0; r < map.grid.rows; ++r) {
      for (int c = 0; c < map.grid.columns; ++c) {
        double nats = 0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
          nats += std::log1p(std::exp((MeanDbm(i, Control(map.grid, c, r)) - kWeakestDbm) / 2));
        }
        map.silence_nats.push_back(static_cast<float>(nats));
      }
    }
    site.maps.push_back(std::move(map));
  }

  Random random_;
  std::vector<Eigen::Vector2d> places_;
  std::vector<double> near_dbm_;  // at one metre
};

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_BENCHMARKS_LARGE_SITE_H_
