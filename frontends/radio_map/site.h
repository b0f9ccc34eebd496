#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "data/building.h"
#include "data/recording.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/magnetic_map.h"
#include "frontends/radio_map/radio_map.h"

namespace walkgraph {

// A point of a survey path: where a survey walk went, resampled about every metre.
struct SurveyPoint {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  int floor = 0;
  std::uint32_t walk = 0;  // index of the survey walk, as in SurveyScan
};

// One unique reading of the survey, placed where the person was when it was heard.
struct SurveyReading {
  std::uint32_t transmitter = 0;  // index into Site::transmitters
  float rssi_dbm = 0;
  float age_s = 0;                                       // printed minus heard
  Eigen::Vector2f position_m = Eigen::Vector2f::Zero();  // at the time heard
  float heading_rad = 0;                                 // of walking, at the time heard
  // What the walker's body adds to the reading, which way they faced (see body_shadow.h). Fields
  // are fitted to readings without it, and it is zero until their shadow has been calibrated.
  float shadow_db = 0;
};

// The readings that were printed together.
struct SurveyScan {
  TimeNs printed_ns = 0;
  std::uint32_t walk = 0;
  // The first walk of the same trial: walks that repeat one route are held out together.
  std::uint32_t trial = 0;
  int floor = 0;
  Radio radio = Radio::kWifi;
  std::vector<SurveyReading> readings;
  // What the walk's device adds to every reading of the radio (see device_offsets.h). The readings
  // are as they were heard; fields are fitted to them without it.
  float device_offset_db = 0;
};

// The magnetic field of half a second of a survey walk, where the person was then.
struct SurveyMagnetic {
  Eigen::Vector2f position_m = Eigen::Vector2f::Zero();
  int floor = 0;
  std::uint32_t walk = 0;   // as in SurveyScan
  std::uint32_t trial = 0;  // as in SurveyScan
  float norm_ut = 0;
  float inclination_rad = 0;
};

// What a phone's barometer had over the true height on a survey walk: weather and device. Whoever
// carries the same phone soon after has about the same.
struct SurveyedOffset {
  std::string device;
  TimeNs unix_ns = 0;  // the middle of the walk
  double offset_m = 0;
  double sigma_m = 0;  // of the walk's own heights about it
};

// What a phone of one model adds to all readings of a radio, of the survey's walks with it: what to
// expect of another such walk. Walks that do not name their phone are a model of their own.
struct DeviceLoudness {
  std::string device;
  Radio radio = Radio::kWifi;
  double mean_db = 0;   // louder than the fields
  double sigma_db = 0;  // of one more walk
};

// What a survey leaves behind: the building, the raw placed readings (for methods that compare
// fingerprints) and the fields trained on them (for methods that need a likelihood).
struct Site {
  Building building;
  std::vector<Transmitter> transmitters;  // sorted, each once
  std::vector<SurveyPoint> path;
  std::vector<SurveyScan> scans;                   // by walk, then printed_ns
  std::vector<SurveyMagnetic> magnetic;            // by walk, then time
  std::vector<RadioMap> maps;                      // by floor, then radio
  std::vector<MagneticMap> magnetic_maps;          // by floor
  std::vector<SurveyedOffset> barometric_offsets;  // by walk
  std::vector<DeviceLoudness> loudness;            // by radio, then device
  // How long after its stamp a reading of a radio speaks of the place where the phone was, s.
  // Calibrated in the survey (see direction_bias.h), whose readings were placed with it;
  // AlignReadings() gives evidence the same.
  std::array<double, kRadioCount> reading_lag_s{};

  // The map of a floor and radio, or nullptr where nothing was surveyed.
  const RadioMap* FindMap(int floor, Radio radio) const;
  // That of a phone model and radio, or nullptr where the survey does not tell.
  const DeviceLoudness* FindLoudness(const std::string& device, Radio radio) const;
  // The magnetic map of a floor, or nullptr where too few survey routes measured it.
  const MagneticMap* FindMagneticMap(int floor) const;
  // Floors with at least one radio map, ascending.
  std::vector<int> SurveyedFloors() const;
  // Counter-clockwise angle to add to an east-north heading to get one of the building frame.
  double HeadingToBuilding() const;
};

inline constexpr std::int32_t kUnknownTransmitter = -1;

// For each transmitter of the evidence its index in the site, or kUnknownTransmitter.
std::vector<std::int32_t> MatchTransmitters(const Site& site, const Evidence& evidence);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SITE_H_
