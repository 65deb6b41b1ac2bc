// SPDX-License-Identifier: MIT
/// \file
/// The function that libFuzzer calls; the build compiles it once for each target.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  umbilic::fuzz::UMBILIC_FUZZ_TARGET({reinterpret_cast<const char*>(bytes), count});
  return 0;
}
