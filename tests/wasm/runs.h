// SPDX-License-Identifier: MIT
/// \file
/// Problems as texts, and what the contract answers, for its tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "problem/text.h"
#include "wasm/api.h"

namespace umbilic::test {

inline std::string message() {
  std::string text(umbilic_copy_message(nullptr, 0) + 1, '\0');
  umbilic_copy_message(text.data(), text.size());
  text.pop_back();
  return text;
}

inline Problem bending_of(const char* generator, int first_level = 1, int last_level = 1) {
  Problem problem{.cage = GeneratedCage{generator, {}}};
  problem.options.weights = weights_of("bending").value();
  problem.options.first_level = first_level;
  problem.options.last_level = last_level;
  return problem;
}

inline umbilic_run* begun(const Problem& problem) {
  const std::string text = problem_text(problem);
  umbilic_run* run = nullptr;
  EXPECT_EQ(umbilic_run_create(text.data(), text.size(), nullptr, 0, &run), UMBILIC_OK) << message();
  return run;
}

inline umbilic_run* finished(const Problem& problem) {
  umbilic_run* run = begun(problem);
  for (int32_t done = 0; !done;) {
    if (umbilic_run_step(run, 20, &done) != UMBILIC_OK) break;
  }
  return run;
}

inline std::string part(const umbilic_run* run, umbilic_part which) {
  umbilic_text text{};
  EXPECT_EQ(umbilic_run_part(run, which, &text), UMBILIC_OK) << message();
  return {text.data, text.length};
}

/// Of the run, whose handle it destroys.
inline Report report_of(umbilic_run* run) {
  umbilic_text text{};
  EXPECT_EQ(umbilic_run_report(run, nullptr, &text), UMBILIC_OK) << message();
  Result<Report> report = parse_report({text.data, text.length});
  EXPECT_TRUE(report.ok()) << report.error().message;
  umbilic_run_destroy(run);
  return report ? std::move(report).value() : Report{};
}

}  // namespace umbilic::test
