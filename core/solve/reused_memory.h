// SPDX-License-Identifier: MIT
/// \file
/// Arrays that are needed again and again, in changing sizes and on several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "base/aligned_doubles.h"

namespace umbilic {

/// Thread safe.
class ReusedMemory {
 public:
  /// At least `size` doubles with unspecified values: the smallest array that was put back and is large enough, or else
  /// the largest, grown.
  AlignedDoubles take(std::size_t size) {
    AlignedDoubles result = best_for(size);
    if (result.size() < size) {
      result = {};  // nothing is copied
      result.resize(size);
    }
    return result;
  }
  void put_back(AlignedDoubles memory) {
    if (memory.empty()) return;
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(memory));
  }

 private:
  AlignedDoubles best_for(std::size_t size) {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return {};
    const auto better = [&](const AlignedDoubles& a, const AlignedDoubles& b) {
      const bool a_fits = a.size() >= size, b_fits = b.size() >= size;
      if (a_fits != b_fits) return a_fits;
      return a_fits ? a.size() < b.size() : a.size() > b.size();
    };
    std::swap(*std::min_element(free_.begin(), free_.end(), better), free_.back());
    AlignedDoubles result = std::move(free_.back());
    free_.pop_back();
    return result;
  }

  std::mutex mutex_;
  std::vector<AlignedDoubles> free_;
};

}  // namespace umbilic
