// SPDX-License-Identifier: MIT
/// \file
/// Negative directions at surfaces with boundaries, on the tangent space of what is held there.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"
#include "mesh/open_cages.h"

namespace umbilic::test {
namespace {

CertificateReport certified(const Cage& cage, const char* functional, BoundaryCondition condition,
                            int iterations = 200) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = 0;
  options.max_iterations = iterations;
  options.tolerance = 1e-8;
  Constraints constraints;
  constraints.boundary = BoundaryConditions{condition, {}};
  umbilic::Run run = *umbilic::Run::create(cage, options, constraints);
  while (!run.step(100)) {
  }
  Certificate certificate = *run.certify();
  while (!certificate.step()) {
  }
  const Result<CertificateReport> report = certificate.report();
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : CertificateReport();
}

Cage generated(const char* name, double radius, double height) {
  CageOptions options;
  options.radius = radius;
  options.height = height;
  options.major_segments = 16;
  options.minor_segments = 8;
  return *generate_cage(name, options);
}

/// Bending is the integral of 4 H^2 - 2 K: H vanishes, and the boundary fixes the integral of K.
TEST(OpenCertificate, finds_no_negative_direction_at_a_catenoid_for_bending) {
  const CertificateReport report = certified(generated("catenoid", 1, 1), "bending", BoundaryCondition::kTangent);
  EXPECT_EQ(report.negative, 0);
  EXPECT_EQ(report.gauge, 0) << "the boundary holds the surface in its place";
}

/// All Fourier modes of its second variation are positive.
TEST(OpenCertificate, finds_no_negative_direction_at_a_clamped_surface_of_revolution) {
  const CertificateReport report = certified(generated("cylinder", 1, 2), "willmore", BoundaryCondition::kTangent);
  EXPECT_EQ(report.negative, 0);
  EXPECT_EQ(report.gauge, 0);
}

/// At the cylinder that the cage is, which is not stationary.
TEST(OpenCertificate, counts_directions_only_among_those_that_the_boundary_leaves) {
  const Cage cage = generated("cylinder", 1, 2);
  const CertificateReport free = certified(cage, "willmore", BoundaryCondition::kFree, 0),
                          position = certified(cage, "willmore", BoundaryCondition::kPosition, 0),
                          tangent = certified(cage, "willmore", BoundaryCondition::kTangent, 0);
  // Each circle of 16 points holds 3 coordinates for C, and 3 more for D.
  EXPECT_EQ(free.unknowns - position.unknowns, 2 * 16 * 3);
  EXPECT_EQ(position.unknowns - tangent.unknowns, 2 * 16 * 3);
  EXPECT_EQ(free.gauge, 10) << "conformal maps";
  EXPECT_EQ(position.gauge, 0);
  // A subspace has no more negative directions; these lose some.
  EXPECT_GT(free.negative, position.negative);
  EXPECT_GT(position.negative, tangent.negative);
}

}  // namespace
}  // namespace umbilic::test
