#include "solvers/baselines/mufaf/mufaf.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "frontends/radio_map/survey_scans.h"
#include "solvers/baselines/mufaf/site_update.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

MufafEstimator Make(std::string_view name, const MufafSettings& settings = {}) {
  for (const MufafMethod& method : kMufafMethods) {
    if (method.description.name == name) return {method, settings, {}, {}};
  }
  throw std::invalid_argument("no such method");
}

double MeanError(const EstimateResult& result, const std::vector<Eigen::Vector2d>& truth) {
  double sum = 0;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(t)));
    sum += (pose.position_m.head<2>() - truth[t]).norm() / static_cast<double>(truth.size());
  }
  return sum;
}

const std::vector<Eigen::Vector2d> kRound{{6, 6}, {42, 6}, {42, 30}, {6, 30}, {6, 8}};

// Makes every transmitter's second half a beacon, as a second radio that hears the same.
void MakeTwoRadios(std::vector<Transmitter>* transmitters) {
  for (std::size_t i = transmitters->size() / 2; i < transmitters->size(); ++i) {
    (*transmitters)[i].radio = Radio::kBeacon;
  }
}

// The survey's scans split by radio, as a phone would have made them.
void SplitScans(Site* site) {
  std::vector<SurveyScan> scans;
  for (const SurveyScan& scan : site->scans) {
    for (const Radio radio : {Radio::kWifi, Radio::kBeacon}) {
      SurveyScan part = scan;
      part.radio = radio;
      std::erase_if(part.readings, [&](const SurveyReading& reading) {
        return site->transmitters[reading.transmitter].radio != radio;
      });
      if (!part.readings.empty()) scans.push_back(part);
    }
  }
  site->scans = scans;
}

TEST(Mufaf, TrackingBeatsFixesAndFusionBeatsOneRadio) {
  SyntheticSite synthetic(41, 16);
  Site site = synthetic.site;
  MakeTwoRadios(&site.transmitters);
  SplitScans(&site);
  MufafSettings settings;
  settings.alpha = 0;
  double fixes = 0, one = 0, tracks = 0, group = 0;
  for (int i = 0; i < 6; ++i) {
    std::vector<Eigen::Vector2d> truth;
    Evidence evidence = synthetic.Walk(kRound, 0.1, 2, &truth);
    MakeTwoRadios(&evidence.transmitters);
    fixes += MeanError(Make("mufaf_exponential").Estimate(site, evidence), truth);
    one += MeanError(Make("mufaf_kalman").Estimate(site, evidence), truth);
    tracks += MeanError(Make("mufaf_tttf", settings).Estimate(site, evidence), truth);
    group += MeanError(Make("mufaf_ksgf", settings).Estimate(site, evidence), truth);
  }
  EXPECT_LT(one, fixes);
  EXPECT_LT(tracks, one);
  EXPECT_LT(group, one);
}

// With one radio there is nothing to fuse.
TEST(Mufaf, FusionsOfOneRadioAreItsTrack) {
  SyntheticSite synthetic(42);
  const Evidence evidence = synthetic.Walk(kRound, 0.1, 2);
  MufafSettings settings;
  settings.alpha = 0;
  const EstimateResult track = Make("mufaf_kalman", settings).Estimate(synthetic.site, evidence);
  for (const char* name : {"mufaf_tttf", "mufaf_ksgf"}) {
    const EstimateResult fused = Make(name, settings).Estimate(synthetic.site, evidence);
    ASSERT_EQ(fused.trajectory.poses.size(), track.trajectory.poses.size());
    for (std::size_t i = 0; i < track.trajectory.poses.size(); ++i) {
      const PoseEstimate &a = track.trajectory.poses[i], &b = fused.trajectory.poses[i];
      EXPECT_NEAR((a.position_m - b.position_m).norm(), 0, 1e-9) << name;
      EXPECT_NEAR((a.covariance_xy_m2 - b.covariance_xy_m2).norm(), 0, 1e-9) << name;
    }
  }
}

TEST(Mufaf, SaysWhenNothingWasHeard) {
  SyntheticSite synthetic(43);
  Evidence evidence = synthetic.Walk(kRound, 0.1, 2);
  evidence.readings.clear();
  for (const MufafMethod& method : kMufafMethods) {
    const EstimateResult result = Make(method.description.name).Estimate(synthetic.site, evidence);
    EXPECT_EQ(result.status, EstimateStatus::kUnobservable) << method.description.name;
  }
}

// A threshold that nothing passes leaves the site as it was; one that everything passes takes all.
TEST(MufafUpdate, TakesScansByTheThreshold) {
  SyntheticSite synthetic(44, 6);
  std::vector<Eigen::Vector2d> truth;
  const Evidence evidence = synthetic.Walk(kRound, 0.1, 2, &truth);
  SurveyWalk walk{&evidence, {}, ""};
  for (std::size_t t = 0; t < truth.size(); ++t) {
    PoseEstimate pose;
    pose.time_ns = SyntheticSite::At(static_cast<double>(t));
    pose.position_m.head<2>() = truth[t];
    pose.floor = 1;
    walk.trajectory.poses.push_back(pose);
  }
  MufafSettings settings;
  settings.update.threshold_db = 1e-3;
  const CellUpdate none = UpdateSiteByCells(synthetic.site, {walk}, {}, settings, {});
  EXPECT_EQ(none.taken, 0);
  EXPECT_GT(none.offered, 50);
  EXPECT_EQ(none.site.scans.size(), synthetic.site.scans.size());
  settings.update.threshold_db = 1e3;
  settings.update.memory = 0;
  const CellUpdate all = UpdateSiteByCells(synthetic.site, {walk}, {}, settings, {});
  EXPECT_EQ(all.taken, all.offered);
  EXPECT_EQ(all.retired, 0);
  EXPECT_EQ(all.site.scans.size(),
            synthetic.site.scans.size() + static_cast<std::size_t>(all.taken));

  // Cells that remember one sample: the last scan taken there, or where none was the survey's.
  settings.update.memory = 1;
  const CellUpdate last = UpdateSiteByCells(synthetic.site, {walk}, {}, settings, {});
  EXPECT_EQ(last.taken, last.offered);
  EXPECT_EQ(last.site.scans.size(), synthetic.site.scans.size() +
                                        static_cast<std::size_t>(last.taken) -
                                        static_cast<std::size_t>(last.retired));
  std::set<std::pair<float, float>> places;
  for (const SurveyScan& scan : last.site.scans) {
    if (scan.walk < NextWalk(synthetic.site)) continue;
    const Eigen::Vector2f at = scan.readings.front().position_m;
    EXPECT_TRUE(places.insert({at.x(), at.y()}).second) << "two scans in a cell of one";
  }
  EXPECT_GT(places.size(), 5U);
}

}  // namespace
}  // namespace walkgraph
