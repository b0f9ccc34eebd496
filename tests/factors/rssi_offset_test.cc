#include "factors/rssi_offset.h"

#include <gtest/gtest.h>

namespace walkgraph {
namespace {

// A survey whose walks with "loud" heard Wi-Fi 4 dB louder than the fields.
Site Surveyed() {
  Site site;
  site.loudness = {{"loud", Radio::kWifi, 4, 1.5}, {"same", Radio::kWifi, 1, 0.01}};
  return site;
}

Evidence With(const std::string& device) {
  Evidence evidence;
  evidence.device = device;
  return evidence;
}

void ExpectPrior(const RssiOffsetPrior& prior, double mean_db, double sigma_db) {
  EXPECT_EQ(prior.mean_db, mean_db);
  EXPECT_EQ(prior.sigma_db, sigma_db);
}

TEST(RssiOffsetPrior, ComesFromTheSurveysWalksWithTheSameModel) {
  const Site site = Surveyed();
  RssiOffsetSettings settings;
  settings.prior_sigma_db = 3;
  // What the phone hears too loud is taken off its readings.
  ExpectPrior(PriorOfRssiOffset(site, With("loud"), Radio::kWifi, settings), -4, 1.5);
  ExpectPrior(PriorOfRssiOffset(site, With("loud"), Radio::kBeacon, settings), 0, 3);
  ExpectPrior(PriorOfRssiOffset(site, With("other"), Radio::kWifi, settings), 0, 3);
  ExpectPrior(PriorOfRssiOffset(site, With(""), Radio::kWifi, settings), 0, 3);
  // However alike the walks were, the next may hold the phone otherwise.
  ExpectPrior(PriorOfRssiOffset(site, With("same"), Radio::kWifi, settings), -1, 0.5);
  settings.from_survey = false;
  ExpectPrior(PriorOfRssiOffset(site, With("loud"), Radio::kWifi, settings), 0, 3);
}

TEST(RssiOffsetPrior, IsHeldWhereTheStateIsFixedAndZeroWhereItIsAbsent) {
  const Site site = Surveyed();
  RssiOffsetSettings settings;
  settings.mode = StateMode::kFixed;
  ExpectPrior(PriorOfRssiOffset(site, With("loud"), Radio::kWifi, settings), -4, 0);
  settings.mode = StateMode::kAbsent;
  ExpectPrior(PriorOfRssiOffset(site, With("loud"), Radio::kWifi, settings), 0, 0);
}

}  // namespace
}  // namespace walkgraph
