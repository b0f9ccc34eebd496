#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "data/angle.h"
#include "data/simulator/radio.h"

namespace walkgraph {
namespace {

constexpr double kPhoneHeightM = 1.2;
constexpr double kBeaconHeightM = 2.2;  // on walls and posts

// The second-lowest bit of the first byte marks a locally administered address: no vendor's.
std::string Address(int kind, int number) {
  char text[24];
  std::snprintf(text, sizeof(text), "02:00:5e:%02x:%02x:%02x", kind, number / 256 % 256,
                number % 256);
  return text;
}

// As ilc20 names beacons: uuid_major_minor_mac.
std::string BeaconName(int floor_index, int number) {
  return "7a1c0000-5eed-4000-8000-000000000000_" + std::to_string(floor_index) + "_" +
         std::to_string(number) + "_" + Address(1, number);
}

Sender PlaceAccessPoint(const Plan& plan, const Floor& floor, int number,
                        const SimulationSettings& settings, Random* random) {
  const double margin_m = settings.wifi.neighbourhood_m;
  const double x =
      random->Uniform(floor.min_corner.x() - margin_m, floor.max_corner.x() + margin_m);
  const double y =
      random->Uniform(floor.min_corner.y() - margin_m, floor.max_corner.y() + margin_m);
  const double power_dbm =
      random->Normal(settings.wifi.power_at_1m_dbm, settings.wifi.power_sigma_db);
  const double phase = random->Uniform();
  const double length_m = settings.propagation.shadow_length_m;
  const bool planar = plan.building.floors.size() == 1;
  return {.radio = Radio::kWifi,
          .name = Address(0, number),
          .position_m = {x, y, floor.height_m + settings.propagation.height_over_floor_m},
          .floor = floor.number,
          .outside = !InsidePolygons(floor.outline, {x, y}),
          .power_at_1m_dbm = power_dbm,
          .phase = phase,
          .shadow = planar ? ShadowField::Planar(length_m, random)
                           : ShadowField::Spatial(length_m, random)};
}

}  // namespace

std::vector<Sender> PlaceAccessPoints(const Plan& plan, const SimulationSettings& settings,
                                      Random* random) {
  std::vector<Sender> senders;
  for (const Floor& floor : plan.building.floors) {
    for (int i = 0; i < settings.wifi.per_floor; ++i) {
      senders.push_back(
          PlaceAccessPoint(plan, floor, static_cast<int>(senders.size()), settings, random));
    }
  }
  return senders;
}

std::vector<Sender> PlaceBeacons(const Plan& plan, const SimulationSettings& settings,
                                 Random* random) {
  std::vector<Sender> senders;
  for (std::size_t i = 0; i < plan.building.floors.size(); ++i) {
    const Floor& floor = plan.building.floors[i];
    std::vector<const WayLink*> ways;
    for (const WayLink& link : plan.links) {
      const bool here = plan.Node(link.from).floor == floor.number;
      if (here && link.kind == WayKind::kCorridor) ways.push_back(&link);
    }
    for (int k = 0; k < settings.beacon.per_floor && !ways.empty(); ++k) {
      const WayLink& way =
          *ways[static_cast<std::size_t>(random->Index(static_cast<int>(ways.size())))];
      const Eigen::Vector2d from = plan.Node(way.from).position_m;
      const Eigen::Vector2d place =
          from + random->Uniform() * (plan.Node(way.to).position_m - from);
      const double power_dbm =
          random->Normal(settings.beacon.power_at_1m_dbm, settings.beacon.power_sigma_db);
      const double phase = random->Uniform();
      senders.push_back(
          {.radio = Radio::kBeacon,
           .name = BeaconName(static_cast<int>(i), static_cast<int>(senders.size())),
           .position_m = {place.x(), place.y(), floor.height_m + kBeaconHeightM},
           .floor = floor.number,
           .outside = false,
           .power_at_1m_dbm = power_dbm,
           .phase = phase,
           .shadow = ShadowField::Spatial(settings.propagation.shadow_length_m, random)});
    }
  }
  return senders;
}

std::vector<Sender> ChangeSenders(std::vector<Sender> senders, const ChangeSettings& settings,
                                  Random random) {
  constexpr double kSilentDbm = -1000.0;
  for (Sender& sender : senders) {
    const double lot = random.Uniform();
    const double change_db = random.Normal(0.0, settings.altered_sigma_db);
    if (lot < settings.vanished_share) {
      sender.power_at_1m_dbm = kSilentDbm;
    } else if (lot < settings.vanished_share + settings.altered_share) {
      sender.power_at_1m_dbm += change_db;
    }
  }
  return senders;
}

double FloorLossDb(const PropagationSettings& settings, int floors) {
  if (floors == 0) return 0.0;
  const double n = floors;
  return settings.floor_loss_db * std::pow(n, (n + 2.0) / (n + 1.0) - settings.floor_exponent);
}

double MeanRssiDbm(const Plan& plan, const Sender& sender, const Eigen::Vector2d& position_m,
                   double height_m, const PropagationSettings& settings) {
  const Eigen::Vector3d phone(position_m.x(), position_m.y(), height_m + kPhoneHeightM);
  const double across_m = (position_m - sender.position_m.head<2>()).norm();
  const double distance_m = std::max(1.0, std::hypot(across_m, phone.z() - sender.position_m.z()));
  const int floor = plan.FloorAt(height_m);
  const int walls = CountWallsBetween(plan, floor, position_m, sender.position_m.head<2>());
  return sender.power_at_1m_dbm - 10.0 * settings.exponent * std::log10(distance_m) -
         settings.wall_loss_db * std::min<double>(walls, settings.most_walls) -
         (sender.outside ? settings.outer_wall_loss_db : 0.0) -
         FloorLossDb(settings, std::abs(floor - sender.floor)) +
         settings.shadow_sigma_db * sender.shadow.At(phone);
}

double DrawRssiDbm(const Plan& plan, const Sender& sender, const WalkState& state,
                   const PropagationSettings& settings, Random* random) {
  const Eigen::Vector2d to_phone = sender.position_m.head<2>() - state.position_m;
  const Eigen::Vector2d facing = DirectionOf(state.heading_rad);
  const double ahead = to_phone.normalized().dot(facing);
  const double body_db = 0.5 * settings.body_loss_db * ahead;  // the mean is in the power
  return MeanRssiDbm(plan, sender, state.position_m, state.height_m, settings) + body_db +
         random->Normal(0.0, settings.reading_sigma_db);
}

const WalkState& StateAt(const std::vector<WalkState>& states, TimeNs time_ns) {
  const auto after =
      std::upper_bound(states.begin(), states.end(), time_ns,
                       [](TimeNs time, const WalkState& state) { return time < state.time_ns; });
  return after == states.begin() ? *after : *(after - 1);
}

double RefreshShare(const WifiSettings& settings, double rssi_dbm) {
  const double strength = (rssi_dbm - settings.refresh_middle_dbm) / settings.refresh_width_db;
  return 0.01 * (settings.refresh_base + settings.refresh_gain / (1.0 + std::exp(-strength)));
}

}  // namespace walkgraph
