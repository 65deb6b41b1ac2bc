// SPDX-License-Identifier: MIT
/// \file
/// Truncated, mutated and random texts: always a cage or a reason, never a crash.
#include <algorithm>
#include <random>

#include "cage/boundary.h"
#include "cage/write.h"
#include "cages.h"
#include "ply_writer.h"

namespace umbilic::test {

namespace {

std::string rich_obj() {
  return "# cube\r\nmtllib a\r\nv -1 -1 -1 0.5\r\nv 1 -1 -1\r\nv 1 1 -1\r\nv -1 1 -1\r\nv -1 -1 1\r\nv 1 -1 1\r\nv 1 1 "
         "\\\r\n1\r\nv -1e0 1 1\r\n"
         "vt 0 0\r\no big box\r\nt crease 2/1/0 1 2 3.5\r\nf 1/1 4/1 3/1 2/1\r\ng a b a\r\nf -4//-1 -3//-1 -2//-1 "
         "-1//-1\r\nf 1 2 6 5\r\nf 2 3 7 6\r\ng x\\y \\\r\n big_box\r\nf 3 4 8 "
         "7\r\nf 4 1 \\\r\n5 8\r\n";
}

std::string rich_off() {
  return "# cube\nCOFF 8 6 12\n-1 -1 -1 1 0 0\n1 -1 -1 1 0 0\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1e0\n-1 1 1\n\n4 0 "
         "3 2 1\n4 4 5 6 7 255 0 0\n"
         "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
}

/// Without keyword, and with lines that end anywhere.
std::string wrapped_off() {
  return "8 6 12 -1 -1 -1 # first\n1 -1 -1 1 1 -1 -1 1 -1 -1 -1 1 1\n-1 1 1 1\n\n1e0 -1 1 1 4\n0 3 2 1\n4 4 5 6 7 255 "
         "0 0\n4 0 1 5\n4 .5\n"
         "4 1 2 6 5\n4 2 3\n7 6\n4 3 0 4 7\n";
}

/// A cube with what the reader skips before, between and behind what it reads.
std::string rich_ply(std::string_view format) {
  const Cage cube = cage_of(rich_off());
  PlyBody body(format);
  body.put("uchar", 2).put("short", -1).put("short", 300).end();
  for (int v = 0; v < 8; ++v) {
    for (int axis = 0; axis < 3; ++axis) body.put("float", cube.vertices(v, axis));
    body.put("uchar", 255).end();
  }
  for (const std::vector<int>& face : cube.faces) {
    body.put("uchar", static_cast<double>(face.size()));
    for (const int v : face) body.put("short", v);
    body.put("uint", 1).put("double", 0.5).end();
  }
  return std::string("ply\nformat ")
             .append(format)
             .append(
                 " 1.0\ncomment a cube\nelement range 1\nproperty list uchar short ends\n"
                 "element vertex 8\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                 "element face 6\nproperty list uchar short vertex_indices\nproperty list uint double weights\n"
                 "end_header\n") +
         body.text();
}

/// The boundary loops are those of the report, and groups survive writing.
void expect_consistent(const Cage& cage, const CageReport& report) {
  const std::vector<std::vector<int>> loops = boundary_loops(cage);
  ASSERT_EQ(loops.size(), report.boundaries.size());
  int boundaries = 0;
  for (const CageComponent& component : report.components) {
    ASSERT_GE(component.genus, 0);
    boundaries += component.boundaries;
  }
  ASSERT_EQ(loops.size(), static_cast<std::size_t>(boundaries));
  const Cage back = cage_of(write_obj(cage));
  ASSERT_EQ(back.faces, cage.faces);
  ASSERT_EQ(back.groups.size(), cage.groups.size());
  for (std::size_t g = 0; g < cage.groups.size(); ++g) {
    ASSERT_EQ(back.groups[g].name, cage.groups[g].name);
    ASSERT_EQ(back.groups[g].faces, cage.groups[g].faces);
    for (const int face : cage.groups[g].faces) ASSERT_LT(face, static_cast<int>(cage.faces.size()));
  }
}

/// A cage that satisfies everything that validation promises, or a message in printable ASCII that names a line of the
/// text (or says what the whole text lacks).
void expect_cage_or_reason(const std::string& text) {
  Result<Cage> cage = read_cage(text);
  if (cage) {
    const auto faces = cage->faces;
    const Result<CageReport> report = validate(*cage);
    ASSERT_TRUE(report.ok());
    ASSERT_EQ(cage->faces, faces) << "validation finds nothing left to do";
    ASSERT_NO_FATAL_FAILURE(expect_consistent(*cage, *report));
    return;
  }
  const std::string& message = cage.error().message;
  ASSERT_FALSE(message.empty());
  ASSERT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; })) << message;
  if (message.rfind("line ", 0) == 0) {
    const auto lines = std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }) + 1;
    const int line = std::stoi(message.substr(5));
    ASSERT_GE(line, 1) << message;
    ASSERT_LE(line, lines) << message;
    return;
  }
  for (const char* whole : {"neither OBJ nor OFF nor PLY", "the file has vertices but no faces", "the file is empty",
                            "the cage has no faces"}) {
    if (message.rfind(whole, 0) == 0) return;
  }
  const bool is_element = message.starts_with("'") || message.starts_with("face ") || message.starts_with("vertex ") ||
                          message.starts_with("edge ") || message.starts_with("the file ");
  if (text.find("binary_") != std::string::npos && is_element) return;
  FAIL() << "no line in: " << message;
}

}  // namespace

TEST(HostileText, the_texts_that_the_other_tests_damage_are_cubes) {
  EXPECT_EQ(cage_of(rich_obj()).faces.size(), 6u);
  EXPECT_EQ(cage_of(rich_off()).faces.size(), 6u);
  EXPECT_EQ(cage_of(rich_obj()).vertices, cage_of(rich_off()).vertices);
  EXPECT_EQ(cage_of(rich_off()).vertices, cage_of(wrapped_off()).vertices);
  EXPECT_EQ(cage_of(rich_off()).faces, cage_of(wrapped_off()).faces);
  for (const std::string& format : kPlyFormatNames) {
    EXPECT_EQ(cage_of(rich_ply(format)).vertices, cage_of(rich_off()).vertices);
    EXPECT_EQ(cage_of(rich_ply(format)).faces, cage_of(rich_off()).faces);
  }
}

TEST(HostileText, every_truncation_is_a_cage_or_has_a_reason) {
  for (const std::string& text :
       {rich_obj(), rich_off(), wrapped_off(), rich_ply("ascii"), rich_ply("binary_little_endian"),
        rich_ply("binary_big_endian"), tetrahedron_obj(), tetrahedron_off()}) {
    for (std::size_t length = 0; length < text.size(); ++length) expect_cage_or_reason(text.substr(0, length));
  }
}

TEST(HostileText, a_truncation_before_the_last_digits_is_never_a_closed_cage) {
  for (const std::string& text : {tetrahedron_obj(), tetrahedron_off()}) {
    for (std::size_t length = 0; length + 2 < text.size(); ++length) {
      const Result<CheckedCage> cage = read_checked_cage(text.substr(0, length));
      if (cage) {
        EXPECT_FALSE(cage->report.boundaries.empty()) << length;
      }
    }
  }
}

TEST(HostileText, random_changes_of_bytes_give_a_cage_or_a_reason) {
  std::mt19937 random(20240229);
  const std::string alphabet = "0123456789-+.eE/\\# \n\r\tvfngotOFC\xff\x80x";
  for (const std::string& original : {rich_obj(), rich_off(), wrapped_off(), rich_ply("ascii"),
                                      rich_ply("binary_little_endian"), rich_ply("binary_big_endian")}) {
    for (int trial = 0; trial < 4000; ++trial) {
      std::string text = original;
      for (unsigned changes = 1 + random() % 6; changes > 0; --changes) {
        const std::size_t at = random() % text.size();
        const char byte = random() % 8 ? alphabet[random() % alphabet.size()] : static_cast<char>(random() % 256);
        switch (random() % 4) {
          case 0: text.insert(at, 1, byte); break;
          case 1: text.erase(at, 1 + random() % 4); break;
          case 2: text.insert(at, text.substr(random() % text.size(), random() % 40)); break;
          default: text[at] = byte;
        }
      }
      ASSERT_NO_FATAL_FAILURE(expect_cage_or_reason(text)) << text;
    }
  }
}

TEST(HostileText, random_bytes_give_a_reason) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    std::string text(random() % 400, ' ');
    for (char& c : text) c = static_cast<char>(random() % 256);
    EXPECT_NE(error_of(text), "");
    EXPECT_NE(error_of("OFF\n" + text), "");
    const std::string body = rich_ply("binary_little_endian");
    EXPECT_NE(error_of(body.substr(0, body.find("end_header\n") + 11) + text), "");
  }
}

}  // namespace umbilic::test
