// SPDX-License-Identifier: MIT
/// \file
/// Sums the mass matrices of patches.
#include "optimize/closeness_term.h"

#include <cmath>
#include <cstddef>

#include "optimize/patch_assembly.h"

namespace umbilic {
namespace {

/// Degree 6 in each direction, the square of bicubic patches, on regular ones; plenty on caps.
constexpr QuadratureRule kMassRule{4, 5, 2};

}  // namespace

ClosenessTerm::ClosenessTerm(const PatchLayout& layout, const Points& own, double weight)
    : patches_(layout, [](const PatchKind& kind) { return PatchBasis(shared_basis_table(kind, kMassRule, 0)); }),
      own_(own),
      weight_(weight) {
  patches_.move_to(own);
  const PatchAssembly assembly(layout, Coordinates(layout.control_count()), true);
  PatchSums sums;
  assembly.clear(sums);
  PatchMemory memory;
  PatchTerms terms;
  for (int set = 0; set < patches_.set_count(); ++set) {
    for (int p = 0; p < layout.sets()[set].count(); ++p) {
      assembly.scalar_terms(set, p, patch(set, p, memory), terms);
      assembly.add(set, p, terms, sums);
    }
  }
  assembly.eliminate(sums);
  mass_ = assembly.lower(sums.values);
  if (weight_ > 0) mass_ /= 2 * weight_;
}

Eigen::MatrixXd ClosenessTerm::patch(int set, int patch, PatchMemory& memory) const {
  const BasisTable& table = patches_.basis(set).table();
  const double* jets = patches_.jets({set, patch, 1}, 3, memory, 0);
  const BasisTable::View values = table.view(0, table.basis);
  Eigen::MatrixXd rows(table.distinct, table.columns);
  for (int s = 0; s < table.distinct; ++s) {
    const auto derivative = [&](int d) {
      const double* x = jets + d * table.samples + s;
      const std::ptrdiff_t stride = 3 * table.samples;
      return Vector3(x[0], x[stride], x[2 * stride]);
    };
    const double area = derivative(1).cross(derivative(2)).norm();
    rows.row(s) = std::sqrt(2 * weight_ * table.weights[s] * area) * values.row(s);
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(table.columns, table.columns);
  result.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  return result;
}

double ClosenessTerm::evaluate(const Points& control, Points* gradient) const {
  const Points moved = control - own_;
  const Points pulled = mass_.selfadjointView<Eigen::Lower>() * moved;
  if (gradient) *gradient += 2 * weight_ * pulled;
  return weight_ * moved.cwiseProduct(pulled).sum();
}

}  // namespace umbilic
