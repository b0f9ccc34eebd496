#include "frontends/radio_map/explained_variance.h"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__)
#define WALKGRAPH_HAS_AVX2_PATH 1
#include <immintrin.h>
#endif

namespace walkgraph {

#ifdef WALKGRAPH_HAS_AVX2_PATH

namespace {

// Right-hand sides solved together, two registers of eight, and rows of the factor that share what
// they load: eight sums stay in registers.
constexpr Eigen::Index kColumns = 16;
constexpr Eigen::Index kRows = 4;

using Tile = Eigen::Matrix<float, Eigen::Dynamic, kColumns, Eigen::RowMajor>;
using Sums = __m256[kRows][2];

// sums -= the `rows` columns of the factor before them, times their solutions.
__attribute__((target("avx2,fma"))) void Subtract(const float* column, Eigen::Index stride,
                                                  const float* solved, Eigen::Index rows,
                                                  Sums& sums) {
  for (Eigen::Index j = 0; j < rows; ++j, column += stride, solved += kColumns) {
    const __m256 low = _mm256_loadu_ps(solved), high = _mm256_loadu_ps(solved + 8);
    for (Eigen::Index r = 0; r < kRows; ++r) {
      const __m256 factor = _mm256_broadcast_ss(column + r);
      sums[r][0] = _mm256_fnmadd_ps(factor, low, sums[r][0]);
      sums[r][1] = _mm256_fnmadd_ps(factor, high, sums[r][1]);
    }
  }
}

// Solves the tile in place by forward substitution and adds up the squares of every column. The
// factor is n x n with its inverse on the diagonal, n a multiple of kRows.
__attribute__((target("avx2,fma"))) void SolveTile(const Eigen::MatrixXf& factor, Tile* tile,
                                                   float* squares) {
  const Eigen::Index n = factor.rows();
  __m256 low_squares = _mm256_setzero_ps(), high_squares = _mm256_setzero_ps();
  for (Eigen::Index i = 0; i < n; i += kRows) {
    float* rows = tile->data() + i * kColumns;
    Sums sums;
    for (Eigen::Index r = 0; r < kRows; ++r) {
      sums[r][0] = _mm256_loadu_ps(rows + r * kColumns);
      sums[r][1] = _mm256_loadu_ps(rows + r * kColumns + 8);
    }
    Subtract(factor.data() + i, n, tile->data(), i, sums);
    for (Eigen::Index r = 0; r < kRows; ++r) {
      for (Eigen::Index s = 0; s < r; ++s) {
        const __m256 below = _mm256_broadcast_ss(&factor(i + r, i + s));
        sums[r][0] = _mm256_fnmadd_ps(below, sums[s][0], sums[r][0]);
        sums[r][1] = _mm256_fnmadd_ps(below, sums[s][1], sums[r][1]);
      }
      const __m256 inverse = _mm256_broadcast_ss(&factor(i + r, i + r));
      sums[r][0] = _mm256_mul_ps(sums[r][0], inverse);
      sums[r][1] = _mm256_mul_ps(sums[r][1], inverse);
      low_squares = _mm256_fmadd_ps(sums[r][0], sums[r][0], low_squares);
      high_squares = _mm256_fmadd_ps(sums[r][1], sums[r][1], high_squares);
      _mm256_storeu_ps(rows + r * kColumns, sums[r][0]);
      _mm256_storeu_ps(rows + r * kColumns + 8, sums[r][1]);
    }
  }
  _mm256_storeu_ps(squares, low_squares);
  _mm256_storeu_ps(squares + 8, high_squares);
}

Eigen::ArrayXf Avx2Explained(const Eigen::MatrixXf& lower, const Eigen::MatrixXf& cross) {
  const Eigen::Index n = lower.rows();
  const Eigen::Index padded = (n + kRows - 1) / kRows * kRows;
  Eigen::MatrixXf factor = Eigen::MatrixXf::Identity(padded, padded);
  factor.topLeftCorner(n, n) = lower;
  factor.diagonal() = factor.diagonal().cwiseInverse().eval();
  Eigen::ArrayXf squares(cross.cols());
  Tile tile(padded, kColumns);
  Eigen::Array<float, kColumns, 1> of_tile;
  for (Eigen::Index first = 0; first < cross.cols(); first += kColumns) {
    const Eigen::Index columns = std::min(kColumns, cross.cols() - first);
    tile.setZero();
    tile.topLeftCorner(n, columns) = cross.middleCols(first, columns);
    SolveTile(factor, &tile, of_tile.data());
    squares.segment(first, columns) = of_tile.head(columns);
  }
  return squares;
}

}  // namespace

#endif

Eigen::ArrayXf PortableExplainedVariance(const Eigen::MatrixXf& lower,
                                         const Eigen::MatrixXf& cross) {
  const Eigen::MatrixXf solved = lower.triangularView<Eigen::Lower>().solve(cross);
  return solved.colwise().squaredNorm().transpose().array();
}

Eigen::ArrayXf ExplainedVariance(const Eigen::MatrixXf& lower, const Eigen::MatrixXf& cross) {
#ifdef WALKGRAPH_HAS_AVX2_PATH
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return Avx2Explained(lower, cross);
  }
#endif
  return PortableExplainedVariance(lower, cross);
}

}  // namespace walkgraph
