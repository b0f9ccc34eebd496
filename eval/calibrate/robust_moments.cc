#include "eval/calibrate/robust_moments.h"

#include <algorithm>
#include <cmath>

namespace walkgraph {
namespace {

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Half width of the interval about `center` that counts.
double ClipWidth(const std::vector<double>& values, double center) {
  std::vector<double> deviation;
  deviation.reserve(values.size());
  for (const double value : values) deviation.push_back(std::abs(value - center));
  return 3.0 * 1.4826 * Median(std::move(deviation));
}

}  // namespace

Moments ClippedMoments(const std::vector<double>& values) {
  Moments moments;
  if (values.empty()) return moments;
  const double center = Median(values);
  const double width = ClipWidth(values, center);
  double sum = 0, squares = 0;
  for (const double value : values) {
    if (std::abs(value - center) > width) continue;
    sum += value - center;
    squares += (value - center) * (value - center);
    ++moments.samples;
  }
  const auto n = static_cast<double>(moments.samples);
  moments.mean = center + sum / n;
  if (moments.samples > 1) moments.variance = (squares - sum * sum / n) / (n - 1.0);
  return moments;
}

Line VarianceOverLag(const std::vector<double>& differences, const std::vector<double>& lag_s) {
  if (differences.empty()) return {};
  const double width = ClipWidth(differences, 0.0);
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (std::abs(differences[i]) > width) continue;
    const double x = lag_s[i], y = differences[i] * differences[i];
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const double determinant = n * sxx - sx * sx;
  if (!(determinant > 0)) return {sy / n, 0.0};
  Line line;
  line.slope = (n * sxy - sx * sy) / determinant;
  line.intercept = (sy - line.slope * sx) / n;
  if (line.slope < 0) return {sy / n, 0.0};
  if (line.intercept < 0) return {0.0, sxy / sxx};
  return line;
}

}  // namespace walkgraph
