#ifndef WALKGRAPH_DATA_FORMATS_CSV_FILES_H_
#define WALKGRAPH_DATA_FORMATS_CSV_FILES_H_

// File and column names that the reader and the writer of the CSV format share. The columns of
// times come in two spellings, time_ns (integer) and time_s (decimal); the tables hold what follows
// them.

namespace walkgraph::csv {

inline constexpr char kWalkFile[] = "walk.json";
inline constexpr char kAccelerometerFile[] = "accelerometer.csv";
inline constexpr char kGyroscopeFile[] = "gyroscope.csv";
inline constexpr char kMagnetometerFile[] = "magnetometer.csv";
inline constexpr char kRotationVectorFile[] = "rotation_vector.csv";
inline constexpr char kPressureFile[] = "pressure.csv";
inline constexpr char kWifiFile[] = "wifi.csv";
inline constexpr char kBeaconFile[] = "beacon.csv";
inline constexpr char kWaypointFile[] = "waypoints.csv";

inline constexpr char kPathFile[] = "path.csv";

inline constexpr char kAccelerometerColumns[] = "x_mps2,y_mps2,z_mps2";
inline constexpr char kGyroscopeColumns[] = "x_radps,y_radps,z_radps";
inline constexpr char kMagnetometerColumns[] = "x_ut,y_ut,z_ut";
inline constexpr char kRotationVectorColumns[] = "x,y,z,w";
inline constexpr char kPressureColumns[] = "pressure_hpa";
inline constexpr char kWifiColumns[] = "bssid,rssi_dbm";   // behind time and heard time
inline constexpr char kBeaconColumns[] = "name,rssi_dbm";  // behind time and heard time
inline constexpr char kWaypointColumns[] = "x_m,y_m,floor";
inline constexpr char kWgs84WaypointColumns[] = "latitude_deg,longitude_deg,floor";

inline constexpr char kPathHeader[] = "time_ns,x_m,y_m,z_m,floor,heading_rad";

}  // namespace walkgraph::csv

#endif  // WALKGRAPH_DATA_FORMATS_CSV_FILES_H_
