// SPDX-License-Identifier: MIT
/// \file
/// The threads wait for jobs. The thread that has a job for them works on it, too, so that it needs none of them.
#include "base/threads.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <list>
#include <system_error>
#include <thread>

namespace umbilic {
namespace {

std::atomic<int>& budget() {
  static std::atomic<int> count{1};
  return count;
}

/// What several threads work on together. Lives as long as the call that waits for it.
struct Job {
  explicit Job(IntCall to_do) : work(to_do) {}

  IntCall work;
  int members = 1;  // that have begun, the owner included
  int helping = 0;  // of the others, those that have not ended
  bool open = true;
  std::exception_ptr failure;
  std::condition_variable helpers_ended;
};

class Team {
 public:
  ~Team() { dismiss(); }

  void run(IntCall work);
  /// Ends all threads; the next job begins new ones.
  void dismiss();

 private:
  void hire();
  void serve();
  Job* open_job();
  void take_part(Job& job, int member, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;  // protects all members, and all jobs
  std::condition_variable news_;
  std::vector<std::thread> threads_;
  std::list<Job*> jobs_;
  bool hired_ = false, dismissed_ = false;
};

Team& team() {
  static Team all;
  return all;
}

/// The job that has been open for longest: of nested ones the outer one, whose pieces are larger.
Job* Team::open_job() {
  for (Job* job : jobs_) {
    if (job->open && job->members < thread_count()) return job;
  }
  return nullptr;
}

void Team::take_part(Job& job, int member, std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  std::exception_ptr failure;
  try {
    job.work(member);
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  job.open = false;
  if (failure && !job.failure) job.failure = failure;
}

void Team::serve() {
  std::unique_lock lock(mutex_);
  for (;;) {
    Job* job = nullptr;
    news_.wait(lock, [&] { return dismissed_ || (job = open_job()) != nullptr; });
    if (job == nullptr) return;
    ++job->helping;
    take_part(*job, job->members++, lock);
    if (--job->helping == 0) job->helpers_ended.notify_one();
  }
}

/// Where the system gives no more threads, there are fewer.
void Team::hire() {
  hired_ = true;
  try {
    while (static_cast<int>(threads_.size()) + 1 < thread_count()) threads_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {
  }
}

void Team::run(IntCall work) {
  Job job(work);
  std::unique_lock lock(mutex_);
  if (!hired_) hire();
  const auto place = jobs_.insert(jobs_.end(), &job);
  news_.notify_all();
  take_part(job, 0, lock);
  job.helpers_ended.wait(lock, [&] { return job.helping == 0; });
  jobs_.erase(place);
  if (job.failure) std::rethrow_exception(job.failure);
}

void Team::dismiss() {
  {
    const std::lock_guard lock(mutex_);
    dismissed_ = true;
  }
  news_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  hired_ = dismissed_ = false;
}

}  // namespace

int thread_count() { return budget().load(std::memory_order_relaxed); }

int hardware_threads() { return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads); }

void use_threads(int count) {
  assert(count >= 1 && count <= kMostThreads);
  if (count == thread_count()) return;
  team().dismiss();
  budget().store(count, std::memory_order_relaxed);
}

void work_together(IntCall work) {
  if (thread_count() == 1) return work(0);
  team().run(work);
}

int OrderedPieces::next() {
  std::unique_lock lock(mutex_);
  const int slots = static_cast<int>(computed_.size());
  free_slot_.wait(lock, [&] { return given_up_ || begun_ == count_ || begun_ < taken_ + slots; });
  return given_up_ || begun_ == count_ ? -1 : begun_++;
}

void OrderedPieces::computed(int piece, IntCall take) {
  std::unique_lock lock(mutex_);
  in_slot(piece) = true;
  if (taking_) return;
  taking_ = true;
  while (taken_ < count_ && in_slot(taken_) && !given_up_) {
    lock.unlock();
    take(taken_);
    lock.lock();
    in_slot(taken_++) = false;
    free_slot_.notify_all();
  }
  taking_ = false;
}

void OrderedPieces::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  free_slot_.notify_all();
}

void RisingNumber::raise(int to) {
  for (int now = get(); now < to && !value_.compare_exchange_weak(now, to, std::memory_order_acq_rel);) {
  }
  value_.notify_all();
}

void RisingNumber::wait_for(int least) const {
  constexpr int kLooks = 200;
  for (int i = 0; i < kLooks && get() < least; ++i) std::this_thread::yield();
  for (int value; (value = get()) < least;) value_.wait(value, std::memory_order_acquire);
}

void StagedPieces::begin_stage(int stage) {
  while (stage < stages() && counts_[stage] == 0) ++stage;
  begun_ = 0;
  left_ = stage < stages() ? counts_[stage] : 0;
  stage_.raise(stage);
}

StagedPieces::Piece StagedPieces::next() {
  for (;;) {
    int stage = 0;
    {
      const std::lock_guard lock(mutex_);
      stage = stage_.get();
      if (stage == stages()) return {-1, 0};
      if (begun_ < counts_[stage]) return {stage, begun_++};
    }
    stage_.wait_for(stage + 1);
  }
}

void StagedPieces::done() {
  const std::lock_guard lock(mutex_);
  if (stage_.get() < stages() && --left_ == 0) begin_stage(stage_.get() + 1);
}

void StagedPieces::give_up() {
  const std::lock_guard lock(mutex_);
  stage_.raise(stages());
}

}  // namespace umbilic
