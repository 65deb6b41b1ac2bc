// SPDX-License-Identifier: MIT
/// \file
/// The tables of all instruction sets that the build has.
#include "solve/solve_kernels.h"

#include "base/instruction_set.h"

namespace umbilic {

inline namespace portable {
extern const SolveKernels kSolveKernels;
}
#ifdef UMBILIC_X86_KERNELS
namespace avx2 {
extern const SolveKernels kSolveKernels;
}
namespace avx512 {
extern const SolveKernels kSolveKernels;
}
#endif

const SolveKernels& solve_kernels() {
#ifdef UMBILIC_X86_KERNELS
  static constexpr KernelTables<SolveKernels> kTables{&portable::kSolveKernels, &avx2::kSolveKernels,
                                                      &avx512::kSolveKernels};
#else
  static constexpr KernelTables<SolveKernels> kTables{&portable::kSolveKernels};
#endif
  return kernels_in_use(kTables);
}

}  // namespace umbilic
