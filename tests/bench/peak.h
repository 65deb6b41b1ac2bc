// SPDX-License-Identifier: MIT
/// \file
/// Floating-point operations per second of one core, at best, by instruction set.
#pragma once

namespace umbilic {

struct PeakKernels {
  /// Iterates x -> factor x + summand in independent lanes; returns their sum, to be used.
  double (*multiply_add)(long rounds, double factor, double summand);
  double flops;  ///< of a round, a multiply-add counting as two
};

/// Measured, for the instruction set in use.
double peak_flops_per_second();

}  // namespace umbilic
