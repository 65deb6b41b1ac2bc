// SPDX-License-Identifier: MIT
/// \file
/// Loops on several threads: every piece once, in the order that is promised, and no more threads than there may be.
#include "base/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <new>
#include <thread>
#include <vector>

#include "base/with_threads.h"

namespace umbilic::test {
namespace {

/// Counts who is inside at the same time.
class Occupancy {
 public:
  class Visit {
   public:
    explicit Visit(Occupancy& place) : place_(place) {
      const int now = ++place_.inside_;
      for (int most = place_.most_; most < now && !place_.most_.compare_exchange_weak(most, now);) {
      }
    }
    ~Visit() { --place_.inside_; }

   private:
    Occupancy& place_;
  };
  int most() const { return most_; }

 private:
  std::atomic<int> inside_ = 0, most_ = 0;
};

void dawdle(int piece) {
  for (int i = 0; i < piece % 5; ++i) std::this_thread::yield();
}

TEST(Threads, are_one_until_more_are_asked_for) {
  EXPECT_EQ(thread_count(), 1);
  EXPECT_GE(hardware_threads(), 1);
  const WithThreads three(3);
  EXPECT_EQ(thread_count(), 3);
}

TEST(ParallelFor, does_every_piece_once_with_a_member_of_its_own_for_each_thread) {
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    for (const int count : {0, 1, 2, 100}) {
      std::vector<int> done(count, 0);
      std::vector<Occupancy> of_member(threads);
      parallel_for(count, [&](int i, int member) {
        ASSERT_LT(member, threads);
        const Occupancy::Visit visit(of_member[member]);
        ++done[i];
        dawdle(i);
      });
      EXPECT_EQ(done, std::vector<int>(count, 1));
      for (const Occupancy& member : of_member) EXPECT_LE(member.most(), 1);
    }
  }
}

TEST(InOrder, takes_every_piece_once_in_order_and_keeps_its_slot_until_then) {
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    for (const int count : {0, 1, 2, 200}) {
      std::vector<int> slots(slot_count(), -1), taken;
      Occupancy taking;
      in_order(
          count, slot_count(),
          [&](int i, int slot, int) {
            dawdle(7 * i);
            EXPECT_EQ(slots[slot], -1);
            slots[slot] = i;
          },
          [&](int i, int slot) {
            const Occupancy::Visit visit(taking);
            dawdle(i);
            EXPECT_EQ(slots[slot], i);
            slots[slot] = -1;
            taken.push_back(i);
          });
      ASSERT_EQ(static_cast<int>(taken.size()), count);
      for (int i = 0; i < count; ++i) EXPECT_EQ(taken[i], i);
      EXPECT_LE(taking.most(), 1);
    }
  }
}

TEST(InStages, ends_each_stage_before_the_next) {
  const int counts[] = {5, 0, 1, 0, 0, 40, 3, 0};
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    std::vector<std::atomic<int>> done(std::size(counts));
    in_stages(counts, [&](int stage, int i, int member) {
      EXPECT_LT(member, threads);
      for (int before = 0; before < stage; ++before) EXPECT_EQ(done[before], counts[before]);
      dawdle(i);
      ++done[stage];
    });
    for (std::size_t stage = 0; stage < done.size(); ++stage) EXPECT_EQ(done[stage], counts[stage]);
  }
  in_stages({}, [](int, int, int) { ADD_FAILURE(); });
}

TEST(ParallelFor, throws_what_a_piece_throws_and_leaves_out_the_rest) {
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    std::atomic<int> done = 0;
    EXPECT_THROW(parallel_for(100'000,
                              [&](int i, int) {
                                if (i == 10) throw std::bad_alloc();
                                ++done;
                                std::this_thread::yield();
                              }),
                 std::bad_alloc);
    EXPECT_LT(done, 100'000 - 1);
    done = 0;
    parallel_for(10, [&](int, int) { ++done; });
    EXPECT_EQ(done, 10);
  }
}

TEST(InOrder, throws_what_a_piece_throws_while_it_is_computed_or_taken) {
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    for (const bool when_taken : {false, true}) {
      int taken = 0;
      EXPECT_THROW(in_order(
                       1000, slot_count(),
                       [&](int i, int, int) {
                         if (!when_taken && i == 20) throw std::bad_alloc();
                       },
                       [&](int i, int) {
                         if (when_taken && i == 20) throw std::bad_alloc();
                         ++taken;
                       }),
                   std::bad_alloc);
      EXPECT_LE(taken, 20);
    }
  }
}

TEST(InStages, throws_what_a_piece_throws_and_begins_no_further_stage) {
  for (const int threads : kThreadCounts) {
    const WithThreads with(threads);
    const int counts[] = {10, 10};
    const auto body = [](int stage, int i, int) {
      EXPECT_EQ(stage, 0);
      if (i == 5) throw std::bad_alloc();
    };
    EXPECT_THROW(in_stages(counts, body), std::bad_alloc);
  }
}

TEST(Threads, do_not_multiply_in_nested_loops) {
  const WithThreads three(3);
  Occupancy inside;
  std::atomic<int> done = 0;
  parallel_for(6, [&](int, int) {
    in_order(
        10, slot_count(),
        [&](int, int, int) {
          parallel_for(5, [&](int i, int) {
            const Occupancy::Visit visit(inside);
            dawdle(i);
            ++done;
          });
        },
        [](int, int) {});
  });
  EXPECT_EQ(done, 6 * 10 * 5);
  EXPECT_LE(inside.most(), 3);
}

// The second outer piece waits, in its own loop, until two of its pieces are begun at the same time.
TEST(Threads, that_have_nothing_else_to_do_help_with_a_nested_loop) {
  const WithThreads two(2);
  parallel_for(2, [](int outer, int) {
    if (outer == 0) return;
    std::atomic<int> begun = 0;
    parallel_for(2, [&](int, int) {
      ++begun;
      while (begun < 2) std::this_thread::yield();
    });
  });
}

TEST(RisingNumber, is_waited_for) {
  const WithThreads two(2);
  RisingNumber number;
  std::vector<int> written(3, 0);
  const int counts[] = {2};
  in_stages(counts, [&](int, int i, int) {
    for (int k = 0; k < 3; ++k) {
      if (i == 0) {
        for (int wait = 0; wait < 1000; ++wait) std::this_thread::yield();
        written[k] = k + 1;
        number.raise(k + 1);
      } else {
        number.wait_for(k + 1);
        EXPECT_EQ(written[k], k + 1);
      }
    }
  });
  number.wait_for(3);
  EXPECT_EQ(number.get(), 3);
}

}  // namespace
}  // namespace umbilic::test
