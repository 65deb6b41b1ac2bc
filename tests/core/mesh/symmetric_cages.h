// SPDX-License-Identifier: MIT
/// \file
/// Cages of any point group: a cage of higher symmetry, distorted at random but alike under the group's elements.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "cage/generate.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {

using Matrix3 = Eigen::Matrix3d;

inline Matrix3 rotation(double turns, const Vector3& axis) {
  return Eigen::AngleAxisd(2 * std::numbers::pi * turns, axis.normalized()).matrix();
}

inline Matrix3 reflection(const Vector3& normal) {
  const Vector3 n = normal.normalized();
  return Matrix3::Identity() - 2 * n * n.transpose();
}

/// The finite group that `generators` generate.
inline std::vector<Matrix3> closure(const std::vector<Matrix3>& generators) {
  std::vector<Matrix3> elements{Matrix3::Identity()};
  for (std::size_t i = 0; i < elements.size() && elements.size() < 1000; ++i) {
    for (const Matrix3& generator : generators) {
      const Matrix3 next = generator * elements[i];
      const bool known =
          std::any_of(elements.begin(), elements.end(), [&](const Matrix3& m) { return (m - next).norm() < 1e-9; });
      if (!known) elements.push_back(next);
    }
  }
  return elements;
}

enum class Supergroup { kPrismatic, kOctahedral, kIcosahedral };

struct PointGroup {
  std::string name;
  int order;
  std::vector<Matrix3> generators;
  Supergroup supergroup;
  int fold;  ///< prismatic: of the main axis
};

/// Each finite group of isometries, those about one axis for a fold of at most 6.
inline std::vector<PointGroup> point_groups() {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ(), diagonal(1, 1, 1);
  const Vector3 fivefold(0, 1, (1 + std::sqrt(5.)) / 2);
  const Matrix3 half_turn = rotation(0.5, x), third = rotation(1. / 3, diagonal), inversion = -Matrix3::Identity();
  std::vector<PointGroup> groups{{"C1", 1, {}, Supergroup::kPrismatic, 2},
                                 {"Ci", 2, {inversion}, Supergroup::kPrismatic, 2},
                                 {"Cs", 2, {reflection(z)}, Supergroup::kPrismatic, 2}};
  for (int n = 2; n <= 6; ++n) {
    const Matrix3 turn = rotation(1. / n, z), turn_and_reflect = rotation(0.5 / n, z) * reflection(z);
    const auto add = [&](const char* name, int number, int order, const std::vector<Matrix3>& generators) {
      groups.push_back({fmt::format(fmt::runtime(name), number), order, generators, Supergroup::kPrismatic, n});
    };
    add("C{}", n, n, {turn});
    add("C{}v", n, 2 * n, {turn, reflection(y)});
    add("C{}h", n, 2 * n, {turn, reflection(z)});
    add("S{}", 2 * n, 2 * n, {turn_and_reflect});
    add("D{}", n, 2 * n, {turn, half_turn});
    add("D{}h", n, 4 * n, {turn, half_turn, reflection(z)});
    add("D{}d", n, 4 * n, {turn_and_reflect, half_turn});
  }
  const Supergroup cubic = Supergroup::kOctahedral, icosahedral = Supergroup::kIcosahedral;
  groups.push_back({"T", 12, {third, rotation(0.5, z)}, cubic, 0});
  groups.push_back({"Td", 24, {third, rotation(0.5, z), reflection({1, -1, 0})}, cubic, 0});
  groups.push_back({"Th", 24, {third, rotation(0.5, z), inversion}, cubic, 0});
  groups.push_back({"O", 24, {third, rotation(0.25, z)}, cubic, 0});
  groups.push_back({"Oh", 48, {third, rotation(0.25, z), inversion}, cubic, 0});
  groups.push_back({"I", 60, {third, rotation(0.2, fivefold)}, icosahedral, 0});
  groups.push_back({"Ih", 120, {third, rotation(0.2, fivefold), inversion}, icosahedral, 0});
  return groups;
}

inline Cage cage_of(const Refined& refined) {
  Cage cage{refined.control, {}};
  for (int f = 0; f < refined.mesh.face_count(); ++f) {
    cage.faces.emplace_back();
    for (int i = 0; i < refined.mesh.face_size(f); ++i) {
      cage.faces.back().push_back(refined.mesh.origin(refined.mesh.halfedge(f, i)));
    }
  }
  return cage;
}

/// A cage whose symmetry group is `group`: its vertices are moved from those of a more symmetric cage by a random
/// field, averaged over the group.
inline Cage distorted(const PointGroup& group) {
  Cage cage;
  switch (group.supergroup) {
    case Supergroup::kPrismatic: cage = cage_of(refined(prism(2 * group.fold), 2)); break;
    case Supergroup::kOctahedral: cage = cage_of(refined(cube(), 2)); break;
    case Supergroup::kIcosahedral: cage = generate_cage("dodecahedron-frame").value(); break;
  }
  const Points field = Random(1).points(cage.vertices.rows());
  const std::vector<Matrix3> elements = closure(group.generators);
  Points mean = Points::Zero(field.rows(), 3);
  for (const Matrix3& g : elements) {
    const Points moved = cage.vertices * g.transpose();
    for (Eigen::Index v = 0; v < moved.rows(); ++v) {
      Eigen::Index image = 0;
      (cage.vertices.rowwise() - moved.row(v)).rowwise().squaredNorm().minCoeff(&image);
      mean.row(v) += field.row(image) * g;
    }
  }
  cage.vertices += 0.05 * mean / std::sqrt(static_cast<double>(elements.size()));
  return cage;
}

/// The same, made once.
inline const Cage& cage_with(const PointGroup& group) {
  static std::map<std::string, Cage> cages;
  const auto known = cages.find(group.name);
  return known != cages.end() ? known->second : cages.emplace(group.name, distorted(group)).first->second;
}

/// The cages side by side as components of one.
inline Cage together(const std::vector<Cage>& cages) {
  Cage all;
  for (const Cage& cage : cages) {
    const int first = static_cast<int>(all.vertices.rows());
    all.vertices.conservativeResize(first + cage.vertices.rows(), 3);
    all.vertices.bottomRows(cage.vertices.rows()) = cage.vertices;
    for (std::vector<int> face : cage.faces) {
      for (int& v : face) v += first;
      all.faces.push_back(face);
    }
  }
  return all;
}

/// The image under x -> linear x + shift, with its faces turned outward again where `linear` reverses.
inline Cage transformed(Cage cage, const Matrix3& linear, const Vector3& shift = Vector3::Zero()) {
  cage.vertices = ((cage.vertices * linear.transpose()).rowwise() + shift.transpose()).eval();
  if (linear.determinant() < 0) {
    for (std::vector<int>& face : cage.faces) std::reverse(face.begin(), face.end());
  }
  return cage;
}

}  // namespace umbilic::test
