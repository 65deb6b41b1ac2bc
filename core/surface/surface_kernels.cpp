// SPDX-License-Identifier: MIT
/// \file
/// The tables of all instruction sets that the build has.
#include "surface/surface_kernels.h"

#include "base/instruction_set.h"

namespace umbilic {

inline namespace portable {
extern const SurfaceKernels kSurfaceKernels;
}
#ifdef UMBILIC_X86_KERNELS
namespace avx2 {
extern const SurfaceKernels kSurfaceKernels;
}
namespace avx512 {
extern const SurfaceKernels kSurfaceKernels;
}
#endif

const SurfaceKernels& surface_kernels() {
#ifdef UMBILIC_X86_KERNELS
  static constexpr KernelTables<SurfaceKernels> kTables{&portable::kSurfaceKernels, &avx2::kSurfaceKernels,
                                                        &avx512::kSurfaceKernels};
#else
  static constexpr KernelTables<SurfaceKernels> kTables{&portable::kSurfaceKernels};
#endif
  return kernels_in_use(kTables);
}

}  // namespace umbilic
