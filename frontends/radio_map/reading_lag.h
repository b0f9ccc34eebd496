#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_

#include <cstdint>
#include <vector>

#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// The lag of one radio's readings (s, see Site::reading_lag_s) that places survey walks best which
// the map was not trained on. Maps are trained and walks held out anew for every lag of a ladder
// from -0.75 to 2.25 s; the answer is the top of the parabola fitted to the scores, never outside
// the ladder; a normal prior of 1 s about none. 0 where no floor has enough walks. `site_index` is
// that of PlaceScans, one list per walk.
double CalibrateReadingLag(const Building& building, const std::vector<SurveyWalk>& walks,
                           const std::vector<std::vector<std::int32_t>>& site_index,
                           const std::vector<SurveyPoint>& path, Radio radio,
                           const TrainerSettings& settings, const Executor& run = RunInOrder);

// The evidence with every reading later by the site's lag, its printing too: its age is the phone's
// own.
Evidence AlignReadings(const Site& site, Evidence evidence);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_READING_LAG_H_
