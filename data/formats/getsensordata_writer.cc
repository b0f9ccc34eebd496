#include <cmath>
#include <string>

#include "data/angle.h"
#include "data/formats/getsensordata.h"
#include "data/formats/text_output.h"

namespace walkgraph {
namespace {

constexpr int kTimeDecimals = 4;
constexpr int kSensorDecimals = 6;
constexpr int kQuaternionDecimals = 8;
constexpr int kDegreeDecimals = 12;  // as the application prints them: a tenth of a micrometre
constexpr char kAccuracy[] = "3";    // Android's "high"
// A phone's sensor hub counts from when the phone was started.
constexpr TimeNs kSinceBootNs = 65'000 * kNsPerSecond;

constexpr char kHeader[] =
    "% LogFile in the format of the 'GetSensorData' App for Android, version 2.x.\n"
    "% ACCE;AppTimestamp(s);SensorTimestamp(s);Acc_X(m/s^2);Acc_Y(m/s^2);Acc_Z(m/s^2);Accuracy\n"
    "% GYRO;AppTimestamp(s);SensorTimestamp(s);Gyr_X(rad/s);Gyr_Y(rad/s);Gyr_Z(rad/s);Accuracy\n"
    "% MAGN;AppTimestamp(s);SensorTimestamp(s);Mag_X(uT);Mag_Y(uT);Mag_Z(uT);Accuracy\n"
    "% PRES;AppTimestamp(s);SensorTimestamp(s);Pres(mbar);Accuracy\n"
    "% AHRS;AppTimestamp(s);SensorTimestamp(s);PitchX(deg);RollY(deg);YawZ(deg);"
    "Quat(2);Quat(3);Quat(4);Accuracy\n"
    "% WIFI;AppTimestamp(s);SensorTimestamp(s);Name_SSID;MAC_BSSID;Frequency;RSS(dBm)\n"
    "% BLE4;AppTimestamp(s);iBeacon;MAC;RSSI(dBm)\n"
    "% POSI;Timestamp(s);Counter;Latitude(degrees);Longitude(degrees);floor ID;Building ID\n";

// Type and both times.
TextRow Row(const char* type, TimeNs time_ns, TimeNs sensor_ns) {
  return TextRow(';')
      .Text(type)
      .Seconds(time_ns, kTimeDecimals)
      .Seconds(sensor_ns + kSinceBootNs, kTimeDecimals);
}

void AddVectors(const Stream<Eigen::Vector3d>& stream, const char* type, TimedLines* lines) {
  for (std::size_t i = 0; i < stream.size(); ++i) {
    TextRow row = Row(type, stream.time_ns[i], stream.time_ns[i]);
    for (const double component : stream.value[i]) row.Number(component, kSensorDecimals);
    lines->Add(stream.time_ns[i], row.Text(kAccuracy));
  }
}

void AddRotations(const Stream<Eigen::Quaterniond>& stream, TimedLines* lines) {
  for (std::size_t i = 0; i < stream.size(); ++i) {
    const Eigen::Quaterniond& rotation = stream.value[i];
    const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
    TextRow row = Row("AHRS", stream.time_ns[i], stream.time_ns[i]);
    // Turns about z, then x, then y.
    row.Number(RadiansToDegrees(std::asin(matrix(2, 1))), kSensorDecimals)
        .Number(RadiansToDegrees(std::atan2(-matrix(2, 0), matrix(2, 2))), kSensorDecimals)
        .Number(RadiansToDegrees(std::atan2(-matrix(0, 1), matrix(1, 1))), kSensorDecimals);
    const double sign = rotation.w() < 0 ? -1.0 : 1.0;  // w follows from the norm
    for (const double component : rotation.vec()) {
      row.Number(sign * component, kQuaternionDecimals);
    }
    lines->Add(stream.time_ns[i], row.Text(kAccuracy));
  }
}

void AddRadio(const Recording& recording, TimedLines* lines) {
  for (const RadioRow& row : recording.radio_rows) {
    const Transmitter& transmitter = recording.transmitters.at(row.transmitter);
    if (transmitter.radio == Radio::kWifi) {
      lines->Add(row.printed_ns, Row("WIFI", row.printed_ns, row.heard_ns)
                                     .Text("simulated")
                                     .Text(transmitter.name)
                                     .Text("2437")
                                     .Number(row.rssi_dbm, 0));
    } else {
      const std::string address = transmitter.name.substr(transmitter.name.rfind('_') + 1);
      lines->Add(row.printed_ns, TextRow(';')
                                     .Text("BLE4")
                                     .Seconds(row.printed_ns, kTimeDecimals)
                                     .Text("iBeacon")
                                     .Text(address)
                                     .Number(row.rssi_dbm, 0));
    }
  }
}

}  // namespace

void WriteGetSensorData(const Recording& recording, const Truth& truth, const std::string& path) {
  TimedLines lines;
  AddVectors(recording.accelerometer_mps2, "ACCE", &lines);
  AddVectors(recording.gyroscope_radps, "GYRO", &lines);
  AddVectors(recording.magnetometer_ut, "MAGN", &lines);
  AddRotations(recording.rotation_vector, &lines);
  for (std::size_t i = 0; i < recording.pressure_hpa.size(); ++i) {
    const TimeNs time_ns = recording.pressure_hpa.time_ns[i];
    lines.Add(time_ns, Row("PRES", time_ns, time_ns)
                           .Number(recording.pressure_hpa.value[i], kSensorDecimals)
                           .Text(kAccuracy));
  }
  AddRadio(recording, &lines);
  int counter = 0;
  for (const Waypoint& waypoint : truth.waypoints) {
    lines.Add(waypoint.time_ns, TextRow(';')
                                    .Text("POSI")
                                    .Seconds(waypoint.time_ns, kTimeDecimals)
                                    .Text(std::to_string(++counter))
                                    .Number(waypoint.position.x(), kDegreeDecimals)
                                    .Number(waypoint.position.y(), kDegreeDecimals)
                                    .Text(std::to_string(waypoint.floor))
                                    .Text("0"));
  }
  WriteTextFile(path, lines.Join(kHeader + std::string("% Model: ") + recording.device + "\n"));
}

}  // namespace walkgraph
