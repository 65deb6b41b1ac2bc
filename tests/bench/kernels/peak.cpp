// SPDX-License-Identifier: MIT
/// \file
/// As many multiplications and additions as the processor can do, in registers.
#include "../peak.h"

#include "base/lanes.h"

namespace umbilic::UMBILIC_KERNELS {

double multiply_add(long rounds, double factor, double summand) {
  constexpr int kChains = 12;  // enough for two units of latency 4 to 6, and few enough for 16 registers
  const Lanes a = splat(factor), b = splat(summand);
  Lanes x[kChains];
  for (int i = 0; i < kChains; ++i) x[i] = splat(1.0 + i);
  for (long round = 0; round < rounds; ++round) {
    for (int i = 0; i < kChains; ++i) x[i] = x[i] * a + b;
  }
  double sum = 0;
  for (int i = 0; i < kChains; ++i) sum += sum_lanes(x[i]);
  return sum;
}

extern const PeakKernels kPeakKernels{multiply_add, 12.0 * 2 * kLaneCount};

}  // namespace umbilic::UMBILIC_KERNELS
