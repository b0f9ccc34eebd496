#ifndef WALKGRAPH_TESTS_FRONTENDS_RADIO_WORLD_H_
#define WALKGRAPH_TESTS_FRONTENDS_RADIO_WORLD_H_

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <vector>

#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// A hall of 60 x 24 m whose signals fall with the logarithm of the distance: -35 dBm at a metre,
// 30 dB per decade, 4 dB of noise; at -85 dBm one sweep in two hears them. Positions are exact.
class RadioWorld {
 public:
  static constexpr double kWidthM = 60, kHeightM = 24, kNoiseDb = 4;
  static constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;

  // Transmitters stand at x < `width_m`.
  explicit RadioWorld(std::uint32_t seed, int transmitters = 10, double width_m = kWidthM)
      : random_(seed) {
    building.floors.resize(1);
    building.floors[0].max_corner = {kWidthM, kHeightM};
    std::uniform_real_distribution<double> x(0, width_m), y(0, kHeightM);
    for (int i = 0; i < transmitters; ++i) {
      transmitters_.push_back({Radio::kWifi, "ap" + std::to_string(100 + i)});
      const double px = x(random_), py = y(random_);
      places_.emplace_back(px, py);
    }
  }

  double MeanDbm(std::size_t transmitter, const Eigen::Vector2d& at) const {
    const double distance_m = std::max(1.0, (at - places_[transmitter]).norm());
    return -35.0 - 30.0 * std::log10(distance_m);
  }
  static double HearProbability(double mean_dbm) {
    return 1.0 / (1.0 + std::exp(-(mean_dbm + 85.0) / 2.0));
  }
  double ReadingDbm(std::size_t transmitter, const Eigen::Vector2d& at) {
    return MeanDbm(transmitter, at) + std::normal_distribution<double>(0.0, kNoiseDb)(random_);
  }
  const std::vector<Transmitter>& transmitters() const { return transmitters_; }
  std::mt19937& random() { return random_; }

  // A straight walk at 1 m/s with a sweep every 2 s, surveyed as lying `shift_m` from where it
  // was. The walk lives as long as the world.
  SurveyWalk Walk(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                  const Eigen::Vector2d& shift_m = Eigen::Vector2d::Zero()) {
    SurveyWalk walk;
    Evidence& evidence = evidence_.emplace_back();
    evidence.transmitters = transmitters_;
    const double duration_s = (to - from).norm();
    evidence.begin_ns = kStart;
    evidence.end_ns = kStart + DurationNs(duration_s);
    std::uniform_real_distribution<double> chance(0, 1);
    for (double t = 0; t <= duration_s; t += 1) {
      const Eigen::Vector2d at = from + t / duration_s * (to - from);
      PoseEstimate pose;
      pose.time_ns = kStart + DurationNs(t);
      pose.position_m.head<2>() = at + shift_m;
      pose.heading_rad = std::atan2((to - from).y(), (to - from).x());
      walk.trajectory.poses.push_back(pose);
      if (std::fmod(t, 2.0) != 0.0) continue;
      for (std::uint32_t i = 0; i < transmitters_.size(); ++i) {
        const Eigen::Vector2d ahead = (to - from).normalized();
        const double body_db = body_shadow_db * ahead.dot((places_[i] - at).normalized());
        const double rssi_dbm = ReadingDbm(i, at) + body_db;
        if (chance(random_) > HearProbability(MeanDbm(i, at))) continue;
        const TimeNs stamp_ns = pose.time_ns - DurationNs(stamped_early_s);
        evidence.readings.push_back({stamp_ns, stamp_ns, i, static_cast<float>(rssi_dbm)});
      }
    }
    walk.evidence = &evidence;
    return walk;
  }

  // Walks along x, one every `spacing_m`, from x = 0 to `width_m`; each displaced at random.
  std::vector<SurveyWalk> Survey(double spacing_m, double width_m = kWidthM,
                                 double shift_sigma_m = 0) {
    std::normal_distribution<double> shift(0.0, 1.0);
    std::vector<SurveyWalk> walks;
    for (double y = spacing_m / 2; y < kHeightM; y += spacing_m) {
      const double dx = shift_sigma_m * shift(random_), dy = shift_sigma_m * shift(random_);
      walks.push_back(Walk({0, y}, {width_m, y}, {dx, dy}));
    }
    return walks;
  }

  Building building;
  double body_shadow_db = 0;   // what lies straight ahead is heard stronger by
  double stamped_early_s = 0;  // readings carry a time this much before they were heard

 private:
  std::mt19937 random_;
  std::vector<Transmitter> transmitters_;
  std::vector<Eigen::Vector2d> places_;
  std::deque<Evidence> evidence_;  // addresses stay
};

}  // namespace walkgraph

#endif  // WALKGRAPH_TESTS_FRONTENDS_RADIO_WORLD_H_
