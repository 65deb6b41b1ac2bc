// SPDX-License-Identifier: MIT
/// \file
/// What a cache makes, shares and forgets.
#include "base/shared_cache.h"

#include <gtest/gtest.h>

namespace umbilic {
namespace {

struct Number {
  int value;
  std::size_t bytes() const { return 40; }
};

TEST(SharedCache, makes_each_value_once) {
  SharedCache<int, Number> cache(100);
  const auto first = cache.get(3, [] { return Number{9}; });
  const auto again = cache.get(3, []() -> Number { throw "made twice"; });
  EXPECT_EQ(first, again);
  EXPECT_EQ(cache.get(4, [] { return Number{16}; })->value, 16);
}

TEST(SharedCache, forgets_what_exceeds_its_capacity_but_not_under_its_users) {
  SharedCache<int, Number> cache(100);
  const auto first = cache.get(1, [] { return Number{1}; });
  cache.get(2, [] { return Number{4}; });
  cache.get(3, [] { return Number{9}; });
  const auto anew = cache.get(1, [] { return Number{-1}; });
  EXPECT_EQ(first->value, 1);
  EXPECT_EQ(anew->value, -1);
}

TEST(SharedCache, holds_a_value_larger_than_its_capacity) {
  SharedCache<int, Number> cache(10);
  const auto first = cache.get(1, [] { return Number{1}; });
  EXPECT_EQ(cache.get(1, [] { return Number{2}; }), first);
}

}  // namespace
}  // namespace umbilic
