#include "data/simulator/scenarios.h"

#include "data/simulator/standard_atmosphere.h"

namespace walkgraph {
namespace {

SimulationSettings HallSettings() {
  SimulationSettings settings;
  settings.building.kind = BuildingKind::kHall;
  settings.building.floors = 1;
  settings.walks.change_floors = false;
  settings.walks.straight_share = 0.3;
  settings.wifi.per_floor = 15;
  return settings;
}

SimulationSettings GyroBias() {
  SimulationSettings settings = CleanSettings();
  const InertialSettings office;
  // More than what a phone's own calibration leaves, to be seen alone; a third of the zero-rate
  // offset that the BMI160's data sheet gives a part without any.
  settings.inertial.gyro_bias_sigma_radps = DegreesToRadians(1.0);
  settings.inertial.gyro_bias_walk_radps_per_sqrt_s = office.gyro_bias_walk_radps_per_sqrt_s;
  return settings;
}

SimulationSettings HeadingOffset() {
  SimulationSettings settings = CleanSettings();
  settings.hold = HoldSettings{};
  settings.magnetic = MagneticSettings{};
  return settings;
}

SimulationSettings StepScale() {
  SimulationSettings settings = CleanSettings();
  // More than the office's few percent, to be seen alone.
  settings.gait.weinberg_k_sigma = 0.1 * settings.gait.weinberg_k;
  return settings;
}

SimulationSettings BaroOffset() {
  SimulationSettings settings = CleanSettings();
  const BarometerSettings office;
  settings.barometer.weather_hpa = office.weather_hpa;
  settings.barometer.weather_sigma_hpa = office.weather_sigma_hpa;
  settings.barometer.offset_sigma_hpa = office.offset_sigma_hpa;
  settings.barometer.trend_sigma_hpa_per_h = office.trend_sigma_hpa_per_h;
  settings.barometer.drift_hpa_per_sqrt_h = office.drift_hpa_per_sqrt_h;
  return settings;
}

SimulationSettings MapChange() {
  SimulationSettings settings = CleanSettings();
  // A refurbished floor: enough to be seen alone.
  settings.change = {.vanished_share = 0.2, .altered_share = 0.3, .altered_sigma_db = 8.0};
  return settings;
}

void QuietPhone(SimulationSettings* settings) {
  settings->hold.offset_sigma_rad = 0;
  settings->hold.wander_rad = 0;
  settings->gait.weinberg_k_sigma = 0;
  settings->inertial.acceleration_bias_sigma_mps2 = 0;
  settings->inertial.gyro_bias_sigma_radps = 0;
  settings->inertial.gyro_bias_walk_radps_per_sqrt_s = 0;
  settings->magnetic.disturbance_ut = 0;
  settings->magnetic.yaw_offset_sigma_rad = 0;
  settings->magnetic.yaw_wander_rad = 0;
}

void QuietAir(BarometerSettings* barometer) {
  barometer->weather_hpa = kStandardPressureHpa;
  barometer->weather_sigma_hpa = 0;
  barometer->offset_sigma_hpa = 0;
  barometer->trend_sigma_hpa_per_h = 0;
  barometer->drift_hpa_per_sqrt_h = 0;
  barometer->steps_per_hour = 0;
  barometer->wander_hpa = 0;
  barometer->air_temperature_k = kStandardTemperatureK;
}

}  // namespace

SimulationSettings SampleSettings() {
  SimulationSettings settings;
  settings.walks = {.survey = 14, .test = 4, .rate_hz = 50, .change_floors = false};
  settings.walks.handling_s = 0;
  settings.walks.stand_after_handling_s = 0;
  settings.inertial.acceleration_bias_sigma_mps2 = 0;
  settings.magnetic.rate_hz = 5;
  settings.magnetic.disturbance_ut = 0;
  const BarometerSettings office = settings.barometer;
  QuietAir(&settings.barometer);
  settings.barometer.rate_hz = 1;
  settings.barometer.weather_hpa = office.weather_hpa;
  settings.barometer.weather_sigma_hpa = office.weather_sigma_hpa;
  settings.barometer.noise_hpa = 0.015;  // standing, all of it white
  settings.wifi.per_floor = 40;
  settings.wifi.neighbourhood_m = 40;
  settings.wifi.refresh_base = 65;  // at every strength
  settings.wifi.refresh_gain = 0;
  settings.wifi.shortest_sweep_s = 2.2;
  settings.wifi.longest_sweep_s = 3.8;
  settings.wifi.keep_s = 15;
  settings.wifi.latency_s = 0;
  settings.wifi.device_offset_sigma_db = 0;
  settings.beacon.enabled = false;
  return settings;
}

SimulationSettings CleanSettings() {
  SimulationSettings settings;
  settings.walks.handling_s = 0;
  QuietPhone(&settings);
  QuietAir(&settings.barometer);
  settings.propagation.body_loss_db = 0;
  settings.wifi.latency_s = 0;
  settings.wifi.device_offset_sigma_db = 0;
  settings.beacon.device_offset_sigma_db = 0;
  settings.change.vanished_share = 0;
  settings.change.altered_share = 0;
  return settings;
}

const std::vector<std::string>& ScenarioNames() {
  static const std::vector<std::string> names = {"office",      "hall",           "clean",
                                                 "gyro_bias",   "heading_offset", "step_scale",
                                                 "baro_offset", "map_change"};
  return names;
}

std::optional<SimulationSettings> ScenarioSettings(const std::string& name) {
  if (name == "office") return SimulationSettings{};
  if (name == "hall") return HallSettings();
  if (name == "clean") return CleanSettings();
  if (name == "gyro_bias") return GyroBias();
  if (name == "heading_offset") return HeadingOffset();
  if (name == "step_scale") return StepScale();
  if (name == "baro_offset") return BaroOffset();
  if (name == "map_change") return MapChange();
  return std::nullopt;
}

}  // namespace walkgraph
