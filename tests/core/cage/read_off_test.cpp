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

TEST(ReadOff, the_keyword_may_be_left_out) {
  for (const char* header : {"4 4 6\n", "# no keyword\n\n 4\t4\n"}) expect_tetrahedron(off(header));
  EXPECT_EQ(error_of("4 4 6\n1 1 1\n"), "line 2: the file ends after 1 of the 4 vertices that line 1 announces");
}

TEST(ReadOff, lines_may_end_anywhere_but_behind_a_colour) {
  std::string numbers = off("4 4 6\n");
  for (const char blank : {'\n', ' '}) {
    std::string text = numbers;
    std::replace(text.begin(), text.end(), ' ', '\n');
    std::replace(text.begin(), text.end(), '\n', blank);
    if (blank == ' ') {  // a face ends its line
      text = "OFF 4 4 6 1 1 1 1 -1 -1 -1 1 -1 -1 -1 1 3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2";
    } else {
      text.insert(0, "OFF\n");
    }
    expect_tetrahedron(text);
  }
  expect_tetrahedron(
      "OFF 4 # vertices\n4\n6 1 1\n1 1 -1 -1 # and so on\n\n-1 1 -1 -1 -1\n1 3 0 1\n2 255 0 0\n3\n0 2 3 3\n3 0 3\n1\n3 "
      "1 3 2 "
      "0.5 0.5 0.5 1\n");
}

TEST(ReadOff, numbers_that_the_keyword_announces_may_stand_on_other_lines) {
  expect_tetrahedron(
      "STCNOFF 4 4 6\n1 1 1 0 0 1\n1 0 0 1\n.5 .5 1 -1 -1\n0 0 1 1 0 0 1 .5 .5\n-1 1 -1 0 0 1 1 0 0 1 .5 .5 -1 -1 1 0 "
      "0 1\n"
      "1 0 0 1 .5 .5\n" +
      std::string(kFaces));
  EXPECT_EQ(error_of("NOFF 4\n4 6\n1\n1 1 0 0 red\n"), "line 3: 'red' behind a vertex is not a number");
  EXPECT_EQ(error_of("NOFF 4\n4 6\n1\n1 1 0 0\n"), "line 3: 2 numbers behind vertex 1, where NOFF announces 3");
}

TEST(ReadOff, an_error_of_a_text_without_lines_for_its_vertices_is_told_by_its_definition) {
  EXPECT_EQ(error_of("OFF\n4 4 6\n1 1\n1 1 -1 x\n"), "line 4: coordinate 'x' of vertex 2 is not a number");
  EXPECT_EQ(error_of("OFF 4 4 6 1 1 1 1 -1 -1 -1 1 -1 -1 -1\n"), "line 1: vertex 4 has 2 coordinates instead of 3");
}

TEST(ReadOff, the_prefixes_stand_in_any_order_but_once) {
  for (const char* header : {"NCOFF 4 4 6\n", "CSTOFF\n4 4 6\n", "NSTCOFF\n4 4 6\n"}) expect_tetrahedron(off(header));
  for (const char* word : {"CCOFF", "SOFF", "TSOFF", "OFFC"}) {
    EXPECT_EQ(error_of(std::string(word) + "\n4 4 6\n"),
              "neither OBJ nor OFF nor PLY: there is no line of an OBJ vertex or face, and no keyword of OFF or PLY at "
              "the start");
  }
}

TEST(ReadOff, what_is_ignored_is_said) {
  const auto notes = [](std::string_view text) { return read_checked_cage(text).value().report.notes; };
  EXPECT_EQ(notes(tetrahedron_off()), std::vector<std::string>{});
  EXPECT_EQ(notes(off("# x\nSTCNOFF\n4 4 6\n", " 0 0 1 1 0 0 1 0.5 0.5")),
            std::vector<std::string>{
                "ignored of the vertices what STCNOFF on line 2 announces: normals, colours, texture coordinates"});
  EXPECT_EQ(notes(off("OFF\n4 4 6\n", " 1")),
            std::vector<std::string>{"ignored numbers behind the coordinates of 4 vertices (the first on line 3)"});
  std::string coloured = tetrahedron_off();
  coloured.insert(coloured.size() - 1, " 0.5 0.5 0.5");
  EXPECT_EQ(notes(coloured), std::vector<std::string>{"ignored the colours of 1 face (on line 10)"});
}

TEST(ReadOff, what_is_no_number_is_not_ignored) {
  EXPECT_EQ(error_of(off("OFF\n4 4 6\n", " red")), "line 3: 'red' behind a vertex is not a number");
  EXPECT_EQ(error_of(off("OFF\n4 4 6\n") + "x"),
            "line 11: more lines than the 4 vertices and 4 faces that line 2 announces");
  const std::string vertices = "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n";
  EXPECT_EQ(error_of(vertices + "3 0 1 2 red\n"), "line 7: 'red' behind a face is not a number");
  EXPECT_EQ(error_of(vertices + "3 0 1 2 3 0 2 3\n3 0 3 1\n3 1 3 2\n"),
            "line 9: the file ends after 3 of the 4 faces that line 2 announces");
  EXPECT_EQ(error_of(vertices + "3 0 1 2 3 0 2 3 3 0 3 1\n3 1 3 2\n"),
            "line 7: more than the 4 numbers of a colour behind the vertices of a face");
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
  EXPECT_EQ(error_of("STC4nOFF\n4 4 6\n"), "line 1: STC4nOFF has vertices of another dimension than 3");
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
              "neither OBJ nor OFF nor PLY: there is no line of an OBJ vertex or face, and no keyword of OFF or PLY at "
              "the start");
  }
}

}  // namespace umbilic::test
