// SPDX-License-Identifier: MIT
/// \file
/// Whether a surface is a minimum among all surfaces near it: the inertia of its full Hessian.
///
/// With the Hessian K of all coordinates of the control points, whatever symmetry the surface was minimized in, and the
/// Sobolev product S, the negative eigenvalues of K + tau S are counted from its L D L^T (Sylvester), after the gauge
/// directions G (optimize/gauge.h) are removed. On the complement of G they are neg(K + tau S) + pos(G^T (K + tau S)^-1
/// G) - dim G. The area product's rank-two term is bordered in the same way.
///
/// Rounding errors of the factorization are measured: while they are not small beside tau S, tau rises tenfold, up to
/// kLargestTau.
///
/// The surface is the discrete one: on coarse levels directions that only the discretization opens count as well (the
/// Clifford torus has 5 at level 0 and none from level 2 on).
#pragma once

#include <memory>

#include "base/result.h"
#include "energy/functional.h"
#include "problem/report.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// Eigenvalues of the Hessian, relative to the Sobolev product, that count as zero: discrete surfaces have many
/// directions, along their parametrization, that change the energy very little.
inline constexpr double kCertificateTau = 1e-3;
/// Where rounding errors hide the signs tau rises by this factor, up to an eigenvalue that no longer counts as zero.
inline constexpr double kTauFactor = 10;
inline constexpr double kLargestTau = 1e-1;
/// |b - A x| / |b| of a factored A and random b: the errors of the factorization relative to the smallest eigenvalues
/// of A, those of tau S along gauge directions. Below one they change no sign that tau leaves in no doubt.
inline constexpr double kLargestResidual = 0.25;

/// So that it takes a minute, not an hour.
inline constexpr int kMaxCertifiedFaces = 10'000;

struct RefinedCage;

/// The work, in steps that a page can wait for.
class Certificate {
 public:
  /// Of a surface with these control points, by a rule so many steps finer than usual. Fails as `Run::certify`.
  static Result<Certificate> create(const RefinedCage& cage, CapKind cap, const Weights& weights, int quadrature = 0);

  Certificate(Certificate&&) noexcept;
  Certificate& operator=(Certificate&&) noexcept;
  ~Certificate();

  /// Does one unit of work, of about the cost of an energy evaluation; returns whether it has ended.
  bool step();
  /// In [0, 1].
  double progress() const;
  /// Once `step` has returned true. The error says why the signs of the eigenvalues cannot be told.
  Result<CertificateReport> report() const;

 private:
  struct State;
  explicit Certificate(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace umbilic
