// SPDX-License-Identifier: MIT
/// \file
/// Ends the program where a promise is broken, as libFuzzer and death tests see it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

namespace umbilic::fuzz {

void require(bool kept, std::string_view words) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(words.size()), words.data());
  std::abort();
}

void require_words(std::string_view message) {
  require(!message.empty(), "a failure has words");
  const bool line = std::none_of(message.begin(), message.end(), [](char c) { return c >= 0 && c < ' '; });
  require(line, "a message is one line that can be printed");
}

}  // namespace umbilic::fuzz
