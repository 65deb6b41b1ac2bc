// SPDX-License-Identifier: MIT
/// \file
/// Runs a part of a test with a number of threads.
#pragma once

#include "base/threads.h"

namespace umbilic::test {

/// So many threads compute until this is destroyed.
class WithThreads {
 public:
  explicit WithThreads(int count) : before_(thread_count()) { use_threads(count); }
  ~WithThreads() { use_threads(before_); }
  WithThreads(const WithThreads&) = delete;
  WithThreads& operator=(const WithThreads&) = delete;

 private:
  int before_;
};

/// Numbers of threads whose results are to be the same: none divides the other, and one exceeds the processors of most
/// machines that run tests.
inline constexpr int kThreadCounts[] = {1, 2, 3, 7};

}  // namespace umbilic::test
