#ifndef WALKGRAPH_SOLVERS_BASELINES_TCPF_HEADING_FILTER_H_
#define WALKGRAPH_SOLVERS_BASELINES_TCPF_HEADING_FILTER_H_

#include <vector>

#include "frontends/evidence/evidence.h"

namespace walkgraph {

struct HeadingFilterSettings {
  double interval_s = 0.05;
  double acceleration_sigma_radps2 = 0.05;
  double compass_sigma_rad = 0.3;
};

template <typename Visitor>
void Visit(Visitor& v, HeadingFilterSettings& s) {
  v.Field("interval_s", s.interval_s, "time between two updates, s (the paper's 20 Hz)");
  v.Field("acceleration_sigma_radps2", s.acceleration_sigma_radps2,
          "error of the differenced gyroscope, rad/s^2 (our choice)");
  v.Field("compass_sigma_rad", s.compass_sigma_rad, "error of a compass reading, rad (our choice)");
}

// Headings with the spread that the filter claims for them, rad.
struct FilteredHeading {
  Stream<double> heading_rad;  // unwrapped
  std::vector<double> sigma_rad;
};

// A Kalman filter over angle and rate: driven by the angular acceleration (the gyroscope's yaw
// differenced twice), corrected by the compass azimuth with the innovation wrapped. Over the time
// that both streams cover; empty where that is none. Source: equations (9)-(12) of the TCPF paper.
FilteredHeading FilterHeading(const Stream<double>& gyro_yaw_rad, const Stream<double>& compass_rad,
                              const HeadingFilterSettings& settings);

// The evidence with the filtered heading in place of its absolute heading. Precondition: it has
// gyroscope yaw and absolute heading.
Evidence WithFilteredHeading(const Evidence& evidence, const HeadingFilterSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TCPF_HEADING_FILTER_H_
