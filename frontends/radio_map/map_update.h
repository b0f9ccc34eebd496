#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_UPDATE_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_UPDATE_H_

#include <cmath>
#include <cstdint>
#include <vector>

#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// Learning from walks that were located, not surveyed.

struct MapChangeSettings {
  int rounds = 3;
  double offset_sigma_db = 4;
  double group_m = 10;
  double vanish_odds = 1000;
  double near_survey_m = 3;
};

template <typename Visitor>
void Visit(Visitor& v, MapChangeSettings& s) {
  v.Field("rounds", s.rounds,
          "walks are located and the survey is updated this often: a better map locates better");
  v.Field("offset_sigma_db", s.offset_sigma_db,
          "prior of what a transmitter's power may have changed by since the survey, dB");
  v.Field("group_m", s.group_m,
          "readings of a walk in one square of this side err together and count as one, m");
  v.Field("vanish_odds", s.vanish_odds,
          "a transmitter is given up where silence is this much likelier than its map has it");
  v.Field("near_survey_m", s.near_survey_m,
          "nearer to the survey than this its own readings say more than located ones, m");
}

// What located walks say has become of a transmitter of one radio map.
struct TransmitterChange {
  std::uint32_t transmitter = 0;  // index into Site::transmitters
  double offset_db = 0;           // posterior mean of today's power minus the survey's
  double offset_sigma_db = 0;
  double expected = 0;  // sweeps in which the map would have it heard, and those that did
  double heard = 0;
  bool vanished = false;

  bool changed() const { return std::abs(offset_db) > 3 * offset_sigma_db; }
};

// By the residuals of readings at the located places against the map. A walk's median residual is
// its phone's and is taken off first. The offset has a normal prior of offset_sigma_db; groups of
// readings (a walk in a square) count once, with the map's spread there. A transmitter has vanished
// that was never heard where the map expects it, at odds (by misses that go together, weighed by
// the map's hear_weight) beyond vanish_odds. By transmitter, those alone that could have been met.
std::vector<TransmitterChange> FindChanges(const Site& site, const RadioMap& map,
                                           const std::vector<SurveyWalk>& walks,
                                           const MapChangeSettings& settings);

// The site with the walks' transmitters and paths, without their scans: what has indices is moved
// to the new transmitters.
Site WithWalks(const Site& site, const std::vector<SurveyWalk>& walks);

// The site as the located walks show it: the survey's readings moved by the offsets of transmitters
// that changed, without those that are then weaker than anything the survey heard and those of
// transmitters that vanished; the walks' own scans added, and the maps trained anew. A located
// reading is placed worse than a surveyed one: fields are fitted to it where the transmitter
// changed or the survey is farther than `near_survey_m`.
Site UpdateSite(const Site& site, const std::vector<SurveyWalk>& walks,
                const TrainerSettings& trainer, const MapChangeSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_UPDATE_H_
