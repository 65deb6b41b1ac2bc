// SPDX-License-Identifier: MIT
/// \file
/// Surfaces that are no minima lead to ones that are lower.
#include "driver/descent.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

TEST(Steepest, is_the_eigenvector_of_the_least_eigenvalue) {
  Eigen::MatrixXd second = Eigen::Vector4d(3, -1, -8, 2).asDiagonal();
  const Eigen::MatrixXd product = Eigen::Vector4d(1, 1, 16, 1).asDiagonal();
  const Eigen::MatrixXd all = Eigen::Matrix4d::Identity();
  // -1 / 1 is less than -8 / 16.
  const Eigen::VectorXd found = *steepest(all, second * all, product * all);
  EXPECT_NEAR(std::abs(found[1]) / found.norm(), 1, 1e-12);
  Eigen::MatrixXd twice(4, 3);
  twice << all.col(2), all.col(2), all.col(3);
  const Eigen::VectorXd within = *steepest(twice, second * twice, product * twice);
  EXPECT_NEAR(std::abs(within[2]) / within.norm(), 1, 1e-12);
  EXPECT_FALSE(steepest(all.col(3), second * all.col(3), product * all.col(3)));
}

umbilic::Run ended(const char* generator, const RunOptions& options, const std::optional<SurfaceState>& start = {}) {
  umbilic::Run run = *umbilic::Run::create(*generate_cage(generator), options, {}, start);
  while (!run.step(1000)) {
  }
  return run;
}

Certificate certified(const umbilic::Run& run) {
  Certificate certificate = *run.certify();
  while (!certificate.step()) {
  }
  return certificate;
}

RunOptions minimizing(const char* functional, int level) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = level;
  return options;
}

/// The tetrahedron's frame has two directions down, which lead to a surface of genus 3 with less symmetry and less
/// bending.
TEST(DescentSlow, leads_from_a_symmetric_surface_to_a_lower_one) {
  const RunOptions options = minimizing("bending", 2);
  const umbilic::Run symmetric = ended("tetrahedron-frame", options);
  const Certificate certificate = certified(symmetric);
  ASSERT_EQ(certificate.report()->negative, 2);
  const std::optional<SurfaceState> start = certificate.descent();
  ASSERT_TRUE(start);
  EXPECT_EQ(start->level, 2);
  const umbilic::Run lower = ended("tetrahedron-frame", options, start);
  EXPECT_LT(lower.group().order, symmetric.group().order);
  EXPECT_LT(lower.result().energy, 0.99 * symmetric.result().energy);
}

/// With a third-order part the Hessian has a rank-two term.
TEST(Descent, knows_the_term_of_the_area) {
  const RunOptions options = minimizing("mvs_cross", 1);
  const umbilic::Run symmetric = ended("two-6", options);
  const Certificate certificate = certified(symmetric);
  ASSERT_GT(certificate.report()->negative, 0);
  const std::optional<SurfaceState> start = certificate.descent();
  ASSERT_TRUE(start);
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-6"), options, {}, start);
  while (run.progress().evaluations < 1) run.step(1);
  EXPECT_LT(run.progress().energy, symmetric.result().energy);
}

TEST(Descent, is_nowhere_from_a_minimum) {
  const Certificate certificate = certified(ended("two-3", minimizing("bending", 2)));
  EXPECT_EQ(certificate.report()->negative, 0);
  EXPECT_FALSE(certificate.descent());
}

}  // namespace
}  // namespace umbilic
