#ifndef WALKGRAPH_DATA_SIMULATOR_STANDARD_ATMOSPHERE_H_
#define WALKGRAPH_DATA_SIMULATOR_STANDARD_ATMOSPHERE_H_

#include <cmath>

namespace walkgraph {

// The troposphere of ISO 2533 (International Standard Atmosphere):
//   p = 1013.25 hPa * (1 - L h/T)^(g M/(R L)),
// with T = 288.15 K at height 0, L = 0.0065 K/m, g = 9.80665 m/s^2, M = 0.0289644 kg/mol and
// R = 8.31432 J/(mol K).
inline constexpr double kStandardTemperatureK = 288.15;
inline constexpr double kStandardPressureHpa = 1013.25;
inline constexpr double kLapseRateKpm = 0.0065;
inline constexpr double kPressureExponent = 9.80665 * 0.0289644 / (8.31432 * kLapseRateKpm);

// Pressure in hPa at a height in metres.
inline double StandardPressure(double height_m) {
  const double temperature = 1.0 - kLapseRateKpm * height_m / kStandardTemperatureK;
  return kStandardPressureHpa * std::pow(temperature, kPressureExponent);
}

// The inverse: height in metres at which the standard atmosphere has a pressure in hPa.
inline double StandardHeight(double pressure_hpa) {
  const double temperature = std::pow(pressure_hpa / kStandardPressureHpa, 1.0 / kPressureExponent);
  return kStandardTemperatureK / kLapseRateKpm * (1.0 - temperature);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_SIMULATOR_STANDARD_ATMOSPHERE_H_
