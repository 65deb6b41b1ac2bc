// SPDX-License-Identifier: MIT
/// \file
/// Writing loses nothing.
#include "cage/write.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "cage/formats.h"
#include "cage/generate.h"
#include "cages.h"

namespace umbilic::test {

TEST(WriteObj, what_is_written_reads_back_to_the_same_bits) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Cage cage = cube_of_any_doubles(random);
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

TEST(WriteObj, holes_are_a_group_that_is_named_once) {
  const Cage cage = generate_cage("n-sided", {.major_segments = 2}).value();
  Cage back = cage_of(write_obj(cage));
  ASSERT_EQ(back.groups.size(), 1u);
  EXPECT_EQ(back.groups[0].name, kHoleGroup);
  EXPECT_EQ(back.groups[0].faces, cage.holes);
  back.holes = back.groups[0].faces;
  back.groups[0].name = "beyond";
  const Cage again = cage_of(write_obj(back));
  ASSERT_EQ(again.groups.size(), 1u);
  EXPECT_EQ(again.groups[0].name, "beyond");
}

TEST(WriteObj, holes_do_not_join_a_group_of_their_name) {
  Cage cage = generate_cage("n-sided", {.major_segments = 2}).value();
  cage.groups.push_back({std::string(kHoleGroup), {0, 1}});
  const Cage back = cage_of(write_obj(cage));
  ASSERT_EQ(back.groups.size(), 2u);
  for (const FaceGroup& group : back.groups) {
    EXPECT_EQ(group.faces, group.name == kHoleGroup ? cage.groups[0].faces : cage.holes) << group.name;
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

/// A mesh whose text takes several pieces.
struct LongMesh {
  Points positions = Points::Constant(5000, 3, 1.0 / 3);
  Points normals = Points::Constant(5000, 3, -1.0 / 3);
  std::vector<std::array<int, 4>> quads = std::vector<std::array<int, 4>>(5000, {4996, 4997, 4998, 4999});
};

TEST(WriteObj, the_pieces_of_a_mesh_are_its_text) {
  const LongMesh mesh;
  std::size_t longest = 0;
  int pieces = 0;
  std::string joined;
  EXPECT_TRUE(write_obj(mesh.positions, mesh.normals, mesh.quads, [&](std::string_view piece) {
    longest = std::max(longest, piece.size());
    ++pieces;
    joined.append(piece);
    return true;
  }));
  EXPECT_EQ(joined, write_obj(mesh.positions, mesh.normals, mesh.quads));
  EXPECT_EQ(std::count(joined.begin(), joined.end(), '\n'), 15000);
  EXPECT_GT(pieces, 5);
  EXPECT_LT(longest, std::size_t{1 << 16} + 200) << "a piece ends with the first line beyond its size";
}

TEST(WriteObj, a_sink_that_takes_no_more_is_given_no_more) {
  const LongMesh mesh;
  for (int most = 0; most < 5; ++most) {
    int given = 0;
    EXPECT_FALSE(
        write_obj(mesh.positions, mesh.normals, mesh.quads, [&](std::string_view) { return ++given <= most; }));
    EXPECT_EQ(given, most + 1);
  }
}

}  // namespace umbilic::test
