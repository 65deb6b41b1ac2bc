// SPDX-License-Identifier: MIT
/// \file
/// The optimizer's sparse factorization beside Eigen's and CHOLMOD's, on matrices of its own metrics: a program that
/// prints a JSON array. CHOLMOD takes the BLAS that it finds, as many threads as that is told to by its environment.
#include <suitesparse/cholmod.h>

#include <Eigen/SparseCholesky>
#include <cstdio>
#include <memory>

#include "../cages.h"
#include "../flops.h"
#include "../measure.h"
#include "../subjects.h"
#include "driver/rules.h"
#include "mesh/hierarchy.h"
#include "optimize/hessian_assembly.h"
#include "optimize/unknowns.h"
#include "solve/sparse_cholesky.h"

namespace umbilic {
namespace {

using Matrix = SparseCholesky::Matrix;

/// What one program takes for one matrix.
struct Measured {
  double analysis = 0, factorization = 0, solution = 0;  ///< seconds; analysis is done once for a pattern
  double entries = 0;                                    ///< that are stored of L
  Eigen::VectorXd result;                                ///< A^-1 (1, 1, ...)
};

std::string text_of(const char* name, const Measured& measured, const Eigen::VectorXd& expected) {
  return fmt::format(
      R"("{}":{{"analysis":{:.4g},"factorization":{:.4g},"solution":{:.4g},"entries":{:.0f},"difference":{:.2g}}})",
      name, measured.analysis, measured.factorization, measured.solution, measured.entries,
      (measured.result - expected).norm() / expected.norm());
}

Measured measure_own(const Matrix& lower, const Eigen::VectorXd& right) {
  Measured measured;
  SparseCholesky factor(SparseCholesky::Pivots::kPositive);
  factor.factor(lower);
  measured.analysis = best_seconds([&] { (void)EliminationTree(lower); });
  measured.factorization = best_seconds([&] { factor.factor(lower); });
  measured.solution = best_seconds([&] { measured.result = factor.solve(right); });
  measured.entries = static_cast<double>(EliminationTree(lower).panel_size());
  return measured;
}

Measured measure_eigen(const Matrix& lower, const Eigen::VectorXd& right) {
  Measured measured;
  Eigen::SimplicialLDLT<Matrix> factor;
  measured.analysis = best_seconds([&] { factor.analyzePattern(lower); });
  measured.factorization = best_seconds([&] { factor.factorize(lower); });
  measured.solution = best_seconds([&] { measured.result = factor.solve(right); });
  measured.entries = static_cast<double>(factor.matrixL().nestedExpression().nonZeros());
  return measured;
}

Measured measure_cholmod(const Matrix& lower, const Eigen::VectorXd& right) {
  Measured measured;
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(lower.rows());
  matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
  matrix.p = const_cast<int*>(lower.outerIndexPtr());
  matrix.i = const_cast<int*>(lower.innerIndexPtr());
  matrix.x = const_cast<double*>(lower.valuePtr());
  matrix.stype = -1;  // the lower triangle
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_REAL;
  matrix.sorted = matrix.packed = 1;
  cholmod_dense vector{};
  vector.nrow = vector.nzmax = vector.d = matrix.nrow;
  vector.ncol = 1;
  vector.x = const_cast<double*>(right.data());
  vector.xtype = CHOLMOD_REAL;
  const auto release = [&](cholmod_factor* factor) { cholmod_free_factor(&factor, &common); };
  using Factor = std::unique_ptr<cholmod_factor, decltype(release)>;
  measured.analysis = best_seconds([&] { Factor(cholmod_analyze(&matrix, &common), release); });
  const Factor factor(cholmod_analyze(&matrix, &common), release);
  measured.factorization = best_seconds([&] { cholmod_factorize(&matrix, factor.get(), &common); });
  measured.solution = best_seconds([&] {
    cholmod_dense* solved = cholmod_solve(CHOLMOD_A, factor.get(), &vector, &common);
    measured.result = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solved->x), lower.rows());
    cholmod_free_dense(&solved, &common);
  });
  measured.entries = common.lnz;
  cholmod_finish(&common);
  return measured;
}

/// The Hessian with just so much of the Sobolev matrix that it is positive definite, as the optimizer factors it.
Matrix positive_definite(const HessianAssembly& assembly) {
  SparseCholesky factor(SparseCholesky::Pivots::kPositive);
  double share = 1e-3;
  while (!factor.factor(assembly.combine(1, share))) share *= 10;
  return assembly.combine(1, share);
}

std::string row(const std::string& cage, bool symmetric, int level, int functional) {
  const Weights weights = only(functional);
  RefinedCage refined = *refine_to_evaluable(*bench_cage(cage), level, symmetric);
  const Points control = refined.control;
  const Coordinates coordinates(refined.mesh, refined.symmetry);
  const Surface surface(std::move(refined), CapKind::kSmooth, weights);
  const Unknowns unknowns(coordinates);
  HessianAssembly assembly(surface.layout(), unknowns, weights, hessian_rule(CapKind::kSmooth, weights));
  assembly.begin(control);
  while (!assembly.advance()) {
  }
  const Matrix lower = positive_definite(assembly);
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(lower.rows());
  const Measured own = measure_own(lower, right);
  return fmt::format(
      R"({{"cage":"{}","symmetric":{},"level":{},"functional":"{}","unknowns":{},"nonzeros":{},"flops":{:.6g},{},{},{}}})",
      cage, symmetric, level, kFunctionalNames[functional], lower.rows(), lower.nonZeros(), factorization_flops(lower),
      text_of("umbilic", own, own.result), text_of("eigen", measure_eigen(lower, right), own.result),
      text_of("cholmod", measure_cholmod(lower, right), own.result));
}

}  // namespace
}  // namespace umbilic

int main() {
  using namespace umbilic;
  std::vector<std::string> rows;
  for (int level = 1; level <= 3; ++level) rows.push_back(row("two-3", false, level, kMvsCross));
  for (int level = 2; level <= 3; ++level) rows.push_back(row("two-3", false, level, kBending));
  for (int level = 3; level <= 4; ++level) rows.push_back(row("two-3", true, level, kMvsCross));
  for (int level = 3; level <= 4; ++level) rows.push_back(row("dodecahedron-frame", true, level, kMvsCross));
  rows.push_back(row("cube", false, 4, kMvsCross));
  return std::puts(joined(rows).c_str()) < 0;
}
