// SPDX-License-Identifier: MIT
/// \file
/// Values that are made once per key and shared by whoever needs them.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace umbilic {

/// Safe to use from several threads. Holds at most `capacity` bytes, apart from a single larger value: what does not
/// fit any more empties it. Values live as long as somebody uses them.
template <class Key, class Value>
class SharedCache {
 public:
  /// > 0, in bytes as counted by Value::bytes.
  explicit SharedCache(std::size_t capacity) : capacity_(capacity) {}

  /// The value of `key`, which `make` returns where there is none yet.
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    const std::lock_guard lock(mutex_);
    if (const auto found = values_.find(key); found != values_.end()) return found->second;
    auto value = std::make_shared<const Value>(make());
    if (bytes_ + value->bytes() > capacity_) {
      values_.clear();
      bytes_ = 0;
    }
    bytes_ += value->bytes();
    values_.emplace(key, value);
    return value;
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const Value>> values_;
  std::size_t bytes_ = 0;
};

}  // namespace umbilic
