#ifndef WALKGRAPH_FACTORS_REFRESH_RATE_H_
#define WALKGRAPH_FACTORS_REFRESH_RATE_H_

#include <cmath>

namespace walkgraph {

// How often a moving phone gets a new value from an access point, in percent of the fastest rate:
// eta(rssi) = floor + range / (1 + exp(-(rssi - middle) / width)). A weak reading is likely an old
// one. Source: equation (5) of the TCPF paper and its fit.
struct RefreshRate {
  double floor_percent = 2.1630;
  double range_percent = 82.4917;
  double middle_dbm = -75.0075;
  double width_db = 1.8464;

  double Percent(double rssi_dbm) const {
    return floor_percent + range_percent / (1 + std::exp(-(rssi_dbm - middle_dbm) / width_db));
  }
  // Percent per dB.
  double Slope(double rssi_dbm) const {
    const double share = (Percent(rssi_dbm) - floor_percent) / range_percent;
    return range_percent * share * (1 - share) / width_db;
  }
  // Weight of a reading: its rate over that of a strong one, in (0, 1]. A variance is divided by
  // it.
  double Weight(double rssi_dbm) const {
    return Percent(rssi_dbm) / (floor_percent + range_percent);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_REFRESH_RATE_H_
