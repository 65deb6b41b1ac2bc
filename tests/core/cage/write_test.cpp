// SPDX-License-Identifier: MIT
/// \file
/// Writing loses nothing.
#include "cage/write.h"

#include <cmath>
#include <cstring>
#include <random>

#include "cage/formats.h"
#include "cage/generate.h"
#include "cages.h"

namespace umbilic::test {

TEST(WriteObj, what_is_written_reads_back_to_the_same_bits) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    Cage cage = generate_cage("cube").value();
    for (double& x : cage.vertices.reshaped()) {
      std::uint64_t bits = random();
      std::memcpy(&x, &bits, sizeof x);
      if (!std::isfinite(x)) x = -0.0;
    }
    const Cage back = parse_obj(write_obj(cage)).value().cage;
    EXPECT_EQ(back.faces, cage.faces);
    ASSERT_EQ(back.vertices.size(), cage.vertices.size());
    EXPECT_EQ(std::memcmp(back.vertices.data(), cage.vertices.data(), sizeof(double) * 24), 0);
  }
}

TEST(WriteObj, every_generated_cage_reads_back_to_the_same_cage) {
  for (const CageName& name : cage_names()) {
    const Cage cage = generate_cage(name.name).value();
    const Cage back = cage_of(write_obj(cage));
    EXPECT_EQ(back.vertices, cage.vertices) << name.name;
    EXPECT_EQ(back.faces, cage.faces) << name.name;
  }
}

TEST(WriteObj, decimals_are_the_shortest_that_do) {
  Cage cage = cage_of(tetrahedron_obj());
  cage.vertices(0, 0) = 0.1;
  cage.vertices(0, 1) = 1e300;
  EXPECT_EQ(write_obj(cage).substr(0, 16), "v 0.1 1e+300 1\nv");
}

TEST(WriteObj, normals_stand_beside_the_vertices_that_they_belong_to) {
  Points positions(4, 3);
  positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  Points normals(4, 3);
  normals << 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0;
  EXPECT_EQ(write_obj(positions, normals, {{0, 1, 2, 3}}),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//2 3//3 4//4\n");
}

}  // namespace umbilic::test
