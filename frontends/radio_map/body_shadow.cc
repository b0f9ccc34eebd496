#include "frontends/radio_map/body_shadow.h"

#include <array>
#include <cmath>
#include <utility>

#include "frontends/radio_map/bearing.h"

namespace walkgraph {
namespace {

Eigen::Vector2d DirectionOf(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

double ShadowDb(double amplitude_db, const Eigen::Vector2d& source_m,
                const SurveyReading& reading) {
  const Eigen::Vector2d at = reading.position_m.cast<double>();
  return amplitude_db * BearingOf(source_m, at).value.dot(DirectionOf(double{reading.heading_rad}));
}

}  // namespace

std::map<std::uint32_t, Eigen::Vector2d> LocateSources(const ScanList& scans) {
  std::map<std::uint32_t, std::pair<Eigen::Vector2d, double>> sums;
  for (const SurveyScan* scan : scans) {
    for (const SurveyReading& reading : scan->readings) {
      auto& [sum, total] =
          sums.try_emplace(reading.transmitter, Eigen::Vector2d::Zero(), 0.0).first->second;
      const double milliwatt = std::pow(10.0, reading.rssi_dbm / 10.0);
      sum += milliwatt * reading.position_m.cast<double>();
      total += milliwatt;
    }
  }
  std::map<std::uint32_t, Eigen::Vector2d> sources;
  for (const auto& [transmitter, sum] : sums) sources[transmitter] = sum.first / sum.second;
  return sources;
}

void SetBodyShadows(double amplitude_db, std::vector<SurveyScan>* scans) {
  if (amplitude_db == 0) return;
  std::map<int, ScanList> by_floor;
  for (const SurveyScan& scan : *scans) by_floor[scan.floor].push_back(&scan);
  std::map<int, std::map<std::uint32_t, Eigen::Vector2d>> sources;
  for (const auto& [floor, list] : by_floor) sources[floor] = LocateSources(list);
  for (SurveyScan& scan : *scans) {
    for (SurveyReading& reading : scan.readings) {
      const Eigen::Vector2d& source = sources[scan.floor].at(reading.transmitter);
      reading.shadow_db = static_cast<float>(ShadowDb(amplitude_db, source, reading));
    }
  }
}

void SetBodyShadow(const RadioMap& map, SurveyScan* scan) {
  for (SurveyReading& reading : scan->readings) {
    const int field = map.FindField(reading.transmitter);
    if (field < 0) continue;
    const auto source = map.fields[static_cast<std::size_t>(field)].source_m.cast<double>();
    reading.shadow_db = static_cast<float>(ShadowDb(map.body_shadow_db, source, reading));
  }
}

}  // namespace walkgraph
