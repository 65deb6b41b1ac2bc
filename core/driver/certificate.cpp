// SPDX-License-Identifier: MIT
/// \file
/// Assembles the full Hessian, factors it and counts signs.
#include "driver/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <random>

#include "base/symmetric_eigen.h"
#include "driver/descent.h"
#include "driver/equations.h"
#include "driver/rules.h"
#include "driver/surface.h"
#include "mesh/hierarchy.h"
#include "optimize/gauge.h"
#include "optimize/hessian_assembly.h"
#include "solve/absolute_inverse.h"
#include "solve/sparse_cholesky.h"

namespace umbilic {
namespace {

int negative_eigenvalues(const Eigen::MatrixXd& symmetric) {
  return static_cast<int>((symmetric_eigen(symmetric).values.array() < 0).count());
}

/// All that the constraints leave, whatever symmetry the surface has.
Unknowns free_unknowns(const RefinedCage& cage, CapChoice cap) {
  Coordinates coordinates(cage.mesh, {}, held_points(cage, cap));
  return Unknowns(coordinates, solutions_of(cage, coordinates));
}

/// Orthonormal directions of the control points that the constraints allow, over the unknowns.
Eigen::MatrixXd in_unknowns(const Eigen::MatrixXd& directions, const Unknowns& unknowns) {
  Eigen::MatrixXd result(unknowns.count(), directions.cols());
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    result.col(i) = unknowns.direction(Eigen::Map<const Points>(directions.col(i).data(), directions.rows() / 3, 3));
  }
  if (unknowns.mapped() || unknowns.count() < directions.rows()) orthonormalize(result);
  return result;
}

/// Share of the work that assembling takes; the rest is factoring.
constexpr double kAssemblyShare = 0.5;

}  // namespace

struct Certificate::State {
  RefinedCage cage;
  Surface surface;
  Unknowns unknowns;
  Eigen::MatrixXd gauge;  // orthonormal directions over the unknowns
  HessianAssembly assembly;
  SparseCholesky factor{SparseCholesky::Pivots::kNonzero};
  bool assembled = false, ended = false;
  double furthest = 0;  // of the progress
  std::optional<Error> failure;
  CertificateReport report;

  State(RefinedCage start, CapChoice cap, const Weights& weights, int quadrature, std::optional<double> fixed_area)
      : cage(std::move(start)),
        surface(cage, cap, weights, 0, fixed_area),
        unknowns(free_unknowns(cage, cap)),
        assembly(surface.layout(), unknowns, weights, minimizing_rule(cap, weights, quadrature), kUmbilicEta,
                 fixed_area, surface.closeness()) {
    report.level = cage.level;
    report.unknowns = unknowns.count();
    report.tau = kCertificateTau;
    gauge = in_unknowns(free_gauge(cage, gauge_of(weights)), unknowns);
    report.gauge = static_cast<int>(gauge.cols());
    ended = unknowns.count() == 0;
    if (!ended) assembly.begin(cage.control);
  }

  double progress() const {
    if (ended) return 1;
    if (!assembled) return kAssemblyShare * assembly.progress();
    return kAssemblyShare + (1 - kAssemblyShare) * factor.progress();
  }

  /// Computes the count, or tries again with a larger tau.
  void judge() {
    const bool factored = factor.succeeded();
    if (factored && residual() <= kLargestResidual) return count();
    if (report.tau < kLargestTau / 2) {
      report.tau *= kTauFactor;
      return factor.begin(assembly.combine(1, report.tau));
    }
    failure =
        Error{factored ? fmt::format("no certificate: rounding errors hide the signs of the Hessian's eigenvalues, "
                                     "even with tau {:g}",
                                     report.tau)
                       : "no certificate: the Hessian of this surface cannot be factored"};
    ended = true;
  }

  double residual() const {
    std::mt19937 random(1);
    Eigen::VectorXd right(unknowns.count());
    for (double& value : right) value = 2.0 * random() / std::mt19937::max() - 1;
    const HessianAssembly::Matrix lower = assembly.combine(1, report.tau);
    const Eigen::VectorXd left = lower.selfadjointView<Eigen::Lower>() * factor.solve(right);
    return (right - left).norm() / right.norm();
  }

  /// The number of negative eigenvalues of K + tau S on the complement of the gauge directions, from the matrix [M U G;
  /// U^T -C^-1 0; G^T 0 0] with K + tau S = M + U C U^T.
  void count() {
    int negative = factor.negative();
    const Eigen::Index rank = assembly.factors().cols();
    Eigen::MatrixXd border(unknowns.count(), rank + gauge.cols());
    border << assembly.factors(), gauge;
    Eigen::MatrixXd schur = -border.transpose() * factor.solve(border);
    if (rank == 2) schur.topLeftCorner<2, 2>() -= Eigen::Matrix2d{{0, 1}, {1, 0}};
    negative += negative_eigenvalues((schur + schur.transpose()) / 2);
    report.negative = negative - report.gauge - (rank == 2 ? 1 : 0);
    ended = true;
  }

  /// The Hessian times some directions.
  Eigen::MatrixXd times_hessian(const Eigen::MatrixXd& directions) const {
    const HessianAssembly::Matrix lower = assembly.combine(1, 0);
    Eigen::MatrixXd result = lower.selfadjointView<Eigen::Lower>() * directions;
    const Eigen::MatrixXd& factors = assembly.factors();
    if (factors.cols() == 2) {
      result += factors.col(0) * (factors.col(1).transpose() * directions);
      result += factors.col(1) * (factors.col(0).transpose() * directions);
    }
    return result;
  }

  /// The directions along which the Hessian without the rank-two term is negative are candidates: where the area does
  /// not change, that term vanishes, and every direction has a part of that kind beside a change of size.
  std::optional<SurfaceState> descent() const {
    if (!ended || failure || report.negative <= 0) return std::nullopt;
    const HessianAssembly::Matrix product = assembly.combine(0, 1);
    Eigen::MatrixXd candidates = AbsoluteInverse(factor, product, report.tau).vectors();
    candidates -= gauge * (gauge.transpose() * candidates).eval();
    const auto found =
        steepest(candidates, times_hessian(candidates), product.selfadjointView<Eigen::Lower>() * candidates);
    if (!found) return std::nullopt;
    const Points direction =
        unknowns.control(*found) - unknowns.control(Eigen::VectorXd(Eigen::VectorXd::Zero(unknowns.count())));
    const std::optional<Points> lower = moved_down(surface, direction);
    if (!lower) return std::nullopt;
    return SurfaceState{cage.level, cage.placement.back(*lower)};
  }
};

Result<Certificate> Certificate::create(const RefinedCage& cage, CapChoice cap, const Weights& weights, int quadrature,
                                        std::optional<double> fixed_area) {
  if (cap == CapKind::kFlat) {
    return Error{"no certificate with cap flat: its second derivatives take the caps' normals as fixed"};
  }
  if (cage.mesh.surface_face_count() > kMaxCertifiedFaces) {
    return Error{fmt::format("no certificate on {} patches; at most {} are possible", cage.mesh.surface_face_count(),
                             kMaxCertifiedFaces)};
  }
  RefinedCage free = cage;
  free.symmetry = {};
  return Certificate(std::make_unique<State>(std::move(free), cap, weights, quadrature, fixed_area));
}

Certificate::Certificate(std::unique_ptr<State> state) : state_(std::move(state)) {}
Certificate::Certificate(Certificate&&) noexcept = default;
Certificate& Certificate::operator=(Certificate&&) noexcept = default;
Certificate::~Certificate() = default;

bool Certificate::step() {
  if (state_->ended) return true;
  if (!state_->assembled) {
    state_->assembled = state_->assembly.advance();
    if (state_->assembled) state_->factor.begin(state_->assembly.combine(1, state_->report.tau));
  } else if (state_->factor.advance()) {
    state_->judge();
  }
  state_->furthest = std::max(state_->furthest, state_->progress());
  return state_->ended;
}

double Certificate::progress() const { return state_->furthest; }

std::optional<SurfaceState> Certificate::descent() const { return state_->descent(); }

Result<CertificateReport> Certificate::report() const {
  assert(state_->ended);
  if (state_->failure) return *state_->failure;
  return state_->report;
}

}  // namespace umbilic
