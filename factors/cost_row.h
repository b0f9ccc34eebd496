#ifndef WALKGRAPH_FACTORS_COST_ROW_H_
#define WALKGRAPH_FACTORS_COST_ROW_H_

#include <algorithm>
#include <cmath>

namespace walkgraph {

// A term c >= 0 of a negative log likelihood that is no square becomes the row
// sqrt(2 c + kRowOffset), whose half square has the gradient of c; the offset keeps the row smooth
// where c vanishes.
inline constexpr double kRowOffset = 1.0;

// The row sqrt(weight (2 cost + kRowOffset)) and the factor that turns the gradient of the cost
// into that of the row. Rounding may leave a cost of zero a little below it.
struct CostRow {
  CostRow(double cost, double weight)
      : value(std::sqrt(weight * (2.0 * std::max(cost, 0.0) + kRowOffset))),
        slope(cost >= 0 ? weight / value : 0.0) {}
  double value;
  double slope;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_COST_ROW_H_
