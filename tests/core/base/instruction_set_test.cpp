// SPDX-License-Identifier: MIT
/// \file
/// Names of instruction sets, and which of them runs.
#include "base/instruction_set.h"

#include <gtest/gtest.h>

#include "base/each_instruction_set.h"

namespace umbilic::test {
namespace {

TEST(InstructionSet, portable_is_always_available) { EXPECT_TRUE(available(InstructionSet::kPortable)); }

TEST(InstructionSet, in_use_is_an_available_one_and_the_one_last_chosen) {
  EXPECT_TRUE(available(instruction_set()));
  with_each_instruction_set([](InstructionSet set) { EXPECT_EQ(instruction_set(), set); });
}

TEST(InstructionSet, has_a_name_each) {
  for (int i = 0; i < kInstructionSetCount; ++i) {
    const auto set = static_cast<InstructionSet>(i);
    const Result<InstructionSet> found = parse_instruction_set(kInstructionSetNames[i]);
    ASSERT_EQ(found.ok(), available(set));
    if (found) {
      EXPECT_EQ(*found, set);
    } else {
      EXPECT_NE(found.error().message.find(kInstructionSetNames[i]), std::string::npos);
    }
  }
}

TEST(InstructionSet, that_is_unknown_is_answered_with_the_known_ones) {
  EXPECT_EQ(parse_instruction_set("sse").error().message,
            "unknown instruction set \"sse\"; known are portable, avx2, avx512");
}

}  // namespace
}  // namespace umbilic::test
