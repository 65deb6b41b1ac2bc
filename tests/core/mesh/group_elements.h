// SPDX-License-Identifier: MIT
/// \file
/// All elements of a symmetry group, as products of its generators, and what makes each of them a symmetry.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "mesh/symmetry.h"

namespace umbilic::test {

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
  const std::set<int> images(map.halfedges.begin(), map.halfedges.end());
  ASSERT_EQ(static_cast<int>(images.size()), mesh.halfedge_count());
  ASSERT_EQ(*images.begin(), 0);
  ASSERT_EQ(*images.rbegin(), mesh.halfedge_count() - 1);
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const int image = map.halfedges[h];
    ASSERT_EQ(map.halfedges[mesh.twin(h)], mesh.twin(image));
    ASSERT_EQ(map.halfedges[mesh.next(h)], map.reverses ? mesh.previous(image) : mesh.next(image));
    ASSERT_EQ(mesh.face(image), image_of_face(mesh, map, mesh.face(h)));
    ASSERT_EQ(map.reverses ? mesh.target(image) : mesh.origin(image), image_of_vertex(mesh, map, mesh.origin(h)));
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
