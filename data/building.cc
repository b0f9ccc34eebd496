#include "data/building.h"

#include <cmath>
#include <stdexcept>

#include "data/angle.h"

namespace walkgraph {
namespace {

// WGS84 ellipsoid (NIMA TR8350.2): semi-major axis and first eccentricity squared.
constexpr double kSemiMajorAxisM = 6378137.0;
constexpr double kEccentricitySquared = 6.69437999014e-3;

// Earth-centred, earth-fixed coordinates of a point on the ellipsoid.
Eigen::Vector3d ToEarthCentred(double latitude_rad, double longitude_rad) {
  const double sin_latitude = std::sin(latitude_rad);
  const double radius =
      kSemiMajorAxisM / std::sqrt(1.0 - kEccentricitySquared * sin_latitude * sin_latitude);
  return radius * Eigen::Vector3d(std::cos(latitude_rad) * std::cos(longitude_rad),
                                  std::cos(latitude_rad) * std::sin(longitude_rad),
                                  (1.0 - kEccentricitySquared) * sin_latitude);
}

bool InsideRing(const Polygon& ring, const Eigen::Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double crossing_x = a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < crossing_x) inside = !inside;
  }
  return inside;
}

}  // namespace

const Floor* Building::FindFloor(int number) const {
  for (const Floor& floor : floors) {
    if (floor.number == number) return &floor;
  }
  return nullptr;
}

Eigen::Vector2d Wgs84ToBuilding(double latitude_deg, double longitude_deg,
                                const GeoReference& origin) {
  const double latitude = DegreesToRadians(origin.latitude_deg);
  const double longitude = DegreesToRadians(origin.longitude_deg);
  const Eigen::Vector3d offset =
      ToEarthCentred(DegreesToRadians(latitude_deg), DegreesToRadians(longitude_deg)) -
      ToEarthCentred(latitude, longitude);
  const Eigen::Vector3d east(-std::sin(longitude), std::cos(longitude), 0.0);
  const Eigen::Vector3d north(-std::sin(latitude) * std::cos(longitude),
                              -std::sin(latitude) * std::sin(longitude), std::cos(latitude));
  const double e = east.dot(offset);
  const double n = north.dot(offset);
  const double c = std::cos(origin.rotation_rad);
  const double s = std::sin(origin.rotation_rad);
  return {c * e + s * n, -s * e + c * n};
}

Eigen::Vector2d BuildingToWgs84(const Eigen::Vector2d& position, const GeoReference& origin) {
  const double latitude = DegreesToRadians(origin.latitude_deg);
  const double squared = 1.0 - kEccentricitySquared * std::sin(latitude) * std::sin(latitude);
  const double east_radius = kSemiMajorAxisM / std::sqrt(squared);  // of the prime vertical
  const double north_radius = east_radius * (1.0 - kEccentricitySquared) / squared;
  const double c = std::cos(origin.rotation_rad);
  const double s = std::sin(origin.rotation_rad);
  Eigen::Vector2d degrees(origin.latitude_deg, origin.longitude_deg);
  // Fixed-point iterations on the forward formula: each gains some four digits on a kilometre.
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Eigen::Vector2d left = position - Wgs84ToBuilding(degrees.x(), degrees.y(), origin);
    const Eigen::Vector2d east_north(c * left.x() - s * left.y(), s * left.x() + c * left.y());
    degrees.x() += RadiansToDegrees(east_north.y() / north_radius);
    degrees.y() += RadiansToDegrees(east_north.x() / (east_radius * std::cos(latitude)));
  }
  return degrees;
}

Truth ToBuildingFrame(const Truth& truth, const Building& building) {
  if (truth.frame == TruthFrame::kBuilding) return truth;
  if (!building.origin) {
    throw std::invalid_argument("truth is in WGS84, but the building has no geographic origin");
  }
  Truth converted = truth;
  converted.frame = TruthFrame::kBuilding;
  for (Waypoint& waypoint : converted.waypoints) {
    waypoint.position =
        Wgs84ToBuilding(waypoint.position.x(), waypoint.position.y(), *building.origin);
  }
  return converted;
}

Truth ToWgs84(const Truth& truth, const Building& building) {
  if (truth.frame == TruthFrame::kWgs84) return truth;
  if (!building.origin) throw std::invalid_argument("the building has no geographic origin");
  Truth converted = truth;
  converted.frame = TruthFrame::kWgs84;
  for (Waypoint& waypoint : converted.waypoints) {
    waypoint.position = BuildingToWgs84(waypoint.position, *building.origin);
  }
  return converted;
}

bool InsidePolygons(const std::vector<Polygon>& rings, const Eigen::Vector2d& point) {
  bool inside = false;
  for (const Polygon& ring : rings) {
    if (!ring.empty() && InsideRing(ring, point)) inside = !inside;
  }
  return inside;
}

}  // namespace walkgraph
