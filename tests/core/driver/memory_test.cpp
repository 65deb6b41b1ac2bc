// SPDX-License-Identifier: MIT
/// \file
/// What is too large is refused before anything is allocated, with the size that would fit.
#include "driver/memory.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

umbilic::Run started(int level) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.first_level = options.last_level = level;
  return *umbilic::Run::create(*generate_cage("two-3"), options);
}

TEST(Memory, of_a_limit_mesh_is_what_its_arrays_take) {
  const Cage cage = *generate_cage("two-3");
  const PolygonMesh mesh(cage);
  for (const int density : {1, 2, 7}) {
    const LimitMesh limit = *started(0).limit_mesh(density);
    const double bytes =
        static_cast<double>(sizeof(double) * (limit.positions.size() + limit.normals.size() + limit.curvatures.size()) +
                            sizeof(int) * limit.positions.rows() + sizeof(limit.quads[0]) * limit.quads.size());
    EXPECT_EQ(limit_mesh_bytes(mesh, density), bytes);
  }
}

TEST(Memory, a_limit_mesh_that_is_too_large_is_refused_with_the_density_that_fits) {
  const umbilic::Run run = started(3);  // 1536 patches
  EXPECT_EQ(run.limit_mesh(0).error().message, "density 0: expected a number >= 1");
  EXPECT_EQ(run.limit_mesh(512).error().message, "density 512 would take 34 GB; at most 124 fits in 2 GB");
  EXPECT_EQ(run.limit_mesh(2'000'000'000).error().message,
            "density 2000000000 would take 5.2e+14 GB; at most 124 fits in 2 GB");
}

TEST(Memory, a_run_that_is_too_large_is_refused_with_the_level_that_fits) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.last_level = 8;
  options.symmetry = false;
  options.metric = MetricChoice::kHessian;
  EXPECT_EQ(umbilic::Run::create(*generate_cage("cube"), options).error().message,
            "level 8 would take 38 GB; at most level 7 fits in 16 GB");
  options.last_level = 2'000'000'000;
  EXPECT_NE(umbilic::Run::create(*generate_cage("cube"), options).error().message.find("at most 2000000 are possible"),
            std::string::npos);
}

TEST(Memory, grows_with_the_faces_and_with_what_the_metric_keeps_of_each_patch) {
  EXPECT_LT(run_bytes(1e5, 1e5, MetricChoice::kIdentity), run_bytes(1e5, 1e5, MetricChoice::kSobolev));
  EXPECT_LT(run_bytes(1e5, 1e5, MetricChoice::kSobolev), run_bytes(1e5, 1e5, MetricChoice::kHessian));
  EXPECT_LT(run_bytes(1e5, 1e4, MetricChoice::kHessian), run_bytes(1e5, 1e5, MetricChoice::kHessian));
  EXPECT_EQ(run_bytes(1e5, 1e5, MetricChoice::kAutomatic), run_bytes(1e5, 1e5, MetricChoice::kSobolev));
  EXPECT_EQ(run_bytes(1e3, 1e3, MetricChoice::kAutomatic), run_bytes(1e3, 1e3, MetricChoice::kHessian));
}

}  // namespace
}  // namespace umbilic
