#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_MAP_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_MAP_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "data/recording.h"
#include "frontends/radio_map/body_shadow.h"

namespace walkgraph {

// A regular grid of control points over one floor. A field is a uniform cubic B-spline over them:
// twice differentiable, and it never overshoots its control values.
struct FieldGrid {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  // position of control point (0, 0)
  double spacing_m = 0;
  int columns = 0;  // along x
  int rows = 0;     // along y
};

// The 16 B-spline weights at a position and their derivatives, shared by all fields on a grid.
// Outside the grid the position is clamped to its edge and the derivative is zero.
struct FieldBasis {
  int column = 0;  // of the first of 4 x 4 control points
  int row = 0;
  std::array<double, 16> weight{};  // row-major: 4 rows of 4 columns
  std::array<double, 16> d_dx{};    // 1/m
  std::array<double, 16> d_dy{};    // 1/m
};

FieldBasis EvaluateBasis(const FieldGrid& grid, const Eigen::Vector2d& position_m);

// The same along one axis with `count` control points, at a coordinate in their spacings.
struct AxisBasis {
  int first = 0;  // of four control points
  std::array<double, 4> weight{};
  std::array<double, 4> derivative{};  // per spacing
};

AxisBasis EvaluateAxis(double coordinate, int count);

// A number that varies over a floor.
struct ScalarValue {
  double value = 0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // per metre
};

// The field whose control values on the whole grid, row-major, are given.
ScalarValue EvaluateField(const FieldGrid& grid, const std::vector<float>& control_values,
                          const FieldBasis& basis);

// One transmitter's expected reading at a position.
struct FieldValue {
  double mean_dbm = 0;
  double log_sigma = 0;   // of the spread in dB: measurement noise and ignorance together
  double logit_hear = 0;  // log odds of hearing it in one sweep
  Eigen::Vector2d d_mean = Eigen::Vector2d::Zero();  // per metre
  Eigen::Vector2d d_log_sigma = Eigen::Vector2d::Zero();
  Eigen::Vector2d d_logit_hear = Eigen::Vector2d::Zero();
};

// The smooth field of every transmitter of one radio on one floor.
class RadioMap {
 public:
  // Control values of one transmitter inside a rectangle of control points; outside the rectangle
  // the transmitter takes its background values.
  struct TransmitterField {
    std::uint32_t transmitter = 0;  // index into Site::transmitters
    int column = 0, row = 0, columns = 0, rows = 0;
    float background_mean_dbm = 0, background_log_sigma = 0, background_logit_hear = 0;
    std::vector<float> mean_dbm, log_sigma, logit_hear;  // rows x columns, row-major
    Eigen::Vector2f source_m = Eigen::Vector2f::Zero();  // where it seems to stand
  };

  int floor = 0;
  Radio radio = Radio::kWifi;
  FieldGrid grid;
  double sigma_min_db = 0;  // the smallest spread of any field
  // Calibrated on survey walks held out in turn (see trainer): how many independent readings a scan
  // is worth, and the sigma of the slow position error that all scans at a place share.
  double n_eff = 0;
  // Power that the probability of what was heard and missed is raised to: misses of one sweep go
  // together (a channel not scanned misses all of its transmitters), more so than signal strengths.
  double hear_weight = 1;
  double map_error_sigma_m = 0;
  // Metres that this error grows per metre from the survey: d metres away its sigma is
  // sqrt(map_error_sigma_m^2 + (map_error_growth d)^2). Calibrated like it.
  double map_error_growth = 0;
  // Amplitude of the shadow of the walker's body on every reading (see body_shadow.h).
  double body_shadow_db = 0;
  std::vector<TransmitterField> fields;  // by transmitter
  // Sum over all transmitters of -log(1 - p_hear): a sweep that hears nothing costs this much.
  std::vector<float> silence_nats;  // on the whole grid, row-major
  // To the nearest scan of the survey, on the whole grid, row-major; empty: everywhere 0.
  std::vector<float> survey_distance_m;

  // Index into `fields`, or -1 where the floor never heard the transmitter.
  int FindField(std::uint32_t transmitter) const;
  FieldValue Evaluate(int field, const FieldBasis& basis) const;
  // The parts of it that a factor asks for, each at a third of the cost, and less without the
  // gradient, which then is zero.
  ScalarValue EvaluateMean(int field, const FieldBasis& basis, bool gradient = true) const;
  ScalarValue EvaluateLogSigma(int field, const FieldBasis& basis, bool gradient = true) const;
  ScalarValue EvaluateLogitHear(int field, const FieldBasis& basis, bool gradient = true) const;
  // The same without gradients, several times faster.
  FieldValue EvaluateValue(int field, const FieldBasis& basis) const;
  // What the body of somebody at a place who faces `ahead`, a unit vector, adds to a reading.
  BodyShadow ShadowOn(int field, const Eigen::Vector2d& position_m,
                      const Eigen::Vector2d& ahead) const;
  // Value and gradient (nats, nats/m) of silence_nats.
  ScalarValue Silence(const FieldBasis& basis) const {
    return EvaluateField(grid, silence_nats, basis);
  }
  // Value and gradient (m, 1) of survey_distance_m.
  ScalarValue SurveyDistance(const FieldBasis& basis) const {
    return survey_distance_m.empty() ? ScalarValue()
                                     : EvaluateField(grid, survey_distance_m, basis);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_RADIO_MAP_H_
