#include "frontends/pressure.h"

#include <algorithm>
#include <cstddef>

namespace walkgraph {
namespace {

constexpr double kMinHpa = 300;
constexpr double kMaxHpa = 1100;

bool Plausible(double pressure_hpa) { return pressure_hpa >= kMinHpa && pressure_hpa <= kMaxHpa; }

const char* Complaint(double value) {
  if (Plausible(value / 100)) return "pressure_in_pa";
  if (Plausible(value * 10)) return "pressure_in_kpa";
  return "pressure_out_of_range";
}

bool Stuck(const Stream<double>& pressure, double constant_s) {
  if (pressure.size() < 2) return false;
  const bool constant = std::all_of(pressure.value.begin(), pressure.value.end(),
                                    [&](double p) { return p == pressure.value.front(); });
  return constant && SecondsBetween(pressure.time_ns.front(), pressure.time_ns.back()) > constant_s;
}

}  // namespace

Stream<double> CheckPressure(const Stream<double>& pressure_hpa, const PressureSettings& settings,
                             std::map<std::string, std::int64_t>* counts) {
  Stream<double> out;
  for (std::size_t i = 0; i < pressure_hpa.size(); ++i) {
    const double value = pressure_hpa.value[i];
    if (Plausible(value)) {
      out.push_back(pressure_hpa.time_ns[i], value);
    } else {
      ++(*counts)[Complaint(value)];
    }
  }
  if (!Stuck(out, settings.constant_s)) return out;
  (*counts)["pressure_constant"] += static_cast<std::int64_t>(out.size());
  return {};
}

}  // namespace walkgraph
