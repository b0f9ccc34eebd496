#include "graph/observability.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "graph/block_elimination.h"

namespace walkgraph {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Share of the squared movement below which a kind counts as at rest.
constexpr double kRestShare = 1e-10;
// Movement below which a block or a coordinate counts as at rest, relative to the largest.
constexpr double kRestMovement = 1e-6;

// The blocks in terms of the labels: which kind each is of and where its coordinates are.
struct Layout {
  const std::vector<BlockLabel>* labels = nullptr;
  std::vector<std::string> kinds;  // in the order of their first labels
  std::vector<int> kind_of_block;
  std::vector<int> offsets;
};

Layout MakeLayout(const LinearSystem& system, const std::vector<BlockLabel>& labels) {
  Layout layout{&labels, {}, {}, ColumnOffsets(system.block_sizes)};
  std::map<std::string, int> index_of_kind;
  for (const BlockLabel& label : labels) {
    const auto [entry, added] =
        index_of_kind.emplace(label.kind, static_cast<int>(layout.kinds.size()));
    if (added) layout.kinds.push_back(label.kind);
    layout.kind_of_block.push_back(entry->second);
  }
  return layout;
}

// Null vectors as columns, in sigmas of each coordinate: one per dependent pivot, but no more of
// one kind than its share of kMaxNamedDirections, so that each kind is heard.
MatrixXd NullVectors(const BlockElimination& elimination, const Layout& layout,
                     const VectorXd& scale) {
  const int limit = std::max(1, kMaxNamedDirections / static_cast<int>(layout.kinds.size()));
  std::vector<int> taken(layout.kinds.size(), 0);
  MatrixXd vectors(scale.size(), 0);
  const auto& conditionals = elimination.conditionals;
  for (size_t origin = conditionals.size(); origin-- > 0;) {
    for (Index k = 0; k < conditionals[origin].free.cols(); ++k) {
      if (taken[layout.kind_of_block[conditionals[origin].block]]++ >= limit) continue;
      VectorXd x = VectorXd::Zero(scale.size());
      for (size_t i = origin + 1; i-- > 0;) {
        const BlockConditional& conditional = conditionals[i];
        auto own = x.segment(layout.offsets[conditional.block], conditional.regression.rows());
        if (i == origin) own = conditional.free.col(k);
        Index from = 0;
        for (const int parent : conditional.parents) {
          const Index size = layout.offsets[parent + 1] - layout.offsets[parent];
          own.noalias() += conditional.regression.middleCols(from, size) *
                           x.segment(layout.offsets[parent], size);
          from += size;
        }
      }
      vectors.conservativeResize(Eigen::NoChange, vectors.cols() + 1);
      vectors.rightCols(1) = scale.asDiagonal() * x;
    }
  }
  return vectors;
}

MatrixXd Orthonormal(const MatrixXd& vectors) {
  const MatrixXd normalised = vectors.colwise().normalized();
  return Eigen::HouseholderQR<MatrixXd>(normalised).householderQ() *
         MatrixXd::Identity(vectors.rows(), vectors.cols());
}

// Splits off the directions in the span of `basis` (orthonormal) that move nothing outside `kinds`.
MatrixXd TakeConfined(const Layout& layout, const std::set<int>& kinds, MatrixXd& basis) {
  MatrixXd outside = basis;
  for (size_t block = 0; block < layout.kind_of_block.size(); ++block) {
    if (kinds.count(layout.kind_of_block[block]) == 0) continue;
    outside.middleRows(layout.offsets[block], layout.offsets[block + 1] - layout.offsets[block])
        .setZero();
  }
  const MatrixXd gram = outside.transpose() * outside;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(gram);
  Index count = 0;
  while (count < basis.cols() && solver.eigenvalues()(count) < kRestShare) ++count;
  MatrixXd confined = basis * solver.eigenvectors().leftCols(count);
  basis = (basis * solver.eigenvectors().rightCols(basis.cols() - count)).eval();
  return confined;
}

// How one kind moves in the given directions; `largest` is the largest movement of any coordinate.
KindMovement Movement(const Layout& layout, int kind, const MatrixXd& directions, double largest) {
  KindMovement movement;
  movement.kind = layout.kinds[kind];
  for (int block = 0; block < static_cast<int>(layout.kind_of_block.size()); ++block) {
    if (layout.kind_of_block[block] != kind) continue;
    const std::vector<std::string>& axes = (*layout.labels)[block].axes;
    bool moves = false;
    for (int row = layout.offsets[block]; row < layout.offsets[block + 1]; ++row) {
      const double distance = directions.row(row).norm();
      movement.share += distance * distance / static_cast<double>(directions.cols());
      if (distance <= kRestMovement * largest) continue;
      moves = true;
      const size_t axis = row - layout.offsets[block];
      if (axis < axes.size() && std::find(movement.axes.begin(), movement.axes.end(), axes[axis]) ==
                                    movement.axes.end()) {
        movement.axes.push_back(axes[axis]);
      }
    }
    if (!moves) continue;
    if (movement.blocks++ == 0) movement.first_block = block;
    movement.last_block = block;
  }
  return movement;
}

void Report(const Layout& layout, const MatrixXd& directions, ObservabilityReport& report) {
  if (directions.cols() == 0) return;
  const double largest = directions.rowwise().norm().maxCoeff();
  UnobservableDirections entry;
  entry.dimension = static_cast<int>(directions.cols());
  for (size_t kind = 0; kind < layout.kinds.size(); ++kind) {
    KindMovement movement = Movement(layout, static_cast<int>(kind), directions, largest);
    if (movement.blocks > 0) entry.movements.push_back(std::move(movement));
  }
  std::stable_sort(entry.movements.begin(), entry.movements.end(),
                   [](const KindMovement& a, const KindMovement& b) { return a.share > b.share; });
  report.directions.push_back(std::move(entry));
}

std::string Join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

}  // namespace

std::optional<ObservabilityReport> AnalyzeObservability(const LinearSystem& system,
                                                        const std::vector<BlockLabel>& labels) {
  CheckShapes(system);
  if (labels.size() != system.block_sizes.size()) {
    throw std::invalid_argument("observability: expected one label per block");
  }
  if (!IsFinite(system)) return std::nullopt;
  const BlockElimination elimination = EliminateBlocks(system, FillReducingOrder(system));
  ObservabilityReport report;
  report.nullity = elimination.nullity;
  if (report.nullity == 0) return report;

  const Layout layout = MakeLayout(system, labels);
  const VectorXd scale =
      ColumnNorms(system).unaryExpr([](double norm) { return norm > 0 ? norm : 1.0; });
  MatrixXd basis = Orthonormal(NullVectors(elimination, layout, scale));
  const int kinds = static_cast<int>(layout.kinds.size());
  std::vector<std::set<int>> groups;
  groups.reserve(static_cast<size_t>(kinds) * (kinds + 1) / 2);
  for (int a = 0; a < kinds; ++a) groups.push_back({a});
  for (int a = 0; a < kinds; ++a) {
    for (int b = a + 1; b < kinds; ++b) groups.push_back({a, b});
  }
  for (const std::set<int>& group : groups) {
    if (basis.cols() > 0) Report(layout, TakeConfined(layout, group, basis), report);
  }
  Report(layout, basis, report);
  return report;
}

std::vector<std::string> DescribeObservability(
    const ObservabilityReport& report,
    const std::map<std::string, std::vector<std::string>>& remedies) {
  std::vector<std::string> sentences;
  for (const UnobservableDirections& entry : report.directions) {
    std::vector<std::string> subjects;
    std::vector<std::string> factors;
    for (const KindMovement& movement : entry.movements) {
      const std::string axes =
          movement.axes.empty() ? "" : " along (" + Join(movement.axes, ", ") + ")";
      subjects.push_back(movement.kind + axes);
      const auto found = remedies.find(movement.kind);
      if (found == remedies.end()) continue;
      for (const std::string& factor : found->second) {
        if (std::find(factors.begin(), factors.end(), factor) == factors.end()) {
          factors.push_back(factor);
        }
      }
    }
    std::string sentence = "unobservable: " + Join(subjects, " together with ");
    if (!factors.empty()) sentence += "; no factor of type " + Join(factors, " or ");
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace walkgraph
