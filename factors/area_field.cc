#include "factors/area_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace walkgraph {
namespace {

constexpr double kMarginM = 5;
constexpr double kFar = 1e20;  // squared squares: no seed in the row

std::size_t Square(const AreaRaster& raster, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
         static_cast<std::size_t>(column);
}

AreaRaster EmptyRaster(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, double margin_m,
                       double spacing_m) {
  AreaRaster raster;
  raster.spacing_m = spacing_m;
  // Half a square more, so that walls on whole squares lie between centres.
  const double margin = margin_m + 0.5 * spacing_m;
  raster.origin_m = low_m.array() - margin;
  const Eigen::Array2d extent = (high_m - low_m).array() + 2 * margin;
  raster.columns = static_cast<int>(std::ceil(extent.x() / spacing_m)) + 1;
  raster.rows = static_cast<int>(std::ceil(extent.y() / spacing_m)) + 1;
  raster.inside.assign(Square(raster, 0, raster.rows), false);
  return raster;
}

// Where the edges of the rings cross the line of a row's centres, ascending.
std::vector<double> Crossings(std::span<const Polygon> rings, double y_m) {
  std::vector<double> crossings;
  for (const Polygon& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d& a = ring[i];
      const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
      if ((a.y() > y_m) == (b.y() > y_m)) continue;
      crossings.push_back(a.x() + (y_m - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// Sets the squares whose centres are inside the rings by the even-odd rule.
void Fill(std::span<const Polygon> rings, bool value, AreaRaster* raster) {
  for (int row = 0; row < raster->rows; ++row) {
    const std::vector<double> crossings =
        Crossings(rings, raster->origin_m.y() + row * raster->spacing_m);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto column = [&](double x_m) {
        const double at = std::ceil((x_m - raster->origin_m.x()) / raster->spacing_m);
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(raster->columns)));
      };
      for (int c = column(crossings[i]); c < column(crossings[i + 1]); ++c) {
        raster->inside[Square(*raster, c, row)] = value;
      }
    }
  }
}

// Squared distance transform of a line of n values that lie `stride` apart: out(i) = min over j of
// (i - j)^2 + f(j), the lower envelope of parabolas (Felzenszwalb and Huttenlocher, Distance
// Transforms of Sampled Functions, Theory of Computing 8, 2012).
void TransformLine(double* values, int n, int stride) {
  std::vector<double> f(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) f[static_cast<std::size_t>(i)] = values[i * stride];
  std::vector<int> apex(static_cast<std::size_t>(n));
  std::vector<double> from(static_cast<std::size_t>(n) + 1);
  const auto meets = [&](int q, int p) {
    const double q2 = static_cast<double>(q) * q, p2 = static_cast<double>(p) * p;
    return (f[static_cast<std::size_t>(q)] + q2 - f[static_cast<std::size_t>(p)] - p2) /
           (2.0 * (q - p));
  };
  std::size_t k = 0;
  from[0] = -std::numeric_limits<double>::infinity();
  from[1] = std::numeric_limits<double>::infinity();
  for (int q = 1; q < n; ++q) {
    double s = meets(q, apex[k]);
    while (k > 0 && s <= from[k]) s = meets(q, apex[--k]);
    if (s <= from[k]) {  // only where k = 0 and f is far on both: the first apex stays
      continue;
    }
    apex[++k] = q;
    from[k] = s;
    from[k + 1] = std::numeric_limits<double>::infinity();
  }
  k = 0;
  for (int i = 0; i < n; ++i) {
    while (from[k + 1] < i) ++k;
    const double d = i - apex[k];
    values[i * stride] = d * d + f[static_cast<std::size_t>(apex[k])];
  }
}

// Distance of every square to the nearest one that is (`inside`) or is not in the area, in squares.
std::vector<double> DistanceTo(const AreaRaster& raster, bool inside) {
  std::vector<double> squared(raster.inside.size());
  for (std::size_t i = 0; i < squared.size(); ++i) {
    squared[i] = raster.inside[i] == inside ? 0 : kFar;
  }
  for (int c = 0; c < raster.columns; ++c) {
    TransformLine(&squared[Square(raster, c, 0)], raster.rows, raster.columns);
  }
  for (int r = 0; r < raster.rows; ++r) {
    TransformLine(&squared[Square(raster, 0, r)], raster.columns, 1);
  }
  for (double& value : squared) value = std::sqrt(value);
  return squared;
}

}  // namespace

AreaField::AreaField(const AreaRaster& raster) : raster_(raster) {
  raster_.inside.clear();
  const std::vector<double> to_inside = DistanceTo(raster, true);
  const std::vector<double> to_outside = DistanceTo(raster, false);
  std::vector<double> distance(to_inside.size());
  for (std::size_t i = 0; i < distance.size(); ++i) {
    // The border lies half a square from the centres on either side of it.
    const double squares = raster.inside[i] ? 0.5 - to_outside[i] : to_inside[i] - 0.5;
    distance[i] = raster.spacing_m * squares;
  }
  distance_m_ = std::make_shared<const std::vector<double>>(std::move(distance));
  grid_ = std::make_shared<const Grid>(distance_m_->data(), 0, raster.rows, 0, raster.columns);
}

AreaRaster WalkableRaster(const Floor& floor, double spacing_m) {
  if (floor.outline.empty() || floor.outline.front().empty()) return {};
  Eigen::Vector2d low = floor.outline.front().front(), high = low;
  for (const Polygon& ring : floor.outline) {
    for (const Eigen::Vector2d& vertex : ring) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
  }
  AreaRaster raster = EmptyRaster(low, high, kMarginM, spacing_m);
  Fill(floor.outline, true, &raster);
  for (const Polygon& obstacle : floor.obstacles) Fill({&obstacle, 1}, false, &raster);
  return raster;
}

AreaRaster PathRaster(std::span<const Eigen::Vector2d> path_m, double reach_m, double spacing_m) {
  if (path_m.empty()) return {};
  Eigen::Vector2d low = path_m.front(), high = low;
  for (const Eigen::Vector2d& point : path_m) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  AreaRaster raster = EmptyRaster(low, high, reach_m + kMarginM, spacing_m);
  const int reach = static_cast<int>(std::ceil(reach_m / spacing_m));
  for (const Eigen::Vector2d& point : path_m) {
    const Eigen::Vector2d at = (point - raster.origin_m) / spacing_m;
    const int column = static_cast<int>(at.x()), row = static_cast<int>(at.y());
    for (int r = row - reach; r <= row + reach + 1; ++r) {
      for (int c = column - reach; c <= column + reach + 1; ++c) {
        if ((Eigen::Vector2d(c, r) - at).norm() * spacing_m > reach_m) continue;
        raster.inside[Square(raster, c, r)] = true;
      }
    }
  }
  return raster;
}

bool HasInside(const AreaRaster& raster) {
  return std::find(raster.inside.begin(), raster.inside.end(), true) != raster.inside.end();
}

}  // namespace walkgraph
