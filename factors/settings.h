#ifndef WALKGRAPH_FACTORS_SETTINGS_H_
#define WALKGRAPH_FACTORS_SETTINGS_H_

#include <cstdint>
#include <string>

#include "data/recording.h"

namespace walkgraph {

// Noise and switches of the factor types and slow states. One struct per factor, and one Visit()
// per struct that names every key once: the configuration file, `walkgraph config` and calibration
// are all made from it. A visitor has `Field(key, value&, documentation)` and `Group(key,
// struct&)`. Sigmas are what one sample deviates, in the unit of the name; none is a weight.

enum class LossKind : std::uint8_t { kNone, kHuber, kCauchy, kTruncated };

// Robust loss on a whitened residual's norm.
struct LossSettings {
  LossKind kind = LossKind::kNone;
  // Whitened norm where the loss leaves the parabola. Truncated: of a single row; one of two rows
  // is cut at the norm that is as rare (chi-square).
  double scale = 2.0;
};

// A slow state is estimated, held at its prior mean, or left out of the model (as if exactly zero).
enum class StateMode : std::uint8_t { kActive, kFixed, kAbsent };

struct StepSettings {
  bool enabled = true;
  double sigma_along_m = 0.10;
  double sigma_across_m = 0.10;
  double tread_m = 0.29;  // of stairs (Riener, Rabuffetti and Frigo 2002)
  LossSettings loss;
};

struct HeadingIncrementSettings {
  bool enabled = true;
  double sigma_rad_per_sqrt_s = 0.05;      // walking direction against integrated gyroscope
  double unmeasured_rad_per_sqrt_s = 1.0;  // what people turn where no gyroscope says so
  LossSettings loss;
};

struct AbsoluteHeadingSettings {
  bool enabled = true;
  double sigma_rad = 0.2;
  double correlation_s = 2.0;  // samples closer than this say the same thing twice
  LossSettings loss;
};

struct StandingSettings {
  bool enabled = true;
  double sigma_mps = 0.05;  // drift of a standing person, per sqrt(s) of standing
  double unseen_mps = 1.4;  // preferred walking speed (Browning et al. 2006): steps may be missed
  LossSettings loss;
};

struct FingerprintSettings {
  bool wifi = true;
  bool beacon = true;
  bool zigbee = true;
  double n_eff = 0;            // independent readings per scan; 0 takes the site's calibrated value
  double min_rssi_dbm = -120;  // weaker readings are not used
  bool refresh_rate = false;   // weak readings of a walking person are the less precise
  // Readings miss the map by far more than a normal density allows: people stand in the way, access
  // points change their power. 1.345 keeps 95 % of the efficiency where they do not (Huber 1981).
  LossSettings loss{LossKind::kHuber, 1.345};

  bool Uses(Radio radio) const {
    return radio == Radio::kWifi ? wifi : radio == Radio::kBeacon ? beacon : zigbee;
  }
};

// Of a phone's gyroscope. The walk is what walks of a minute cannot tell from none; calibration
// finds 0.0003 on ipin2023, whose walks are longer.
struct GyroBiasSettings {
  StateMode mode = StateMode::kActive;
  double prior_sigma_radps = 0.01;
  double walk_radps_per_sqrt_s = 0.0005;
  double knot_s = 20;
};

struct HeadingOffsetSettings {
  StateMode mode = StateMode::kActive;
  double prior_mean_rad = 0;
  double prior_sigma_rad = 0.2;
  double walk_rad_per_sqrt_s = 0.02;
  double knot_s = 10;
};

struct StepScaleSettings {
  StateMode mode = StateMode::kActive;
  double prior_mean = 1.0;
  double prior_sigma = 0.1;
  double walk_per_sqrt_s = 0.005;
  double knot_s = 20;
};

struct MapErrorSettings {
  StateMode mode = StateMode::kActive;
  double sigma_m = 0;  // stationary, per axis; 0 takes the site's calibrated value
  double correlation_m = 20;
  double correlation_s = 150;
  double knot_s = 5;
  bool grows = false;  // away from the survey, as calibrated
  bool widens = true;  // the same for covariances alone
};

struct RssiOffsetSettings {
  StateMode mode = StateMode::kActive;
  double prior_sigma_db = 3.0;
  bool from_survey = true;  // mean and spread of the same phone model's survey walks, where known
};

// Calibrated on ipin2023 (two phones, 38 recordings): means over a second repeat to 0.13 m.
struct BarometricSettings {
  bool enabled = true;
  double sigma_m = 0.13;
  LossSettings loss{LossKind::kHuber, 2.0};  // doors and ventilation move the air
};

// What the barometer's height has over the true one: weather, device and the site's altitude. Left
// free at the start; its drift is that of the same recordings, phones at rest. (Between waypoints
// of one level calibration finds 0.027.)
struct BarometricOffsetSettings {
  StateMode mode = StateMode::kActive;
  double prior_mean_m = 0;
  double prior_sigma_m = 1000;
  double walk_m_per_sqrt_s = 0.033;
  double knot_s = 10;
};

// Heights on a level and between levels.
struct LevelSettings {
  double sigma_m = 0.15;  // ramps, uneven ground, a phone held higher or lower
  // Of a person between levels, a random walk of the height: stairs rise by 0.2 to 0.5 m/s.
  double climb_m_per_sqrt_s = 0.5;
};

enum class AreaKind : std::uint8_t {
  kNone,      // a walk may lead anywhere
  kWalkable,  // the floor's outline without its obstacles; nothing where the plan has no outline
  kSurveyed,  // within reach of a survey path
};
inline constexpr std::array<std::string_view, 3> kAreaKindNames = {"none", "walkable", "surveyed"};

struct AreaSettings {
  AreaKind kind = AreaKind::kWalkable;
  double reach_m = 3;  // of a survey path
  double sigma_m = 1;  // how far outside a person gets who spends a second there
  bool connectors =
      false;  // hold people between two floors to the stairs and lifts of the building
};

// What the discrete floor model assumes. Our choice, spread and background looked at on ipin2023.
struct FloorSettings {
  double stay_s = 300;
  double change_s = 20;
  double spread_db = 8;
  double missing_dbm = -95;
  double n_eff = 4;  // independent readings per scan (field measurements: 3 to 4 of 100)
  // Weight of the whole building's looks on every floor against a floor's own, by number.
  double background = 0.3;
  double correlation_s = 20;  // what is heard within says the same thing again
};

struct MagneticLookSettings {
  bool enabled = false;
  double correlation_s = 0;  // 0: the site's calibrated value
};

struct PriorSettings {
  double position_sigma_m = 200;  // of a walk's start about the middle of the floor
};

struct FactorSettings {
  StepSettings step;
  HeadingIncrementSettings heading_increment;
  AbsoluteHeadingSettings absolute_heading;
  StandingSettings standing;
  FingerprintSettings fingerprint;
  MagneticLookSettings magnetic;
  GyroBiasSettings gyro_bias;
  HeadingOffsetSettings heading_offset;
  StepScaleSettings step_scale;
  MapErrorSettings map_error;
  RssiOffsetSettings rssi_offset;
  BarometricSettings barometric;
  BarometricOffsetSettings barometric_offset;
  LevelSettings level;
  AreaSettings area;
  FloorSettings floor;
  PriorSettings prior;
};

template <typename Visitor>
void Visit(Visitor& v, LossSettings& s) {
  v.Field("loss", s.kind, "robust loss on the whitened norm: none, huber, cauchy or truncated");
  v.Field("loss_scale", s.scale, "whitened norm where the loss leaves the parabola");
}
template <typename Visitor>
void Visit(Visitor& v, StepSettings& s) {
  v.Field("enabled", s.enabled, "use detected steps");
  v.Field("sigma_along_m", s.sigma_along_m, "error of one step's length, m");
  v.Field("sigma_across_m", s.sigma_across_m, "sideways error of one step, m");
  v.Field("tread_m", s.tread_m,
          "length of a step between levels at most, m; 0: as long as on a level");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, HeadingIncrementSettings& s) {
  v.Field("enabled", s.enabled, "use integrated gyroscope yaw between nodes");
  v.Field("sigma_rad_per_sqrt_s", s.sigma_rad_per_sqrt_s,
          "change of walking direction against the gyroscope, rad per square root of seconds");
  v.Field("unmeasured_rad_per_sqrt_s", s.unmeasured_rad_per_sqrt_s,
          "change of walking direction without a gyroscope, rad per square root of seconds");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, AbsoluteHeadingSettings& s) {
  v.Field("enabled", s.enabled, "use rotation vector or magnetometer heading");
  v.Field("sigma_rad", s.sigma_rad, "short-term error of an absolute heading, rad");
  v.Field("correlation_s", s.correlation_s, "samples closer than this are one sample, s");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, StandingSettings& s) {
  v.Field("enabled", s.enabled, "hold the position between nodes while standing");
  v.Field("sigma_mps", s.sigma_mps, "drift of a standing person, m per square root of seconds");
  v.Field("unseen_mps", s.unseen_mps,
          "speed of a person who may be walking although no step was detected, m/s");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, FingerprintSettings& s) {
  v.Field("wifi", s.wifi, "use Wi-Fi readings");
  v.Field("beacon", s.beacon, "use beacon readings");
  v.Field("zigbee", s.zigbee, "use ZigBee readings");
  v.Field("n_eff", s.n_eff, "independent readings per scan; 0 takes the site's calibrated value");
  v.Field("min_rssi_dbm", s.min_rssi_dbm, "weaker readings are not used, dBm");
  v.Field("refresh_rate", s.refresh_rate,
          "give weak readings of a walking person the greater variance of TCPF's refresh rate");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, MagneticLookSettings& s) {
  v.Field("enabled", s.enabled, "use the magnetic field where readings say what it is asked about");
  v.Field("correlation_s", s.correlation_s,
          "samples of so long are worth one, s; 0 takes the site's calibrated value");
}
template <typename Visitor>
void Visit(Visitor& v, GyroBiasSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("prior_sigma_radps", s.prior_sigma_radps, "bias at the start, rad/s");
  v.Field("walk_radps_per_sqrt_s", s.walk_radps_per_sqrt_s, "random walk, rad/s per sqrt(s)");
  v.Field("knot_s", s.knot_s, "knot spacing, s");
}
template <typename Visitor>
void Visit(Visitor& v, HeadingOffsetSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("prior_mean_rad", s.prior_mean_rad,
          "walking direction minus absolute heading, mean over walks, rad");
  v.Field("prior_sigma_rad", s.prior_sigma_rad, "spread of the offset over walks, rad");
  v.Field("walk_rad_per_sqrt_s", s.walk_rad_per_sqrt_s, "random walk, rad per sqrt(s)");
  v.Field("knot_s", s.knot_s, "knot spacing, s");
}
template <typename Visitor>
void Visit(Visitor& v, StepScaleSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("prior_mean", s.prior_mean, "true over modelled step length, mean over walks");
  v.Field("prior_sigma", s.prior_sigma, "spread of the scale over walks");
  v.Field("walk_per_sqrt_s", s.walk_per_sqrt_s, "random walk, per sqrt(s)");
  v.Field("knot_s", s.knot_s, "knot spacing, s");
}
template <typename Visitor>
void Visit(Visitor& v, MapErrorSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("sigma_m", s.sigma_m,
          "stationary error of the radio map per axis, m; 0 takes the site's calibrated value");
  v.Field("correlation_m", s.correlation_m, "distance over which the error persists, m");
  v.Field("correlation_s", s.correlation_s, "time over which it persists at one place, s");
  v.Field("knot_s", s.knot_s, "knot spacing, s");
  v.Field("grows", s.grows,
          "the error grows with the distance from the survey at the site's calibrated rate; false: "
          "it is the same everywhere");
  v.Field("widens", s.widens,
          "covariances take the error to grow so, poses do not; false: neither does");
}
template <typename Visitor>
void Visit(Visitor& v, RssiOffsetSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("prior_sigma_db", s.prior_sigma_db,
          "device offset per radio, of a phone model that the survey does not tell of, dB");
  v.Field("from_survey", s.from_survey,
          "expect of a phone what survey walks with its model show; false: nothing of any");
}
template <typename Visitor>
void Visit(Visitor& v, BarometricSettings& s) {
  v.Field("enabled", s.enabled, "use the barometer");
  v.Field("sigma_m", s.sigma_m, "error of a height by the barometer, m");
  Visit(v, s.loss);
}
template <typename Visitor>
void Visit(Visitor& v, BarometricOffsetSettings& s) {
  v.Field("mode", s.mode, "active, fixed or absent");
  v.Field("prior_mean_m", s.prior_mean_m,
          "height by the barometer minus height in the building frame, m");
  v.Field("prior_sigma_m", s.prior_sigma_m, "spread of the offset over recordings, m");
  v.Field("walk_m_per_sqrt_s", s.walk_m_per_sqrt_s, "random walk, m per sqrt(s)");
  v.Field("knot_s", s.knot_s, "knot spacing, s");
}
template <typename Visitor>
void Visit(Visitor& v, LevelSettings& s) {
  v.Field("sigma_m", s.sigma_m, "height of a person on a level about the level's, m");
  v.Field("climb_m_per_sqrt_s", s.climb_m_per_sqrt_s,
          "random walk of the height between levels, m per sqrt(s)");
}
template <typename Visitor>
void Visit(Visitor& v, AreaSettings& s) {
  v.Field(
      "kind", s.kind,
      "where people walk: none (anywhere), walkable (the plan) or surveyed (near survey paths)");
  v.Field("reach_m", s.reach_m, "a place this near a survey path is in the surveyed area, m");
  v.Field("sigma_m", s.sigma_m, "distance outside of a person who spends a second there, m");
  v.Field("connectors", s.connectors,
          "between two floors people are at the stairs and lifts that the building knows");
}
template <typename Visitor>
void Visit(Visitor& v, FloorSettings& s) {
  v.Field("stay_s", s.stay_s, "mean time on a floor, s");
  v.Field("change_s", s.change_s, "mean time between floors, s");
  v.Field("spread_db", s.spread_db, "difference of two scans of one place, dB");
  v.Field("missing_dbm", s.missing_dbm, "stands for a transmitter that was not heard, dBm");
  v.Field("n_eff", s.n_eff, "independent readings of all that is heard within a correlation time");
  v.Field("background", s.background,
          "weight of the whole building's looks on every floor against a floor's own");
  v.Field("correlation_s", s.correlation_s, "time over which what is heard stays the same, s");
}
template <typename Visitor>
void Visit(Visitor& v, PriorSettings& s) {
  v.Field("position_sigma_m", s.position_sigma_m,
          "prior of the first position about the middle of the floor, m");
}
template <typename Visitor>
void Visit(Visitor& v, FactorSettings& s) {
  v.Group("step", s.step);
  v.Group("heading_increment", s.heading_increment);
  v.Group("absolute_heading", s.absolute_heading);
  v.Group("standing", s.standing);
  v.Group("fingerprint", s.fingerprint);
  v.Group("magnetic", s.magnetic);
  v.Group("gyro_bias", s.gyro_bias);
  v.Group("heading_offset", s.heading_offset);
  v.Group("step_scale", s.step_scale);
  v.Group("map_error", s.map_error);
  v.Group("rssi_offset", s.rssi_offset);
  v.Group("barometric", s.barometric);
  v.Group("barometric_offset", s.barometric_offset);
  v.Group("level", s.level);
  v.Group("area", s.area);
  v.Group("floor", s.floor);
  v.Group("prior", s.prior);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_SETTINGS_H_
