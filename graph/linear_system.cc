#include "graph/linear_system.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace walkgraph {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void Require(bool condition, size_t factor, const char* expected) {
  if (!condition) {
    throw std::invalid_argument("linear factor " + std::to_string(factor) + ": expected " +
                                expected);
  }
}

}  // namespace

void CheckShapes(const LinearSystem& system) {
  const int blocks = static_cast<int>(system.block_sizes.size());
  for (const int size : system.block_sizes) {
    if (size <= 0) throw std::invalid_argument("linear system: expected block sizes above zero");
  }
  std::vector<size_t> last_use(blocks, 0);
  for (size_t i = 0; i < system.factors.size(); ++i) {
    const LinearFactor& factor = system.factors[i];
    Index width = 0;
    for (const int block : factor.blocks) {
      Require(block >= 0 && block < blocks, i, "block indices in range");
      Require(last_use[block] != i + 1, i, "each block once");
      last_use[block] = i + 1;
      width += system.block_sizes[block];
    }
    Require(factor.jacobian.cols() == width, i, "as many columns as its blocks have");
    Require(factor.jacobian.rows() == factor.residual.size(), i, "one residual per row");
  }
}

void CheckPairs(const LinearSystem& system, const std::vector<std::pair<int, int>>& pairs) {
  const int blocks = static_cast<int>(system.block_sizes.size());
  for (const auto& [a, b] : pairs) {
    if (a == b || std::min(a, b) < 0 || std::max(a, b) >= blocks) {
      throw std::invalid_argument("pair (" + std::to_string(a) + ", " + std::to_string(b) +
                                  "): expected two different blocks of the system");
    }
  }
}

bool IsFinite(const LinearSystem& system) {
  return std::all_of(system.factors.begin(), system.factors.end(), [](const LinearFactor& factor) {
    return factor.jacobian.allFinite() && factor.residual.allFinite();
  });
}

std::vector<int> ColumnOffsets(const std::vector<int>& block_sizes) {
  std::vector<int> offsets(block_sizes.size() + 1, 0);
  std::partial_sum(block_sizes.begin(), block_sizes.end(), offsets.begin() + 1);
  return offsets;
}

VectorXd ColumnNorms(const LinearSystem& system) {
  const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
  VectorXd squared = VectorXd::Zero(offsets.back());
  for (const LinearFactor& factor : system.factors) {
    Index from = 0;
    for (const int block : factor.blocks) {
      const Index size = system.block_sizes[block];
      squared.segment(offsets[block], size) +=
          factor.jacobian.middleCols(from, size).colwise().squaredNorm().transpose();
      from += size;
    }
  }
  return squared.cwiseSqrt();
}

}  // namespace walkgraph
