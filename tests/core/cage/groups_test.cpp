// SPDX-License-Identifier: MIT
/// \file
/// Groups of faces, and tags that are ignored but not in silence.
#include <fmt/format.h>

#include "cage/generate.h"
#include "cage/write.h"
#include "cages.h"

namespace umbilic::test {
namespace {

/// The groups as "a: 1 2, b: 3", with faces from 1.
std::string groups_of(const Cage& cage) {
  std::string text;
  for (const FaceGroup& group : cage.groups) {
    text += (text.empty() ? "" : ", ") + group.name + ":";
    for (const int face : group.faces) text += fmt::format(" {}", face + 1);
  }
  return text;
}

/// Of a tetrahedron, with `lines[i]` before its face i.
std::string groups_between(const std::array<std::string, 4>& lines) {
  const std::array<const char*, 4> faces{"f 1 2 3\n", "f 1 3 4\n", "f 1 4 2\n", "f 2 4 3\n"};
  std::string text(kTetrahedronVertices);
  for (std::size_t i = 0; i < 4; ++i) text += lines[i] + faces[i];
  return groups_of(cage_of(text));
}

std::string error_within(std::string_view text, const ReadLimits& limits = {}) {
  const Result<CheckedCage> cage = read_checked_cage(text, limits);
  return cage ? "" : cage.error().message;
}

}  // namespace

TEST(Groups, hold_the_faces_after_their_line_until_the_next_one) {
  EXPECT_EQ(groups_between({"", "g a\n", "", "g b\n"}), "a: 2 3, b: 4");
  EXPECT_EQ(groups_between({"g a\n", "g\n", "g a\n", "g\n"}), "a: 1 3");
  EXPECT_EQ(groups_between({"", "", "", ""}), "");
}

TEST(Groups, of_one_line_all_hold_its_faces_and_a_name_given_twice_counts_once) {
  EXPECT_EQ(groups_between({"g a b\n", "g b c b\n", "g a a\n", "g c\n"}), "a: 1 3, b: 1 2, c: 2 4");
}

TEST(Groups, without_faces_are_dropped_and_the_others_are_in_the_order_of_their_first_faces) {
  EXPECT_EQ(groups_between({"g last\ng first none\ng first\n", "g middle\n", "", "g last\n"}),
            "first: 1, middle: 2 3, last: 4");
}

TEST(Groups, are_made_by_objects_too_which_g_does_not_end) {
  EXPECT_EQ(groups_between({"o body\n", "g head\n", "g\n", "o tail\n"}), "body: 1 2 3, head: 2, tail: 4");
  EXPECT_EQ(groups_between({"g fin\no body\n", "o\n", "g\n", "o body\ng body\n"}), "fin: 1 2, body: 1 4");
  EXPECT_EQ(groups_between({"o Part  1 \n", "o Part 2\n", "", ""}), "Part_1: 1, Part_2: 2 3 4");
}

TEST(Groups, are_read_through_continued_lines_comments_and_any_line_end) {
  EXPECT_EQ(groups_between({"g a \\\n b\\\n c # d\n", "g #a\n", "\tg\ta\r\n", "g\\\nx\n"}), "a: 1 3, b: 1, c: 1, x: 4");
}

TEST(Groups, hold_faces_that_count_their_vertices_backwards) {
  EXPECT_EQ(groups_of(cage_of("v 1 1 1\nv 1 -1 -1\nv -1 1 -1\ng a\nf -3 -2 -1\nv -1 -1 1\nf -4 -2 -1\ng b\nf -4 -1 "
                              "-3\nf 2 4 3\n")),
            "a: 1 2, b: 3 4");
}

TEST(Groups, keep_their_faces_where_faces_are_turned_and_vertices_dropped) {
  const CheckedCage read =
      read_checked_cage(
          "v 9 9 9\nv 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\ng a\nf 2 4 3\nf 2 4 5\ng b\nf 2 5 3\nf 3 5 4\n")
          .value();
  EXPECT_EQ(read.report.repairs.size(), 2u);
  EXPECT_EQ(groups_of(read.cage), "a: 1 2, b: 3 4");
  EXPECT_EQ(read.cage.faces[3], (std::vector<int>{1, 3, 2}));
  ASSERT_EQ(read.report.groups.size(), 2u);
  EXPECT_EQ(read.report.groups[1].name, "b");
  EXPECT_EQ(read.report.groups[1].faces, 2);
}

TEST(Groups, have_names_that_can_be_printed) {
  EXPECT_EQ(groups_between({"g fl\xC3\xBCgel\n", "g W\xFCrfel\n", "g \x1b[31m\x7f\xC2\x9B\n", "g a\\b\n"}),
            "fl\xC3\xBCgel: 1, W?rfel: 2, ?[31m??: 3, a\\b: 4");
}

TEST(Groups, are_written_and_read_back_the_same) {
  Cage cage = generate_cage("two-3").value();
  const auto faces = static_cast<int>(cage.faces.size());
  for (const auto& [name, step] : {std::pair("every", 1), {"second\\", 2}, {"third", 3}, {"seventh\\", 7}}) {
    cage.groups.push_back({name, {}});
    for (int f = step - 1; f < faces; f += step) cage.groups.back().faces.push_back(f);
  }
  cage.groups[0].faces.pop_back();
  cage.groups[3].faces.push_back(faces - 1);
  const Cage back = cage_of(write_obj(cage));
  EXPECT_EQ(back.faces, cage.faces);
  EXPECT_EQ(groups_of(back), groups_of(cage));
  EXPECT_EQ(write_obj(back), write_obj(cage));
}

TEST(Groups, that_are_too_many_or_too_large_are_refused_at_their_line) {
  std::string many(kTetrahedronVertices);
  for (int i = 0; i < 100'000; ++i) many += fmt::format("g part{}\nf 1 2 3\n", i);
  EXPECT_EQ(error_within(many), "line 20005: more than 10000 groups: the file is too large");

  ReadLimits limits;
  limits.groups = 2;
  EXPECT_EQ(error_within(tetrahedron_obj() + "g a b\ng b a\no a\n", limits), "");
  EXPECT_EQ(error_within(tetrahedron_obj() + "g a b\no c\n", limits),
            "line 10: more than 2 groups: the file is too large");
  limits.memberships = 7;
  EXPECT_EQ(error_within("g a b\n" + tetrahedron_obj(), limits),
            "line 9: more than 7 faces in all groups together: the file is too large");
  limits.memberships = 8;
  EXPECT_EQ(error_within("g a b\n" + tetrahedron_obj(), limits), "");
  EXPECT_EQ(error_within("g " + std::string(256, 'x') + "\n" + tetrahedron_obj()), "");
  EXPECT_EQ(error_within("v 1 2 3\no x " + std::string(255, 'x') + "\n" + tetrahedron_obj()),
            "line 2: a group's name of more than 256 bytes");
}

TEST(Tags, are_noted_once_for_each_kind_with_the_first_line) {
  const CheckedCage read = read_checked_cage(tetrahedron_obj() +
                                             "t crease 2/1/0 1 2 3.5\ns off\nusemtl red\nt corner 1/1/0 1 9\nt crease "
                                             "2/1/0 2 3 1\nt hole 1/0/0 2\nt interpolateboundary 1/0/0 1\nt\n")
                               .value();
  EXPECT_EQ(read.report.notes,
            (std::vector<std::string>{"ignored 2 crease tags (the first on line 9): edges stay smooth",
                                      "ignored 1 corner tag (on line 12): vertices stay smooth",
                                      "ignored 1 hole tag (on line 14): the faces stay",
                                      "ignored 2 tags (the first on line 15): they change nothing"}));
}

TEST(Tags, are_not_seen_in_texture_coordinates_smoothing_groups_and_materials) {
  EXPECT_TRUE(read_checked_cage("mtllib a\nvt 0 0\ns 1\nusemtl t\n" + tetrahedron_obj()).value().report.notes.empty());
}

}  // namespace umbilic::test
