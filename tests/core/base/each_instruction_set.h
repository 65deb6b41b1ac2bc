// SPDX-License-Identifier: MIT
/// \file
/// Runs code with the kernels of every instruction set that the machine has.
#pragma once

#include "base/instruction_set.h"

namespace umbilic::test {

/// Calls `body` with each available set in use, portable first, then restores the one that was.
template <class Body>
void with_each_instruction_set(const Body& body) {
  const InstructionSet before = instruction_set();
  for (int i = 0; i < kInstructionSetCount; ++i) {
    const auto set = static_cast<InstructionSet>(i);
    if (!available(set)) continue;
    use_instruction_set(set);
    body(set);
  }
  use_instruction_set(before);
}

}  // namespace umbilic::test
