// SPDX-License-Identifier: MIT
/// \file
/// The C contract as a C program would use it: what each getter writes, and what a failure leaves untouched.
#include "wasm/api.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

struct Options {
  int symmetry = 1;
  int metric = 0;
  int first_level = 1;
  int last_level = 1;
  int cap = 2;
  int max_iterations = 1000;
};

umbilic_minimizer* bending_of(const char* name, const Options& o) {
  umbilic_cage* cage = nullptr;
  EXPECT_EQ(umbilic_cage_generate(name, 1, 1.0, &cage), UMBILIC_OK);
  const double bending[6] = {1, 0, 0, 0, 0, 0};
  umbilic_minimizer* minimizer = nullptr;
  EXPECT_EQ(umbilic_minimizer_create(cage, bending, o.cap, o.symmetry, o.metric, o.first_level, o.last_level,
                                     o.max_iterations, 1e-6, &minimizer),
            UMBILIC_OK);
  umbilic_cage_destroy(cage);
  return minimizer;
}

umbilic_minimizer* minimized(const char* name, const Options& o) {
  umbilic_minimizer* minimizer = bending_of(name, o);
  while (!umbilic_minimizer_step(minimizer, 20)) {
  }
  return minimizer;
}

std::string message() {
  char text[256];
  umbilic_copy_message(text, sizeof text);
  return text;
}

TEST(Api, names_the_symmetry_that_a_run_keeps_before_its_first_step) {
  for (const int symmetry : {1, 0}) {
    umbilic_minimizer* minimizer = bending_of("two-3", {.symmetry = symmetry});
    int32_t order = 0;
    EXPECT_STREQ(umbilic_minimizer_group(minimizer, &order), symmetry ? "D3h" : "C1");
    EXPECT_EQ(order, symmetry ? 12 : 1);
    umbilic_minimizer_destroy(minimizer);
  }
}

TEST(Api, minimizes_in_the_metric_that_is_asked_for) {
  const char* const names[] = {"hessian", "identity", "sobolev", "hessian"};
  for (int metric = 0; metric < 4; ++metric) {
    umbilic_minimizer* minimizer = minimized("cube", {.metric = metric, .max_iterations = 3});
    double level[11];
    ASSERT_EQ(umbilic_minimizer_level_count(minimizer), 1);
    umbilic_minimizer_level(minimizer, 0, level);
    EXPECT_STREQ(umbilic_minimizer_level_metric(minimizer, 0), names[metric]);
    EXPECT_EQ(level[8] > 0, metric != 1) << "how often it was built";
    umbilic_minimizer_destroy(minimizer);
  }
}

TEST(Api, tells_which_levels_only_prepare_the_first_evaluable_one) {
  umbilic_minimizer* minimizer = minimized("cube", {.first_level = 0, .last_level = 1});
  ASSERT_EQ(umbilic_minimizer_level_count(minimizer), 2);
  double level[11];
  EXPECT_NE(std::string(umbilic_minimizer_level(minimizer, 0, level)), "");
  EXPECT_EQ(level[0], 0);
  EXPECT_EQ(level[1], 24) << "evaluated on the faces of level 1";
  EXPECT_EQ(level[9], 0);
  EXPECT_STREQ(umbilic_minimizer_level(minimizer, 1, level), "converged");
  EXPECT_EQ(level[0], 1);
  EXPECT_EQ(level[1], 24);
  EXPECT_EQ(level[9], 1);
  umbilic_minimizer_destroy(minimizer);
}

TEST(Api, extrapolates_from_three_evaluable_levels) {
  umbilic_minimizer* two = minimized("cube", {.last_level = 2});
  umbilic_minimizer* three = minimized("cube", {.last_level = 3});
  double limit[3];
  EXPECT_STREQ(umbilic_minimizer_limit(two, limit), "too_few_levels");
  EXPECT_TRUE(std::isfinite(limit[0]));
  EXPECT_TRUE(std::isnan(limit[2]));
  EXPECT_STREQ(umbilic_minimizer_limit(three, limit), "converging");
  EXPECT_LE(std::abs(limit[0] - 8 * M_PI), limit[2]) << "the sphere's energy";
  umbilic_minimizer_destroy(two);
  umbilic_minimizer_destroy(three);
}

TEST(Api, certifies_a_sphere_as_a_local_minimum_after_its_minimizer_is_gone) {
  umbilic_minimizer* minimizer = minimized("cube", {.last_level = 2});
  umbilic_certificate* certificate = nullptr;
  ASSERT_EQ(umbilic_minimizer_certify(minimizer, &certificate), UMBILIC_OK);
  umbilic_minimizer_destroy(minimizer);
  EXPECT_EQ(umbilic_certificate_progress(certificate), 0);
  double progress = 0;
  for (int32_t done = 0; !done;) {
    ASSERT_EQ(umbilic_certificate_step(certificate, 1, &done), UMBILIC_OK);
    EXPECT_GE(umbilic_certificate_progress(certificate), progress);
    progress = umbilic_certificate_progress(certificate);
  }
  EXPECT_EQ(progress, 1);
  double report[5];
  umbilic_certificate_report(certificate, report);
  EXPECT_EQ(report[0], 2);
  EXPECT_EQ(report[1], 3 * 98);
  EXPECT_EQ(report[2], 10);
  EXPECT_EQ(report[3], 1e-3);
  EXPECT_EQ(report[4], 0);
  umbilic_certificate_destroy(certificate);
}

TEST(Api, refuses_to_certify_flat_caps_and_leaves_the_handle_untouched) {
  umbilic_minimizer* minimizer = bending_of("cube", {.cap = 1});
  umbilic_certificate* certificate = nullptr;
  EXPECT_EQ(umbilic_minimizer_certify(minimizer, &certificate), UMBILIC_BAD_INPUT);
  EXPECT_EQ(certificate, nullptr);
  EXPECT_NE(message().find("flat"), std::string::npos) << message();
  umbilic_minimizer_destroy(minimizer);
}

}  // namespace
