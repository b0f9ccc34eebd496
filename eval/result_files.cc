#include "eval/result_files.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "eval/files.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

// "," and the value, or "," alone for NaN.
void AppendField(double value, int digits, std::string* row) {
  *row += ',';
  if (std::isnan(value)) return;
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
  *row += buffer.data();
}

void AppendInteger(int value, std::string* row) {
  *row += ',';
  *row += std::to_string(value);
}

std::string ScoreRow(const WalkOutcome& walk, const std::string& method,
                     const MethodOutcome& outcome) {
  const ErrorSummary errors = Summarise(outcome.errors);
  std::string row =
      walk.walk + "," + method + "," + std::to_string(walk.fold) + "," + std::to_string(errors.n);
  for (const double value : {errors.mean_m, errors.rmse_m, errors.median_m, errors.p75_m,
                             errors.p90_m, errors.p95_m, errors.max_m}) {
    AppendField(value, 4, &row);
  }
  for (const double value : {errors.floor_accuracy, errors.coverage50, errors.coverage95,
                             errors.nees, walk.survey_distance_m, walk.duration_s}) {
    AppendField(value, 4, &row);
  }
  row += ',';
  row += StatusName(outcome.status);
  return row + '\n';
}

Json Point(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

Json Rings(const std::vector<Polygon>& polygons) {
  Json rings = Json::array();
  for (const Polygon& polygon : polygons) {
    Json ring = Json::array();
    for (const Eigen::Vector2d& vertex : polygon) ring.push_back(Point(vertex));
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace

std::string FormatTrajectoryCsv(const Trajectory& trajectory) {
  std::string text =
      "time_ns,x_m,y_m,z_m,floor,heading_rad,cov_xx,cov_xy,cov_yy,cov_zz,cov_hh,modes\n";
  for (const PoseEstimate& pose : trajectory.poses) {
    text += std::to_string(pose.time_ns);
    for (int i = 0; i < 3; ++i) AppendField(pose.position_m[i], 4, &text);
    AppendInteger(pose.floor, &text);
    AppendField(pose.heading_rad, 5, &text);
    AppendField(pose.covariance_xy_m2(0, 0), 6, &text);
    AppendField(pose.covariance_xy_m2(0, 1), 6, &text);
    AppendField(pose.covariance_xy_m2(1, 1), 6, &text);
    AppendField(pose.variance_z_m2, 6, &text);
    AppendField(pose.variance_heading_rad2, 6, &text);
    AppendInteger(pose.modes, &text);
    text += '\n';
  }
  return text;
}

std::string FormatTrajectoryTum(const Trajectory& trajectory) {
  std::string text;
  for (const PoseEstimate& pose : trajectory.poses) {
    std::array<char, 256> row;
    std::snprintf(row.data(), row.size(), "%lld.%09lld %.4f %.4f %.4f 0 0 %.6f %.6f\n",
                  static_cast<long long>(pose.time_ns / kNsPerSecond),
                  static_cast<long long>(pose.time_ns % kNsPerSecond), pose.position_m.x(),
                  pose.position_m.y(), pose.position_m.z(), std::sin(pose.heading_rad / 2),
                  std::cos(pose.heading_rad / 2));
    text += row.data();
  }
  return text;
}

std::string FormatStatesCsv(const std::vector<SlowStateEstimate>& states) {
  std::string text = "state,time_ns,value,sigma\n";
  for (const SlowStateEstimate& state : states) {
    text += state.name + "," + std::to_string(state.time_ns);
    AppendField(state.value, 6, &text);
    AppendField(state.sigma, 6, &text);
    text += "\n";
  }
  return text;
}

std::string FormatScoresCsv(const Evaluation& evaluation) {
  std::string text =
      "walk,method,fold,n,mean_m,rmse_m,median_m,p75_m,p90_m,p95_m,max_m,floor_accuracy,"
      "coverage50,coverage95,nees,survey_distance_m,duration_s,status\n";
  for (const WalkOutcome& walk : evaluation.walks) {
    if (!walk.finished) continue;
    for (std::size_t i = 0; i < evaluation.methods.size(); ++i) {
      text += ScoreRow(walk, evaluation.methods[i], walk.methods[i]);
    }
  }
  return text;
}

std::string FormatWalkJson(const WalkOutcome& outcome, const std::vector<std::string>& methods) {
  Json json = {{"walk", outcome.walk}, {"fold", outcome.fold}};
  json["survey_distance_m"] = outcome.survey_distance_m;  // null where it is not finite
  json["waypoints"] = Json::array();
  for (const Waypoint& waypoint : outcome.truth.waypoints) {
    json["waypoints"].push_back({{"time_ns", waypoint.time_ns},
                                 {"x_m", waypoint.position.x()},
                                 {"y_m", waypoint.position.y()},
                                 {"floor", waypoint.floor}});
  }
  json["methods"] = Json::object();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const MethodOutcome& method = outcome.methods[i];
    Json errors = Json::array(), nees = Json::array();
    for (const WaypointError& error : method.errors) {
      errors.push_back(error.error_m);
      nees.push_back(error.nees);  // null where there is no covariance
    }
    json["methods"][methods[i]] = {{"status", StatusName(method.status)},
                                   {"messages", method.messages},
                                   {"errors_m", errors},
                                   {"nees", nees}};
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string FormatBuildingJson(const Building& building) {
  Json json = {{"name", building.name}, {"floors", Json::array()}};
  for (const Floor& floor : building.floors) {
    Json item = {{"number", floor.number},
                 {"name", floor.name},
                 {"height_m", floor.height_m},
                 {"min_corner_m", Point(floor.min_corner)},
                 {"max_corner_m", Point(floor.max_corner)},
                 {"outline_m", Rings(floor.outline)},
                 {"obstacles_m", Rings(floor.obstacles)}};
    if (!floor.image.path.empty()) {
      item["image"] = {{"path", floor.image.path},
                       {"min_corner_m", Point(floor.image.min_corner)},
                       {"max_corner_m", Point(floor.image.max_corner)}};
    }
    json["floors"].push_back(item);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json StatisticsRows(const std::vector<FactorStatistics>& statistics) {
  Json rows = Json::array();
  for (const FactorStatistics& s : statistics) {
    rows.push_back({{"factor", s.factor},
                    {"count", s.count},
                    {"mean_squared_whitened", s.mean_squared_whitened},
                    {"downweighted", s.downweighted}});
  }
  return rows;
}

std::string FormatExplanation(const EstimateResult& result, const Evidence& evidence) {
  Json json = {{"factors", StatisticsRows(result.factor_statistics)},
               {"residuals", Json::object()},
               {"hypotheses", Json::array()},
               {"readings_ns", Json::array()},
               {"barometer", Json::array()}};
  const Stream<double>& barometer = evidence.barometric_height_m;
  for (std::size_t i = 0; i < barometer.size(); ++i) {
    json["barometer"].push_back(Json::array({barometer.time_ns[i], barometer.value[i]}));
  }
  if (!result.innovations.empty()) json["innovations"] = StatisticsRows(result.innovations);
  for (const FactorResidual& r : result.residuals) {
    json["residuals"][r.factor].push_back(
        Json::array({r.time_ns, r.mean_squared_whitened, r.count, r.downweighted}));
  }
  for (const Hypothesis& h : result.hypotheses) {
    json["hypotheses"].push_back({{"source", h.source},
                                  {"negative_log_posterior", h.negative_log_posterior},
                                  {"kept", h.kept}});
  }
  for (const RadioReading& reading : evidence.readings) {
    Json& times = json["readings_ns"];
    if (times.empty() || times.back() != reading.heard_ns) times.push_back(reading.heard_ns);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void WriteEstimate(const std::string& out, const std::string& walk, const Evidence& evidence,
                   const std::string& method, const EstimateResult& result, bool tum) {
  const std::string name = walk + "." + method;
  if (!result.residuals.empty()) {
    WriteFileWhole(out + "/explain/" + name + ".json", FormatExplanation(result, evidence));
  }
  if (!result.trajectory.empty()) {
    WriteFileWhole(out + "/trajectories/" + name + ".csv", FormatTrajectoryCsv(result.trajectory));
    if (tum) {
      WriteFileWhole(out + "/trajectories/" + name + ".tum",
                     FormatTrajectoryTum(result.trajectory));
    }
  }
  if (!result.slow_states.empty()) {
    WriteFileWhole(out + "/states/" + name + ".csv", FormatStatesCsv(result.slow_states));
  }
}

}  // namespace walkgraph
