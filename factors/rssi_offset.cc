#include "factors/rssi_offset.h"

#include <algorithm>

namespace walkgraph {
namespace {

// How a person holds a phone is never known better, however alike the survey's walks were.
constexpr double kLeastSigmaDb = 0.5;

}  // namespace

RssiOffsetPrior PriorOfRssiOffset(const Site& site, const Evidence& evidence, Radio radio,
                                  const RssiOffsetSettings& settings) {
  if (settings.mode == StateMode::kAbsent) return {};
  RssiOffsetPrior prior{0, settings.prior_sigma_db};
  const DeviceLoudness* known =
      settings.from_survey ? site.FindLoudness(evidence.device, radio) : nullptr;
  if (known != nullptr) prior = {-known->mean_db, std::max(kLeastSigmaDb, known->sigma_db)};
  if (settings.mode == StateMode::kFixed) prior.sigma_db = 0;
  return prior;
}

}  // namespace walkgraph
