// SPDX-License-Identifier: MIT
/// \file
/// Whether sampled energies contradict what holds for all closed surfaces, so that they cannot be the surface's own: a
/// lower bound of energy/lower_bounds.h, or Gauss & Bonnet's theorem (driver/gauss_bonnet.h).
///
/// Sums over samples may be a little below a bound that the surface attains. What is allowed for is the quadrature's
/// error, told by two rules, and for what both of them miss the defect of Gauss & Bonnet, which samples that miss
/// curvature show. Minimizers that attain their bound stay above it by more than that on all levels of the catalog, as
/// splines and caps cannot follow them; relative to the bound, `umbilic optimize --functional bending` of the generated
/// torus and cube:
///
///   level                     | 0       | 1       | 2       | 3
///   torus, above 8 pi^2 by    | 1.2e-3  | 4.6e-5  | 2.3e-6  | 1.6e-7
///     difference of two rules | 9.4e-9  | 1.1e-10 | 1.1e-12 | 3.3e-14
///     Gauss & Bonnet's defect | 2.1e-11 | 1.2e-12 | 9.6e-15 | 1.1e-14
///   cube, above 8 pi by       | 1.6e-2  | 2.9e-3  | 8.5e-5  | 4.3e-6
///     difference of two rules | 3.3e-6  | 3.1e-6  | 3.5e-7  | 4.3e-8
///     Gauss & Bonnet's defect | 2.6e-9  | 2.2e-9  | 4.3e-10 | 1.0e-10
#pragma once

namespace umbilic {

/// Of sums over millions of samples, relative.
inline constexpr double kSummationError = 1e-9;
/// An error larger than this part of a bound excuses nothing: no rule that sees the curvature errs by so much.
inline constexpr double kMostAllowed = 1e-2;

/// Whether a value that is known to within `error`, or NaN where that is not known, is below `bound` >= 0 beyond doubt.
constexpr bool below(double bound, double value, double error) {
  const double most = kMostAllowed * bound;
  return value + (error < most ? error : most) < bound * (1 - kSummationError);
}

}  // namespace umbilic
