// SPDX-License-Identifier: MIT
/// \file
/// The numbers in the metrics' constructions, and what they were chosen from.
#pragma once

#include "surface/quadrature.h"

namespace umbilic {

/// mu of the metric H + mu S. On surfaces between a cage and its minimizer it ends between 10 and 1e-6, the smaller the
/// nearer the minimizer. It starts in the middle of that, and may leave it by some powers of ten on either side before
/// the metric is given up or mu falls no further.
inline constexpr double kStartMu = 1e-2;
inline constexpr double kSmallestMu = 1e-8;
inline constexpr double kLargestMu = 1e6;
/// By which mu rises until the metric is positive definite, and the largest by which it falls to the next surface.
inline constexpr double kMuFactor = 10;
inline constexpr double kLargestMuFall = 1e3;
/// So small a multiple of the Sobolev product hides no decrease that matters.
inline constexpr double kSettledMu = 1e-5;
/// From here on the Sobolev product makes up the metric: what it predicts is but the smaller for a larger mu.
inline constexpr double kUninformativeMu = 10;

/// Regularization at umbilics of the metric's Hessian, relative to the norm of II: with that of the energy itself
/// single samples near umbilics make mu rise by orders of magnitude.
inline constexpr double kMetricUmbilicEta = 0.03;

/// A Sobolev product needs no exact integrals, only that no direction is missed.
inline constexpr QuadratureRule kSobolevRule{3, 3, 2};
/// Its mass term removes the kernel: a small part of what |grad^k f|^2 is for functions that vary over a tenth of
/// sqrt(area), as the details of a surface do.
inline constexpr double kMassShare = 0.01;
inline constexpr double kMassWaves = 10;

/// Samples whose contributions one step of building a metric adds, such that it costs about an energy evaluation.
inline constexpr int kHessianSamplesPerPart = 300;
inline constexpr int kSobolevSamplesPerPart = 3000;

}  // namespace umbilic
