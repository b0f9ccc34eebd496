#ifndef WALKGRAPH_DATA_FORMATS_RECORDING_BUILDER_H_
#define WALKGRAPH_DATA_FORMATS_RECORDING_BUILDER_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "data/dataset.h"
#include "data/read_report.h"
#include "data/recording.h"
#include "data/time.h"
#include "data/truth.h"

namespace walkgraph {

// Where all readers put what they have parsed. It judges values and times by one set of rules,
// counts what it drops or repairs in the report (see data/formats/README.md for the names), and
// guarantees what Recording and Truth promise.
class RecordingBuilder {
 public:
  explicit RecordingBuilder(ReadReport* report) : report_(report) {}

  // Device axes; m/s^2, rad/s, microtesla.
  void AddAcceleration(TimeNs time, const Eigen::Vector3d& mps2);
  void AddAngularRate(TimeNs time, const Eigen::Vector3d& radps);
  void AddMagneticField(TimeNs time, const Eigen::Vector3d& ut);
  // Vector part of the unit quaternion from device to east-north-up; w >= 0 follows from the norm.
  void AddRotationVector(TimeNs time, const Eigen::Vector3d& xyz);
  // The whole quaternion, of either sign; it is normalised.
  void AddQuaternion(TimeNs time, const Eigen::Quaterniond& device_to_enu);
  void AddPressure(TimeNs time, double hpa);
  // `name` as in Transmitter, any case: it is stored in lower case.
  void AddRadioRow(Radio radio, std::string_view name, TimeNs printed, TimeNs heard,
                   double rssi_dbm);
  void AddWaypoint(TimeNs time, const Eigen::Vector2d& position, int floor);

  // Orders everything by time and moves it into the walk. The builder is empty afterwards.
  void Finish(Recording* recording, Truth* truth);

 private:
  struct NameHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view name) const {
      return std::hash<std::string_view>()(name);
    }
  };
  using NameIndex = std::unordered_map<std::string, std::uint32_t, NameHash, std::equal_to<>>;

  void AddVector(Stream<Eigen::Vector3d>* stream, TimeNs time, const Eigen::Vector3d& value,
                 double largest);
  std::uint32_t FindOrAddTransmitter(Radio radio, std::string_view name);
  std::vector<TimeNs> AllTimes();
  void DropStrayTimes();
  void OrderRadioRows();
  void OrderWaypoints();
  void CheckClocks();

  ReadReport* report_;
  Recording recording_;
  Truth truth_;
  NameIndex names_[kRadioCount];
  std::string lower_case_;  // scratch
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_RECORDING_BUILDER_H_
