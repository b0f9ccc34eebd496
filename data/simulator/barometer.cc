#include "data/simulator/barometer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "data/simulator/noise.h"
#include "data/simulator/standard_atmosphere.h"

namespace walkgraph {
namespace {

// Streams of random numbers beside the main one, which pays for weather and white noise alone.
enum RandomStream : std::uint64_t { kOffset, kTrend, kDrift, kSteps, kWander };

double PerHpa(PressureUnit unit) {
  if (unit == PressureUnit::kPa) return 100.0;
  return unit == PressureUnit::kKpa ? 0.1 : 1.0;
}

// Change of the weather since the beginning, hPa: a trend and a random walk.
class Drift {
 public:
  Drift(const BarometerSettings& settings, double dt_s, Random trend_random, Random random)
      : trend_(trend_random.Normal(0.0, settings.trend_sigma_hpa_per_h) * dt_s / 3600.0),
        sigma_(settings.drift_hpa_per_sqrt_h * std::sqrt(dt_s / 3600.0)),
        random_(random) {}

  double Next() { return value_ += trend_ + sigma_ * random_.Normal(); }

 private:
  double trend_;
  double sigma_;
  Random random_;
  double value_ = 0;
};

// Steps that come and go: doors and fans, hPa.
class Steps {
 public:
  Steps(const BarometerSettings& settings, double dt_s, Random random)
      : settings_(settings), dt_s_(dt_s), random_(random) {}

  double Next() {
    const double mean_s =
        value_ == 0.0 ? 3600.0 / settings_.steps_per_hour : settings_.step_length_s;
    const bool changes = random_.Uniform() < 1.0 - std::exp(-dt_s_ / mean_s);
    const double step = random_.Normal(0.0, settings_.step_sigma_hpa);
    if (changes) value_ = value_ == 0.0 ? step : 0.0;
    return value_;
  }

 private:
  BarometerSettings settings_;
  double dt_s_;
  Random random_;
  double value_ = 0;
};

}  // namespace

void SimulateBarometer(const std::vector<WalkState>& states, const BarometerSettings& settings,
                       Random* random, Recording* recording) {
  if (settings.state == BarometerState::kMissing) return;
  const double state_s = SecondsBetween(states[0].time_ns, states[1].time_ns);
  const auto every = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(1.0 / settings.rate_hz / state_s)));
  const double dt_s = state_s * static_cast<double>(every);
  const double weather_hpa = random->Normal(settings.weather_hpa, settings.weather_sigma_hpa);
  const double offset_hpa = random->Fork(kOffset).Normal(0.0, settings.offset_sigma_hpa);
  Drift drift(settings, dt_s, random->Fork(kTrend), random->Fork(kDrift));
  Steps steps(settings, dt_s, random->Fork(kSteps));
  Random wander_random = random->Fork(kWander);
  Wander wander(settings.wander_hpa, settings.wander_s, dt_s, &wander_random);
  const bool stops = settings.state == BarometerState::kStops;
  const std::size_t end = stops ? states.size() / 2 : states.size();
  double first_hpa = 0;
  for (std::size_t i = 0; i < end; i += every) {
    const double ground_m = StandardHeight(weather_hpa + drift.Next());
    // Warm air is thin: it takes more height to the same pressure.
    const double rise_m = states[i].height_m * kStandardTemperatureK / settings.air_temperature_k;
    double hpa = StandardPressure(ground_m + rise_m) + offset_hpa + steps.Next() +
                 wander.Next(&wander_random) + random->Normal(0.0, settings.noise_hpa);
    if (i == 0) first_hpa = hpa;
    if (settings.state == BarometerState::kConstant) hpa = first_hpa;
    recording->pressure_hpa.push_back(states[i].time_ns, hpa * PerHpa(settings.unit));
  }
}

}  // namespace walkgraph
