#include "data/simulator/radio.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace walkgraph {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kWaves = 96;

// Multi-wall model (COST 231 final report, section 4.7.2): free space plus 3.4 dB per light wall.
// The access point radiates 17 dBm (ETSI EN 300 328 allows 20), free space takes 40 dB to 1 m
// at 2.4 GHz, hand and phone another 8 dB. Heights make distances below a metre impossible.
constexpr double kPowerAt1mDbm = -34.0;
constexpr double kPowerSigmaDb = 3.0;  // models and mountings differ
constexpr double kWallLossDb = 3.4;
constexpr double kOuterWallLossDb = 6.9;  // "heavy wall" of the same model
// Phones hear the neighbourhood too: access points stand up to this far outside the floor.
constexpr double kNeighbourhoodM = 40.0;
constexpr double kHeightDifferenceM = 1.3;
// Beyond some walls waves find ways around: diffraction and reflection bound the loss.
constexpr double kMostWalls = 6.0;
// 3GPP TR 38.901, indoor office: sigma 3 dB in sight to 8 dB out of sight (table 7.4.1-1),
// correlation length 6 m out of sight (table 7.5-6).
constexpr double kShadowSigmaDb = 4.5;
constexpr double kShadowLengthM = 6.0;
// A person between phone and access point: up to 9 dB, and a spread of 2-4 dB from reading to
// reading (Kaemarungsi and Krishnamurthy, MobiQuitous 2004).
constexpr double kBodyLossDb = 6.0;
constexpr double kReadingSigmaDb = 3.0;
// A beacon frame of the lowest rate is received down to about -92 dBm (IEEE 802.11 asks for -82),
// and one dwell on a channel misses some although they are strong enough: that often, 40 % of the
// printed rows are repeats, as in the recordings of ilc20.
constexpr double kThresholdDbm = -92.0;
constexpr double kMissProbability = 0.35;

// One sweep over both bands takes 2-4 s, and a phone prints what it has not heard again for up to
// 15 s more (Android keeps scan results that long and longer).
constexpr double kShortestSweepS = 2.2;
constexpr double kLongestSweepS = 3.8;
constexpr double kKeepS = 15.0;
constexpr double kRunUpS = 8.0;  // sweeps run before the recording does

struct Heard {
  TimeNs heard_ns = 0;
  double rssi_dbm = 0;
};

// The second-lowest bit of the first byte marks a locally administered address: no vendor's.
std::string Bssid(int number) {
  constexpr char kDigits[] = "0123456789abcdef";
  return std::string("02:00:5e:00:00:") + kDigits[number / 16 % 16] + kDigits[number % 16];
}

const WalkState& StateAt(const std::vector<WalkState>& states, TimeNs time_ns) {
  const auto after =
      std::upper_bound(states.begin(), states.end(), time_ns,
                       [](TimeNs time, const WalkState& state) { return time < state.time_ns; });
  return after == states.begin() ? *after : *(after - 1);
}

// The reading of one dwell; nullopt where nothing is heard.
std::optional<double> Receive(const Plan& plan, const AccessPoint& access_point,
                              const WalkState& state, Random* random) {
  const Eigen::Vector2d to_phone = access_point.position_m - state.position_m;
  const Eigen::Vector2d facing(std::cos(state.heading_rad), std::sin(state.heading_rad));
  const double ahead = to_phone.normalized().dot(facing);
  const double body_db = 0.5 * kBodyLossDb * ahead;  // the mean over directions is in the power
  const double rssi_dbm = MeanRssiDbm(plan, access_point, state.position_m) + body_db +
                          random->Normal(0.0, kReadingSigmaDb);
  const bool missed = random->Uniform() < kMissProbability;
  if (missed || rssi_dbm < kThresholdDbm) return std::nullopt;
  return std::round(rssi_dbm);
}

// Prints everything that the phone still remembers, strongest first as Android does.
void PrintScan(TimeNs printed_ns, const std::map<std::size_t, Heard>& memory,
               std::vector<std::pair<std::size_t, RadioRow>>* rows) {
  const std::size_t begin = rows->size();
  for (const auto& [access_point, heard] : memory) {
    if (SecondsBetween(heard.heard_ns, printed_ns) > kKeepS) continue;
    RadioRow row;
    row.printed_ns = printed_ns;
    row.heard_ns = heard.heard_ns;
    row.rssi_dbm = static_cast<float>(heard.rssi_dbm);
    rows->emplace_back(access_point, row);
  }
  std::stable_sort(
      rows->begin() + static_cast<std::ptrdiff_t>(begin), rows->end(),
      [](const auto& a, const auto& b) { return a.second.rssi_dbm > b.second.rssi_dbm; });
}

}  // namespace

ShadowField::ShadowField(double correlation_length_m, Random* random) {
  for (int i = 0; i < kWaves; ++i) {
    // exp(-d / L) in the plane has the spectrum (1 + (k L)^2)^(-3/2), whose distribution of k
    // inverts in closed form.
    const double u = std::max(random->Uniform(), 1e-6);
    const double k = std::sqrt(1.0 / (u * u) - 1.0) / correlation_length_m;
    const double direction = random->Uniform(0.0, kTurn);
    const double phase = random->Uniform(0.0, kTurn);
    waves_.push_back({{k * std::cos(direction), k * std::sin(direction)}, phase});
  }
}

double ShadowField::At(const Eigen::Vector2d& position) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += std::cos(wave.wave_vector.dot(position) + wave.phase_rad);
  return sum * std::sqrt(2.0 / kWaves);
}

std::vector<AccessPoint> PlaceAccessPoints(const Plan& plan, int count, Random* random) {
  const Floor& floor = plan.building.floors.front();
  std::vector<AccessPoint> access_points;
  for (int i = 0; i < count; ++i) {
    const double x = random->Uniform(floor.min_corner.x() - kNeighbourhoodM,
                                     floor.max_corner.x() + kNeighbourhoodM);
    const double y = random->Uniform(floor.min_corner.y() - kNeighbourhoodM,
                                     floor.max_corner.y() + kNeighbourhoodM);
    const double power_dbm = random->Normal(kPowerAt1mDbm, kPowerSigmaDb);
    const double sweep_fraction = random->Uniform();
    access_points.push_back(
        {Bssid(i), {x, y}, power_dbm, sweep_fraction, ShadowField(kShadowLengthM, random)});
  }
  return access_points;
}

double MeanRssiDbm(const Plan& plan, const AccessPoint& access_point,
                   const Eigen::Vector2d& position) {
  const double distance_m =
      std::hypot((position - access_point.position_m).norm(), kHeightDifferenceM);
  const int walls = CountWallsBetween(plan, position, access_point.position_m);
  const bool outside =
      !InsidePolygons(plan.building.floors.front().outline, access_point.position_m);
  return access_point.power_at_1m_dbm - 20.0 * std::log10(distance_m) -
         kWallLossDb * std::min<double>(walls, kMostWalls) - (outside ? kOuterWallLossDb : 0.0) +
         kShadowSigmaDb * access_point.shadow.At(position);
}

void SimulateWifi(const Plan& plan, const std::vector<AccessPoint>& access_points,
                  const std::vector<WalkState>& states, Random* random, Recording* recording) {
  std::map<std::size_t, Heard> memory;  // by access point
  std::vector<std::pair<std::size_t, RadioRow>> rows;
  const TimeNs begin_ns = states.front().time_ns;
  const TimeNs end_ns = states.back().time_ns;
  TimeNs sweep_ns = begin_ns - DurationNs(kRunUpS);
  while (true) {
    const double duration_s = random->Uniform(kShortestSweepS, kLongestSweepS);
    const TimeNs printed_ns = sweep_ns + DurationNs(duration_s);
    if (printed_ns > end_ns) break;
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      const TimeNs heard_ns = sweep_ns + DurationNs(duration_s * access_points[i].sweep_fraction);
      const auto rssi = Receive(plan, access_points[i], StateAt(states, heard_ns), random);
      if (rssi) memory[i] = {heard_ns, *rssi};
    }
    if (printed_ns >= begin_ns) PrintScan(printed_ns, memory, &rows);
    sweep_ns = printed_ns;
  }
  std::map<std::size_t, std::uint32_t> transmitter;
  for (auto& [access_point, row] : rows) {
    const auto [found, is_new] = transmitter.try_emplace(
        access_point, static_cast<std::uint32_t>(recording->transmitters.size()));
    if (is_new) {
      recording->transmitters.push_back({Radio::kWifi, access_points[access_point].bssid});
    }
    row.transmitter = found->second;
    recording->radio_rows.push_back(row);
  }
}

}  // namespace walkgraph
