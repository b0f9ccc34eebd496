#ifndef WALKGRAPH_FRONTENDS_SETTINGS_H_
#define WALKGRAPH_FRONTENDS_SETTINGS_H_

#include "data/reader_settings.h"

namespace walkgraph {

// Parameters of the frontends. Like factors/settings.h, one Visit() per struct names every key
// once: a visitor has `Field(key, value&, documentation)` and `Group(key, struct&)`.

// Complementary filter of the direction of gravity.
struct GravityFilterSettings {
  // Against the phones' own fusion (rotation vector) 1-4 s agree best, to 0.8-1.5 deg rms, on the
  // ilc20 and ipin2023 recordings; shorter follows the gait, longer drifts with the gyroscope.
  double time_constant_s = 2.0;
  double start_window_s = 1.0;  // mean acceleration over this span starts the filter
};

// Signs that a hand plays with the phone. While walking with the phone in view the tilt spread is
// 9 deg in the 99th percentile of ilc20 and the sway at most 0.9 rad in all of ilc20 and ipin2023.
// While the phone is waved to calibrate it (first half minute of ipin2023) the spread has a median
// of 24 deg, and 98 % of the time one of the two is beyond what is set here.
struct HandlingSettings {
  double tilt_window_s = 2.0;
  double tilt_spread_rad = 0.26;
  double sway_window_s = 3.0;
  double sway_rad = 1.2;
  double yaw_smoothing_s = 0.3;
  double merge_gap_s = 2.0;
};

// Peaks of vertical acceleration between zero crossings.
struct StepDetectorSettings {
  double smoothing_s = 0.2;  // two centred means of this width: zero at 5 Hz, half power at 1.6 Hz
  double detrend_s = 2.0;    // removes what is slower than a step
  double min_swing_mps2 = 0.6;  // smallest peak to valley, m/s^2: a standing person stays below
  double swing_ratio = 0.4;     // of the swing of a sine with the local rms
  double rms_window_s = 3.0;
  double min_interval_s = 0.3;  // no walker takes more than 3.3 steps a second
  double max_interval_s = 1.5;  // a step with no neighbour closer than this is not walking
  double weinberg_k = 0.45;     // m / (m/s^2)^(1/4)
  bool fourier_confirmation = false;
  double fourier_window_s = 5.0;  // ten steps: the frequency is known to a fraction of one
};

// Integration of the gyroscope about the vertical.
struct YawSettings {
  double max_gap_s = 0.25;  // longer breaks are bridged and counted
};

// Absolute heading and its own quality.
struct HeadingQualitySettings {
  // Disagreement with the gyroscope is measured over this span. Of 2, 5 and 10 s and of the norm
  // and inclination of the field, 10 s tells good legs from bad best: on ipin2023 the quarter of
  // the straight legs that agree best are off by 7.5 deg rms, the worst quarter by 17.7.
  double window_s = 10.0;
};

struct PressureSettings {
  double constant_s = 10.0;  // a sensor that repeats one value for longer than this is stuck
  double silent_s = 5.0;     // one that ends so long before the recording has stopped
  // Samples closer than this say the same twice: ipin2023's 6-10 Hz follow a slow wander.
  double mean_s = 1.0;
};

// From a file to evidence.
struct FrontendSettings {
  ReaderSettings reader;
  GravityFilterSettings gravity;
  HandlingSettings handling;
  StepDetectorSettings steps;
  YawSettings yaw;
  HeadingQualitySettings heading;
  PressureSettings pressure;
};

template <typename Visitor>
void Visit(Visitor& v, GravityFilterSettings& s) {
  v.Field("time_constant_s", s.time_constant_s, "pull of the accelerometer on gravity, s");
  v.Field("start_window_s", s.start_window_s, "mean acceleration that starts the filter, s");
}
template <typename Visitor>
void Visit(Visitor& v, HandlingSettings& s) {
  v.Field("tilt_window_s", s.tilt_window_s, "span over which the spread of gravity is taken, s");
  v.Field("tilt_spread_rad", s.tilt_spread_rad, "spread of gravity that means handling, rad");
  v.Field("sway_window_s", s.sway_window_s, "span over which yaw to and fro is taken, s");
  v.Field("sway_rad", s.sway_rad,
          "yaw to and fro, beyond one turn to each side, that means handling, rad");
  v.Field("yaw_smoothing_s", s.yaw_smoothing_s, "yaw is averaged over this span first, s");
  v.Field("merge_gap_s", s.merge_gap_s, "handling episodes closer than this are one, s");
}
template <typename Visitor>
void Visit(Visitor& v, StepDetectorSettings& s) {
  v.Field("smoothing_s", s.smoothing_s, "width of the two smoothing means, s");
  v.Field("detrend_s", s.detrend_s, "width of the mean that is taken off, s");
  v.Field("min_swing_mps2", s.min_swing_mps2, "smallest peak to valley of a step, m/s^2");
  v.Field("swing_ratio", s.swing_ratio, "smallest peak to valley against the local swing");
  v.Field("rms_window_s", s.rms_window_s, "span of the local swing, s");
  v.Field("min_interval_s", s.min_interval_s, "shortest time between two steps, s");
  v.Field("max_interval_s", s.max_interval_s, "longest time between two steps of a walk, s");
  v.Field("weinberg_k", s.weinberg_k, "step length over the fourth root of its swing");
  v.Field("fourier_confirmation", s.fourier_confirmation,
          "confirm peaks by the walking frequency of a Fourier transform (DSFF)");
  v.Field("fourier_window_s", s.fourier_window_s, "span of that transform, s");
}
template <typename Visitor>
void Visit(Visitor& v, YawSettings& s) {
  v.Field("max_gap_s", s.max_gap_s, "longer breaks of the gyroscope are counted, s");
}
template <typename Visitor>
void Visit(Visitor& v, HeadingQualitySettings& s) {
  v.Field("window_s", s.window_s, "span of the comparison with the gyroscope, s");
}
template <typename Visitor>
void Visit(Visitor& v, PressureSettings& s) {
  v.Field("constant_s", s.constant_s, "one value for longer than this is a stuck sensor, s");
  v.Field("silent_s", s.silent_s, "a barometer that ends so long before the walk has stopped, s");
  v.Field("mean_s", s.mean_s, "pressure is averaged over this span, s");
}
template <typename Visitor>
void Visit(Visitor& v, FrontendSettings& s) {
  v.Group("reader", s.reader);
  v.Group("gravity", s.gravity);
  v.Group("handling", s.handling);
  v.Group("steps", s.steps);
  v.Group("yaw", s.yaw);
  v.Group("heading", s.heading);
  v.Group("pressure", s.pressure);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_SETTINGS_H_
