// SPDX-License-Identifier: MIT
/// \file
/// The tables of all instruction sets that the build has.
#include "energy/energy_kernels.h"

#include "base/instruction_set.h"

namespace umbilic {

inline namespace portable {
extern const EnergyKernels kEnergyKernels;
}
#ifdef UMBILIC_X86_KERNELS
namespace avx2 {
extern const EnergyKernels kEnergyKernels;
}
namespace avx512 {
extern const EnergyKernels kEnergyKernels;
}
#endif

const EnergyKernels& energy_kernels() {
#ifdef UMBILIC_X86_KERNELS
  static constexpr KernelTables<EnergyKernels> kTables{&portable::kEnergyKernels, &avx2::kEnergyKernels,
                                                       &avx512::kEnergyKernels};
#else
  static constexpr KernelTables<EnergyKernels> kTables{&portable::kEnergyKernels};
#endif
  return kernels_in_use(kTables);
}

}  // namespace umbilic
