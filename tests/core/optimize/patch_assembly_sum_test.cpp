// SPDX-License-Identifier: MIT
/// \file
/// Assembled matrices against dense sums of the patches' matrices, whatever the patches' points depend on.
#include <gtest/gtest.h>

#include <limits>

#include "cage/generate.h"
#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "optimize/dense_assembly.h"
#include "optimize/patch_assembly.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

/// A mesh with coordinates of its points, of which every patch is evaluated or one for each orbit.
struct Case {
  std::string name;
  PolygonMesh mesh;
  Coordinates coordinates;
  PatchLayout layout;
};

Case free_case(const std::string& name, const Refined& refined, CapKind cap) {
  return {name, refined.mesh, Coordinates(refined.mesh.vertex_count()), PatchLayout(refined.mesh, cap)};
}

Case symmetric_case(const std::string& name, const Cage& cage, int level, CapKind cap) {
  PolygonMesh mesh(cage);
  SymmetryGroup group = find_symmetry(mesh, cage.vertices);
  for (int i = 0; i < level; ++i) {
    group = umbilic::refined(group, mesh);
    mesh = catmull_clark(mesh).mesh;
  }
  return {name, mesh, Coordinates(mesh, group), PatchLayout(mesh, cap, face_orbits(mesh, group))};
}

std::vector<Case> cases() {
  const Cage small_torus = *generate_cage("torus", {.major_segments = 3, .minor_segments = 3});
  std::vector<Case> all;
  // The 16 points of a patch are 9: some are met twice, and some four times.
  all.push_back(free_case("torus of 3 x 3 quads", refined(small_torus, 0), CapKind::kSmooth));
  all.push_back(free_case("torus of 6 x 6 quads", refined(small_torus, 1), CapKind::kSmooth));
  all.push_back(symmetric_case("symmetric torus of 3 x 3 quads", small_torus, 0, CapKind::kSmooth));
  for (const CapKind cap : kAllCaps) {
    all.push_back(free_case("trapezohedron", refined(trapezohedron(5), 1), cap));
    all.push_back(symmetric_case("symmetric trapezohedron", trapezohedron(5), 2, cap));
  }
  // Patches of one cap meet the points of a net around a corner twice.
  all.push_back(free_case("cube, rings that overlap", refined(cube(), 1), CapKind::kSmooth));
  all.push_back(free_case("cube, two rings", refined(cube(), 2), CapKind::kSmooth));
  all.push_back(symmetric_case("symmetric cube", cube(), 2, CapKind::kSmooth));
  all.push_back(symmetric_case("symmetric cube, four rings", cube(), 3, CapKind::kSmooth));
  return all;
}

/// Entries that must not be read are not finite.
constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();

TEST(PatchAssembly, of_blocks_is_the_sum_of_the_patches_matrices_times_their_multiplicities) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Eigen::MatrixXd b(c.coordinates.matrix()), points = all_points(c.layout, 3, b);
    const PatchAssembly assembly(c.layout, c.coordinates);
    PatchSums sums;
    assembly.clear(sums);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(b.cols(), b.cols());
    Random random(3);
    for_each_patch(c.layout, [&](int s, int p) {
      const PatchSet& set = c.layout.sets()[s];
      const int columns = set.columns, padded = columns + 3;
      const Eigen::MatrixXd any = random.matrix<Eigen::MatrixXd>(3 * columns, 3 * columns);
      const Eigen::MatrixXd block = any + any.transpose();
      std::vector<double> given(static_cast<std::size_t>(9) * padded * padded, kUnread);
      for (int e = 0; e < 3; ++e) {
        for (int f = 0; f <= e; ++f) {
          for (int i = 0; i < columns; ++i) {
            for (int j = 0; j < (e == f ? i + 1 : columns); ++j) {
              given[(e * padded + i) * 3 * padded + f * padded + j] = block(e * columns + i, f * columns + j);
            }
          }
        }
      }
      PatchTerms terms;
      assembly.terms(s, p, given.data(), padded, terms);
      assembly.add(s, p, terms, sums);
      expected += set.multiplicities[p] * congruent(block, patch_points(c.layout, 3, points, s, p));
    });
    assembly.eliminate(sums);
    ASSERT_EQ(assembly.size(), c.coordinates.count());
    EXPECT_LT((full(assembly.lower(sums.values)) - expected).norm(), 1e-13 * expected.norm());
  }
}

TEST(PatchAssembly, of_scalar_blocks_is_that_of_the_same_block_for_each_coordinate) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Eigen::MatrixXd b(c.coordinates.matrix());
    const PatchAssembly assembly(c.layout, c.coordinates),
        scalar(c.layout, Coordinates(c.layout.control_count()), true);
    PatchSums sums, scalar_sums;
    assembly.clear(sums);
    scalar.clear(scalar_sums);
    const int count = c.layout.control_count();
    const Eigen::MatrixXd points = all_points(c.layout, 1, Eigen::MatrixXd::Identity(count, count));
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(count, count);
    Random random(4);
    for_each_patch(c.layout, [&](int s, int p) {
      const PatchSet& set = c.layout.sets()[s];
      Eigen::MatrixXd block = random.matrix<Eigen::MatrixXd>(set.columns, set.columns);
      block = (block + block.transpose()).eval();
      expected += set.multiplicities[p] * congruent(block, patch_points(c.layout, 1, points, s, p));
      block.triangularView<Eigen::StrictlyUpper>().setConstant(kUnread);
      PatchTerms terms;
      assembly.scalar_terms(s, p, block, terms);
      assembly.add(s, p, terms, sums);
      scalar.scalar_terms(s, p, block, terms);
      scalar.add(s, p, terms, scalar_sums);
    });
    assembly.eliminate(sums);
    scalar.eliminate(scalar_sums);
    EXPECT_LT((full(scalar.lower(scalar_sums.values)) - expected).norm(), 1e-13 * expected.norm());
    Eigen::MatrixXd three = Eigen::MatrixXd::Zero(3 * count, 3 * count);
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) three.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(expected(i, j));
    }
    const Eigen::MatrixXd reduced = congruent(three, b);
    EXPECT_LT((full(assembly.lower(sums.values)) - reduced).norm(), 1e-13 * reduced.norm());
  }
}

TEST(PatchAssembly, adds_to_the_values_and_its_pattern_holds_each_entry_of_the_lower_triangle_once_in_order) {
  for (const Case& c : cases()) {
    const PatchAssembly assembly(c.layout, c.coordinates);
    const std::vector<double> values(assembly.nonzeros(), 1.0);
    const Eigen::SparseMatrix<double> ones = assembly.lower(values);
    for (int column = 0; column < ones.outerSize(); ++column) {
      int previous = column - 1;
      for (Eigen::SparseMatrix<double>::InnerIterator it(ones, column); it; ++it) {
        if (previous < column) {
          EXPECT_EQ(it.row(), column) << "the diagonal comes first";
        }
        EXPECT_GT(it.row(), previous);
        previous = static_cast<int>(it.row());
      }
      EXPECT_GE(previous, column) << "no column is empty";
    }
    const int columns = c.layout.sets()[0].columns;
    const std::vector<double> zero(static_cast<std::size_t>(9) * columns * columns, 0.0);
    PatchSums sums;
    assembly.clear(sums);
    sums.values = values;
    PatchTerms terms;
    assembly.terms(0, 0, zero.data(), columns, terms);
    assembly.add(0, 0, terms, sums);
    assembly.eliminate(sums);
    EXPECT_EQ(sums.values, values);
  }
}

TEST(PatchCursor, visits_each_patch_once_whatever_the_budget) {
  const PatchLayout layout(refined(trapezohedron(5), 2).mesh, CapKind::kSmooth);
  std::vector<std::pair<int, int>> expected;
  for_each_patch(layout, [&](int s, int p) { expected.emplace_back(s, p); });
  for (const int budget : {1, 7, 100, 1'000'000}) {
    std::vector<std::pair<int, int>> visited;
    PatchCursor cursor;
    int parts = 0;
    for (; !cursor.ended(layout); ++parts) {
      for (const auto [set, patch] : cursor.advance(layout, budget, [](int) { return 3; })) {
        visited.emplace_back(set, patch);
      }
    }
    EXPECT_EQ(visited, expected);
    const int per_part = (budget + 2) / 3, patches = static_cast<int>(expected.size());
    EXPECT_EQ(parts, (patches + per_part - 1) / per_part);
  }
}

}  // namespace
}  // namespace umbilic::test
