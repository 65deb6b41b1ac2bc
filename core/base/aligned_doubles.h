// SPDX-License-Identifier: MIT
/// \file
/// Arrays of doubles that start on a cache line, so that a vector load rarely straddles two lines.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace umbilic {

inline constexpr std::size_t kCacheLine = 64;

template <class T>
struct CacheLineAllocator {
  using value_type = T;

  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(kCacheLine)));
  }
  void deallocate(T* at, std::size_t) { ::operator delete(at, std::align_val_t(kCacheLine)); }

  friend bool operator==(CacheLineAllocator, CacheLineAllocator) { return true; }
};

using AlignedDoubles = std::vector<double, CacheLineAllocator<double>>;

/// Grows `storage` to at least `size` doubles and returns its start. The values are unspecified.
inline double* reserve(AlignedDoubles& storage, std::size_t size) {
  if (storage.size() < size) storage.resize(size);
  return storage.data();
}

}  // namespace umbilic
