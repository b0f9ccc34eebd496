#include "eval/honesty/matched_site.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "eval/honesty/random_field.h"
#include "frontends/radio_map/hearing.h"

namespace walkgraph {
namespace {

constexpr int kFloor = 0;
constexpr double kHalfWidthM = 45;
constexpr double kSpacingM = 3;
constexpr int kTransmitters = 60;
constexpr double kSmallestSpreadDb = 4;
constexpr double kBodyShadowDb = 2;

RadioMap::TransmitterField MakeField(int index, const FieldGrid& grid, Random random) {
  constexpr double kNearM = 3, kAtOneMetreDbm = -38, kExponent = 2.8;
  constexpr double kShadowDb = 4, kShadowM = 8;
  const Eigen::Vector2d sender(random.Uniform(-kHalfWidthM, kHalfWidthM),
                               random.Uniform(-kHalfWidthM, kHalfWidthM));
  const auto shadow = RandomField::SquaredExponential(kShadowM, random.Fork(0));
  const auto spread = RandomField::SquaredExponential(2 * kShadowM, random.Fork(1));
  RadioMap::TransmitterField field;
  field.transmitter = static_cast<std::uint32_t>(index);
  field.source_m = sender.cast<float>();
  field.columns = grid.columns;
  field.rows = grid.rows;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d at = grid.origin_m + grid.spacing_m * Eigen::Vector2d(column, row);
      const double distance_m = std::max(kNearM, (at - sender).norm());
      const double mean_dbm =
          kAtOneMetreDbm - 10 * kExponent * std::log10(distance_m) + kShadowDb * shadow.At(at);
      field.mean_dbm.push_back(static_cast<float>(mean_dbm));
      field.log_sigma.push_back(static_cast<float>(
          std::log(kSmallestSpreadDb * std::exp(0.2 * std::abs(spread.At(at))))));
      field.logit_hear.push_back(
          static_cast<float>(std::clamp((mean_dbm + 80.0) / 4.0, -7.0, 3.0)));
    }
  }
  return field;
}

RadioMap MakeMap(double map_error_sigma_m, const Random& random) {
  RadioMap map;
  map.floor = kFloor;
  map.radio = Radio::kWifi;
  // One control point more at the low edge and two at the high: a cubic spline needs them.
  const int across = static_cast<int>(2 * kHalfWidthM / kSpacingM) + 4;
  map.grid = {Eigen::Vector2d::Constant(-kHalfWidthM - kSpacingM), kSpacingM, across, across};
  map.sigma_min_db = kSmallestSpreadDb;
  map.map_error_sigma_m = map_error_sigma_m;
  map.body_shadow_db = kBodyShadowDb;
  for (int i = 0; i < kTransmitters; ++i) {
    map.fields.push_back(MakeField(i, map.grid, random.Fork(static_cast<std::uint64_t>(i))));
  }
  map.silence_nats = SilenceField(map.grid, map.fields);
  return map;
}

}  // namespace

Site MakeMatchedSite(double map_error_sigma_m, const Random& random) {
  Site site;
  Floor floor;
  floor.number = kFloor;
  floor.name = "hall";
  floor.min_corner = Eigen::Vector2d::Constant(-kHalfWidthM);
  floor.max_corner = Eigen::Vector2d::Constant(kHalfWidthM);
  site.building.floors.push_back(floor);
  for (int i = 0; i < kTransmitters; ++i) {
    // Transmitters are sorted by name.
    site.transmitters.push_back({Radio::kWifi, "sender" + std::to_string(100 + i)});
  }
  site.maps.push_back(MakeMap(map_error_sigma_m, random));
  const int across = static_cast<int>(2 * kHalfWidthM / kSpacingM);
  for (int row = 0; row < across; ++row) {
    for (int column = 0; column < across; ++column) {
      const Eigen::Vector2d at = kSpacingM * Eigen::Vector2d(column + 0.5, row + 0.5) -
                                 Eigen::Vector2d::Constant(kHalfWidthM);
      site.path.push_back({at, kFloor, static_cast<std::uint32_t>(row)});
    }
  }
  return site;
}

}  // namespace walkgraph
