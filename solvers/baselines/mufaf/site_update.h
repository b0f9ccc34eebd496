#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_UPDATE_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_UPDATE_H_

#include <vector>

#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"
#include "solvers/baselines/mufaf/mufaf.h"

namespace walkgraph {

struct CellUpdate {
  Site site;
  int offered = 0, taken = 0, retired = 0;  // scans
};

// MUFAF's adaptive fingerprint update with walks that were located: every scan is offered to the
// cells of its radio and floor where the walker was (see AdaptiveCellMap); one that is taken
// becomes a scan of the site at the cell, in place of the cell's oldest one where it remembers no
// more (see MapUpdateSettings). The walks come one after the other, as several walkers
// feeding one map do. The radio maps are trained anew.
CellUpdate UpdateSiteByCells(const Site& site, const std::vector<SurveyWalk>& walks,
                             const TrainerSettings& trainer, const MufafSettings& settings,
                             const WknnSettings& wknn);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_SITE_UPDATE_H_
