// SPDX-License-Identifier: MIT
/// \file
/// Threads: one budget of them for all that the process computes, and loops that share their work among them.
///
/// Results do not depend on the number of threads, to the last bit. So no loop here sums what its threads have each
/// summed. `parallel_for` is for pieces that write to places of their own; `in_order` also lets each piece be added to
/// a sum, which happens in the order of the pieces whichever thread has computed them; `in_stages` is for pieces that
/// need what others have written:
///
///     use_threads(hardware_threads());
///     std::vector<Block> blocks(slot_count());
///     in_order(patches, [&](int p, int slot, int) { compute(p, blocks[slot]); },
///              [&](int p, int slot) { sum += blocks[slot]; });
///
/// The budget is the process's: a loop within another one's piece is helped by the threads that have nothing else to
/// do, so that nested loops do not multiply threads. With one thread all of them are plain loops. In WebAssembly
/// threads run in workers that JavaScript has made before, and the module without shared memory has none.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace umbilic {

/// The most threads that can be asked for.
inline constexpr int kMostThreads = 256;

/// Number of threads that compute at the same time, the calling one included; 1 until `use_threads` is called.
int thread_count();
/// Sets `thread_count`, to 1 up to kMostThreads. Not while anything is computed.
void use_threads(int count);
/// Number of threads that this process may run at the same time, at most kMostThreads.
int hardware_threads();

/// Results of `in_order` that wait to be taken: so many that threads seldom wait for each other.
inline int slot_count() { return thread_count() == 1 ? 1 : 4 * thread_count(); }

/// A number that rises, which other threads wait for. They look for a moment before they sleep.
class RisingNumber {
 public:
  int get() const { return value_.load(std::memory_order_acquire); }
  /// Does nothing if it is this high already.
  void raise(int to);
  /// Returns once the number is at least this.
  void wait_for(int least) const;

 private:
  std::atomic<int> value_ = 0;
};

/// A reference to something that can be called with an int; it outlives the call that it is passed to.
class IntCall {
 public:
  template <class Callable>
  IntCall(const Callable& callable)
      : object_(&callable), call_([](const void* object, int i) { (*static_cast<const Callable*>(object))(i); }) {}
  void operator()(int i) const { call_(object_, i); }

 private:
  const void* object_;
  void (*call_)(const void*, int);
};

/// Calls work(0) on this thread, and work(1), work(2), ... on other threads of the budget as far as they have nothing
/// to do; none of them once one of these calls has returned. So `work` takes pieces from a common supply until there
/// are no more. Returns after all calls have; throws what the first of them has thrown.
void work_together(IntCall work);

/// The supply of pieces 0, 1, ... of a loop whose results are taken in this order.
class OrderedPieces {
 public:
  OrderedPieces(int count, int slots) : count_(count), computed_(slots, false) {}

  /// The next piece to compute, -1 if there are no more. Waits until the piece's slot is free.
  int next();
  /// The piece is computed. Calls `take` for all pieces whose turn it is now, unless another thread is doing so.
  void computed(int piece, IntCall take);
  /// Leaves out all further pieces, because one has failed.
  void give_up();

 private:
  std::vector<bool>::reference in_slot(int piece) { return computed_[piece % computed_.size()]; }

  const int count_;
  std::mutex mutex_;  // protects the members below
  std::condition_variable free_slot_;
  std::vector<bool> computed_;  // of the pieces in the slots, whether they are and wait to be taken
  int begun_ = 0, taken_ = 0;
  bool taking_ = false, given_up_ = false;
};

/// The supply of pieces of stages that follow each other.
class StagedPieces {
 public:
  struct Piece {
    int stage, index;
  };
  explicit StagedPieces(std::span<const int> counts) : counts_(counts) { begin_stage(0); }

  /// The next piece, as soon as all stages before its own have ended; a negative stage if there are no more.
  Piece next();
  void done();
  /// Leaves out all further pieces, because one has failed.
  void give_up();

 private:
  void begin_stage(int stage);
  int stages() const { return static_cast<int>(counts_.size()); }

  const std::span<const int> counts_;
  std::mutex mutex_;          // protects the members below
  int begun_ = 0, left_ = 0;  // pieces of the stage
  RisingNumber stage_;        // the number of stages once all have ended
};

/// Calls body(i, member) for each i < count, on several threads, each of which has another `member` < thread_count().
template <class Body>
void parallel_for(int count, const Body& body) {
  if (thread_count() > 1 && count > 1) {
    std::atomic<int> next = 0;
    const auto work = [&](int member) {
      try {
        for (int i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) body(i, member);
      } catch (...) {
        next.store(count, std::memory_order_relaxed);
        throw;
      }
    };
    return work_together(work);
  }
  for (int i = 0; i < count; ++i) body(i, 0);
}

/// Calls compute(i, slot, member) for each i < count, on several threads as `parallel_for`, and take(i, slot) in rising
/// order of i, each after the same piece has been computed and never two at the same time. What `compute` leaves in
/// memory of the slot, of which there are `slots`, at most slot_count(), stays there until it is taken.
template <class Compute, class Take>
void in_order(int count, int slots, const Compute& compute, const Take& take) {
  if (thread_count() > 1 && slots > 1 && count > 1) {
    OrderedPieces pieces(count, slots);
    const auto take_piece = [&](int i) { take(i, i % slots); };
    const auto work = [&](int member) {
      try {
        for (int i; (i = pieces.next()) >= 0;) {
          compute(i, i % slots, member);
          pieces.computed(i, take_piece);
        }
      } catch (...) {
        pieces.give_up();
        throw;
      }
    };
    return work_together(work);
  }
  for (int i = 0; i < count; ++i) {
    compute(i, 0, 0);
    take(i, 0);
  }
}

/// Calls body(stage, i, member) for each stage in turn and each i < counts[stage], on several threads as
/// `parallel_for`; for none of a stage before all calls for the stage before have ended.
template <class Body>
void in_stages(std::span<const int> counts, const Body& body) {
  if (thread_count() > 1) {
    StagedPieces pieces(counts);
    const auto work = [&](int member) {
      try {
        for (StagedPieces::Piece piece; (piece = pieces.next()).stage >= 0;) {
          body(piece.stage, piece.index, member);
          pieces.done();
        }
      } catch (...) {
        pieces.give_up();
        throw;
      }
    };
    return work_together(work);
  }
  for (std::size_t stage = 0; stage < counts.size(); ++stage) {
    for (int i = 0; i < counts[stage]; ++i) body(static_cast<int>(stage), i, 0);
  }
}

}  // namespace umbilic
