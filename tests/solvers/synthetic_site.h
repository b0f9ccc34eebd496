#ifndef WALKGRAPH_TESTS_SOLVERS_SYNTHETIC_SITE_H_
#define WALKGRAPH_TESTS_SOLVERS_SYNTHETIC_SITE_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "data/time.h"
#include "data/trajectory.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph::testing {

// A hall of 48 x 36 m with access points whose signal falls with the logarithm of the distance
// (exponent 3 from -35 dBm at 1 m) and carries 5 dB of noise; weaker than about -88 dBm is rarely
// heard. Small enough to reason about, random enough to make methods earn their rank.
class SyntheticSite {
 public:
  static constexpr double kWidthM = 48, kHeightM = 36, kNoiseDb = 5;
  static constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;
  static constexpr double kStepLengthM = 0.7, kSpeedMps = 1.0;

  explicit SyntheticSite(std::uint32_t seed, int transmitters = 12) : random_(seed) {
    Floor floor;
    floor.number = 1;
    floor.height_m = 4;
    floor.max_corner = {kWidthM, kHeightM};
    site.building.floors.push_back(floor);
    std::uniform_real_distribution<double> x(0, kWidthM), y(0, kHeightM);
    for (int i = 0; i < transmitters; ++i) {
      site.transmitters.push_back({Radio::kWifi, "ap" + std::to_string(100 + i)});
      const double px = x(random_), py = y(random_);
      positions_.emplace_back(px, py);
    }
    Survey();
    FillMap();
  }

  double MeanDbm(std::size_t transmitter, const Eigen::Vector2d& at) const {
    return -35.0 - 30.0 * std::log10(std::max(1.0, (at - positions_[transmitter]).norm()));
  }
  static double LogitHear(double mean_dbm) { return (mean_dbm + 88.0) / 2.0; }

  // A walk along a polyline at constant speed: steps, absolute heading (with an error of
  // `heading_error_rad` per sample), and a scan every `scan_s` whose readings are all heard at
  // once. `truth` receives the position at each second.
  Evidence Walk(const std::vector<Eigen::Vector2d>& corners, double heading_error_rad,
                double scan_s, std::vector<Eigen::Vector2d>* truth = nullptr) {
    Evidence evidence;
    evidence.id = "synthetic";
    evidence.floor = 1;
    evidence.begin_ns = kStart;
    evidence.transmitters = site.transmitters;
    double length = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
    const double duration_s = length / kSpeedMps;
    evidence.end_ns = kStart + DurationNs(duration_s);
    evidence.motion.push_back({evidence.begin_ns, evidence.end_ns, MotionState::kWalking});
    const double step_s = kStepLengthM / kSpeedMps;
    for (double t = 0; t + step_s <= duration_s; t += step_s) {
      evidence.steps.push_back({At(t), At(t + step_s), kStepLengthM});
    }
    std::normal_distribution<double> heading_noise(0, heading_error_rad);
    double heading = 0;
    for (double t = 0; t <= duration_s; t += 0.1) {
      const Eigen::Vector2d ahead = Along(corners, t + 0.05) - Along(corners, t);
      if (ahead.norm() > 0) {
        const double raw = std::atan2(ahead.y(), ahead.x());
        heading += std::remainder(raw - heading, 2 * std::numbers::pi);
      }
      evidence.absolute_heading_rad.push_back(At(t), heading + heading_noise(random_));
      evidence.absolute_heading_sigma_rad.push_back(heading_error_rad);
    }
    for (double t = scan_s / 2; t <= duration_s; t += scan_s) {
      for (const SurveyReading& reading : Scan(Along(corners, t))) {
        evidence.readings.push_back({At(t), At(t), reading.transmitter, reading.rssi_dbm});
      }
    }
    if (truth != nullptr) {
      truth->clear();
      for (double t = 0; t <= duration_s; t += 1) truth->push_back(Along(corners, t));
    }
    return evidence;
  }

  static TimeNs At(double seconds) { return kStart + DurationNs(seconds); }

  Site site;

 private:
  static Eigen::Vector2d Along(const std::vector<Eigen::Vector2d>& corners, double seconds) {
    double rest = seconds * kSpeedMps;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const double leg = (corners[i] - corners[i - 1]).norm();
      if (rest <= leg) return corners[i - 1] + rest / leg * (corners[i] - corners[i - 1]);
      rest -= leg;
    }
    return corners.back();
  }

  std::vector<SurveyReading> Scan(const Eigen::Vector2d& at) {
    std::normal_distribution<double> noise(0, kNoiseDb);
    std::uniform_real_distribution<double> chance(0, 1);
    std::vector<SurveyReading> readings;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const double mean = MeanDbm(i, at);
      const double rssi = std::round(mean + noise(random_));
      if (chance(random_) > 1 / (1 + std::exp(-LogitHear(mean)))) continue;
      readings.push_back(
          {static_cast<std::uint32_t>(i), static_cast<float>(rssi), 0.0F, at.cast<float>()});
    }
    return readings;
  }

  // Survey walks along x every 3 m, a scan per metre.
  void Survey() {
    std::uint32_t walk = 0;
    for (double y = 1.5; y < kHeightM; y += 3, ++walk) {
      for (double x = 1.5; x < kWidthM; x += 1) {
        const Eigen::Vector2d at(x, y);
        site.path.push_back({at, 1, walk});
        site.scans.push_back({At(-100 + x), walk, walk, 1, Radio::kWifi, Scan(at)});
      }
    }
  }

  void FillMap() {
    RadioMap map;
    map.floor = 1;
    map.grid = {{-6, -6}, 3.0, 21, 17};
    map.sigma_min_db = 4;
    map.n_eff = 4;
    const auto log_sigma = static_cast<float>(std::log(kNoiseDb));
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      RadioMap::TransmitterField field{
          static_cast<std::uint32_t>(i), 2, 2, 17, 13, -95.0F, log_sigma + 0.5F, -6.0F, {}, {}, {}};
      for (int r = 0; r < field.rows; ++r) {
        for (int c = 0; c < field.columns; ++c) {
          const double mean = MeanDbm(i, {3.0 * c, 3.0 * r});
          field.mean_dbm.push_back(static_cast<float>(mean));
          field.log_sigma.push_back(log_sigma);
          field.logit_hear.push_back(static_cast<float>(LogitHear(mean)));
        }
      }
      map.fields.push_back(field);
    }
    FillSilence(&map);
    site.maps.push_back(map);
  }

  void FillSilence(RadioMap* map) const {
    for (int r = 0; r < map->grid.rows; ++r) {
      for (int c = 0; c < map->grid.columns; ++c) {
        double nats = 0;
        const Eigen::Vector2d at = map->grid.origin_m + Eigen::Vector2d(3.0 * c, 3.0 * r);
        for (std::size_t i = 0; i < positions_.size(); ++i) {
          nats += std::log1p(std::exp(LogitHear(MeanDbm(i, at))));
        }
        map->silence_nats.push_back(static_cast<float>(nats));
      }
    }
  }

  std::mt19937 random_;
  std::vector<Eigen::Vector2d> positions_;
};

// A walk's truth, by second, as a trajectory on the site's floor.
inline Trajectory TrueTrajectory(const std::vector<Eigen::Vector2d>& truth) {
  Trajectory trajectory;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    PoseEstimate pose;
    pose.time_ns = SyntheticSite::At(static_cast<double>(t));
    pose.position_m.head<2>() = truth[t];
    pose.floor = 1;
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_SOLVERS_SYNTHETIC_SITE_H_
