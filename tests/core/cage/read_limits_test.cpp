// SPDX-License-Identifier: MIT
/// \file
/// Files that are too large are refused where that shows, by the line.
#include "cage/read_limits.h"

#include <fmt/format.h>

#include "cages.h"

namespace umbilic::test {
namespace {

std::string refusal(std::string_view text, const ReadLimits& limits) {
  const Result<CheckedCage> cage = read_checked_cage(text, limits);
  return cage ? "" : cage.error().message;
}

TEST(ReadLimits, are_no_hindrance_where_they_are_just_kept) {
  for (const std::string& text : {tetrahedron_obj(), tetrahedron_off()}) {
    EXPECT_EQ(refusal(text, {text.size(), 4, 4, 3}), "");
    EXPECT_EQ(refusal(text, {text.size() - 1, 4, 4, 3}),
              fmt::format("the file has more than {} bytes", text.size() - 1));
  }
}

TEST(ReadLimits, of_vertices_faces_and_corners_are_named_with_the_line_that_breaks_them) {
  EXPECT_EQ(refusal(tetrahedron_obj(), {1000, 3, 4, 3}), "line 4: more than 3 vertices: the file is too large");
  EXPECT_EQ(refusal(tetrahedron_obj(), {1000, 4, 2, 3}), "line 7: more than 2 faces: the file is too large");
  EXPECT_EQ(refusal(tetrahedron_obj(), {1000, 4, 4, 2}), "line 5: a face of more than 2 vertices");
  EXPECT_EQ(refusal(tetrahedron_off(), {1000, 3, 4, 3}), "line 2: 4 vertices and 4 faces: at most 3 and 4 are read");
  EXPECT_EQ(refusal(tetrahedron_off(), {1000, 4, 3, 3}), "line 2: 4 vertices and 4 faces: at most 4 and 3 are read");
  EXPECT_EQ(refusal(tetrahedron_off(), {1000, 4, 4, 2}), "line 7: a face of more than 2 vertices");
}

TEST(ReadLimits, stop_a_file_that_announces_more_than_it_holds) {
  EXPECT_EQ(error_of("OFF\n9000000000000000000 1 0\n"),
            "line 2: 9000000000000000000 vertices and 1 faces: at most 4000000 and 4000000 are read");
}

}  // namespace
}  // namespace umbilic::test
