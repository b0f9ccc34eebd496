#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_BUILDER_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_BUILDER_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "frontends/radio_map/executor.h"
#include "frontends/radio_map/gaussian_process.h"
#include "frontends/radio_map/radio_map.h"
#include "frontends/radio_map/site.h"
#include "frontends/radio_map/trainer.h"

namespace walkgraph {

// The survey scans of one radio on one floor, in a fixed order.
using ScanList = std::vector<const SurveyScan*>;

// What a map is made of, and where its control points lie.
struct FloorSurvey {
  int floor = 0;
  Radio radio = Radio::kWifi;
  FieldGrid grid;
  ScanList scans;
};

// What the fields of one radio on one floor have in common.
struct FieldModel {
  FieldPrior prior;
  double hear_bandwidth_m = 2.5;  // of the kernel that counts heard and missed sweeps
  double sigma_scale = 1;         // left-out residuals over their predicted sigma, root mean square
};

// Some of a site's transmitters, or all.
struct TransmitterSelection {
  std::vector<bool> selected;  // by transmitter; empty: all
  bool Has(std::uint32_t transmitter) const {
    return selected.empty() || (transmitter < selected.size() && selected[transmitter]);
  }
};

// How much of a map is built: trials do with less than the map that a site keeps.
struct MapDetail {
  TransmitterSelection transmitters;
  // A dense process costs O(n^3): above this many samples of a transmitter they are merged over a
  // wider spacing.
  std::size_t max_samples = 300;
  ReadingFilter fits;  // fields are fitted to its readings; all where empty
};

// The samples that each transmitter's field is trained on.
std::map<std::uint32_t, std::vector<FieldSample>> CollectSamples(const ScanList& scans,
                                                                 const TrainerSettings& settings,
                                                                 const MapDetail& detail = {});

// Root mean square of readings' residuals over their predicted sigma when whole trials are left out
// in turn, on an even selection of transmitters; 1 where no two trials heard anything in common.
// Of the readings where they were heard, not of the samples that average them: it is readings that
// a map is held against, and what its slope makes of a sample's width is no noise.
double LeftOutSigmaScale(const ScanList& scans, const TrainerSettings& settings,
                         const FieldPrior& prior, const Executor& run = RunInOrder);

// Two control points beyond a box on every side, so that all of it lies inside the spline.
FieldGrid GridOverBox(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m,
                      double spacing_m);

// The grid that covers a floor's bounding box and everything in `path`.
FieldGrid CoveringGrid(const Floor* floor, const std::vector<SurveyPoint>& path, int floor_number,
                       const TrainerSettings& settings);

// The floors that any of the scans is on.
std::set<int> FloorsOf(const std::vector<SurveyScan>& scans);

// What one radio heard on one floor, of all the scans and the whole path of a survey.
FloorSurvey SurveyOfFloor(const Building& building, const std::vector<SurveyPoint>& path,
                          const std::vector<SurveyScan>& scans, int floor, Radio radio,
                          const TrainerSettings& settings);

// What the maps of one survey have in common, whatever their model.
struct MapInput {
  int floor = 0;
  Radio radio = Radio::kWifi;
  FieldGrid grid;
  std::map<std::uint32_t, std::vector<FieldSample>> samples;   // of each transmitter kept
  std::map<std::uint32_t, std::vector<std::size_t>> heard_in;  // scans of each transmitter
  std::map<std::uint32_t, Eigen::Vector2d> sources_m;          // see survey_shadows.h
  std::vector<Eigen::Vector2d> sweep_places;                   // of each scan
  std::vector<float> survey_distance_m;                        // see RadioMap
};
MapInput MakeMapInput(const FloorSurvey& survey, const TrainerSettings& settings,
                      const MapDetail& detail = {});

// The map without its calibration (n_eff and the map error stay 0).
RadioMap BuildMap(const MapInput& input, const FieldModel& model, const TrainerSettings& settings,
                  const Executor& run = RunInOrder);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_MAP_BUILDER_H_
