#include "frontends/radio_map/map_update.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "frontends/radio_map/survey_scans.h"
#include "frontends/radio_map/survey_shadows.h"

namespace walkgraph {
namespace {

// Readings in one square of a walk: their mean residual and the map's variance there.
struct ResidualGroup {
  double sum_db = 0, variance_db2 = 0, count = 0;
};

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Gathers what the scans of walks say about the transmitters of a map.
class ChangeFinder {
 public:
  ChangeFinder(const RadioMap& map, const MapChangeSettings& settings)
      : map_(map), settings_(settings), groups_(map.fields.size()), tallies_(map.fields.size()) {}

  void AddWalk(const std::vector<SurveyScan>& scans) {
    std::vector<Residual> residuals;
    for (const SurveyScan& scan : scans) {
      if (scan.floor == map_.floor && scan.radio == map_.radio) AddScan(scan, &residuals);
    }
    if (residuals.empty()) return;
    std::vector<double> values;
    for (const Residual& residual : residuals) values.push_back(residual.residual_db);
    const double phone_db = Median(std::move(values));
    for (const Residual& residual : residuals) {
      ResidualGroup& group =
          groups_[residual.field][{residual.walk, residual.column, residual.row}];
      group.sum_db += residual.residual_db - phone_db;
      group.variance_db2 += residual.variance_db2;
      ++group.count;
    }
  }

  std::vector<TransmitterChange> Changes() const {
    std::vector<TransmitterChange> changes;
    for (std::size_t f = 0; f < map_.fields.size(); ++f) {
      if (groups_[f].empty() && tallies_[f].expected <= 0) continue;
      TransmitterChange change = tallies_[f];
      change.transmitter = map_.fields[f].transmitter;
      double information = 1 / (settings_.offset_sigma_db * settings_.offset_sigma_db), sum = 0;
      for (const auto& [square, group] : groups_[f]) {
        const double weight = group.count / group.variance_db2;  // over the mean variance
        information += weight;
        sum += weight * group.sum_db / group.count;
      }
      change.offset_db = sum / information;
      change.offset_sigma_db = 1 / std::sqrt(information);
      change.vanished = change.heard == 0 && silence_nats_.contains(f) &&
                        silence_nats_.at(f) > std::log(settings_.vanish_odds);
      changes.push_back(change);
    }
    return changes;
  }

 private:
  struct Residual {
    std::size_t field = 0;
    std::uint32_t walk = 0;
    long column = 0, row = 0;
    double residual_db = 0, variance_db2 = 0;
  };

  void AddScan(const SurveyScan& scan, std::vector<Residual>* residuals) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    std::set<std::size_t> heard;
    for (const SurveyReading& reading : scan.readings) {
      const Eigen::Vector2d at = reading.position_m.cast<double>();
      middle += at / static_cast<double>(scan.readings.size());
      const int field = map_.FindField(reading.transmitter);
      if (field < 0) continue;
      heard.insert(static_cast<std::size_t>(field));
      const FieldValue value = map_.EvaluateValue(field, EvaluateBasis(map_.grid, at));
      residuals->push_back({static_cast<std::size_t>(field), scan.walk,
                            std::lround(at.x() / settings_.group_m),
                            std::lround(at.y() / settings_.group_m),
                            double{reading.rssi_dbm} - reading.shadow_db - value.mean_dbm,
                            std::exp(2 * value.log_sigma)});
    }
    const FieldBasis basis = EvaluateBasis(map_.grid, middle);
    for (std::size_t f = 0; f < map_.fields.size(); ++f) {
      const double logit = map_.EvaluateValue(static_cast<int>(f), basis).logit_hear;
      tallies_[f].expected += 1 / (1 + std::exp(-logit));
      tallies_[f].heard += heard.contains(f) ? 1 : 0;
      silence_nats_[f] += map_.hear_weight * std::log1p(std::exp(logit));
    }
  }

  const RadioMap& map_;
  const MapChangeSettings& settings_;
  std::vector<std::map<std::tuple<std::uint32_t, long, long>, ResidualGroup>> groups_;
  std::vector<TransmitterChange> tallies_;
  std::map<std::size_t, double> silence_nats_;  // of never hearing it, by field
};

// Scans of the located walks as the site would have them; numbered after the survey's.
std::vector<SurveyScan> ScansOf(const Site& site, const std::vector<SurveyWalk>& walks) {
  const std::uint32_t first = NextWalk(site);
  std::vector<SurveyScan> scans;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    if (walks[i].trajectory.empty()) continue;
    const std::vector<std::int32_t> index = MatchTransmitters(site, *walks[i].evidence);
    for (const Radio radio : kAllRadios) {
      const double lag_s = site.reading_lag_s[static_cast<std::size_t>(radio)];
      for (SurveyScan& scan : PlaceScans(walks, i, radio, index, lag_s, {lag_s, lag_s})) {
        std::erase_if(scan.readings, [&](const SurveyReading& reading) {
          return reading.transmitter >= site.transmitters.size();
        });
        if (scan.readings.empty()) continue;
        const RadioMap* map = site.FindMap(scan.floor, radio);
        if (map != nullptr) SetBodyShadow(*map, &scan);
        scan.walk += first;
        scan.trial += first;
        scans.push_back(std::move(scan));
      }
    }
  }
  return scans;
}

using Changes = std::map<std::uint32_t, TransmitterChange>;  // by transmitter

void ApplyChanges(const RadioMap& map, const Changes& changes, std::vector<SurveyScan>* scans) {
  const auto on_map = [&map](const SurveyScan& scan) {
    return scan.floor == map.floor && scan.radio == map.radio;
  };
  float weakest_dbm = std::numeric_limits<float>::infinity();
  for (const SurveyScan& scan : *scans) {
    if (!on_map(scan)) continue;
    for (const SurveyReading& reading : scan.readings) {
      weakest_dbm = std::min(weakest_dbm, reading.rssi_dbm);
    }
  }
  for (SurveyScan& scan : *scans) {
    if (!on_map(scan)) continue;
    std::vector<SurveyReading> today;
    for (SurveyReading reading : scan.readings) {
      const auto found = changes.find(reading.transmitter);
      const TransmitterChange change = found == changes.end() ? TransmitterChange() : found->second;
      if (change.vanished) continue;
      if (change.changed()) reading.rssi_dbm += static_cast<float>(change.offset_db);
      // What is weaker nobody would hear today.
      if (reading.rssi_dbm >= weakest_dbm) today.push_back(reading);
    }
    scan.readings = std::move(today);
  }
}

// Whether a located reading says what the survey does not know better.
bool AddsToSurvey(const RadioMap& map, const Changes& changes, const SurveyReading& reading,
                  double near_survey_m) {
  if (map.FindField(reading.transmitter) < 0) return true;
  const auto change = changes.find(reading.transmitter);
  if (change != changes.end() && change->second.changed()) return true;
  const FieldBasis basis = EvaluateBasis(map.grid, reading.position_m.cast<double>());
  return map.SurveyDistance(basis).value > near_survey_m;
}

}  // namespace

std::vector<TransmitterChange> FindChanges(const Site& site, const RadioMap& map,
                                           const std::vector<SurveyWalk>& walks,
                                           const MapChangeSettings& settings) {
  ChangeFinder finder(map, settings);
  std::map<std::uint32_t, std::vector<SurveyScan>> by_walk;
  for (SurveyScan& scan : ScansOf(site, walks)) by_walk[scan.walk].push_back(std::move(scan));
  for (const auto& [walk, scans] : by_walk) finder.AddWalk(scans);
  return finder.Changes();
}

Site WithWalks(const Site& site, const std::vector<SurveyWalk>& walks) {
  std::set<Transmitter> all(site.transmitters.begin(), site.transmitters.end());
  for (const SurveyWalk& walk : walks) {
    if (walk.trajectory.empty()) continue;
    for (const RadioReading& reading : walk.evidence->readings) {
      all.insert(walk.evidence->transmitters[reading.transmitter]);
    }
  }
  Site result = site;
  result.transmitters.assign(all.begin(), all.end());
  std::vector<std::uint32_t> moved;
  for (const Transmitter& transmitter : site.transmitters) {
    moved.push_back(static_cast<std::uint32_t>(std::distance(
        result.transmitters.begin(),
        std::lower_bound(result.transmitters.begin(), result.transmitters.end(), transmitter))));
  }
  for (SurveyScan& scan : result.scans) {
    for (SurveyReading& reading : scan.readings) reading.transmitter = moved[reading.transmitter];
  }
  for (RadioMap& map : result.maps) {
    for (RadioMap::TransmitterField& field : map.fields) {
      field.transmitter = moved[field.transmitter];
    }
  }
  const std::uint32_t first = NextWalk(site);
  for (std::size_t i = 0; i < walks.size(); ++i) {
    AppendSurveyPath(walks[i].trajectory, first + static_cast<std::uint32_t>(i), &result.path);
  }
  return result;
}

Site UpdateSite(const Site& site, const std::vector<SurveyWalk>& walks,
                const TrainerSettings& trainer, const MapChangeSettings& settings) {
  const std::uint32_t first_located = NextWalk(site);
  const Site before = WithWalks(site, walks);
  Site result = before;
  std::map<const RadioMap*, Changes> changes;
  for (const RadioMap& map : before.maps) {
    for (const TransmitterChange& change : FindChanges(before, map, walks, settings)) {
      changes[&map][change.transmitter] = change;
    }
    ApplyChanges(map, changes[&map], &result.scans);
  }
  std::erase_if(result.scans, [](const SurveyScan& scan) { return scan.readings.empty(); });
  for (SurveyScan& scan : ScansOf(before, walks)) result.scans.push_back(std::move(scan));
  RetrainMaps(trainer, site, &result, [&](const SurveyScan& scan, const SurveyReading& reading) {
    if (scan.walk < first_located) return true;
    const RadioMap* map = before.FindMap(scan.floor, scan.radio);
    return map == nullptr || AddsToSurvey(*map, changes.at(map), reading, settings.near_survey_m);
  });
  return result;
}

}  // namespace walkgraph
