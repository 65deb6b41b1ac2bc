// SPDX-License-Identifier: MIT
/// \file
/// The constants of the metrics, and the reasons for their values.
#pragma once

#include "base/threads.h"
#include "surface/quadrature.h"

namespace umbilic {

/// mu of the metric H + mu S. Between a cage and its minimizer it needs to be between 10 and 1e-6, smaller near the
/// minimizer. It starts in the middle of this range. Beyond kLargestMu the metric is given up; below kSmallestMu mu
/// shrinks no further.
inline constexpr double kStartMu = 1e-2;
inline constexpr double kSmallestMu = 1e-8;
inline constexpr double kLargestMu = 1e6;
/// The factor by which mu grows until the metric is positive definite, and the largest by which it shrinks for the next
/// surface.
inline constexpr double kMuFactor = 10;
inline constexpr double kLargestMuFall = 1e3;
/// Newton's metric: most negative eigenvalues of H + mu S that are replaced one by one, each of which costs a few
/// solutions with the factored matrix. mu falls by kMuFactor after a decrease of more than kGoodGain of the predicted
/// one, and rises by kMuRise after one of less than kPoorGain.
inline constexpr int kMostNegative = 12;
inline constexpr double kMuRise = 4;
inline constexpr double kGoodGain = 0.75, kPoorGain = 0.25;
/// A Sobolev term with so small a factor hides no decrease that matters.
inline constexpr double kSettledMu = 1e-5;
/// From here on the Sobolev product dominates, so the predicted decrease only measures mu: it shrinks as mu grows.
inline constexpr double kUninformativeMu = 10;

/// Regularization at umbilics in the Hessian of the metric, relative to the norm of II. With the much smaller one of
/// the energy, single samples near umbilics would raise mu by orders of magnitude.
inline constexpr double kMetricUmbilicEta = 0.03;

/// Quadrature of the Sobolev product. It need not be accurate; it must only see every direction.
inline constexpr QuadratureRule kSobolevRule{3, 3, 2};
/// The mass term of the Sobolev product, which removes its kernel: kMassShare times what |grad^k f|^2 is for an f that
/// varies over sqrt(area) / kMassWaves, the size of a surface's details.
inline constexpr double kMassShare = 0.01;
inline constexpr double kMassWaves = 10;

/// Samples that one part of the work on a metric processes, so that it costs about one energy evaluation.
inline constexpr int kHessianSamplesPerPart = 300;
inline constexpr int kSobolevSamplesPerPart = 3000;
/// With several threads so many times as much for each, that calling them costs little.
inline constexpr int kPartsPerThread = 8;
inline int samples_at_once(int samples_per_part) {
  return thread_count() == 1 ? samples_per_part : kPartsPerThread * thread_count() * samples_per_part;
}

}  // namespace umbilic
