#include "frontends/radio_map/survey_shadows.h"

#include <cmath>
#include <utility>

#include "data/angle.h"
#include "frontends/radio_map/body_shadow.h"

namespace walkgraph {
namespace {

void SetShadow(double amplitude_db, const Eigen::Vector2d& source_m, SurveyReading* reading) {
  const Bearing bearing = BearingOf(source_m, reading->position_m.cast<double>());
  const Eigen::Vector2d ahead = DirectionOf(double{reading->heading_rad});
  reading->shadow_db = static_cast<float>(ShadowOf(amplitude_db, bearing, ahead).value_db);
}

}  // namespace

std::map<std::uint32_t, Eigen::Vector2d> LocateSources(const ScanList& scans,
                                                       const TransmitterSelection& transmitters) {
  std::map<std::uint32_t, std::pair<Eigen::Vector2d, double>> sums;
  for (const SurveyScan* scan : scans) {
    for (const SurveyReading& reading : scan->readings) {
      if (!transmitters.Has(reading.transmitter)) continue;
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
      SetShadow(amplitude_db, sources[scan.floor].at(reading.transmitter), &reading);
    }
  }
}

void SetBodyShadow(const RadioMap& map, SurveyScan* scan) {
  for (SurveyReading& reading : scan->readings) {
    const int field = map.FindField(reading.transmitter);
    if (field < 0) continue;
    const auto source = map.fields[static_cast<std::size_t>(field)].source_m.cast<double>();
    SetShadow(map.body_shadow_db, source, &reading);
  }
}

}  // namespace walkgraph
