#include "solvers/baselines/mufaf/site_update.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "frontends/radio_map/survey_scans.h"
#include "solvers/baselines/mufaf/map_update.h"
#include "solvers/baselines/mufaf/site_cells.h"

namespace walkgraph {
namespace {

// One radio on one floor.
class CellFeeder {
 public:
  CellFeeder(const Site& site, int floor, Radio radio, const MufafSettings& settings,
             const WknnSettings& wknn)
      : site_(site),
        floor_(floor),
        radio_(radio),
        settings_(settings),
        wknn_(wknn),
        cells_(site, floor, radio, settings.cell_m, wknn.max_age_s, wknn.missing_dbm),
        adaptive_(cells_.map(), settings.update) {
    for (const std::vector<std::size_t>& scans : cells_.scans()) {
      samples_.emplace_back(scans.begin(), scans.end());
    }
  }

  // Appends the scans that are taken to the site, and the indices of those that they replace to
  // `retired`.
  void Feed(const SurveyWalk& walk, std::uint32_t number, CellUpdate* update,
            std::set<std::size_t>* retired) {
    if (cells_.map().size() < 2) return;
    for (const QueryScan& scan :
         CollectQueryScans(site_, *walk.evidence, wknn_.max_age_s, radio_)) {
      const PoseEstimate pose = walk.trajectory.At(scan.time_ns);
      const std::optional<Eigen::VectorXd> signals = cells_.SignalsOf(scan.signal);
      if (pose.floor != floor_ || !signals) continue;
      ++update->offered;
      const Eigen::Vector2d at = pose.position_m.head<2>();
      const Eigen::VectorXd known = adaptive_.SignalsAt(at);
      if (!adaptive_.Offer(at, *signals)) continue;
      ++update->taken;
      const auto cell = static_cast<std::size_t>(adaptive_.map().NearestCell(at));
      Remember(cell, update->site.scans.size(), retired);
      update->site.scans.push_back(ScanAt(cell, scan, known, number));
    }
  }

 private:
  void Remember(std::size_t cell, std::size_t scan, std::set<std::size_t>* retired) {
    std::deque<std::size_t>& samples = samples_[cell];
    samples.push_back(scan);
    if (settings_.update.memory <= 0) return;
    while (samples.size() > static_cast<std::size_t>(settings_.update.memory)) {
      retired->insert(samples.front());
      samples.pop_front();
    }
  }

  SurveyScan ScanAt(std::size_t cell, const QueryScan& scan, const Eigen::VectorXd& known,
                    std::uint32_t walk) const {
    const Eigen::Vector2f center = adaptive_.map().centers_m()[cell].cast<float>();
    SurveyScan added;
    added.printed_ns = scan.time_ns;
    added.walk = added.trial = walk;
    added.floor = floor_;
    added.radio = radio_;
    if (settings_.update.store == StoreRule::kObserved) {
      for (const SignalVector::Entry& entry : scan.signal.entries) {
        added.readings.push_back({entry.transmitter, entry.rssi_dbm, 0.0F, center});
      }
      return added;
    }
    for (std::uint32_t t = 0; t < site_.transmitters.size(); ++t) {
      const std::int32_t anchor = cells_.AnchorOf(t);
      if (anchor < 0 || known(anchor) <= wknn_.missing_dbm) continue;
      added.readings.push_back({t, static_cast<float>(known(anchor)), 0.0F, center});
    }
    return added;
  }

  const Site& site_;
  int floor_;
  Radio radio_;
  const MufafSettings& settings_;
  const WknnSettings& wknn_;
  SiteCells cells_;
  AdaptiveCellMap adaptive_;
  std::vector<std::deque<std::size_t>> samples_;  // scans of the site that each cell remembers
};

void EraseScans(const std::set<std::size_t>& indices, std::vector<SurveyScan>* scans) {
  std::vector<SurveyScan> kept;
  for (std::size_t i = 0; i < scans->size(); ++i) {
    if (!indices.contains(i)) kept.push_back(std::move((*scans)[i]));
  }
  *scans = std::move(kept);
}

}  // namespace

CellUpdate UpdateSiteByCells(const Site& site, const std::vector<SurveyWalk>& walks,
                             const TrainerSettings& trainer, const MufafSettings& settings,
                             const WknnSettings& wknn) {
  CellUpdate update{site};
  std::set<std::size_t> retired;
  for (const int floor : site.SurveyedFloors()) {
    for (const Radio radio : kAllRadios) {
      CellFeeder feeder(site, floor, radio, settings, wknn);
      std::uint32_t number = NextWalk(site);
      for (const SurveyWalk& walk : walks) {
        if (!walk.trajectory.empty()) feeder.Feed(walk, number, &update, &retired);
        ++number;
      }
    }
  }
  EraseScans(retired, &update.site.scans);
  update.retired = static_cast<int>(retired.size());
  RetrainMaps(trainer, site, &update.site);
  return update;
}

}  // namespace walkgraph
