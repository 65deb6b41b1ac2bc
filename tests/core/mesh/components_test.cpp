// SPDX-License-Identifier: MIT
/// \file
/// Components of unions of cages whose genera are known.
#include "mesh/components.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

Cage united(const std::vector<Cage>& parts) {
  Cage all;
  for (const Cage& part : parts) {
    const int offset = static_cast<int>(all.vertices.rows());
    Points vertices(offset + part.vertices.rows(), 3);
    vertices << all.vertices, part.vertices;
    all.vertices = vertices;
    for (std::vector<int> face : part.faces) {
      for (int& corner : face) corner += offset;
      all.faces.push_back(face);
    }
  }
  return all;
}

TEST(Components, have_the_genera_of_the_cages_that_were_united_at_every_level) {
  const Cage cage = united({cube(), *generate_cage("two-4"), tetrahedron(), *generate_cage("torus")});
  for (int steps = 0; steps < 3; ++steps) {
    const Refined finer = refined(cage, steps);
    const MeshComponents components = find_components(finer.mesh);
    EXPECT_EQ(components.genera, (std::vector{0, 3, 0, 1}));
    // The first vertices of a refined mesh are those of the coarser one.
    EXPECT_EQ(components.of_vertex[0], 0);
    EXPECT_EQ(components.of_vertex[7], 0);
    EXPECT_EQ(components.of_vertex[8], 1);
  }
}

TEST(Components, are_one_where_all_is_connected) {
  for (const char* name : {"two-3", "dodecahedron-frame", "torus"}) {
    const MeshComponents components = find_components(PolygonMesh(*generate_cage(name)));
    EXPECT_EQ(components.genera.size(), 1u);
    for (const int component : components.of_vertex) EXPECT_EQ(component, 0);
  }
}

}  // namespace
}  // namespace umbilic::test
