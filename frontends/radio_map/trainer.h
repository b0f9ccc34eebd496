#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_TRAINER_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_TRAINER_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/trajectory.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/executor.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

struct TrainerSettings {
  double grid_spacing_m = 4.0;        // of the control points
  double sample_spacing_m = 3.0;      // readings of one walk closer than this become one sample
  double margin_m = 15.0;             // of a transmitter's field around the places that heard it
  double rssi_offset_sigma_db = 3.0;  // common to the readings of a scan, in calibration
  double hear_prior_sweeps = 1.0;     // weight of the floor-wide rate in the probability of hearing
  bool calibrate_lag = true;          // else readings are taken to speak of their stamped time
  bool shade_readings = true;         // else a body is taken to shield nothing
  bool level_devices = true;          // else all survey walks are taken to hear equally well
};

template <typename Visitor>
void Visit(Visitor& v, TrainerSettings& s) {
  v.Field("grid_spacing_m", s.grid_spacing_m, "spacing of the fields' control points, m");
  v.Field("sample_spacing_m", s.sample_spacing_m,
          "readings of one walk closer than this become one sample, m");
  v.Field("margin_m", s.margin_m, "field around the places that heard a transmitter, m");
  v.Field("rssi_offset_sigma_db", s.rssi_offset_sigma_db,
          "offset common to the readings of a scan, in calibration, dB");
  v.Field("hear_prior_sweeps", s.hear_prior_sweeps,
          "weight of the floor-wide rate in the probability of hearing, sweeps");
  v.Field(
      "calibrate_lag", s.calibrate_lag,
      "find how long after its stamp a reading speaks of the phone's place; false: at its stamp");
  v.Field("shade_readings", s.shade_readings,
          "find what the walker's body takes off readings from behind; false: nothing");
  v.Field(
      "level_devices", s.level_devices,
      "fit fields without what each survey walk's phone adds to all readings; false: none does");
}

// A walk with known positions. How well they are known shows in the noise that the fields are
// fitted with: the trajectory's covariance is not used.
struct SurveyWalk {
  const Evidence* evidence = nullptr;
  Trajectory trajectory;
  // Walks of one trial repeat a route: what is asked of a map is how it does on routes that it does
  // not know, so that they are held out together. Empty: a trial of its own.
  std::string trial = "";
};

// Trains the radio maps of every floor and radio from survey walks (pairs of evidence and
// trajectory). Walks without a trajectory add nothing, walks without readings only their path. Each
// field is a Gaussian process; its length scale and noise, the bandwidth of hearing and a map's
// n_eff and map_error_sigma_m are chosen by how well they place survey walks held out of the map
// (see map_calibration.h), and so is the lag of each radio's readings. Deterministic: equal input
// gives an equal site, however its parts are run. No survey at all gives a site without maps.
Site TrainSite(const Building& building, const std::vector<SurveyWalk>& walks,
               const TrainerSettings& settings, const Executor& run = RunInOrder);

// Which readings of a site's scans the fields of signal strength are fitted to. That a scan heard
// them counts in any case.
using ReadingFilter = std::function<bool(const SurveyScan&, const SurveyReading&)>;

// The maps of the scans that `site` has now, in place of those it had. What is calibrated stays as
// it was on the survey of the `calibrated` site: walks that were located and not surveyed cannot
// tell how well walks are located. So do the scans' device offsets: a transmitter that has changed
// would pass for a device.
void RetrainMaps(const TrainerSettings& settings, const Site& calibrated, Site* site,
                 const ReadingFilter& fits = {});

// A trajectory as points about a metre apart of the survey walk with that index.
void AppendSurveyPath(const Trajectory& trajectory, std::uint32_t walk,
                      std::vector<SurveyPoint>* path);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_TRAINER_H_
