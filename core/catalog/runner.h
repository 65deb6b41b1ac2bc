// SPDX-License-Identifier: MIT
/// \file
/// Computes entries on several threads, one entry at a time on each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalog/entry.h"

namespace umbilic::catalog {

/// What a thread works on, to its end unless `watch` ends it.
struct CatalogTask {
  std::string name;
  double cost;  ///< relative to other tasks; the dear ones begin first, so that no thread is left with one
  std::function<void(const Watch& watch)> work;
};

/// Where the tasks stand.
struct CatalogProgress {
  std::size_t done = 0;
  std::size_t count = 0;
  std::string task;  ///< of the thread that reports
  int level = 0;
};

/// Runs all tasks, `jobs` >= 1 at a time. `report` is called now and then, by one thread at a time; once it returns
/// false, no task begins any more and those under way end. Returns whether all were run. `work` is called by several
/// threads at once.
bool run_tasks(std::vector<CatalogTask> tasks, int jobs, const std::function<bool(const CatalogProgress&)>& report);

/// Relative cost of an entry, from its unknowns, which are the same for all frames of one family, and its levels.
double cost_of(const CatalogShape& shape, const EntrySettings& settings);

}  // namespace umbilic::catalog
