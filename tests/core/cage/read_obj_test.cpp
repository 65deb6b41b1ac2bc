// SPDX-License-Identifier: MIT
/// \file
/// OBJ texts as programs write them, and as they should not be.
#include <clocale>
#include <limits>
#include <locale>

#include "cage/write.h"
#include "cages.h"

namespace umbilic::test {

TEST(ReadObj, a_tetrahedron_keeps_its_vertices_in_order) {
  const Cage cage = cage_of(tetrahedron_obj());
  ASSERT_EQ(cage.vertices.rows(), 4);
  EXPECT_EQ(cage.vertices.row(1), Eigen::RowVector3d(1, -1, -1));
  EXPECT_EQ(cage.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}));
}

TEST(ReadObj, texture_and_normal_indices_are_ignored_in_every_form) {
  const std::string vertices(kTetrahedronVertices);
  expect_tetrahedron(vertices +
                     "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1/1/1 4/1/1 2/1/1\nf 2/ 4/-1 3/1/\n");
}

TEST(ReadObj, negative_indices_count_back_from_the_line_they_stand_on) {
  expect_tetrahedron("v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nf -3 -2 -1\nv -1 -1 1\nf -4 -2 -1\nf -4/-9 -1 -3\nf 2 4 3\n");
}

TEST(ReadObj, faces_may_stand_before_their_vertices) {
  expect_tetrahedron(std::string(kTetrahedronFaces) + std::string(kTetrahedronVertices));
}

TEST(ReadObj, every_line_end_and_a_byte_order_mark_are_accepted) {
  for (const std::string_view end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : tetrahedron_obj()) c == '\n' ? text += end : text += c;
    expect_tetrahedron(text);
    text.resize(text.size() - end.size());
    expect_tetrahedron(text);
  }
}

TEST(ReadObj, a_carriage_return_ends_a_line_in_the_count_too) {
  EXPECT_EQ(error_of("# a\r# b\rv 1 2\r"), "line 3: vertex 1 has 2 coordinates instead of 3");
  EXPECT_EQ(error_of("# a\r\n# b\r\nv 1 2\r\n"), "line 3: vertex 1 has 2 coordinates instead of 3");
}

TEST(ReadObj, comments_groups_materials_and_blank_space_say_nothing) {
  expect_tetrahedron(
      "# made by hand \\\n\nmtllib a.mtl\no thing\ng one two\ns 1\n  v 1 1 1 # first\n\tv\t1 -1 -1\nv -1 1 -1   \nv -1 "
      "-1 1\nusemtl x\n"
      "f 1 2 3#tail\nl 1 2\np 1\nvp 0.5\nf  1  3  4 \ncstype bezier\nf 1 4 2\nf 2 4 3\nend\n");
}

TEST(ReadObj, a_backslash_continues_a_line) {
  expect_tetrahedron(
      "v 1 1 \\\n1\nv 1 -1 -1\nv -1\\\n1 -1\nv -1 -1 1\nf 1 2 \\\r\n3\nf 1 3 4\nf 1 \\\n\\\n4 2\nf 2 4 3\\");
}

TEST(ReadObj, an_error_in_a_continued_line_is_counted_from_where_it_begins) {
  EXPECT_EQ(error_of("v 1 1 \\\n\\\nx\nv 1 2 3\n"), "line 1: coordinate 'x' of vertex 1 is not a number");
  EXPECT_EQ(error_of("v 1 1 \\\n\\\n1\nv 1 2 x\n"), "line 4: coordinate 'x' of vertex 2 is not a number");
}

TEST(ReadObj, weights_and_colours_behind_a_vertex_are_ignored_and_that_is_said) {
  const std::string faces(kTetrahedronFaces);
  const auto notes = [](std::string_view text) { return read_checked_cage(text).value().report.notes; };
  const std::string weights = "v 1 1 1 1\nv 1 -1 -1 0.5\nv -1 1 -1 1.0\nv -1 -1 1\n" + faces;
  expect_tetrahedron(weights);  // the weight of a rational surface's point does not move it
  EXPECT_EQ(notes(weights),
            std::vector<std::string>{"ignored the weights of 1 vertex (on line 2): polygons have no use for them"});
  const std::string colours = "v 1 1 1\nv 1 -1 -1 0.5 0.5 0.5\nv -1 1 -1 1 0 0 1\nv -1 -1 1 0 0 0\n" + faces;
  expect_tetrahedron(colours);
  EXPECT_EQ(notes(colours), std::vector<std::string>{"ignored the colours of 3 vertices (the first on line 2)"});
  EXPECT_EQ(notes("v 1 1 1 1\nv 1 -1 -1 1\nv -1 1 -1 1\nv -1 -1 1 1\n" + faces), std::vector<std::string>{});
}

TEST(ReadObj, other_words_behind_a_vertex_are_refused) {
  EXPECT_EQ(error_of("v 1 1 1\nv 1 -1 -1 red\n"), "line 2: 'red' behind the coordinates of vertex 2 is not a number");
  EXPECT_EQ(error_of("v 1 1 1 v 1 -1 -1\n"), "line 1: 'v' behind the coordinates of vertex 1 is not a number");
}

TEST(ReadObj, other_numbers_behind_a_vertex_are_likely_a_mistake_which_is_said) {
  const std::string text = "v 1 1 1\nv 1 -1 -1 2 3\nv -1 1 -1 1 2 3 4 5\nv -1 -1 1\n" + std::string(kTetrahedronFaces);
  expect_tetrahedron(text);
  EXPECT_EQ(read_checked_cage(text).value().report.notes,
            std::vector<std::string>{"ignored the numbers behind the coordinates of 2 vertices (the first on line 2), "
                                     "which are neither a weight nor a colour"});
}

TEST(ReadObj, numbers_are_read_to_the_last_digit) {
  const Cage cage = cage_of("v +0.1 1e+2 -1E-3\nv 1 -.5 -1.\nv 2.2250738585072014e-308 1e-400 4.9e-324\nv -1 -1 1\n" +
                            std::string(kTetrahedronFaces));
  EXPECT_EQ(cage.vertices(0, 0), 0.1);
  EXPECT_EQ(cage.vertices(0, 1), 100);
  EXPECT_EQ(cage.vertices(0, 2), -0.001);
  EXPECT_EQ(cage.vertices(1, 1), -0.5);
  EXPECT_EQ(cage.vertices(2, 0), std::numeric_limits<double>::min());
  EXPECT_EQ(cage.vertices(2, 1), 0);
  EXPECT_EQ(cage.vertices(2, 2), std::numeric_limits<double>::denorm_min());
}

namespace {

struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(ReadObj, numbers_do_not_depend_on_the_locale) {
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  // Not every machine has one of these; the C++ locale above is there everywhere.
  for (const char* comma : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, comma)) break;
  }
  Cage cage = cage_of("v 1234.5 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n" + std::string(kTetrahedronFaces));
  EXPECT_EQ(cage.vertices(0, 0), 1234.5);
  EXPECT_EQ(write_obj(cage).substr(0, 12), "v 1234.5 1 1");
  EXPECT_EQ(error_of("v 1,5 1 1\n"), "line 1: coordinate '1,5' of vertex 1 is not a number");
  std::locale::global(before);
  std::setlocale(LC_ALL, c_before.c_str());
}

TEST(ReadObj, what_is_not_a_finite_number_is_refused) {
  EXPECT_EQ(error_of("v 1 nan 1\n"), "line 1: coordinate 'nan' of vertex 1 is not finite");
  EXPECT_EQ(error_of("v 1 1 1\nv -inf 1 1\n"), "line 2: coordinate '-inf' of vertex 2 is not finite");
  EXPECT_EQ(error_of("v 1 1 1e999\n"), "line 1: coordinate '1e999' of vertex 1 is not finite");
  EXPECT_EQ(error_of("v 1 1 1" + std::string(400, '0') + "\n"),
            "line 1: coordinate '10000000000000000000000000000000...' of vertex 1 is not finite");
  for (const char* junk : {"x", "1.2.3", "0x10", "1e", "--1", "+-1", "1_000", "-", "1d5"}) {
    EXPECT_EQ(error_of(std::string("v 1 ") + junk + " 1\n"),
              std::string("line 1: coordinate '") + junk + "' of vertex 1 is not a number");
  }
}

TEST(ReadObj, a_vertex_with_too_few_coordinates_is_refused) {
  EXPECT_EQ(error_of("v\n"), "line 1: vertex 1 has 0 coordinates instead of 3");
  EXPECT_EQ(error_of("v 1\n"), "line 1: vertex 1 has 1 coordinate instead of 3");
}

TEST(ReadObj, indices_that_name_no_vertex_are_refused_with_their_line) {
  const std::string vertices(kTetrahedronVertices);
  EXPECT_EQ(error_of(vertices + "f 1 2 0\n"), "line 5: vertex 0 does not exist: indices start at 1");
  EXPECT_EQ(error_of(vertices + "f 1 2 3\nf 1 2 -5\n"), "line 6: vertex -5 does not exist: 4 come before this line");
  EXPECT_EQ(error_of(vertices + "\nf 1 2 5\n"), "line 6: face 1 names vertex 5, but there are 4 vertices");
  EXPECT_EQ(error_of(vertices + "f 1 2 2147483648\n"), "line 5: vertex '2147483648' does not exist");
  EXPECT_EQ(error_of(vertices + "f 1 2 99999999999999999999\n"),
            "line 5: vertex '99999999999999999999' does not exist");
  EXPECT_EQ(error_of(vertices + "f 1 2 -99999999999999999999\n"),
            "line 5: vertex -9223372036854775808 does not exist: 4 come before this line");
  EXPECT_EQ(error_of("f -1 -2 -3\n" + vertices), "line 1: vertex -1 does not exist: 0 come before this line");
}

TEST(ReadObj, corners_that_are_not_indices_are_refused) {
  const std::string vertices(kTetrahedronVertices);
  for (const char* junk : {"x", "1.5", "1/x", "1//x", "1/1/x", "1/1/1/1", "/1", "1x", "//"}) {
    EXPECT_EQ(error_of(vertices + "f 1 2 " + junk + "\n"),
              std::string("line 5: '") + junk + "' is not a face corner (v, v/vt, v//vn or v/vt/vn)");
  }
}

TEST(ReadObj, faces_too_small_or_with_a_repeated_vertex_are_refused) {
  const std::string vertices(kTetrahedronVertices);
  EXPECT_EQ(error_of(vertices + "f 1 2\n"), "line 5: face 1 has 2 vertices");
  EXPECT_EQ(error_of(vertices + "f 1\n"), "line 5: face 1 has 1 vertex");
  EXPECT_EQ(error_of(vertices + "f\n"), "line 5: face 1 has 0 vertices");
  EXPECT_EQ(error_of(vertices + "f 1 2 3\nf 1 2 3 2\n"), "line 6: face 2 names vertex 2 twice");
  EXPECT_EQ(error_of(vertices + "f 1 1\n"), "line 5: face 1 names vertex 1 twice");
}

TEST(ReadObj, a_file_without_faces_says_so) {
  EXPECT_EQ(error_of(""), "the file is empty");
  EXPECT_EQ(error_of("\xEF\xBB\xBF \r\n\t\n"), "the file is empty");
  const std::string curves =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nl 1 2 3\n";
  EXPECT_EQ(error_of(curves),
            "the file has vertices but no faces (no line that begins with f); curves, points and free-form surfaces "
            "are not read");
}

TEST(ReadObj, other_kinds_of_files_are_told_apart_from_meshes) {
  const std::string neither =
      "neither OBJ nor OFF nor PLY: there is no line of an OBJ vertex or face, and no keyword of OFF or PLY at the "
      "start";
  EXPECT_EQ(error_of("solid cube\nfacet normal 0 0 1\n"), neither);
  EXPECT_EQ(error_of("<html>\n"), neither);
  using namespace std::string_literals;
  EXPECT_EQ(error_of("glTF\2\0\0\0junk"s), "line 1: not a text file: it holds a zero byte");
  EXPECT_EQ(error_of("\x89PNG\r\n\x1A\n\0\0\0\rIHDR"s), "line 3: not a text file: it holds a zero byte");
}

TEST(ReadObj, quoted_words_of_a_file_are_printable_and_short) {
  const std::string message = error_of("v 1 1 \x1b[31m\xff" + std::string(1000, 'a') + "\n");
  EXPECT_EQ(message, "line 1: coordinate '?[31m?" + std::string(26, 'a') + "...' of vertex 1 is not a number");
}

}  // namespace umbilic::test
