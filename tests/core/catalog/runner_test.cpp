// SPDX-License-Identifier: MIT
/// \file
/// Tasks on threads: each once, the dear ones first, and none after a wish to end.
#include "catalog/runner.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <new>

#include "base/with_threads.h"
#include "cage/generate.h"

namespace umbilic::catalog {
namespace {

using test::WithThreads;

const umbilic::Run& some_run() {
  static const umbilic::Run run = *umbilic::Run::create(*generate_cage("cube"), {.weights = *weights_of("bending")});
  return run;
}

TEST(CatalogRunner, does_every_task_once_on_any_number_of_threads) {
  for (const int threads : {1, 2, 5}) {
    const WithThreads with(threads);
    std::array<std::atomic<int>, 20> counts{};
    std::vector<CatalogTask> tasks;
    for (auto& count : counts) tasks.push_back({"task", 1, [&count](const Watch&) { ++count; }});
    EXPECT_TRUE(run_tasks(std::move(tasks), [](const CatalogProgress&) { return true; }));
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
  run_tasks(std::move(tasks), [&](const CatalogProgress& progress) {
    EXPECT_EQ(progress.count, 4u);
    done.push_back(progress.done);
    return true;
  });
  EXPECT_EQ(order, (std::vector<double>{5, 3, 2, 1}));
  EXPECT_EQ(done, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(CatalogRunner, begins_nothing_more_once_it_is_to_end) {
  const WithThreads two(2);
  std::atomic<int> begun = 0;
  std::vector<CatalogTask> tasks;
  for (int i = 0; i < 10; ++i) {
    tasks.push_back({"task", 1, [&begun](const Watch& watch) {
                       ++begun;
                       while (watch(some_run())) {
                       }
                     }});
  }
  EXPECT_FALSE(run_tasks(std::move(tasks), [&](const CatalogProgress&) { return false; }));
  EXPECT_LE(begun, 2);
}

TEST(CatalogRunner, ends_all_tasks_when_one_throws_and_throws_the_same) {
  for (const int threads : {1, 3}) {
    const WithThreads with(threads);
    std::vector<CatalogTask> tasks(5, {"waits", 1, [](const Watch& watch) {
                                         while (watch(some_run())) {
                                         }
                                       }});
    tasks.front() = {"throws", 2, [](const Watch&) { throw std::bad_alloc(); }};
    EXPECT_THROW(run_tasks(std::move(tasks), [](const CatalogProgress&) { return true; }), std::bad_alloc);
  }
}

}  // namespace
}  // namespace umbilic::catalog
