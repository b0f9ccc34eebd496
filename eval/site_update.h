#ifndef WALKGRAPH_EVAL_SITE_UPDATE_H_
#define WALKGRAPH_EVAL_SITE_UPDATE_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "eval/survey.h"

namespace walkgraph {

// Who locates the walks that a site learns from, unless told otherwise, and how it learns.
enum class SiteUpdate : std::uint8_t {
  kGraph,       // batch; offsets of transmitters, then all scans (see UpdateSite)
  kKriging,     // viterbi, as MUFAF's own fusion is too far off where much has changed; its
                // adaptive fingerprint update
  kCovariance,  // the same, the map interpolated by its covariance
};
inline constexpr std::array<std::string_view, 3> kSiteUpdateNames = {"graph", "kriging",
                                                                     "covariance"};

struct SiteUpdateOptions {
  LearnOptions learn;
  std::string site;    // file of the site as it was
  std::string method;  // locates the walks; empty: the update's own
  SiteUpdate update = SiteUpdate::kGraph;
  bool floor_given = true;
};

// Locates the walks of a data set, whose waypoints it does not look at, and writes what the site
// learns from them to learn.out. Returns an exit code; throws InputError where site or data set
// cannot be read.
int UpdateSurveyedSite(const SiteUpdateOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SITE_UPDATE_H_
