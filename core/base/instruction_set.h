// SPDX-License-Identifier: MIT
/// \file
/// Which instruction set the kernels use: chosen once per process, or set by a caller that compares them.
///
/// A kernel is a hot function that is compiled once per instruction set: the sources in a layer's folder kernels/, each
/// in a namespace of the set's name (base/kernel_namespace.h) and called through the layer's table. Everything else is
/// compiled once, for any processor.
#pragma once

#include <array>
#include <string_view>

#include "base/result.h"

namespace umbilic {

enum class InstructionSet {
  kPortable,  ///< what any processor of the target has: 2 lanes
  kAvx2,      ///< x86-64 with AVX2 and FMA: 4 lanes
  kAvx512,    ///< x86-64 with AVX-512 F, DQ and VL: 8 lanes
};

inline constexpr int kInstructionSetCount = 3;
inline constexpr std::array<std::string_view, kInstructionSetCount> kInstructionSetNames{"portable", "avx2", "avx512"};

constexpr std::string_view name_of(InstructionSet set) { return kInstructionSetNames[static_cast<int>(set)]; }

/// Whether this program has kernels for the set and this processor can run them.
bool available(InstructionSet set);

/// The set whose kernels run. Initially the largest one that is available.
InstructionSet instruction_set();

/// Makes the kernels of `set` run from now on; it must be available. Results of different sets agree to rounding.
void use_instruction_set(InstructionSet set);

/// The available set of that name; the error lists the names, or says that the processor lacks it.
Result<InstructionSet> parse_instruction_set(std::string_view name);

/// A layer's kernels for each instruction set; null where the program has none for it.
template <class Kernels>
using KernelTables = std::array<const Kernels*, kInstructionSetCount>;

/// The kernels of the set in use.
template <class Kernels>
const Kernels& kernels_in_use(const KernelTables<Kernels>& tables) {
  return *tables[static_cast<int>(instruction_set())];
}

}  // namespace umbilic
