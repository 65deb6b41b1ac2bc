// SPDX-License-Identifier: MIT
/// \file
/// What a run, an evaluation or a gradient check has to say, as plain values; no layer below core/cli knows JSON.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "cage/cage.h"
#include "energy/functional.h"
#include "solve/stop_reason.h"

namespace umbilic {

struct EnergyReport {
  /// In the order of `Functional`; third-order values include the factor area. NaN where the quantity diverges.
  std::array<double, kFunctionalCount> functionals{};
  double area = 0;
  double gaussian = 0;  ///< integral of the Gaussian curvature
  /// |objective by the reporting rule - objective by the minimizing rule|, of the run's functional (of bending, where
  /// there is none).
  double quadrature_error = 0;
  bool whole = true;  ///< whether `gaussian` is that of a closed surface, see driver/gauss_bonnet.h
  /// Whether an energy is below what any closed surface of the genus has, see driver/contradiction.h.
  bool below_bound = false;
  /// Whether the surface is proved to be embedded: connected, and with its error below Li & Yau's 8 pi of `willmore`.
  bool embedded = false;

  /// Whether these can be the energies of a surface, and both rules have found some.
  bool credible() const { return whole && !below_bound && std::isfinite(quadrature_error); }
};

struct LevelReport {
  int level = 0;               ///< Catmull-Clark steps from the cage to the mesh whose points are moved
  int patches = 0;             ///< faces of the mesh that the surface is evaluated on
  int unknowns = 0;            ///< coordinates that the optimizer moves
  double energy = 0;           ///< by the minimizing rule
  double energy_reported = 0;  ///< by the reporting rule
  int iterations = 0;
  int evaluations = 0;
  double seconds = 0;
  StopReason stop = StopReason::kConverged;
  std::string_view metric;  ///< "identity", "sobolev" or "hessian"
  int metrics = 0;          ///< how often the metric was built
  int quadrature = 0;       ///< steps by which its rules became finer than usual, see driver/rules.h
  bool credible = true;     ///< whether its energies can be a surface's, see EnergyReport
  bool thickened = false;   ///< whether its start was made thicker, see driver/thickness.h
  bool evaluable = true;  ///< whether the moved mesh is the evaluated one; coarser ones only prepare the first of these
};

/// The symmetry that a run keeps.
struct GroupReport {
  std::string name;  ///< Schoenflies symbol
  int order = 1;
};

/// What the levels' energies say about their limit.
enum class LimitStatus {
  kConverging,     ///< `energy` is the limit to within `error`
  kTooFewLevels,   ///< fewer than three evaluable levels
  kNotMinimized,   ///< one of the last three levels did not converge
  kNotConverging,  ///< the last three levels are in no asymptotic range: the least energy is an upper bound
  kNotWhole,       ///< the last level's energy is not the surface's: curvature hides between its samples
};

/// "converging", "too_few_levels", "not_minimized", "not_converging", "not_whole".
constexpr std::string_view name_of(LimitStatus status) {
  switch (status) {
    case LimitStatus::kConverging: return "converging";
    case LimitStatus::kTooFewLevels: return "too_few_levels";
    case LimitStatus::kNotMinimized: return "not_minimized";
    case LimitStatus::kNotConverging: return "not_converging";
    case LimitStatus::kNotWhole: return "not_whole";
  }
  return "";
}

/// See driver/extrapolate.h. Without a limit, `energy` is the least level's, and `error` and `lower` are NaN.
struct LimitReport {
  LimitStatus status = LimitStatus::kTooFewLevels;
  double energy = 0;
  double order = 0;  ///< observed, NaN where it cannot be told
  double error = 0;  ///< the true limit is within energy +- error,
  double lower = 0;  ///< and not below this: energy - error, or the functional's lower bound
};

/// Whether the surface of a level is a minimum among all surfaces near it, symmetric or not. See driver/certificate.h.
struct CertificateReport {
  int level = 0;
  int unknowns = 0;  ///< of the full, unreduced Hessian
  int gauge = 0;     ///< directions removed: those along which the energy cannot change
  double tau = 0;    ///< eigenvalues of the Hessian relative to the Sobolev product below -tau count as negative
  int negative = 0;  ///< directions along which the energy decreases to second order
};

struct EvaluationReport {
  int level = 0;
  int patches = 0;
  EnergyReport energies;
};

struct GradientReport {
  int level = 0;
  int unknowns = 0;
  int directions = 0;
  double analytic = 0;           ///< directional derivative of the direction with the largest mismatch
  double difference = 0;         ///< the same by central differences
  double relative_mismatch = 0;  ///< the largest
  double tolerance = 0;
  bool ok = false;
};

}  // namespace umbilic
