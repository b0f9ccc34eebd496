#include "frontends/pressure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "frontends/evidence/barometric_formula.h"

namespace walkgraph {
namespace {

constexpr double kMinHpa = 300;
constexpr double kMaxHpa = 1100;

struct Unit {
  double hpa = 1;
  const char* count = nullptr;  // none: what is expected
};
constexpr std::array<Unit, 3> kUnits = {Unit{1.0, nullptr}, Unit{0.01, "pressure_in_pa"},
                                        Unit{10.0, "pressure_in_kpa"}};

bool Plausible(double pressure_hpa) { return pressure_hpa >= kMinHpa && pressure_hpa <= kMaxHpa; }

// The unit in which most of the samples are plausible.
const Unit& UnitOf(const Stream<double>& pressure) {
  const auto plausible = [&pressure](const Unit& unit) {
    return std::count_if(pressure.value.begin(), pressure.value.end(),
                         [&unit](double p) { return Plausible(p * unit.hpa); });
  };
  return *std::max_element(kUnits.begin(), kUnits.end(), [&](const Unit& a, const Unit& b) {
    return plausible(a) < plausible(b);
  });
}

// The first sample behind `first` that differs from it.
std::size_t EndOfRun(const Stream<double>& pressure, std::size_t first) {
  std::size_t end = first + 1;
  while (end < pressure.size() && pressure.value[end] == pressure.value[first]) ++end;
  return end;
}

Stream<double> WithoutStuckRuns(const Stream<double>& pressure, double constant_s,
                                std::map<std::string, std::int64_t>* counts) {
  Stream<double> out;
  for (std::size_t i = 0; i < pressure.size();) {
    const std::size_t end = EndOfRun(pressure, i);
    if (SecondsBetween(pressure.time_ns[i], pressure.time_ns[end - 1]) > constant_s) {
      (*counts)["pressure_constant"] += static_cast<std::int64_t>(end - i);
      i = end;
    }
    for (; i < end; ++i) out.push_back(pressure.time_ns[i], pressure.value[i]);
  }
  return out;
}

// Sums up samples about the first, as times and heights are large.
class Mean {
 public:
  void Add(TimeNs time_ns, double height_m) {
    if (count_ == 0) {
      origin_ns_ = time_ns;
      origin_m_ = height_m;
    }
    const double h = height_m - origin_m_;
    ++count_;
    sum_s_ += SecondsBetween(origin_ns_, time_ns);
    sum_m_ += h;
    sum_squared_m2_ += h * h;
  }

  bool empty() const { return count_ == 0; }

  void AppendTo(HeightStream* stream) const {
    const double mean = sum_m_ / count_;
    const double spread = std::max(0.0, sum_squared_m2_ / count_ - mean * mean);
    stream->height_m.push_back(origin_ns_ + DurationNs(sum_s_ / count_), origin_m_ + mean);
    stream->sigma_m.push_back(count_ > 1 ? std::sqrt(spread / (count_ - 1)) : 0.0);
  }

 private:
  TimeNs origin_ns_ = 0;
  double origin_m_ = 0;
  int count_ = 0;
  double sum_s_ = 0, sum_m_ = 0, sum_squared_m2_ = 0;
};

}  // namespace

Stream<double> CheckPressure(const Stream<double>& pressure, const PressureSettings& settings,
                             std::map<std::string, std::int64_t>* counts) {
  const Unit& unit = UnitOf(pressure);
  Stream<double> out;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const double hpa = pressure.value[i] * unit.hpa;
    if (Plausible(hpa)) {
      out.push_back(pressure.time_ns[i], hpa);
    } else {
      ++(*counts)["pressure_out_of_range"];
    }
  }
  if (unit.count != nullptr && !out.empty()) {
    (*counts)[unit.count] += static_cast<std::int64_t>(out.size());
  }
  return WithoutStuckRuns(out, settings.constant_s, counts);
}

HeightStream BarometricHeight(const Recording& recording, const PressureSettings& settings,
                              std::map<std::string, std::int64_t>* counts) {
  const Stream<double> pressure = CheckPressure(recording.pressure_hpa, settings, counts);
  HeightStream heights;
  if (pressure.empty()) return heights;
  const TimeNs length_ns = std::max<TimeNs>(1, DurationNs(settings.mean_s));
  const TimeNs begin_ns = pressure.time_ns.front();
  TimeNs interval = 0;
  Mean mean;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const TimeNs at = (pressure.time_ns[i] - begin_ns) / length_ns;
    if (at != interval && !mean.empty()) {
      mean.AppendTo(&heights);
      mean = {};
    }
    interval = at;
    mean.Add(pressure.time_ns[i], HeightOfPressure(pressure.value[i]));
  }
  mean.AppendTo(&heights);
  const double silent_s = SecondsBetween(pressure.time_ns.back(), recording.end_ns);
  if (silent_s > settings.silent_s) {
    (*counts)["pressure_stopped_s"] += static_cast<std::int64_t>(silent_s);
  }
  return heights;
}

}  // namespace walkgraph
