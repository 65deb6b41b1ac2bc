// SPDX-License-Identifier: MIT
/// \file
/// Frames have the full symmetry of the graph that they are drawn on.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "cage/generate.h"
#include "cages.h"

namespace umbilic::test {

namespace {

using Matrix = Eigen::Matrix3d;

using std::numbers::pi;

Matrix rotation(double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis.normalized()).matrix(); }
Matrix reflection(const Vector3& normal) {
  const Vector3 n = normal.normalized();
  return Matrix::Identity() - 2 * n * n.transpose();
}

/// The finite group that `generators` generate.
std::vector<Matrix> group(const std::vector<Matrix>& generators) {
  std::vector<Matrix> elements{Matrix::Identity()};
  for (std::size_t i = 0; i < elements.size() && elements.size() < 1000; ++i) {
    for (const Matrix& generator : generators) {
      const Matrix next = generator * elements[i];
      const bool known =
          std::any_of(elements.begin(), elements.end(), [&](const Matrix& m) { return (m - next).norm() < 1e-9; });
      if (!known) elements.push_back(next);
    }
  }
  return elements;
}

/// Prismatic group of order 4n about the z axis, with a twofold axis along x.
std::vector<Matrix> dihedral(int n) {
  return group({rotation(2 * pi / n, Vector3::UnitZ()), reflection(Vector3::UnitZ()), reflection(Vector3::UnitY())});
}

std::vector<Matrix> tetrahedral() {
  return group({rotation(2 * pi / 3, {1, 1, 1}), reflection({1, -1, 0}), reflection({1, 1, 0})});
}

std::vector<Matrix> octahedral() {
  return group({rotation(2 * pi / 3, {1, 1, 1}), rotation(pi / 2, Vector3::UnitZ()), reflection(Vector3::UnitX())});
}

std::vector<Matrix> icosahedral() {
  const double phi = (1 + std::sqrt(5.)) / 2;
  return group({rotation(2 * pi / 3, {1, 1, 1}), rotation(2 * pi / 5, {0, 1, phi}), reflection(Vector3::UnitX())});
}

/// Each face as the set of its vertices, renamed by `renaming`.
std::set<std::set<int>> face_sets(const Cage& cage, const std::vector<int>& renaming) {
  std::set<std::set<int>> faces;
  for (const std::vector<int>& face : cage.faces) {
    std::set<int> renamed;
    for (const int v : face) renamed.insert(renaming[v]);
    faces.insert(renamed);
  }
  return faces;
}

/// Every element maps vertices onto vertices to round-off, and faces onto faces.
void expect_symmetric(const std::string& name, const std::vector<Matrix>& symmetries, std::size_t order) {
  ASSERT_EQ(symmetries.size(), order) << name;
  for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
    CageOptions options;
    options.family = family;
    options.thickness = 1.2;
    options.spread = 1.3;
    const Cage cage = generate_cage(name, options).value();
    std::vector<int> image(cage.vertices.rows());
    for (std::size_t v = 0; v < image.size(); ++v) image[v] = static_cast<int>(v);
    const std::set<std::set<int>> faces = face_sets(cage, image);
    for (const Matrix& g : symmetries) {
      const Points moved = cage.vertices * g.transpose();
      for (Eigen::Index v = 0; v < moved.rows(); ++v) {
        Eigen::Index nearest = 0;
        const double distance = (cage.vertices.rowwise() - moved.row(v)).rowwise().norm().minCoeff(&nearest);
        ASSERT_LT(distance, 1e-12) << name;
        image[v] = static_cast<int>(nearest);
      }
      ASSERT_EQ(face_sets(cage, image), faces) << name;
    }
  }
}

}  // namespace

TEST(FrameSymmetry, two_junctions_with_n_arms_have_the_symmetry_of_the_n_prism) {
  for (int arms = 3; arms <= 12; ++arms) {
    expect_symmetric("two-" + std::to_string(arms), dihedral(arms), static_cast<std::size_t>(4 * arms));
  }
}

TEST(FrameSymmetry, tetrahedron_and_truncated_tetrahedron_have_the_24_symmetries_of_the_tetrahedron) {
  expect_symmetric("tetrahedron-frame", tetrahedral(), 24);
  expect_symmetric("truncated-tetrahedron-frame", tetrahedral(), 24);
}

TEST(FrameSymmetry, cube_and_octahedron_have_the_48_symmetries_of_the_cube) {
  expect_symmetric("cube-frame", octahedral(), 48);
  expect_symmetric("octahedron-frame", octahedral(), 48);
}

TEST(FrameSymmetry, the_dodecahedron_has_120_symmetries) { expect_symmetric("dodecahedron-frame", icosahedral(), 120); }

TEST(FrameSymmetry, the_hexagonal_prism_has_24_symmetries) {
  expect_symmetric("hexagonal-prism-frame", dihedral(6), 24);
}

}  // namespace umbilic::test
