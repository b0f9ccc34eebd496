#include "eval/inspect.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "data/angle.h"
#include "eval/table.h"
#include "frontends/build_evidence.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
StreamFigures FiguresOf(const char* name, const Stream<T>& stream, const Recording& recording) {
  StreamFigures figures;
  figures.name = name;
  figures.samples = static_cast<std::int64_t>(stream.size());
  if (stream.empty()) return figures;
  figures.starts_after_s = SecondsBetween(recording.begin_ns, stream.time_ns.front());
  figures.stops_before_s = SecondsBetween(stream.time_ns.back(), recording.end_ns);
  if (stream.size() < 2) return figures;
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < stream.size(); ++i) {
    intervals_s.push_back(SecondsBetween(stream.time_ns[i - 1], stream.time_ns[i]));
  }
  std::sort(intervals_s.begin(), intervals_s.end());
  const double median_s = intervals_s[intervals_s.size() / 2];
  figures.rate_hz = 1.0 / median_s;
  figures.longest_gap_s = intervals_s.back();
  figures.gaps = static_cast<int>(
      intervals_s.end() - std::upper_bound(intervals_s.begin(), intervals_s.end(), 10 * median_s));
  return figures;
}

void CountEvidence(const Evidence& evidence, std::map<std::string, std::int64_t>* counts) {
  *counts = evidence.counts;
  (*counts)["steps"] = static_cast<std::int64_t>(evidence.steps.size());
  (*counts)["motion_intervals"] = static_cast<std::int64_t>(evidence.motion.size());
  (*counts)["gyro_yaw_samples"] = static_cast<std::int64_t>(evidence.gyro_yaw_rad.size());
  (*counts)["absolute_headings"] = static_cast<std::int64_t>(evidence.absolute_heading_rad.size());
  (*counts)["barometric_heights"] = static_cast<std::int64_t>(evidence.barometric_height_m.size());
  (*counts)["readings"] = static_cast<std::int64_t>(evidence.readings.size());
}

Json HeadingJson(const HeadingFigures& figures) {
  return {
      {"samples", figures.samples}, {"mean_rad", figures.MeanRad()}, {"rms_rad", figures.RmsRad()}};
}

Json SensorsJson(const SensorFigures& figures) {
  Json json = {{"heading_walking", HeadingJson(figures.heading_walking)},
               {"heading_standing", HeadingJson(figures.heading_standing)},
               {"legs", Json::array()}};
  for (const LegFigures& leg : figures.legs) {
    json["legs"].push_back({{"begin_ns", leg.begin_ns},
                            {"end_ns", leg.end_ns},
                            {"true_m", leg.true_m},
                            {"estimated_m", leg.estimated_m},
                            {"steps", leg.steps},
                            {"straight", leg.straight}});
  }
  return json;
}

std::string FormatCounts(const std::string& title,
                         const std::map<std::string, std::int64_t>& counts) {
  if (counts.empty()) return "";
  std::string text = title + ":";
  for (const auto& [name, count] : counts) text += " " + name + "=" + std::to_string(count);
  return text + "\n";
}

}  // namespace

Inspection InspectWalk(const Walk& walk, const Building& building,
                       const FrontendSettings& settings) {
  const Recording& recording = walk.recording;
  Inspection inspection;
  inspection.id = recording.id;
  inspection.device = recording.device;
  inspection.report = walk.report;
  inspection.duration_s = SecondsBetween(recording.begin_ns, recording.end_ns);
  inspection.streams = {FiguresOf("accelerometer_mps2", recording.accelerometer_mps2, recording),
                        FiguresOf("gyroscope_radps", recording.gyroscope_radps, recording),
                        FiguresOf("magnetometer_ut", recording.magnetometer_ut, recording),
                        FiguresOf("rotation_vector", recording.rotation_vector, recording),
                        FiguresOf("pressure_hpa", recording.pressure_hpa, recording)};
  inspection.radio_rows = static_cast<std::int64_t>(recording.radio_rows.size());
  for (const Transmitter& transmitter : recording.transmitters) {
    ++inspection.transmitters[RadioName(transmitter.radio)];
  }
  const Evidence evidence = BuildEvidence(recording, settings);
  CountEvidence(evidence, &inspection.evidence);
  inspection.waypoints = static_cast<std::int64_t>(walk.truth.waypoints.size());
  if (walk.truth.frame == TruthFrame::kBuilding || building.origin) {
    const double rotation_rad = building.origin ? -building.origin->rotation_rad : 0.0;
    inspection.sensors =
        ComputeSensorFigures(evidence, ToBuildingFrame(walk.truth, building), rotation_rad);
  }
  return inspection;
}

std::string FormatInspection(const Inspection& inspection) {
  const ReadReport& report = inspection.report;
  std::string text = inspection.id + "  (" + report.format + ", " +
                     (inspection.device.empty() ? "unknown device" : inspection.device) + ", " +
                     FixedDecimals(inspection.duration_s, 1) + " s, " +
                     std::to_string(report.lines) + " lines)\n";
  Table table({"stream", "samples", "Hz", "longest gap s", "gaps", "starts s", "stops s"});
  for (const StreamFigures& stream : inspection.streams) {
    table.AddRow({stream.name, std::to_string(stream.samples), FixedDecimals(stream.rate_hz, 1),
                  FixedDecimals(stream.longest_gap_s, 3), std::to_string(stream.gaps),
                  "+" + FixedDecimals(stream.starts_after_s, 2),
                  "-" + FixedDecimals(stream.stops_before_s, 2)});
  }
  text += table.Format();
  text += "radio rows: " + std::to_string(inspection.radio_rows) +
          "  waypoints: " + std::to_string(inspection.waypoints) + "\n";
  text += FormatCounts("transmitters", inspection.transmitters);
  text += FormatCounts("evidence", inspection.evidence);
  text += FormatCounts("records", report.records);
  text += report.hazards.empty() ? "hazards: none\n" : FormatCounts("hazards", report.hazards);
  if (report.first_malformed_line > 0) {
    text += "first malformed line: " + std::to_string(report.first_malformed_line) + "\n";
  }
  if (report.cut_last_line) text += "the last line is cut\n";
  return text;
}

std::string FormatSensorSummary(const std::vector<Inspection>& inspections) {
  std::vector<SensorFigures> figures;
  for (const Inspection& inspection : inspections) figures.push_back(inspection.sensors);
  const SensorSummary sum = Summarize(figures);
  if (sum.legs == 0 && sum.heading_walking.samples == 0) return "";
  const auto degrees = [](double rad) { return FixedDecimals(RadiansToDegrees(rad), 1); };
  const auto share = [](double value) { return FixedDecimals(100 * value, 1); };
  Table table({"sensors against truth", "n", "mean", "median", "rms or sd"});
  for (const auto& [name, heading] : {std::pair{"heading walking, deg", sum.heading_walking},
                                      std::pair{"heading standing, deg", sum.heading_standing}}) {
    table.AddRow({name, std::to_string(heading.samples), degrees(heading.MeanRad()), "-",
                  degrees(heading.RmsRad())});
  }
  table.AddRow({"distance rate, straight legs, %", std::to_string(sum.straight_legs),
                share(sum.distance_rate_mean), share(sum.distance_rate_median),
                share(sum.distance_rate_std)});
  table.AddRow({"displacement error, legs, %", std::to_string(sum.legs), "-",
                share(sum.displacement_error_median), "-"});
  return table.Format();
}

std::string FormatInspectionJson(const Inspection& inspection) {
  const ReadReport& report = inspection.report;
  Json json = {{"id", inspection.id},
               {"format", report.format},
               {"device", inspection.device},
               {"duration_s", inspection.duration_s},
               {"bytes", report.bytes},
               {"lines", report.lines},
               {"cut_last_line", report.cut_last_line},
               {"first_malformed_line", report.first_malformed_line},
               {"streams", Json::object()},
               {"radio_rows", inspection.radio_rows},
               {"transmitters", inspection.transmitters},
               {"waypoints", inspection.waypoints},
               {"evidence", inspection.evidence},
               {"records", report.records},
               {"hazards", report.hazards}};
  for (const StreamFigures& stream : inspection.streams) {
    json["streams"][stream.name] = {{"samples", stream.samples},
                                    {"rate_hz", stream.rate_hz},
                                    {"longest_gap_s", stream.longest_gap_s},
                                    {"gaps", stream.gaps},
                                    {"starts_after_s", stream.starts_after_s},
                                    {"stops_before_s", stream.stops_before_s}};
  }
  json["sensors"] = SensorsJson(inspection.sensors);
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace walkgraph
