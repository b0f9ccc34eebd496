#ifndef WALKGRAPH_TESTS_SOLVERS_TWO_FLOORS_H_
#define WALKGRAPH_TESTS_SOLVERS_TWO_FLOORS_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "data/time.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"

namespace walkgraph::testing {

// A house of floors 3.5 m apart, each with four access points that are heard on it at about -60 dBm
// and 15 dB weaker on the next, surveyed by one walk a floor, and a person who stands on it and
// rides a lift: what a floor tracker sees, without any walking.
class TwoFloors {
 public:
  static constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;
  static constexpr double kStoreyM = 3.5, kPressureSigmaM = 0.1, kNoiseDb = 4;
  static constexpr int kTransmittersPerFloor = 4;

  explicit TwoFloors(std::uint32_t seed, int floors = 2) : random_(seed) {
    for (int f = 0; f < floors; ++f) {
      Floor floor;
      floor.number = f;
      floor.height_m = kStoreyM * f;
      floor.max_corner = {20, 20};
      site.building.floors.push_back(floor);
      for (int i = 0; i < kTransmittersPerFloor; ++i) {
        site.transmitters.push_back(
            {Radio::kWifi, "ap" + std::to_string(10 + f) + std::to_string(i)});
      }
    }
    for (int f = 0; f < floors; ++f) Survey(f);
  }

  // Floors by second, with `between` on the way, and a barometer off by `offset_m` at the start
  // that then drifts by `drift_m_per_s`; a scan every 4 s.
  static constexpr int kBetween = -99;
  Evidence Ride(const std::vector<int>& floor_by_second, double offset_m,
                double drift_m_per_s = 0) {
    Evidence evidence;
    evidence.begin_ns = kStart;
    evidence.end_ns = At(static_cast<double>(floor_by_second.size()));
    evidence.transmitters = site.transmitters;
    evidence.motion.push_back({evidence.begin_ns, evidence.end_ns, MotionState::kStanding});
    std::normal_distribution<double> noise(0, kPressureSigmaM);
    for (std::size_t s = 0; s < floor_by_second.size(); ++s) {
      const double z = Height(floor_by_second, s);
      evidence.barometric_height_m.push_back(
          At(static_cast<double>(s)),
          z + offset_m + drift_m_per_s * static_cast<double>(s) + noise(random_));
      evidence.barometric_height_sigma_m.push_back(0.02);
      if (s % 4 == 2) AppendScan(static_cast<int>(std::lround(z / kStoreyM)), At(s), &evidence);
    }
    return evidence;
  }

  // A floor for `seconds`, then the way to the next for `ride_s`, and so on.
  static std::vector<int> Stays(const std::vector<int>& floors, int seconds, int ride_s) {
    std::vector<int> by_second;
    for (std::size_t i = 0; i < floors.size(); ++i) {
      if (i > 0) by_second.insert(by_second.end(), static_cast<std::size_t>(ride_s), kBetween);
      by_second.insert(by_second.end(), static_cast<std::size_t>(seconds), floors[i]);
    }
    return by_second;
  }

  static TimeNs At(double seconds) { return kStart + DurationNs(seconds); }

  Site site;

 private:
  // Linear on the way between two stays.
  static double Height(const std::vector<int>& by_second, std::size_t s) {
    if (by_second[s] != kBetween) return kStoreyM * by_second[s];
    std::size_t before = s, after = s;
    while (by_second[before] == kBetween) --before;
    while (by_second[after] == kBetween) ++after;
    const double share = static_cast<double>(s - before) / static_cast<double>(after - before);
    return kStoreyM * (by_second[before] + share * (by_second[after] - by_second[before]));
  }

  double Strength(std::size_t transmitter, int floor) {
    const int own = static_cast<int>(transmitter) / kTransmittersPerFloor;
    std::normal_distribution<double> noise(0, kNoiseDb);
    return -60.0 - 15.0 * std::abs(own - floor) + noise(random_);
  }

  void Survey(int floor) {
    for (int s = 0; s < 40; ++s) {
      SurveyScan scan;
      scan.printed_ns = kStart - (1000 - 200 * floor) * kNsPerSecond + 4 * s * kNsPerSecond;
      scan.floor = floor;
      scan.walk = static_cast<std::uint32_t>(floor);
      for (std::size_t t = 0; t < site.transmitters.size(); ++t) {
        SurveyReading reading;
        reading.transmitter = static_cast<std::uint32_t>(t);
        reading.rssi_dbm = static_cast<float>(Strength(t, floor));
        if (reading.rssi_dbm > -90) scan.readings.push_back(reading);
      }
      site.scans.push_back(scan);
      site.path.push_back({{0.5 * s, 10.0}, floor, static_cast<std::uint32_t>(floor)});
    }
  }

  void AppendScan(int floor, TimeNs time_ns, Evidence* evidence) {
    for (std::size_t t = 0; t < site.transmitters.size(); ++t) {
      RadioReading reading;
      reading.transmitter = static_cast<std::uint32_t>(t);
      reading.heard_ns = reading.printed_ns = time_ns;
      reading.rssi_dbm = static_cast<float>(Strength(t, floor));
      if (reading.rssi_dbm > -90) evidence->readings.push_back(reading);
    }
  }

  std::mt19937_64 random_;
};

}  // namespace walkgraph::testing

#endif  // WALKGRAPH_TESTS_SOLVERS_TWO_FLOORS_H_
