// SPDX-License-Identifier: MIT
/// \file
/// What moves of a surface while the equations of its boundary hold.
#include "driver/boundary_rows.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "driver/surface.h"
#include "mesh/boundary.h"
#include "mesh/hierarchy.h"
#include "mesh/open_cages.h"
#include "surface/limit_stencil.h"

namespace umbilic::test {
namespace {

Eigen::MatrixXd matrix_of(const std::vector<PointRow>& rows, int points) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), points);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < rows[row].points.size(); ++i) {
      matrix(static_cast<Eigen::Index>(row), rows[row].points[i]) += rows[row].weights[i];
    }
  }
  return matrix;
}

/// A random displacement that no row sees; its size is about 1.
Points free_displacement(const Eigen::MatrixXd& rows, int points) {
  std::mt19937 random(3);
  Eigen::MatrixXd wish(points, 3);
  for (double& x : wish.reshaped()) x = 2.0 * random() / std::mt19937::max() - 1;
  if (rows.rows() == 0) return wish;
  return wish - rows.completeOrthogonalDecomposition().solve(rows * wish);
}

/// Boundaries of every kind, convex and concave corners of holes among them.
std::map<std::string, Cage> cages() {
  std::map<std::string, Cage> all = holed_cages();
  all.merge(tame_open_cages());
  all.merge(wild_open_cages());
  all.emplace("sheet without its middle",
              with_holes(sheet(5, 5), {0, 1, 2, 3, 4, 5, 9, 10, 12, 14, 15, 19, 20, 21, 22, 23, 24}));
  all.emplace("cube without a corner", with_holes(cube(), {0, 2, 4}));
  return all;
}

using Displacements = testing::TestWithParam<BoundaryCondition>;

TEST_P(Displacements, that_the_equations_allow_leave_the_boundary_where_it_is) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{GetParam(), {}};
  for (const auto& [name, cage] : cages()) {
    SCOPED_TRACE(name);
    const Result<RefinedCage> prepared = prepare(cage, 1, false, constraints);
    if (!prepared) continue;  // curvature that the cage does not tell
    RefinedCage coarse = refine(*prepared, required_level(prepared->mesh).value());
    const Eigen::MatrixXd rows = matrix_of(boundary_rows(coarse.boundary, coarse.mesh), coarse.mesh.vertex_count());
    coarse.control = free_displacement(rows, coarse.mesh.vertex_count());
    const RefinedCage fine = refine(coarse, 2);
    std::vector<SurfacePlace> places;
    for (const std::vector<int>& loop : boundary_loops(fine.mesh)) {
      for (const int h : loop) {
        SurfacePlace place;
        place.vertex = fine.mesh.origin(h);
        places.push_back(place);
      }
    }
    double position = 0, slope = 0;
    for (const LimitStencil& stencil : limit_stencils(fine.mesh, places)) {
      const Eigen::Matrix3d moved = stencil.apply(fine.control);
      position = std::max(position, moved.col(0).cwiseAbs().maxCoeff());
      slope = std::max(slope, moved.rightCols(2).cwiseAbs().maxCoeff());
    }
    const Eigen::MatrixXd finer = matrix_of(boundary_rows(fine.boundary, fine.mesh), fine.mesh.vertex_count());
    const double residual = finer.rows() == 0 ? 0 : (finer * fine.control).cwiseAbs().maxCoeff();
    EXPECT_LE(residual, 1e-13) << "the equations mean the same on every level";
    if (GetParam() == BoundaryCondition::kFree) {
      EXPECT_GT(position, 1e-3);
    } else {
      EXPECT_LE(position, 1e-13);
    }
    if (GetParam() >= BoundaryCondition::kTangent) {
      EXPECT_LE(slope, 1e-13);
    }
  }
}

std::string name_of_condition(const testing::TestParamInfo<BoundaryCondition>& condition) {
  return std::string(name_of(condition.param));
}

INSTANTIATE_TEST_SUITE_P(At, Displacements,
                         testing::Values(BoundaryCondition::kFree, BoundaryCondition::kPosition,
                                         BoundaryCondition::kTangent, BoundaryCondition::kCurvature),
                         name_of_condition);

TEST(BoundaryRows, of_position_leave_the_slope_open) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{BoundaryCondition::kPosition, {}};
  // Concave corners, around a hole of one face.
  const RefinedCage coarse = *prepare(with_holes(sheet(7, 7), {24, 0,  1,  2,  3,  4,  5,  6,  7,  13, 14, 20, 21,
                                                               27, 28, 34, 35, 41, 42, 43, 44, 45, 46, 47, 48}),
                                      0, false, constraints);
  RefinedCage cage = refine(coarse, 1);
  const Eigen::MatrixXd position = matrix_of(boundary_rows(cage.boundary, cage.mesh), cage.mesh.vertex_count());
  cage.boundary.assign(cage.boundary.size(), BoundaryCondition::kTangent);
  const Eigen::MatrixXd tangent = matrix_of(boundary_rows(cage.boundary, cage.mesh), cage.mesh.vertex_count());
  const auto rank = [](const Eigen::MatrixXd& m) { return m.completeOrthogonalDecomposition().rank(); };
  EXPECT_LT(rank(position), rank(tangent));
  EXPECT_LT(rank(tangent), cage.mesh.vertex_count());
}

}  // namespace
}  // namespace umbilic::test
