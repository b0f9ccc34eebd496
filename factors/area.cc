#include "factors/area.h"

#include <vector>

namespace walkgraph {
namespace {

constexpr double kSpacingM = 0.5;  // a third of the narrowest door

AreaRaster RasterOf(const Site& site, int floor, const AreaSettings& settings) {
  switch (settings.kind) {
    case AreaKind::kWalkable: {
      const Floor* plan = site.building.FindFloor(floor);
      return plan == nullptr ? AreaRaster() : WalkableRaster(*plan, kSpacingM);
    }
    case AreaKind::kSurveyed: {
      std::vector<Eigen::Vector2d> path;
      for (const SurveyPoint& point : site.path) {
        if (point.floor == floor) path.push_back(point.position_m);
      }
      return PathRaster(path, settings.reach_m, kSpacingM);
    }
    case AreaKind::kNone:
      break;
  }
  return {};
}

}  // namespace

std::optional<AreaField> AreaOfFloor(const Site& site, int floor, const AreaSettings& settings) {
  const AreaRaster raster = RasterOf(site, floor, settings);
  if (!HasInside(raster)) return std::nullopt;
  return AreaField(raster);
}

}  // namespace walkgraph
