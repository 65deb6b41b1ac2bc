// SPDX-License-Identifier: MIT
/// \file
/// A queue of tasks, and the threads that process it.
#include "catalog/runner.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/threads.h"

namespace umbilic::catalog {
namespace {

class Queue {
 public:
  Queue(std::vector<CatalogTask> tasks, const std::function<bool(const CatalogProgress&)>& report)
      : tasks_(std::move(tasks)), report_(report) {
    std::stable_sort(tasks_.begin(), tasks_.end(), [](const auto& a, const auto& b) { return a.cost > b.cost; });
  }

  void work() {
    while (const CatalogTask* task = take()) {
      try {
        task->work([&](const Run& run) { return tell(task->name, run.progress().level); });
      } catch (...) {
        const std::lock_guard lock(mutex_);
        going_ = false;
        throw;
      }
      const std::lock_guard lock(mutex_);
      if (going_) ++done_;
    }
  }

  bool finished() const { return going_ && done_ == tasks_.size(); }

 private:
  const CatalogTask* take() {
    const std::lock_guard lock(mutex_);
    return going_ && next_ < tasks_.size() ? &tasks_[next_++] : nullptr;
  }

  bool tell(const std::string& name, int level) {
    const std::lock_guard lock(mutex_);
    going_ = going_ && report_({done_, tasks_.size(), name, level});
    return going_;
  }

  std::vector<CatalogTask> tasks_;
  const std::function<bool(const CatalogProgress&)>& report_;
  std::mutex mutex_;
  std::size_t next_ = 0, done_ = 0;
  bool going_ = true;
};

}  // namespace

bool run_tasks(std::vector<CatalogTask> tasks, const std::function<bool(const CatalogProgress&)>& report) {
  Queue queue(std::move(tasks), report);
  const auto work = [&](int) { queue.work(); };
  work_together(work);
  return queue.finished();
}

double cost_of(const CatalogShape& shape, const EntrySettings& settings) {
  double cost = std::pow(4.0, settings.run.last_level) * std::min(settings.run.max_iterations, 300);
  if (third_order(settings.run.weights)) cost *= 2;
  if (settings.run.weights[kMvs] > 0) cost *= 2;
  if (settings.second_family) cost *= 3;
  return cost * (1 + 0.1 * shape.arms);
}

}  // namespace umbilic::catalog
