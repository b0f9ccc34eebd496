#include "solvers/baselines/mufaf/site_cells.h"

#include <cmath>
#include <map>
#include <utility>

namespace walkgraph {
namespace {

constexpr double kPriorSamples = 4;
constexpr double kFallbackVarianceDb2 = 25;  // where no cell has two samples

struct CellSums {
  double count = 0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  Eigen::VectorXd first, second;  // sums of signals and of their squares
  std::vector<std::size_t> scans;

  Eigen::VectorXd Mean() const { return first / count; }
  Eigen::ArrayXd Deviations() const {
    return (second.array() - first.array().square() / count).max(0.0);
  }
};

SignalVector YoungReadings(const SurveyScan& scan, double max_age_s) {
  SignalVector signal;
  for (const SurveyReading& reading : scan.readings) {
    if (reading.age_s < max_age_s)
      signal.entries.push_back({reading.transmitter, reading.rssi_dbm});
  }
  return signal;
}

Eigen::Vector2d PlaceOf(const SurveyScan& scan) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SurveyReading& reading : scan.readings) sum += reading.position_m.cast<double>();
  return sum / static_cast<double>(scan.readings.size());
}

}  // namespace

SiteCells::SiteCells(const Site& site, int floor, Radio radio, double cell_m, double max_age_s,
                     double missing_dbm)
    : anchor_(site.transmitters.size(), -1), missing_dbm_(missing_dbm), map_(0) {
  std::vector<std::size_t> scans;
  Eigen::Index anchors = 0;
  for (std::size_t i = 0; i < site.scans.size(); ++i) {
    const SurveyScan& scan = site.scans[i];
    if (scan.floor != floor || scan.radio != radio || scan.readings.empty()) continue;
    scans.push_back(i);
    for (const SurveyReading& reading : scan.readings) {
      std::int32_t& anchor = anchor_[reading.transmitter];
      if (anchor < 0) anchor = static_cast<std::int32_t>(anchors++);
    }
  }
  map_ = CellMap(anchors);
  std::map<std::pair<long, long>, CellSums> cells;
  for (const std::size_t index : scans) {
    const SurveyScan& scan = site.scans[index];
    const std::optional<Eigen::VectorXd> signals = SignalsOf(YoungReadings(scan, max_age_s));
    if (!signals) continue;
    const Eigen::Vector2d place = PlaceOf(scan);
    CellSums& cell = cells[{std::lround(place.x() / cell_m), std::lround(place.y() / cell_m)}];
    if (cell.count == 0) cell.first = cell.second = Eigen::VectorXd::Zero(anchors);
    ++cell.count;
    cell.place += place;
    cell.first += *signals;
    cell.second += signals->cwiseAbs2();
    cell.scans.push_back(index);
  }
  double squares = 0, degrees_of_freedom = 0;
  for (const auto& [square, cell] : cells) {
    squares += cell.Deviations().sum();
    degrees_of_freedom += (cell.count - 1) * static_cast<double>(anchors);
  }
  const double pooled = squares > 0 ? squares / degrees_of_freedom : kFallbackVarianceDb2;
  for (auto& [square, cell] : cells) {
    const Eigen::VectorXd variance =
        (kPriorSamples * pooled + cell.Deviations()) / (kPriorSamples + cell.count - 1);
    map_.AddCell(cell.place / cell.count, cell.Mean(), variance, cell.count);
    scans_.push_back(std::move(cell.scans));
  }
}

std::optional<Eigen::VectorXd> SiteCells::SignalsOf(const SignalVector& scan) const {
  Eigen::VectorXd signals = Eigen::VectorXd::Constant(map_.anchors(), missing_dbm_);
  bool any = false;
  for (const SignalVector::Entry& entry : scan.entries) {
    const std::int32_t anchor = anchor_[entry.transmitter];
    if (anchor < 0) continue;
    signals(anchor) = entry.rssi_dbm;
    any = true;
  }
  if (!any) return std::nullopt;
  return signals;
}

}  // namespace walkgraph
