#include "frontends/radio_map/trainer.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "frontends/radio_map/barometric_history.h"
#include "frontends/radio_map/device_offsets.h"
#include "frontends/radio_map/direction_bias.h"
#include "frontends/radio_map/magnetic_trainer.h"
#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/map_calibration.h"
#include "frontends/radio_map/radio_survey.h"
#include "frontends/radio_map/survey_scans.h"
#include "frontends/radio_map/survey_shadows.h"

namespace walkgraph {
namespace {

constexpr double kPathSpacingM = 1.0;

std::vector<Transmitter> AllTransmitters(const std::vector<SurveyWalk>& walks) {
  std::set<Transmitter> all;
  for (const SurveyWalk& walk : walks) {
    if (walk.trajectory.empty()) continue;
    for (const RadioReading& reading : walk.evidence->readings) {
      all.insert(walk.evidence->transmitters[reading.transmitter]);
    }
  }
  return {all.begin(), all.end()};
}

// Half seconds between the first and the last known position; those without a sample left out.
void AppendMagnetic(const std::vector<SurveyWalk>& walks, std::size_t index,
                    std::vector<SurveyMagnetic>* samples) {
  const SurveyWalk& walk = walks[index];
  if (walk.trajectory.empty()) return;
  const std::uint32_t trial = FirstOfTrial(walks, index);
  const TimeNs begin = walk.trajectory.poses.front().time_ns;
  const TimeNs end = walk.trajectory.poses.back().time_ns;
  for (TimeNs time = begin; time < end; time += DurationNs(kMagneticSampleS)) {
    const std::optional<MagneticSample> mean =
        MeanField(walk.evidence->magnetic, time, time + DurationNs(kMagneticSampleS));
    if (!mean) continue;
    const PoseEstimate pose = walk.trajectory.At(time + DurationNs(kMagneticSampleS / 2));
    samples->push_back({pose.position_m.head<2>().cast<float>(), pose.floor,
                        static_cast<std::uint32_t>(index), trial, static_cast<float>(mean->norm_ut),
                        static_cast<float>(mean->inclination_rad)});
  }
}

FloorSurvey SurveyOf(const Site& site, int floor, Radio radio, const TrainerSettings& settings) {
  return SurveyOfFloor(site.building, site.path, site.scans, floor, radio, settings);
}

using BodyShadows = std::array<double, kRadioCount>;  // dB

void TrainMaps(const TrainerSettings& settings, const BodyShadows& body_shadow_db,
               const Executor& run, Site* site) {
  for (const int floor : FloorsOf(site->scans)) {
    for (const Radio radio : kAllRadios) {
      const FloorSurvey survey = SurveyOf(*site, floor, radio, settings);
      if (survey.scans.empty()) continue;
      const FieldModel model = SelectFieldModel(survey, settings, run);
      RadioMap map = BuildMap(MakeMapInput(survey, settings), model, settings, run);
      const MapCalibration calibration = CalibrateMap(survey, model, settings, run);
      map.n_eff = calibration.n_eff;
      map.hear_weight = calibration.hear_weight;
      map.map_error_sigma_m = calibration.map_error_sigma_m;
      map.map_error_growth = calibration.map_error_growth;
      map.body_shadow_db = body_shadow_db[static_cast<std::size_t>(radio)];
      site->maps.push_back(std::move(map));
    }
  }
}

}  // namespace

void AppendSurveyPath(const Trajectory& trajectory, std::uint32_t walk,
                      std::vector<SurveyPoint>* path) {
  const PoseEstimate* last = nullptr;
  for (const PoseEstimate& pose : trajectory.poses) {
    const Eigen::Vector2d to = pose.position_m.head<2>();
    if (last == nullptr || last->floor != pose.floor) {
      path->push_back({to, pose.floor, walk});
      last = &pose;
      continue;
    }
    const Eigen::Vector2d from = last->position_m.head<2>();
    const int pieces = static_cast<int>((to - from).norm() / kPathSpacingM);
    for (int i = 1; i <= pieces; ++i) {
      path->push_back({from + (to - from) * i / pieces, pose.floor, walk});
    }
    if (pieces > 0) last = &pose;
  }
}

void RetrainMaps(const TrainerSettings& settings, const Site& calibrated, Site* site,
                 const ReadingFilter& fits) {
  site->maps.clear();
  for (const RadioMap& before : calibrated.maps) {
    const FloorSurvey survey = SurveyOf(*site, before.floor, before.radio, settings);
    if (survey.scans.empty()) continue;
    const FieldModel model =
        SelectFieldModel(SurveyOf(calibrated, before.floor, before.radio, settings), settings);
    // With the survey's samples merged as ever, what is added would blur them.
    const MapDetail detail = {.transmitters = {}, .max_samples = 900, .fits = fits};
    RadioMap map = BuildMap(MakeMapInput(survey, settings, detail), model, settings);
    map.n_eff = before.n_eff;
    map.hear_weight = before.hear_weight;
    map.map_error_sigma_m = before.map_error_sigma_m;
    map.map_error_growth = before.map_error_growth;
    map.body_shadow_db = before.body_shadow_db;
    site->maps.push_back(std::move(map));
  }
}

Site TrainSite(const Building& building, const std::vector<SurveyWalk>& walks,
               const TrainerSettings& settings, const Executor& run) {
  Site site;
  site.building = building;
  site.transmitters = AllTransmitters(walks);
  std::vector<std::vector<std::int32_t>> site_index;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    AppendSurveyPath(walks[i].trajectory, static_cast<std::uint32_t>(i), &site.path);
    AppendMagnetic(walks, i, &site.magnetic);
    if (auto offset = MeasureBarometricOffset(building, walks[i])) {
      site.barometric_offsets.push_back(std::move(*offset));
    }
    site_index.push_back(MatchTransmitters(site, *walks[i].evidence));
  }
  BodyShadows body_shadow_db{};
  for (const Radio radio : kAllRadios) {
    const RadioSurvey survey{building, walks, site_index, site.path, radio, settings};
    const auto r = static_cast<std::size_t>(radio);
    const auto [lag_s, shadow_db] = CalibrateDirectionBias(survey, run);
    site.reading_lag_s[r] = lag_s;
    body_shadow_db[r] = shadow_db;
    std::vector<SurveyScan> scans = survey.Scans(lag_s, {lag_s, lag_s});
    SetBodyShadows(shadow_db, &scans);
    std::move(scans.begin(), scans.end(), std::back_inserter(site.scans));
  }
  std::stable_sort(site.scans.begin(), site.scans.end(),
                   [](const SurveyScan& a, const SurveyScan& b) {
                     return std::tie(a.walk, a.printed_ns) < std::tie(b.walk, b.printed_ns);
                   });
  if (settings.level_devices) {
    SetDeviceOffsets(settings.sample_spacing_m, &site.scans);
    std::vector<std::string> devices;
    for (const SurveyWalk& walk : walks) devices.push_back(walk.evidence->device);
    site.loudness = SummariseDevices(site.scans, devices);
  }
  TrainMaps(settings, body_shadow_db, run, &site);
  site.magnetic_maps = TrainMagneticMaps(site);
  return site;
}

}  // namespace walkgraph
