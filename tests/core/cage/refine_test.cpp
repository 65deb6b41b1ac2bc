// SPDX-License-Identifier: MIT
/// \file
/// One Catmull-Clark step of open cages.
#include "cage/refine.h"

#include <gtest/gtest.h>

#include "cage/generate.h"

namespace umbilic::test {
namespace {

/// m x n quads over a bent sheet; the vertex (i, j) is j (m + 1) + i.
Cage sheet(int m, int n) {
  Cage cage;
  cage.vertices.resize((m + 1) * (n + 1), 3);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= m; ++i)
      cage.vertices.row(j * (m + 1) + i) << i, j + 0.1 * i * i, 0.3 * i * j * j - 0.2 * i * i;
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      const int v = j * (m + 1) + i;
      cage.faces.push_back({v, v + 1, v + m + 2, v + m + 1});
    }
  }
  return cage;
}

/// Where the sheet's points at (i, j) / 2 go by the refinement of cubic splines in each direction, whose ends stay.
Vector3 spline_point(const Cage& cage, int m, int n, int i, int j) {
  const auto weights = [](int k, int last) {
    std::vector<std::pair<int, double>> w;
    if (k % 2 == 1) return std::vector<std::pair<int, double>>{{k / 2, 0.5}, {k / 2 + 1, 0.5}};
    if (k == 0 || k == 2 * last) return std::vector<std::pair<int, double>>{{k / 2, 1.}};
    return std::vector<std::pair<int, double>>{{k / 2 - 1, 0.125}, {k / 2, 0.75}, {k / 2 + 1, 0.125}};
  };
  Vector3 sum = Vector3::Zero();
  for (const auto& [a, x] : weights(i, m)) {
    for (const auto& [b, y] : weights(j, n)) sum += x * y * cage.vertices.row(b * (m + 1) + a);
  }
  return sum;
}

TEST(Refined, sheet_is_the_tensor_product_of_refined_splines_up_to_its_corners) {
  for (const auto& [m, n] : {std::pair(1, 1), std::pair(1, 3), std::pair(4, 3)}) {
    const Cage cage = sheet(m, n), fine = refined(cage);
    ASSERT_EQ(fine.vertices.rows(), (2 * m + 1) * (2 * n + 1));
    ASSERT_EQ(fine.faces.size(), 4 * cage.faces.size());
    for (int j = 0; j <= 2 * n; ++j) {
      for (int i = 0; i <= 2 * m; ++i) {
        const Vector3 expected = spline_point(cage, m, n, i, j);
        const double nearest = (fine.vertices.rowwise() - expected.transpose()).rowwise().norm().minCoeff();
        EXPECT_LT(nearest, 1e-14) << m << " x " << n << ": " << i << ", " << j;
      }
    }
    // The quad at a face's corner begins with the vertex, which keeps its number.
    for (std::size_t f = 0; f < cage.faces.size(); ++f) {
      for (int i = 0; i < 4; ++i) EXPECT_EQ(fine.faces[4 * f + i][0], cage.faces[f][i]);
    }
  }
}

TEST(Refined, cage_passes_holes_and_groups_on_and_stays_valid) {
  Cage cage = sheet(2, 2);
  cage.holes = {1, 3};
  cage.groups = {{"left", {0, 2}}};
  Cage fine = refined(cage);
  EXPECT_EQ(fine.holes, (std::vector<int>{4, 5, 6, 7, 12, 13, 14, 15}));
  EXPECT_EQ(fine.groups[0].faces, (std::vector<int>{0, 1, 2, 3, 8, 9, 10, 11}));
  Cage closed = refined(*generate_cage("two-3", {.family = FrameFamily::kHub}));
  EXPECT_EQ(validate(closed)->genus, 2);
  EXPECT_TRUE(validate(closed)->repairs.empty());
}

TEST(Refined, vertex_of_valence_n_moves_as_catmull_and_clark_say) {
  const Cage cube = *generate_cage("cube");  // (Q + 2 R) / 3 with Q = V / 3 and R = 2 V / 3
  const Cage fine = refined(cube);
  for (int v = 0; v < 8; ++v) EXPECT_LT((fine.vertices.row(v) - 5. / 9 * cube.vertices.row(v)).norm(), 1e-15);
}

}  // namespace
}  // namespace umbilic::test
