// SPDX-License-Identifier: MIT
/// \file
/// All elements of a symmetry group, as products of its generators, and what makes each of them a symmetry.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh/symmetry.h"

namespace umbilic::test {

inline SymmetryGroup symmetry_of(const Cage& cage) { return find_symmetry(PolygonMesh(cage), cage.vertices); }

inline Symmetry product(const Symmetry& a, const Symmetry& b) {
  Symmetry result{a.isometry * b.isometry, {a.map.reverses != b.map.reverses, b.map.halfedges}};
  for (int& h : result.map.halfedges) h = a.map.halfedges[h];
  return result;
}

/// Elements are told apart by their maps.
inline std::vector<Symmetry> all_elements(const SymmetryGroup& group, const PolygonMesh& mesh) {
  Symmetry identity{Eigen::Matrix3d::Identity(), {}};
  for (int h = 0; h < mesh.halfedge_count(); ++h) identity.map.halfedges.push_back(h);
  std::vector<Symmetry> elements{identity};
  std::set<std::pair<bool, std::vector<int>>> known{{false, identity.map.halfedges}};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const Symmetry& generator : group.generators) {
      Symmetry next = product(generator, elements[i]);
      if (known.insert({next.map.reverses, next.map.halfedges}).second) elements.push_back(std::move(next));
    }
  }
  return elements;
}

/// The map is a relabelling that keeps faces, edges and, up to its sense, the order around each face.
inline void expect_automorphism(const PolygonMesh& mesh, const Automorphism& map) {
  ASSERT_EQ(static_cast<int>(map.halfedges.size()), mesh.halfedge_count());
  std::vector<bool> taken(map.halfedges.size(), false);
  for (const int image : map.halfedges) {
    ASSERT_FALSE(taken.at(image));
    taken[image] = true;
  }
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const int image = map.halfedges[h];
    ASSERT_EQ(map.halfedges[mesh.twin(h)], mesh.twin(image));
    ASSERT_EQ(map.halfedges[mesh.next(h)], map.reverses ? mesh.previous(image) : mesh.next(image));
    ASSERT_EQ(mesh.face(image), image_of_face(mesh, map, mesh.face(h)));
    ASSERT_EQ(map.reverses ? mesh.target(image) : mesh.origin(image), image_of_vertex(mesh, map, mesh.origin(h)));
  }
}

/// Products of the isometries depend only on the element, and are orthogonal, to the rounding of words of a few
/// letters.
inline void expect_exact(const PolygonMesh& mesh, const SymmetryGroup& group) {
  const std::vector<Symmetry> elements = all_elements(group, mesh);
  ASSERT_EQ(static_cast<int>(elements.size()), group.order);
  std::map<std::pair<bool, int>, Eigen::Matrix3d> isometries;  // an element is known by the image of a half-edge
  for (const Symmetry& element : elements) {
    isometries[{element.map.reverses, element.map.halfedges[0]}] = element.isometry;
  }
  ASSERT_EQ(isometries.size(), elements.size());
  for (const Symmetry& g : group.generators) {
    EXPECT_LT((g.isometry * g.isometry.transpose() - Eigen::Matrix3d::Identity()).norm(), 3e-15);
    for (const Symmetry& h : elements) {
      const std::pair<bool, int> product{g.map.reverses != h.map.reverses, g.map.halfedges[h.map.halfedges[0]]};
      EXPECT_LT((isometries.at(product) - g.isometry * h.isometry).norm(), 2e-14);
    }
  }
}

/// Largest distance between the image of a point and the point of the image.
inline double error_of(const PolygonMesh& mesh, const Points& points, const Vector3& center, const Symmetry& symmetry) {
  double largest = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vector3 from = points.row(v).transpose() - center;
    const Vector3 to = points.row(image_of_vertex(mesh, symmetry.map, v)).transpose() - center;
    largest = std::max(largest, (symmetry.isometry * from - to).norm());
  }
  return largest;
}

}  // namespace umbilic::test
