// SPDX-License-Identifier: MIT
/// \file
/// Cages that a problem names: generated, read, or refused with the name that the user knows them by.
#include "problem/cage_of.h"

#include <gtest/gtest.h>

#include <string>

namespace umbilic {
namespace {

TEST(CageOf, a_generator_and_its_parameters_are_the_generated_cage) {
  const GeneratedCage input{"torus", {.ratio = 0.3, .major_segments = 5, .minor_segments = 4}};
  const Result<CheckedCage> cage = cage_of(input);
  ASSERT_TRUE(cage.ok()) << cage.error().message;
  EXPECT_EQ(cage->cage.vertices, generate_cage("torus", input.options)->vertices);
  EXPECT_EQ(cage->report.faces, 20);
  EXPECT_EQ(cage->report.genus, 1);
  EXPECT_EQ(cage_of(GeneratedCage{"torus", {.ratio = 2}}).error().message, "ratio 2 is not between 0 and 1");
}

TEST(CageOf, a_text_is_read_and_its_errors_begin_with_its_name_where_it_has_one) {
  const std::string tetrahedron = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
  EXPECT_EQ(cage_of(CageText{"", tetrahedron})->report.edges, 6);
  EXPECT_EQ(cage_of(CageText{"", ""}).error().message, "the file is empty");
  EXPECT_EQ(cage_of(CageText{"a.obj", ""}).error().message, "a.obj: the file is empty");
}

TEST(CageOf, a_path_is_left_to_the_command_line) {
  EXPECT_EQ(cage_of(CagePath{"a.obj"}).error().message,
            "cage.file: a.obj is not read here; only the command line opens files");
}

}  // namespace
}  // namespace umbilic
