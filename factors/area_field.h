#ifndef WALKGRAPH_FACTORS_AREA_FIELD_H_
#define WALKGRAPH_FACTORS_AREA_FIELD_H_

#include <ceres/cubic_interpolation.h>

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "data/building.h"

namespace walkgraph {

// Squares over a rectangle; square (0, 0) has its centre at `origin_m`.
struct AreaRaster {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  double spacing_m = 0.5;
  int columns = 0;
  int rows = 0;
  std::vector<bool> inside;  // row-major: whether the centre is in the area
  bool operator==(const AreaRaster&) const = default;
};

// Signed distance from the border of an area on one floor, in metres, positive outside: exact
// between the centres of a raster's squares (so that the border is known to a square), cubic
// between them. Cheap to copy.
class AreaField {
 public:
  // Precondition: the raster has squares inside the area.
  explicit AreaField(const AreaRaster& raster);

  // Inside the raster the field; further out the distance to the raster is added, so that a pose
  // that has left the building is drawn back too.
  template <typename T>
  T At(const T& x_m, const T& y_m) const;

 private:
  using Grid = ceres::Grid2D<double, 1>;

  AreaRaster raster_;  // without `inside`
  std::shared_ptr<const std::vector<double>> distance_m_;
  std::shared_ptr<const Grid> grid_;
};

// What lies inside the floor's outline and outside its obstacles, with a margin. Not inside
// anywhere where the floor has no outline.
AreaRaster WalkableRaster(const Floor& floor, double spacing_m);

// What lies within `reach_m` of a point of the path. Not inside anywhere where there is none.
AreaRaster PathRaster(std::span<const Eigen::Vector2d> path_m, double reach_m, double spacing_m);

bool HasInside(const AreaRaster& raster);

template <typename T>
T AreaField::At(const T& x_m, const T& y_m) const {
  const auto clamp = [](const T& value, double low, double high) {
    return value < T(low) ? T(low) : value > T(high) ? T(high) : value;
  };
  const double width_m = raster_.spacing_m * (raster_.columns - 1);
  const double height_m = raster_.spacing_m * (raster_.rows - 1);
  const T x = clamp(x_m, raster_.origin_m.x(), raster_.origin_m.x() + width_m);
  const T y = clamp(y_m, raster_.origin_m.y(), raster_.origin_m.y() + height_m);
  T distance;
  ceres::BiCubicInterpolator<Grid>(*grid_).Evaluate((y - raster_.origin_m.y()) / raster_.spacing_m,
                                                    (x - raster_.origin_m.x()) / raster_.spacing_m,
                                                    &distance);
  const T beyond_x = x_m - x, beyond_y = y_m - y;
  if (beyond_x != T(0) || beyond_y != T(0)) {
    using std::sqrt;
    distance += sqrt(beyond_x * beyond_x + beyond_y * beyond_y);
  }
  return distance;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_AREA_FIELD_H_
