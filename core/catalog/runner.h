// SPDX-License-Identifier: MIT
/// \file
/// Computes entries side by side, each on one thread while there are more of them than threads; then the threads that
/// are left over help with the last ones (base/threads.h).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalog/entry.h"

namespace umbilic::catalog {

/// The work of a task; it ends early if `watch` says so.
struct CatalogTask {
  std::string name;
  double cost;  ///< relative to other tasks; expensive ones begin first, so that none is left for the end
  std::function<void(const Watch& watch)> work;
};

/// The current state of the tasks.
struct CatalogProgress {
  std::size_t done = 0;
  std::size_t count = 0;
  std::string task;  ///< the task of the reporting thread
  int level = 0;
};

/// Runs all tasks, thread_count() at a time, and returns whether all were run. `report` is called from time to time, by
/// one thread at a time; once it returns false, no further task begins and the current ones end. `work` is called by
/// several threads at once; what it throws ends the others, and is thrown here.
bool run_tasks(std::vector<CatalogTask> tasks, const std::function<bool(const CatalogProgress&)>& report);

/// Relative cost of an entry, from its levels and its number of unknowns, which is the same for all frames of a family.
double cost_of(const CatalogShape& shape, const EntrySettings& settings);

}  // namespace umbilic::catalog
