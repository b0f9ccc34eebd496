#ifndef WALKGRAPH_DATA_SIMULATOR_SETTINGS_VISIT_H_
#define WALKGRAPH_DATA_SIMULATOR_SETTINGS_VISIT_H_

#include "data/simulator/settings.h"

namespace walkgraph {

// Names every key of the settings once; a visitor has `Field(key, value&, documentation)` and
// `Group(key, struct&)`, as in factors/settings.h. Sources and measured values stand in settings.h.

template <typename Visitor>
void Visit(Visitor& v, BuildingSettings& s) {
  v.Field("floors", s.floors, "number of floors; a hall has one");
  v.Field("lowest_floor", s.lowest_floor, "number of the lowest floor");
  v.Field("floor_height_m", s.floor_height_m, "from floor to floor, m");
  v.Field("latitude_deg", s.latitude_deg, "of the frame's origin, degrees");
  v.Field("longitude_deg", s.longitude_deg, "of the frame's origin, degrees");
  v.Field("rotation_deg", s.rotation_deg, "from east to the frame's x, counter-clockwise, degrees");
  v.Field("grid_spacing_m", s.grid_spacing_m, "of the ways through a hall or a given plan, m");
}
template <typename Visitor>
void Visit(Visitor& v, WalkSettings& s) {
  v.Field("survey", s.survey, "number of survey walks");
  v.Field("test", s.test, "number of test walks");
  v.Field("duration_s", s.duration_s, "of a walk, about, s");
  v.Field("rate_hz", s.rate_hz, "of accelerometer and gyroscope, Hz, to whole milliseconds");
  v.Field("change_floors", s.change_floors, "take stairs, lifts and escalators");
  v.Field("connector_share", s.connector_share,
          "share of the occasions to change floors that are taken");
  v.Field("straight_share", s.straight_share, "share of the crossings that are passed straight on");
  v.Field("waypoint_every_s", s.waypoint_every_s, "longest time between waypoints, s");
  v.Field("stop_every_s", s.stop_every_s, "mean time between stops, s; 0: none");
  v.Field("stop_s", s.stop_s, "mean length of a stop, s");
  v.Field("handling_s", s.handling_s, "for which the phone is waved at the start, s");
  v.Field("stand_after_handling_s", s.stand_after_handling_s,
          "for which the person then stands, s");
}
template <typename Visitor>
void Visit(Visitor& v, GaitSettings& s) {
  v.Field("step_rate_hz", s.step_rate_hz, "mean over persons, Hz");
  v.Field("step_rate_sigma_hz", s.step_rate_sigma_hz, "spread over persons, Hz");
  v.Field("step_length_m", s.step_length_m, "mean over persons, m");
  v.Field("step_length_sigma_m", s.step_length_sigma_m, "spread over persons, m");
  v.Field("step_variation", s.step_variation, "spread from step to step, share of the length");
  v.Field("weinberg_k", s.weinberg_k,
          "step length over the fourth root of a step's vertical swing");
  v.Field("weinberg_k_sigma", s.weinberg_k_sigma, "its spread over persons");
  v.Field("riser_m", s.riser_m, "height of a stair, m");
  v.Field("tread_m", s.tread_m, "depth of a stair, m");
  v.Field("stairs_up_rate_hz", s.stairs_up_rate_hz, "steps climbing stairs, Hz");
  v.Field("stairs_down_rate_hz", s.stairs_down_rate_hz, "steps descending stairs, Hz");
  v.Field("stairs_up_swing_mps2", s.stairs_up_swing_mps2,
          "vertical acceleration of a step up, peak to peak, m/s2");
  v.Field("stairs_down_swing_mps2", s.stairs_down_swing_mps2,
          "vertical acceleration of a step down, peak to peak, m/s2");
}
template <typename Visitor>
void Visit(Visitor& v, RideSettings& s) {
  v.Field("lift_speed_mps", s.lift_speed_mps, "at full speed, m/s");
  v.Field("lift_acceleration_mps2", s.lift_acceleration_mps2, "largest, m/s2");
  v.Field("door_s", s.door_s, "for which doors open or close, s");
  v.Field("escalator_speed_mps", s.escalator_speed_mps, "along the incline, m/s");
  v.Field("escalator_slope_deg", s.escalator_slope_deg, "of the incline, degrees");
}
template <typename Visitor>
void Visit(Visitor& v, HoldSettings& s) {
  v.Field("pitch_rad", s.pitch_rad, "mean tilt of the phone, rad");
  v.Field("pitch_sigma_rad", s.pitch_sigma_rad, "its spread over walks, rad");
  v.Field("roll_sigma_rad", s.roll_sigma_rad, "spread of the roll over walks, rad");
  v.Field("sway_rad", s.sway_rad, "with steps and strides, rad");
  v.Field("offset_sigma_rad", s.offset_sigma_rad,
          "how far the phone points past the walking direction, over walks, rad");
  v.Field("wander_rad", s.wander_rad, "slow wandering of the hand, rad");
  v.Field("wander_s", s.wander_s, "its time constant, s");
}
template <typename Visitor>
void Visit(Visitor& v, InertialSettings& s) {
  v.Field("acceleration_noise_mps2", s.acceleration_noise_mps2, "white, per sample and axis, m/s2");
  v.Field("acceleration_bias_sigma_mps2", s.acceleration_bias_sigma_mps2,
          "constant, per axis, over phones, m/s2");
  v.Field("gyro_noise_radps", s.gyro_noise_radps, "white, per sample and axis, rad/s");
  v.Field("gyro_bias_sigma_radps", s.gyro_bias_sigma_radps,
          "at the start, per axis, over walks, rad/s");
  v.Field("gyro_bias_walk_radps_per_sqrt_s", s.gyro_bias_walk_radps_per_sqrt_s,
          "its random walk, rad/s per square root of seconds");
}
template <typename Visitor>
void Visit(Visitor& v, MagneticSettings& s) {
  v.Field("rate_hz", s.rate_hz, "of magnetometer and rotation vector, Hz");
  v.Field("horizontal_ut", s.horizontal_ut, "Earth's field to the north, uT");
  v.Field("vertical_ut", s.vertical_ut, "Earth's field down, uT");
  v.Field("noise_ut", s.noise_ut, "white, per sample and axis, uT");
  v.Field("disturbance_ut", s.disturbance_ut, "of steel in the building, each component, uT");
  v.Field("disturbance_length_m", s.disturbance_length_m, "over which it persists, m");
  v.Field("yaw_offset_sigma_rad", s.yaw_offset_sigma_rad, "error of north that a walk keeps, rad");
  v.Field("yaw_wander_rad", s.yaw_wander_rad, "error of north that changes with time, rad");
  v.Field("yaw_wander_s", s.yaw_wander_s, "its time constant, s");
  v.Field("fusion_s", s.fusion_s,
          "time constant with which the rotation vector follows the field, s; 0: at once");
}
template <typename Visitor>
void Visit(Visitor& v, BarometerSettings& s) {
  v.Field("state", s.state, "works, missing, stops (half way) or constant");
  v.Field("unit", s.unit, "of what is written: hpa, pa or kpa");
  v.Field("rate_hz", s.rate_hz, "of samples, Hz");
  v.Field("weather_hpa", s.weather_hpa, "pressure at the frame's zero, mean over days, hPa");
  v.Field("weather_sigma_hpa", s.weather_sigma_hpa, "its spread over walks, hPa");
  v.Field("offset_sigma_hpa", s.offset_sigma_hpa, "of the sensor, over phones, hPa");
  v.Field("trend_sigma_hpa_per_h", s.trend_sigma_hpa_per_h,
          "rise or fall of the weather, over walks, hPa/h");
  v.Field("drift_hpa_per_sqrt_h", s.drift_hpa_per_sqrt_h,
          "random walk of the weather, hPa per square root of hours");
  v.Field("steps_per_hour", s.steps_per_hour,
          "doors and ventilation: how often the pressure steps");
  v.Field("step_sigma_hpa", s.step_sigma_hpa, "size of a step, hPa");
  v.Field("step_length_s", s.step_length_s, "for which it stays, mean, s");
  v.Field("noise_hpa", s.noise_hpa, "white, per sample, hPa");
  v.Field("wander_hpa", s.wander_hpa, "slow part of the noise, hPa");
  v.Field("wander_s", s.wander_s, "its time constant, s");
  v.Field("air_temperature_k", s.air_temperature_k,
          "of the air inside, K; 288.15: heights of the standard atmosphere");
}
template <typename Visitor>
void Visit(Visitor& v, PropagationSettings& s) {
  v.Field("exponent", s.exponent, "of path loss; 2: free space");
  v.Field("wall_loss_db", s.wall_loss_db, "per wall, dB");
  v.Field("outer_wall_loss_db", s.outer_wall_loss_db, "of senders outside, dB");
  v.Field("most_walls", s.most_walls, "that count");
  v.Field("floor_loss_db", s.floor_loss_db, "of one floor, dB");
  v.Field("floor_exponent", s.floor_exponent, "by which further floors count less");
  v.Field("height_over_floor_m", s.height_over_floor_m, "of access points, m");
  v.Field("shadow_sigma_db", s.shadow_sigma_db, "of shadowing, dB");
  v.Field("shadow_length_m", s.shadow_length_m, "over which it persists, m");
  v.Field("body_loss_db", s.body_loss_db, "between facing a sender and turning the back to it, dB");
  v.Field("reading_sigma_db", s.reading_sigma_db, "from reading to reading, dB");
}
template <typename Visitor>
void Visit(Visitor& v, WifiSettings& s) {
  v.Field("enabled", s.enabled, "whether there are access points");
  v.Field("per_floor", s.per_floor, "access points per floor and around it");
  v.Field("power_at_1m_dbm", s.power_at_1m_dbm, "mean, as received, dBm");
  v.Field("power_sigma_db", s.power_sigma_db, "spread over access points, dB");
  v.Field("neighbourhood_m", s.neighbourhood_m, "so far outside stand access points, m");
  v.Field("threshold_dbm", s.threshold_dbm, "weaker readings are not heard, dBm");
  v.Field("refresh_base", s.refresh_base, "share of sweeps that refresh a reading, floor, percent");
  v.Field("refresh_gain", s.refresh_gain, "what strong readings have more, percent");
  v.Field("refresh_middle_dbm", s.refresh_middle_dbm, "where half of it is reached, dBm");
  v.Field("refresh_width_db", s.refresh_width_db, "of the transition, dB");
  v.Field("shortest_sweep_s", s.shortest_sweep_s, "duration of a sweep, s");
  v.Field("longest_sweep_s", s.longest_sweep_s, "duration of a sweep, s");
  v.Field("keep_s", s.keep_s, "for which old readings are printed again, s");
  v.Field("run_up_s", s.run_up_s, "for which sweeps run before the recording, s");
  v.Field("latency_s", s.latency_s, "by which readings are stamped too early, s");
  v.Field("device_offset_sigma_db", s.device_offset_sigma_db, "over phones, dB");
}
template <typename Visitor>
void Visit(Visitor& v, BeaconSettings& s) {
  v.Field("enabled", s.enabled, "whether there are beacons");
  v.Field("per_floor", s.per_floor, "beacons per floor");
  v.Field("power_at_1m_dbm", s.power_at_1m_dbm, "mean, as received, dBm");
  v.Field("power_sigma_db", s.power_sigma_db, "spread over beacons, dB");
  v.Field("interval_s", s.interval_s, "between advertisements, s");
  v.Field("loss", s.loss, "share of them that the phone misses");
  v.Field("threshold_dbm", s.threshold_dbm, "weaker ones are not heard, dBm");
  v.Field("device_offset_sigma_db", s.device_offset_sigma_db, "over phones, dB");
}
template <typename Visitor>
void Visit(Visitor& v, ChangeSettings& s) {
  v.Field("vanished_share", s.vanished_share, "of the senders, silent in the test walks");
  v.Field("altered_share", s.altered_share, "of the senders, with another power in the test walks");
  v.Field("altered_sigma_db", s.altered_sigma_db, "of the change, dB");
}
template <typename Visitor>
void Visit(Visitor& v, SimulationSettings& s) {
  v.Group("building", s.building);
  v.Group("walks", s.walks);
  v.Group("gait", s.gait);
  v.Group("ride", s.ride);
  v.Group("hold", s.hold);
  v.Group("inertial", s.inertial);
  v.Group("magnetic", s.magnetic);
  v.Group("barometer", s.barometer);
  v.Group("propagation", s.propagation);
  v.Group("wifi", s.wifi);
  v.Group("beacon", s.beacon);
  v.Group("change", s.change);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_SETTINGS_VISIT_H_
