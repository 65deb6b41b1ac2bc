// SPDX-License-Identifier: MIT
/// \file
/// Tasks on threads: each once, the dear ones first, and none after a wish to end.
#include "catalog/runner.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "cage/generate.h"

namespace umbilic::catalog {
namespace {

const umbilic::Run& some_run() {
  static const umbilic::Run run = *umbilic::Run::create(*generate_cage("cube"), {.weights = *weights_of("bending")});
  return run;
}

TEST(CatalogRunner, does_every_task_once_on_any_number_of_threads) {
  for (const int jobs : {1, 2, 5}) {
    std::array<std::atomic<int>, 20> counts{};
    std::vector<CatalogTask> tasks;
    for (auto& count : counts) tasks.push_back({"task", 1, [&count](const Watch&) { ++count; }});
    EXPECT_TRUE(run_tasks(std::move(tasks), jobs, [](const CatalogProgress&) { return true; }));
    for (const auto& count : counts) EXPECT_EQ(count, 1);
  }
}

TEST(CatalogRunner, begins_with_the_dearest_and_reports_how_many_are_done) {
  std::vector<double> order;
  std::vector<std::size_t> done;
  std::vector<CatalogTask> tasks;
  for (const double cost : {2.0, 5.0, 1.0, 3.0}) {
    tasks.push_back({"task", cost, [&order, cost](const Watch& watch) {
                       order.push_back(cost);
                       EXPECT_TRUE(watch(some_run()));
                     }});
  }
  run_tasks(std::move(tasks), 1, [&](const CatalogProgress& progress) {
    EXPECT_EQ(progress.count, 4u);
    done.push_back(progress.done);
    return true;
  });
  EXPECT_EQ(order, (std::vector<double>{5, 3, 2, 1}));
  EXPECT_EQ(done, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(CatalogRunner, begins_nothing_more_once_it_is_to_end) {
  std::atomic<int> begun = 0;
  std::vector<CatalogTask> tasks;
  for (int i = 0; i < 10; ++i) {
    tasks.push_back({"task", 1, [&begun](const Watch& watch) {
                       ++begun;
                       while (watch(some_run())) {
                       }
                     }});
  }
  EXPECT_FALSE(run_tasks(std::move(tasks), 2, [&](const CatalogProgress&) { return false; }));
  EXPECT_LE(begun, 2);
}

}  // namespace
}  // namespace umbilic::catalog
