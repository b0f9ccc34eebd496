#ifndef WALKGRAPH_DATA_BUILDING_H_
#define WALKGRAPH_DATA_BUILDING_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/truth.h"

namespace walkgraph {

using Polygon = std::vector<Eigen::Vector2d>;  // closed ring in metres, last vertex not repeated

struct PlanImage {
  std::string path;  // PNG; empty where there is none
  // Building-frame rectangle that the image covers (image rows run from top = max y down).
  Eigen::Vector2d min_corner = Eigen::Vector2d::Zero();
  Eigen::Vector2d max_corner = Eigen::Vector2d::Zero();
};

// The ways that people take on a floor, as straight links between nodes: middle lines of halls.
struct WayNetwork {
  std::vector<Eigen::Vector2d> nodes;     // building frame
  std::vector<std::array<int, 2>> links;  // indices of two nodes
  bool empty() const { return links.empty(); }
};

struct Floor {
  int number = 0;
  std::string name;  // as the source calls it, "B1"
  double height_m = 0;
  Eigen::Vector2d min_corner = Eigen::Vector2d::Zero();  // bounding box, building frame
  Eigen::Vector2d max_corner = Eigen::Vector2d::Zero();
  std::vector<Polygon> outline;    // empty: only the bounding box is known
  std::vector<Polygon> obstacles;  // not walkable (shops)
  WayNetwork ways;                 // empty: not known
  PlanImage image;
};

// Where the building frame's origin lies and how it is turned: x = east and y = north rotated by
// rotation_rad (counter-clockwise angle from east to the frame's +x axis).
struct GeoReference {
  double latitude_deg = 0;
  double longitude_deg = 0;
  double rotation_rad = 0;
};

enum class ConnectorKind : std::uint8_t { kStairs, kLift, kEscalator };

// Where a connector is entered from a floor.
struct ConnectorStop {
  int floor = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // building frame
};

// A place where a person changes floors: stairs, a lift or an escalator. Height moves near the line
// through its stops, and nowhere else on a level.
struct Connector {
  std::string name;
  ConnectorKind kind = ConnectorKind::kStairs;
  std::vector<ConnectorStop> stops;  // two or more, by increasing floor
  double radius_m = 3.0;             // how far from that line: half a stairwell
};

struct Building {
  std::string name;
  std::vector<Floor> floors;          // by increasing number
  std::vector<Connector> connectors;  // empty: not known
  std::optional<GeoReference> origin;

  const Floor* FindFloor(int number) const;
};

// Waypoints in metres of the building frame. WGS84 truth goes through the local tangent plane at
// the building's origin (error under 1 mm within 1 km). Throws std::invalid_argument where the
// truth is WGS84 and the building has no origin.
Truth ToBuildingFrame(const Truth& truth, const Building& building);

// Metres east/north of the origin, turned into the building frame, for a WGS84 point in degrees.
Eigen::Vector2d Wgs84ToBuilding(double latitude_deg, double longitude_deg,
                                const GeoReference& origin);

// The waypoints in degrees. Throws std::invalid_argument where the building has no origin.
Truth ToWgs84(const Truth& truth, const Building& building);

// The inverse of Wgs84ToBuilding(): latitude and longitude in degrees of a point of the building
// frame.
Eigen::Vector2d BuildingToWgs84(const Eigen::Vector2d& position, const GeoReference& origin);

// Inside by the even-odd rule over all rings; points on an edge may fall on either side.
bool InsidePolygons(const std::vector<Polygon>& rings, const Eigen::Vector2d& point);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_BUILDING_H_
