// SPDX-License-Identifier: MIT
/// \file
/// A cache of values that are computed once per key and shared by all users.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace umbilic {

/// Thread safe. Holds at most `capacity` bytes, or a single larger value: when a new value does not fit, the cache
/// drops all others first. A value that somebody still holds stays valid.
template <class Key, class Value>
class SharedCache {
 public:
  /// `capacity` > 0 is in bytes, as Value::bytes counts them.
  explicit SharedCache(std::size_t capacity) : capacity_(capacity) {}

  /// The value of `key`. Calls `make` if the cache does not have it.
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
