// SPDX-License-Identifier: MIT
/// \file
/// The function that libFuzzer calls; the build compiles it once for each target.
#include <cstddef>
#include <cstdint>
#include <ctime>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::clock_t begin = std::clock();
  umbilic::fuzz::UMBILIC_FUZZ_TARGET({reinterpret_cast<const char*>(bytes), count});
  const auto ticks = static_cast<double>(std::clock() - begin);
  umbilic::fuzz::require(ticks < umbilic::fuzz::kMostSeconds * CLOCKS_PER_SEC, "no input takes long");
  return 0;
}
