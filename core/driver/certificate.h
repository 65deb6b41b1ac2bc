// SPDX-License-Identifier: MIT
/// \file
/// Whether a surface is a minimum among all surfaces near it: the inertia of its full Hessian.
///
/// The Hessian K is that of all coordinates of the control points, whatever symmetry the run kept; S is the Sobolev
/// product. The negative eigenvalues of K + tau S are counted from its L D L^T (Sylvester), after removing the gauge
/// directions G (optimize/gauge.h). On the complement of G their number is neg(K + tau S) + pos(G^T (K + tau S)^-1 G) -
/// dim G. The rank-two term of the area product is treated in the same way, as a border of the matrix.
///
/// The rounding errors of the factorization are measured. If they are not small compared with tau S, tau grows tenfold,
/// up to kLargestTau.
///
/// The certificate is about the discrete surface. On coarse levels it also counts directions that exist only because of
/// the discretization (the Clifford torus has 5 at level 0 and none from level 2 on).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "base/result.h"
#include "energy/functional.h"
#include "problem/problem.h"
#include "problem/report.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// Eigenvalues of the Hessian, relative to the Sobolev product, that count as zero. Discrete surfaces have many
/// directions, along their parametrization, that change the energy very little.
inline constexpr double kCertificateTau = 1e-3;
/// If rounding errors hide the signs, tau grows by this factor, until it would hide eigenvalues that do not count as
/// zero.
inline constexpr double kTauFactor = 10;
inline constexpr double kLargestTau = 1e-1;
/// Largest |b - A x| / |b| of a factored A and random b. It measures the errors of the factorization relative to the
/// smallest eigenvalues of A, which are those of tau S along gauge directions. Below one, errors change no sign of an
/// eigenvalue that is clearly beyond tau.
inline constexpr double kLargestResidual = 0.25;

/// Keeps the time of a certificate at about a minute.
inline constexpr int kMaxCertifiedFaces = 10'000;

/// How often one goes on along a direction of descent at most, and the part of the energy by which that must fall.
inline constexpr std::size_t kMostDescents = 8;
inline constexpr double kLeastDescent = 1e-6;

struct RefinedCage;

/// The computation, in steps short enough for a page to wait for.
class Certificate {
 public:
  /// For a surface with these control points, with quadrature rules refined by `quadrature` steps and `fixed_area` as
  /// in Surface. Where faces are held, the directions are those in which the others can move. Fails as `Run::certify`.
  static Result<Certificate> create(const RefinedCage& cage, CapChoice cap, const Weights& weights, int quadrature = 0,
                                    std::optional<double> fixed_area = {});

  Certificate(Certificate&&) noexcept;
  Certificate& operator=(Certificate&&) noexcept;
  ~Certificate();

  /// Does one unit of work, which costs about one energy evaluation. Returns whether the computation has ended.
  bool step();
  /// The completed fraction, in [0, 1].
  double progress() const;
  /// Available once `step` has returned true. The error says why the signs of the eigenvalues cannot be determined.
  Result<CertificateReport> report() const;
  /// A surface of lower energy near this one, whose points are those of all vertices: this one, moved along the
  /// steepest direction that the search finds. Nothing where the report counts no direction, or none leads down. Costs
  /// some tens of evaluations.
  std::optional<SurfaceState> descent() const;

 private:
  struct State;
  explicit Certificate(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace umbilic
