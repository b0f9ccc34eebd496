#ifndef WALKGRAPH_FRONTENDS_EVIDENCE_BAROMETRIC_FORMULA_H_
#define WALKGRAPH_FRONTENDS_EVIDENCE_BAROMETRIC_FORMULA_H_

#include <cmath>

namespace walkgraph {

// Height and pressure in an atmosphere of one temperature, the barometric formula
//   H = -(R T) / (g M) ln(p / p0),
// with p0 = 1013.25 hPa, T = 288.15 K, g = 9.80665 m/s^2, M = 0.0289644 kg/mol (U.S. Standard
// Atmosphere 1976) and R = 8.314462618 J/(mol K) (CODATA 2018): 111.025 m at 1000 hPa, 8.32 m/hPa
// near p0. Between the floors of a house the air has no lapse rate to speak of, which is why this
// form and not that of the troposphere (110.88 m at 1000 hPa) is taken. Air of another temperature
// scales differences of height by T / 288.15 K: at 294 K a storey comes out 2 % (6 cm) low. Heights
// of floors that a survey takes from pressure have the same scale.
inline constexpr double kScaleHeightM = 8.314462618 * 288.15 / (9.80665 * 0.0289644);
inline constexpr double kSeaLevelHpa = 1013.25;

inline double HeightOfPressure(double pressure_hpa) {
  return -kScaleHeightM * std::log(pressure_hpa / kSeaLevelHpa);
}

inline double PressureAtHeight(double height_m) {
  return kSeaLevelHpa * std::exp(-height_m / kScaleHeightM);
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_EVIDENCE_BAROMETRIC_FORMULA_H_
