// SPDX-License-Identifier: MIT
/// \file
/// OFF texts and their variants.
#include "cages.h"

namespace umbilic::test {

namespace {

constexpr std::string_view kFaces = "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";

std::string off(std::string_view header, std::string_view behind_vertex = "") {
  std::string text(header);
  for (const char* vertex : {"1 1 1", "1 -1 -1", "-1 1 -1", "-1 -1 1"})
    text.append(vertex).append(behind_vertex).append("\n");
  return text + std::string(kFaces);
}

}  // namespace

TEST(ReadOff, the_same_tetrahedron_as_in_obj) { expect_tetrahedron(tetrahedron_off()); }

TEST(ReadOff, the_edge_count_may_be_absent_or_wrong) {
  for (const char* header : {"OFF\n4 4\n", "OFF\n4 4 0\n", "OFF\n4 4 -7\n", "OFF\n4 4 999999999999\n"})
    expect_tetrahedron(off(header));
}

TEST(ReadOff, counts_may_stand_behind_the_keyword) {
  for (const char* header : {"OFF 4 4 6\n", "OFF4 4 6\n", "  OFF\t4 4\n"}) expect_tetrahedron(off(header));
}

TEST(ReadOff, comments_and_blank_lines_may_stand_anywhere) {
  expect_tetrahedron(
      "# first\n\nOFF # keyword\n# counts\n4 4 6 # here\n\n1 1 1\n1 -1 -1\n# between\n-1 1 -1\n\n-1 -1 1\n3 0 1 2\n#\n"
      "3 0 2 3 # red\n3 0 3 1\n3 1 3 2\n# end\n\n");
}

TEST(ReadOff, more_numbers_per_vertex_are_ignored) {
  expect_tetrahedron(off("COFF\n4 4 6\n", " 0.1 0.2 0.3 1"));
  expect_tetrahedron(off("NOFF\n4 4 6\n", " 0 0 1"));
  expect_tetrahedron(off("STOFF\n4 4 6\n", " 0.5 0.5"));
  expect_tetrahedron(off("STCNOFF\n4 4 6\n", " 0 0 1 255 0 0 255 0.5 0.5"));
  expect_tetrahedron(off("OFF\n4 4 6\n", " 255 0 0"));
}

TEST(ReadOff, face_colours_are_ignored) {
  expect_tetrahedron(
      "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n3 0 3 1 12\n3 1 3 2\n");
}

TEST(ReadOff, every_line_end_and_a_byte_order_mark_are_accepted) {
  for (const std::string_view end : {"\n", "\r\n", "\r"}) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : tetrahedron_off()) c == '\n' ? text += end : text += c;
    expect_tetrahedron(text);
  }
}

TEST(ReadOff, variants_that_are_not_three_dimensional_text_are_refused_with_the_reason) {
  EXPECT_EQ(error_of("OFF BINARY\n"), "line 1: binary OFF is not read; save it as text");
  EXPECT_EQ(error_of(std::string("COFF BINARY\n\0\0\0\4", 16)), "line 1: binary OFF is not read; save it as text");
  EXPECT_EQ(error_of("4OFF\n4 4 6\n"), "line 1: 4OFF has vertices of another dimension than 3");
  EXPECT_EQ(error_of("# x\nnOFF 3\n4 4 6\n"), "line 2: nOFF has vertices of another dimension than 3");
}

TEST(ReadOff, counts_that_are_no_counts_are_refused) {
  EXPECT_EQ(error_of("OFF\nfour 4 6\n"), "line 2: expected the numbers of vertices and faces, found 'four'");
  EXPECT_EQ(error_of("OFF\n4\n"), "line 2: expected the numbers of vertices and faces, found ''");
  EXPECT_EQ(error_of("OFF\n4 -4 6\n"), "line 2: expected the numbers of vertices and faces, found '-4'");
  EXPECT_EQ(error_of("OFF\n"), "line 1: the file ends before the numbers of vertices and faces");
}

TEST(ReadOff, a_truncated_file_says_what_is_missing) {
  EXPECT_EQ(error_of("OFF\n4 4 6\n1 1 1\n1 -1 -1\n"),
            "line 4: the file ends after 2 of the 4 vertices that line 2 announces");
  EXPECT_EQ(error_of("OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n"),
            "line 7: the file ends after 1 of the 4 faces that line 2 announces");
  EXPECT_EQ(error_of("OFF\n4 4 6\n1 1 1\n1 -1\n"), "line 4: vertex 2 has 2 coordinates instead of 3");
  EXPECT_EQ(error_of(off("OFF\n4 4 6\n").substr(0, 45)), "line 7: a face of 3 vertices has only 2");
}

TEST(ReadOff, counts_that_no_file_could_hold_cost_nothing) {
  EXPECT_EQ(error_of("OFF\n9000000000000000000 9000000000000000000 0\n1 1 1\n"),
            "line 2: 9000000000000000000 vertices and 9000000000000000000 faces: at most 4000000 and 4000000 are read");
  EXPECT_EQ(error_of("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"),
            "line 6: a face of more than 10000 vertices");
}

TEST(ReadOff, lines_beyond_the_counts_are_refused) {
  EXPECT_EQ(error_of(off("OFF\n4 3 6\n")), "line 10: more lines than the 4 vertices and 3 faces that line 2 announces");
}

TEST(ReadOff, indices_count_from_zero_in_the_file_and_in_its_errors) {
  const std::string vertices = "OFF\n4 1 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n";
  EXPECT_EQ(error_of(vertices + "3 0 1 4\n"), "line 7: index 4 does not exist: 4 vertices have the indices 0 to 3");
  EXPECT_EQ(error_of(vertices + "3 0 1 -1\n"), "line 7: index -1 does not exist: 4 vertices have the indices 0 to 3");
  EXPECT_EQ(error_of(vertices + "3 0 1 x\n"), "line 7: 'x' is not a vertex index");
  EXPECT_EQ(error_of(vertices + "x 0 1 2\n"), "line 7: expected a face's number of vertices, found 'x'");
  EXPECT_EQ(error_of(vertices + "3 0 1 0\n"), "line 7: face 1 names vertex 0 twice");
  EXPECT_EQ(error_of("OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n"),
            "line 10: edge between vertices 0 and 1 belongs to 3 faces: not a manifold");
  const CheckedCage open = read_checked_cage(vertices + "3 1 2 3\n").value();
  EXPECT_EQ(open.report.boundaries.at(0).first_vertex, 1);
}

TEST(ReadOff, a_file_without_faces_says_so) { EXPECT_EQ(error_of("OFF\n1 0 0\n0 0 0\n"), "the cage has no faces"); }

TEST(ReadOff, words_that_merely_contain_the_keyword_are_not_off) {
  for (const char* first : {"OFFSET", "SCOFFER", "off"}) {
    EXPECT_EQ(error_of(std::string(first) + "\n4 4 6\n"),
              "neither OBJ nor OFF: there is no line of an OBJ vertex or face, and no OFF keyword at the start");
  }
}

}  // namespace umbilic::test
