// SPDX-License-Identifier: MIT
/// \file
/// Asks the compiler's run-time library what the processor has. The library also asks whether the operating system
/// saves the wider registers.
#include "base/instruction_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cassert>

namespace umbilic {
namespace {

InstructionSet best() {
  for (const InstructionSet set : {InstructionSet::kAvx512, InstructionSet::kAvx2}) {
    if (available(set)) return set;
  }
  return InstructionSet::kPortable;
}

std::atomic<InstructionSet>& in_use() {
  static std::atomic<InstructionSet> set{best()};
  return set;
}

}  // namespace

bool available(InstructionSet set) {
  switch (set) {
    case InstructionSet::kPortable: return true;
#ifdef UMBILIC_X86_KERNELS
    case InstructionSet::kAvx2: return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::kAvx512:
      return available(InstructionSet::kAvx2) && __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#endif
    default: return false;
  }
}

InstructionSet instruction_set() { return in_use().load(std::memory_order_relaxed); }

void use_instruction_set(InstructionSet set) {
  assert(available(set));
  in_use().store(set, std::memory_order_relaxed);
}

Result<InstructionSet> parse_instruction_set(std::string_view name) {
  const auto found = std::find(kInstructionSetNames.begin(), kInstructionSetNames.end(), name);
  if (found == kInstructionSetNames.end()) {
    return Error{
        fmt::format("unknown instruction set \"{}\"; known are {}", name, fmt::join(kInstructionSetNames, ", "))};
  }
  const auto set = static_cast<InstructionSet>(found - kInstructionSetNames.begin());
  if (!available(set)) return Error{fmt::format("this program or processor has no {}", name)};
  return set;
}

}  // namespace umbilic
