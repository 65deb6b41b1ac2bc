// SPDX-License-Identifier: MIT
/// \file
/// Times the loops of kernels/peak.cpp.
#include "peak.h"

#include "base/instruction_set.h"
#include "measure.h"

namespace umbilic {

inline namespace portable {
extern const PeakKernels kPeakKernels;
}
#ifdef UMBILIC_X86_KERNELS
namespace avx2 {
extern const PeakKernels kPeakKernels;
}
namespace avx512 {
extern const PeakKernels kPeakKernels;
}
#endif

double peak_flops_per_second() {
#ifdef UMBILIC_X86_KERNELS
  const KernelTables<PeakKernels> tables{&portable::kPeakKernels, &avx2::kPeakKernels, &avx512::kPeakKernels};
#else
  const KernelTables<PeakKernels> tables{&portable::kPeakKernels};
#endif
  const PeakKernels& kernels = kernels_in_use(tables);
  constexpr long kRounds = 200'000;
  volatile double used = 0;
  const double seconds =
      best_seconds([&] { used = kernels.multiply_add(kRounds, 0.999 + 1e-9 * (used > 1), 1e-3); }, 0.2);
  return kRounds * kernels.flops / seconds;
}

}  // namespace umbilic
