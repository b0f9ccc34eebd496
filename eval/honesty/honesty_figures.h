#ifndef WALKGRAPH_EVAL_HONESTY_HONESTY_FIGURES_H_
#define WALKGRAPH_EVAL_HONESTY_HONESTY_FIGURES_H_

#include <string>
#include <vector>

#include "eval/honesty/honesty_output.h"
#include "eval/report/figures/figures.h"

namespace walkgraph {

// Claimed against found shares, NEES per dimension by method and by walk, and the factors' mean
// squared whitened residuals. Of methods with an answer; none where no method has one.
std::vector<Figure> HonestyFigures(const HonestyResult& result);

// They and nothing else as one HTML file, without a script or a link; the same bytes for the same
// numbers.
std::string FormatHonestyPage(const std::vector<Figure>& figures);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_HONESTY_FIGURES_H_
