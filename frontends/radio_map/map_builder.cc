#include "frontends/radio_map/map_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "frontends/radio_map/hearing.h"
#include "frontends/radio_map/survey_scans.h"
#include "frontends/radio_map/survey_shadows.h"

namespace walkgraph {
namespace {

// Transmitters that the field model is fitted on; more change it by less than a step of the
// ladders.
constexpr std::size_t kFitTransmitters = 60;

// The readings of one walk in one cell, in their order.
using Cell = std::vector<const FieldSample*>;

std::vector<Cell> CellsOf(const std::vector<FieldSample>& readings, double spacing_m) {
  using Key = std::tuple<std::uint32_t, long, long>;
  std::vector<std::pair<Key, const FieldSample*>> by_cell;
  by_cell.reserve(readings.size());
  for (const FieldSample& reading : readings) {
    const Eigen::Vector2d cell = reading.position_m / spacing_m;
    by_cell.push_back({{reading.walk, std::lround(cell.x()), std::lround(cell.y())}, &reading});
  }
  std::sort(by_cell.begin(), by_cell.end());
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < by_cell.size(); ++i) {
    if (i == 0 || by_cell[i].first != by_cell[i - 1].first) cells.emplace_back();
    cells.back().push_back(by_cell[i].second);
  }
  return cells;
}

// No more than `max_samples` of them, by cells as wide as it takes.
std::vector<Cell> CellsOf(const std::vector<FieldSample>& readings, double spacing_m,
                          std::size_t max_samples) {
  std::vector<Cell> cells = CellsOf(readings, spacing_m);
  // One sample per walk is as far as merging goes.
  while (cells.size() > max_samples && spacing_m < 1e4) {
    spacing_m *= 1.5;
    cells = CellsOf(readings, spacing_m);
  }
  return cells;
}

FieldSample MeanOf(const Cell& cell) {
  FieldSample mean{.walk = cell.front()->walk, .trial = cell.front()->trial};
  for (const FieldSample* reading : cell) {
    mean.position_m += reading->position_m;
    mean.rssi_dbm += reading->rssi_dbm;
  }
  mean.position_m /= static_cast<double>(cell.size());
  mean.rssi_dbm /= static_cast<double>(cell.size());
  return mean;
}

std::vector<FieldSample> MeansOf(const std::vector<Cell>& cells) {
  std::vector<FieldSample> means;
  means.reserve(cells.size());
  for (const Cell& cell : cells) means.push_back(MeanOf(cell));
  return means;
}

// Every transmitter's readings, without what a device and a body add to them.
std::map<std::uint32_t, std::vector<FieldSample>> CollectReadings(const ScanList& scans,
                                                                  const MapDetail& detail) {
  std::map<std::uint32_t, std::vector<FieldSample>> readings;
  for (const SurveyScan* scan : scans) {
    for (const SurveyReading& reading : scan->readings) {
      if (!detail.transmitters.Has(reading.transmitter)) continue;
      if (detail.fits && !detail.fits(*scan, reading)) continue;
      readings[reading.transmitter].push_back(
          {reading.position_m.cast<double>(),
           double{reading.rssi_dbm} - scan->device_offset_db - reading.shadow_db, scan->walk,
           scan->trial});
    }
  }
  return readings;
}

using Selection = std::vector<const std::vector<FieldSample>*>;

// An even selection of the transmitters that several trials heard.
Selection SelectForFit(const std::map<std::uint32_t, std::vector<FieldSample>>& readings) {
  Selection eligible;
  for (const auto& [transmitter, list] : readings) {
    const bool several_trials = std::any_of(list.begin(), list.end(), [&](const FieldSample& s) {
      return s.trial != list.front().trial;
    });
    if (several_trials && list.size() >= 6) eligible.push_back(&list);
  }
  if (eligible.size() <= kFitTransmitters) return eligible;
  Selection selection;
  for (std::size_t i = 0; i < kFitTransmitters; ++i) {
    selection.push_back(eligible[i * eligible.size() / kFitTransmitters]);
  }
  return selection;
}

void SetRectangle(const FieldGrid& grid, const std::vector<FieldSample>& samples, double margin_m,
                  RadioMap::TransmitterField* field) {
  Eigen::Vector2d low = samples.front().position_m, high = low;
  for (const FieldSample& sample : samples) {
    low = low.cwiseMin(sample.position_m);
    high = high.cwiseMax(sample.position_m);
  }
  const Eigen::Vector2d first = (low.array() - margin_m - grid.origin_m.array()) / grid.spacing_m;
  const Eigen::Vector2d last = (high.array() + margin_m - grid.origin_m.array()) / grid.spacing_m;
  field->column = std::clamp(static_cast<int>(std::floor(first.x())), 0, grid.columns - 1);
  field->row = std::clamp(static_cast<int>(std::floor(first.y())), 0, grid.rows - 1);
  field->columns =
      std::clamp(static_cast<int>(std::ceil(last.x())), field->column, grid.columns - 1) -
      field->column + 1;
  field->rows =
      std::clamp(static_cast<int>(std::ceil(last.y())), field->row, grid.rows - 1) - field->row + 1;
}

void FillSignal(const FieldGrid& grid, const FieldProcess& process, double sigma_scale,
                RadioMap::TransmitterField* field) {
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(field->columns) * field->rows);
  for (int row = 0; row < field->rows; ++row) {
    for (int column = 0; column < field->columns; ++column) {
      points.col(static_cast<Eigen::Index>(row) * field->columns + column) =
          grid.origin_m +
          grid.spacing_m * Eigen::Vector2d(field->column + column, field->row + row);
    }
  }
  Eigen::VectorXd mean, sigma;
  process.Predict(points, &mean, &sigma);
  const Eigen::VectorXf mean_f = mean.cast<float>();
  const Eigen::VectorXf log_sigma = (sigma_scale * sigma).array().log().matrix().cast<float>();
  field->mean_dbm.assign(mean_f.begin(), mean_f.end());
  field->log_sigma.assign(log_sigma.begin(), log_sigma.end());
  field->background_mean_dbm = static_cast<float>(process.far_mean_dbm());
  field->background_log_sigma = static_cast<float>(std::log(sigma_scale * process.far_sigma_db()));
}

std::vector<Eigen::Vector2d> SweepPlaces(const ScanList& scans) {
  std::vector<Eigen::Vector2d> places;
  for (const SurveyScan* scan : scans) places.push_back(MeanPosition(*scan));
  return places;
}

std::map<std::uint32_t, std::vector<std::size_t>> HeardIn(
    const ScanList& scans, const TransmitterSelection& transmitters) {
  std::map<std::uint32_t, std::vector<std::size_t>> heard;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (const SurveyReading& reading : scans[i]->readings) {
      if (!transmitters.Has(reading.transmitter)) continue;
      std::vector<std::size_t>& list = heard[reading.transmitter];
      if (list.empty() || list.back() != i) list.push_back(i);
    }
  }
  return heard;
}

double LeastSigma(const std::vector<RadioMap::TransmitterField>& fields) {
  float least = std::numeric_limits<float>::infinity();
  for (const RadioMap::TransmitterField& field : fields) {
    for (const float log_sigma : field.log_sigma) least = std::min(least, log_sigma);
    least = std::min(least, field.background_log_sigma);
  }
  return std::exp(static_cast<double>(least));
}

// Distance of every control point to the nearest scan.
std::vector<float> SurveyDistanceField(const FieldGrid& grid,
                                       const std::vector<Eigen::Vector2d>& sweep_places) {
  if (sweep_places.empty()) {
    return std::vector<float>(static_cast<std::size_t>(grid.columns) * grid.rows,
                              std::numeric_limits<float>::infinity());
  }
  // Places closer than a fraction of the grid's spacing are one.
  std::map<std::pair<long, long>, Eigen::Vector2f> cells;
  const float cell_m = 0.25F * static_cast<float>(grid.spacing_m);
  for (const Eigen::Vector2d& place : sweep_places) {
    const Eigen::Vector2f at = place.cast<float>();
    cells.try_emplace({std::lround(at.x() / cell_m), std::lround(at.y() / cell_m)}, at);
  }
  Eigen::ArrayXf x(static_cast<Eigen::Index>(cells.size())), y(x.size());
  Eigen::Index i = 0;
  for (const auto& [cell, place] : cells) {
    x[i] = place.x();
    y[i++] = place.y();
  }
  std::vector<float> distances;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2f control =
          (grid.origin_m + grid.spacing_m * Eigen::Vector2d(column, row)).cast<float>();
      const float nearest = ((x - control.x()).square() + (y - control.y()).square()).minCoeff();
      distances.push_back(std::sqrt(nearest));
    }
  }
  return distances;
}

}  // namespace

std::map<std::uint32_t, std::vector<FieldSample>> CollectSamples(const ScanList& scans,
                                                                 const TrainerSettings& settings,
                                                                 const MapDetail& detail) {
  std::map<std::uint32_t, std::vector<FieldSample>> samples = CollectReadings(scans, detail);
  for (auto& [transmitter, list] : samples) {
    list = MeansOf(CellsOf(list, settings.sample_spacing_m, detail.max_samples));
  }
  return samples;
}

double LeftOutSigmaScale(const ScanList& scans, const TrainerSettings& settings,
                         const FieldPrior& prior, const Executor& run) {
  const auto readings = CollectReadings(scans, {});
  const Selection selection = SelectForFit(readings);
  std::vector<Eigen::VectorXd> whitened(selection.size());
  run(selection.size(), [&](std::size_t i) {
    const std::vector<Cell> cells =
        CellsOf(*selection[i], settings.sample_spacing_m, MapDetail().max_samples);
    // One of each, so that who stands still does not count for more than who walks on.
    std::vector<FieldSample> middle;
    for (const Cell& cell : cells) middle.push_back(*cell[cell.size() / 2]);
    whitened[i] = FieldProcess(MeansOf(cells), prior).LeaveOneTrialOut(middle);
  });
  double sum = 0;
  Eigen::Index count = 0;
  for (const Eigen::VectorXd& of_transmitter : whitened) {
    sum += of_transmitter.squaredNorm();
    count += of_transmitter.size();
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 1.0;
}

FieldGrid GridOverBox(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m,
                      double spacing_m) {
  FieldGrid grid;
  grid.spacing_m = spacing_m;
  grid.origin_m = low_m.array() - 2.0 * spacing_m;
  const Eigen::Vector2d size = (high_m - low_m) / spacing_m;
  grid.columns = static_cast<int>(std::ceil(size.x())) + 5;
  grid.rows = static_cast<int>(std::ceil(size.y())) + 5;
  return grid;
}

FieldGrid CoveringGrid(const Floor* floor, const std::vector<SurveyPoint>& path, int floor_number,
                       const TrainerSettings& settings) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  if (floor != nullptr) {
    low = floor->min_corner;
    high = floor->max_corner;
  }
  for (const SurveyPoint& point : path) {
    if (point.floor != floor_number) continue;
    low = low.cwiseMin(point.position_m);
    high = high.cwiseMax(point.position_m);
  }
  return GridOverBox(low, high, settings.grid_spacing_m);
}

std::set<int> FloorsOf(const std::vector<SurveyScan>& scans) {
  std::set<int> floors;
  for (const SurveyScan& scan : scans) floors.insert(scan.floor);
  return floors;
}

FloorSurvey SurveyOfFloor(const Building& building, const std::vector<SurveyPoint>& path,
                          const std::vector<SurveyScan>& scans, int floor, Radio radio,
                          const TrainerSettings& settings) {
  FloorSurvey survey{floor, radio, {}, {}};
  survey.grid = CoveringGrid(building.FindFloor(floor), path, floor, settings);
  for (const SurveyScan& scan : scans) {
    if (scan.floor == floor && scan.radio == radio) survey.scans.push_back(&scan);
  }
  return survey;
}

MapInput MakeMapInput(const FloorSurvey& survey, const TrainerSettings& settings,
                      const MapDetail& detail) {
  MapInput input{survey.floor, survey.radio, survey.grid, {}, {}, {}, {}, {}};
  input.samples = CollectSamples(survey.scans, settings, detail);
  input.heard_in = HeardIn(survey.scans, detail.transmitters);
  input.sources_m = LocateSources(survey.scans, detail.transmitters);
  input.sweep_places = SweepPlaces(survey.scans);
  input.survey_distance_m = SurveyDistanceField(survey.grid, input.sweep_places);
  return input;
}

RadioMap BuildMap(const MapInput& input, const FieldModel& model, const TrainerSettings& settings,
                  const Executor& run) {
  RadioMap map;
  map.floor = input.floor;
  map.radio = input.radio;
  map.grid = input.grid;
  const HearingModel hearing(map.grid, input.sweep_places, model.hear_bandwidth_m,
                             settings.hear_prior_sweeps);
  for (const auto& [transmitter, samples] : input.samples) {
    map.fields.emplace_back().transmitter = transmitter;
  }
  run(map.fields.size(), [&](std::size_t f) {
    RadioMap::TransmitterField& field = map.fields[f];
    const std::vector<FieldSample>& samples = input.samples.at(field.transmitter);
    SetRectangle(map.grid, samples, settings.margin_m, &field);
    FillSignal(map.grid, FieldProcess(samples, model.prior), model.sigma_scale, &field);
    hearing.Fill(input.heard_in.at(field.transmitter), &field);
    field.source_m = input.sources_m.at(field.transmitter).cast<float>();
  });
  map.sigma_min_db = LeastSigma(map.fields);
  map.silence_nats = SilenceField(map.grid, map.fields);
  map.survey_distance_m = input.survey_distance_m;
  return map;
}

}  // namespace walkgraph
