// SPDX-License-Identifier: MIT
/// \file
/// PLY files of all formats and types.
#include <random>

#include "cage/formats.h"
#include "cage/write.h"
#include "cages.h"
#include "ply_writer.h"

namespace umbilic::test {

namespace {

Cage tetrahedron() { return cage_of(tetrahedron_obj()); }

/// An ascii file with these lines of vertices and faces in place of a tetrahedron's.
std::string ascii(std::string_view vertices = "1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n",
                  std::string_view faces = "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n") {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_index\nend_header\n{}{}",
      vertices, faces);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string replaced_everywhere(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

TEST(ReadPly, the_same_tetrahedron_as_in_obj) {
  expect_tetrahedron(ascii());
  for (const std::string& format : kPlyFormatNames) expect_tetrahedron(write_ply(tetrahedron(), format));
}

TEST(ReadPly, every_generated_cage_in_every_format_reads_back_to_the_same_cage) {
  for (const CageName& name : cage_names()) {
    const Cage cage = generate_cage(name.name).value();
    for (const std::string& format : kPlyFormatNames) {
      const Cage back = cage_of(write_ply(cage, format));
      EXPECT_EQ(back.vertices, cage.vertices) << name.name << " " << format;
      EXPECT_EQ(back.faces, cage.faces) << name.name << " " << format;
    }
  }
}

TEST(ReadPly, doubles_read_back_to_the_same_bits_and_floats_to_their_values) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Cage cage = cube_of_any_doubles(random);
    for (const std::string& format : kPlyFormatNames) {
      const Cage back = parse_ply(write_ply(cage, format)).value().cage;
      ASSERT_EQ(back.vertices.size(), cage.vertices.size());
      EXPECT_EQ(std::memcmp(back.vertices.data(), cage.vertices.data(), sizeof(double) * 24), 0) << format;
    }
  }
  Cage third = tetrahedron();
  third.vertices /= 3;
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    EXPECT_EQ(cage_of(write_ply(third, format, {.coordinate = "float"})).vertices,
              third.vertices.cast<float>().cast<double>().eval());
  }
}

TEST(ReadPly, numbers_may_be_of_any_type) {
  const std::vector<std::string> types{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"};
  Cage shifted = tetrahedron();
  shifted.vertices.array() += 1;  // 0 or 2, which every type has
  for (const std::string& format : kPlyFormatNames) {
    for (const std::string& type : types) {
      for (const PlyTypes& used :
           {PlyTypes{type, "uchar", "int"}, PlyTypes{"int", type, "int"}, PlyTypes{"int", "uchar", type}}) {
        const Cage back = cage_of(write_ply(shifted, format, used));
        EXPECT_EQ(back.vertices, shifted.vertices) << format << " " << type;
        EXPECT_EQ(back.faces, shifted.faces) << format << " " << type;
      }
    }
    expect_tetrahedron(write_ply(tetrahedron(), format, {"char", "int", "short"}));
  }
}

TEST(ReadPly, types_may_be_named_by_their_bits) {
  std::string file = ascii();
  for (const auto& [from, to] : {std::pair{"property float x", "property float32 x"},
                                 {"property float y", "property float64 y"},
                                 {"property float z", "property int8 z"},
                                 {"list uchar int", "list uint16 uint32"}}) {
    file = replaced(file, from, to);
  }
  expect_tetrahedron(file);
}

TEST(ReadPly, indices_need_all_bits_of_an_unsigned_type) {
  Cage torus = generate_cage("torus", {.major_segments = 20, .minor_segments = 10})
                   .value();  // 200 vertices: more than a char has
  for (const std::string& format : kPlyFormatNames) {
    EXPECT_EQ(cage_of(write_ply(torus, format, {"double", "uchar", "uchar"})).faces, torus.faces) << format;
  }
}

TEST(ReadPly, other_properties_and_elements_are_skipped) {
  const Cage cage = tetrahedron();
  for (const std::string& format : kPlyFormatNames) {
    PlyBody body(format);
    for (int camera = 0; camera < 2; ++camera) {
      body.put("uchar", 3).put("short", 1).put("short", -2).put("short", 3).put("float", 0.5).end();
    }
    for (const std::vector<int>& face : cage.faces) {
      body.put("uchar", 255).put("int", 2).put("double", NAN).put("double", 1).put("uchar", 3);
      for (const int v : face) body.put("ushort", v);
      body.put("ushort", 0).end();
    }
    body.put("int", 7).end();
    for (int v = 0; v < 4; ++v) {
      body.put("float", 9).put("double", cage.vertices(v, 2)).put("uchar", 0).put("float", cage.vertices(v, 0));
      body.put("int", cage.vertices(v, 1)).put("char", -1).end();
    }
    body.put("uint", 1).put("uint", 0).end();
    const std::string file =
        fmt::format("ply\nformat {} 1.0\ncomment element face 9\nobj_info num_cols 512\n", format) +
        "element camera 2\nproperty list uchar short view\nproperty float f\n"
        "element face 4\nproperty uchar red\nproperty list int double texcoord\nproperty list uchar ushort "
        "vertex_indices\nproperty ushort flags\ncomment between\n"
        "element nothing 1000000000000000000\nelement one 1\nproperty int n\n"
        "element vertex 4\nproperty float nx\nproperty double z\nproperty list uchar int around\nproperty float "
        "x\nproperty int y\nproperty char c\n"
        "element none 0\nproperty list int int n\nelement edge 1\nproperty uint a\nproperty uint b\nend_header\n" +
        body.text();
    expect_tetrahedron(file);
  }
}

TEST(ReadPly, lines_may_end_in_every_way_and_a_mark_may_stand_before_them) {
  for (const char* end : {"\r\n", "\r"}) expect_tetrahedron(replaced_everywhere(ascii(), "\n", end));
  expect_tetrahedron("\xEF\xBB\xBF" + ascii());
  expect_tetrahedron(replaced(replaced(ascii(), "ply\n", "ply \t\n\n"), "1 -1 -1\n", "\n  1\t-1 -1 \n\n"));
  expect_tetrahedron(ascii() + "\n \n");
}

TEST(ReadPly, the_bytes_behind_the_header_are_no_part_of_its_last_line) {
  Cage cage = tetrahedron();
  cage.vertices.array() += 10 - cage.vertices(0, 0);  // the first byte is that of a line's end
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string file = write_ply(cage, "binary_little_endian", {.coordinate = "uchar"});
    const std::size_t body = file.find("end_header\n") + 11;
    ASSERT_EQ(file[body], '\n');
    const std::string read = replaced_everywhere(file.substr(0, body), "\n", end) + file.substr(body);
    EXPECT_EQ(cage_of(read).vertices, cage.vertices);
  }
}

TEST(ReadPly, errors_of_a_header_name_its_line) {
  const auto header = [](std::string_view from, std::string_view to) { return error_of(replaced(ascii(), from, to)); };
  EXPECT_EQ(header("format ascii 1.0\n", ""), "line 2: the line of the format must come first");
  EXPECT_EQ(header("ascii 1.0", "ascii 2.0"), "line 2: version '2.0' of the format is not 1.0");
  EXPECT_EQ(header("ascii", "binary"),
            "line 2: format 'binary' is none of ascii, binary_little_endian, binary_big_endian");
  EXPECT_EQ(header("ascii 1.0", "ascii 1.0\nformat ascii 1.0"), "line 3: a second line of the format");
  EXPECT_EQ(header("ascii 1.0", "ascii 1.0 now"), "line 2: more words than 'format' takes");
  EXPECT_EQ(header("vertex 4", "vertex"),
            "line 3: expected the name of an element and how many there are, found 'vertex' and ''");
  EXPECT_EQ(header("vertex 4", "vertex -4"),
            "line 3: expected the name of an element and how many there are, found 'vertex' and '-4'");
  EXPECT_EQ(header("element vertex 4\n", ""), "line 3: a property before the first element");
  EXPECT_EQ(header("float y", "real y"),
            "line 5: 'real' is no type of a property (as uchar, int, float or double are)");
  EXPECT_EQ(header("float y", "list uchar y"),
            "line 5: 'y' is no type of a property (as uchar, int, float or double are)");
  EXPECT_EQ(header("float y", "float"), "line 5: the property has no name");
  EXPECT_EQ(header("property float y\n", ""), "line 3: the element vertex has no property y");
  EXPECT_EQ(header("float y", "float x"), "line 3: the element vertex has two properties x");
  EXPECT_EQ(header("float y", "list int int y"), "line 3: the property y is a list, not a number");
  EXPECT_EQ(header("vertex_index", "corners"),
            "line 7: the element face has no property vertex_indices or vertex_index");
  EXPECT_EQ(header("end_header", "property list int int vertex_index\nend_header"),
            "line 7: the element face has two properties vertex_index");
  EXPECT_EQ(header("list uchar int", "int"), "line 7: the property vertex_index is no list");
  EXPECT_EQ(header("element face 4", "element faces 4"),
            "line 9: the header ends without an element face: strips, edges and points are not read");
  EXPECT_EQ(header("element vertex", "element point"), "line 9: the header ends without an element vertex");
  EXPECT_EQ(header("end_header", "element face 4\nend_header"), "line 9: a second element face");
  EXPECT_EQ(header("end_header", "end header"),
            "line 9: expected element, property, comment or end_header, found 'end'");
  EXPECT_EQ(error_of(ascii().substr(0, ascii().find("end_header"))),
            "line 9: the file ends before the line end_header");
  EXPECT_EQ(error_of("ply"), "line 1: the file ends before the line end_header");
}

TEST(ReadPly, errors_of_a_text_name_its_line) {
  EXPECT_EQ(error_of(ascii("1 1 1\n1 -1\n-1 1 -1\n-1 -1 1\n")), "line 11: the line ends before 'z'");
  EXPECT_EQ(error_of(ascii("1 1 1\n1 -1 one\n")), "line 11: 'one' for 'z' is not a number");
  EXPECT_EQ(error_of(ascii("1 1 1\n1 nan 1\n")), "line 11: the coordinate y is not finite");
  EXPECT_EQ(error_of(ascii("1 1 1\n1 1e999 1\n")), "line 11: the coordinate y is not finite");
  EXPECT_EQ(error_of(ascii("1 1 1\n1 1 1 1\n")), "line 11: '1' is more than the header announces");
  EXPECT_EQ(error_of(ascii("1 1 1\n", "")),
            "line 10: the file ends after 1 of the 4 elements 'vertex' that line 3 announces");
  const std::string_view vertices = "1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n";
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1 2\n")),
            "line 14: the file ends after 1 of the 4 elements 'face' that line 7 announces");
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1\n")), "line 14: the line ends before 'vertex_index'");
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1 4\n")),
            "line 14: index 4 does not exist: 4 vertices have the indices 0 to 3");
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1 -1\n")),
            "line 14: index -1 does not exist: 4 vertices have the indices 0 to 3");
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1 1.5\n")),
            "line 14: index 1.5 does not exist: 4 vertices have the indices 0 to 3");
  EXPECT_EQ(error_of(ascii(vertices, "-3 0 1 2\n")), "line 14: -3 is no length of the list 'vertex_index'");
  EXPECT_EQ(error_of(ascii(vertices, "2.5 0 1 2\n")), "line 14: 2.5 is no length of the list 'vertex_index'");
  EXPECT_EQ(error_of(ascii(vertices, "inf 0 1 2\n")), "line 14: inf is no length of the list 'vertex_index'");
  EXPECT_EQ(error_of(ascii(vertices, "1000000 0 1 2\n")), "line 14: a face of more than 10000 vertices");
  EXPECT_EQ(error_of(ascii() + "0 0 0\n"),
            "line 18: the file goes on behind the last element that its header announces");
  EXPECT_EQ(error_of(ascii(vertices, "3 0 1 2\n3 0 2 3\n3 0 3 1\n2 1 3\n")), "line 17: face 4 has 2 vertices");
}

TEST(ReadPly, errors_of_bytes_name_the_element) {
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    const Cage cage = tetrahedron();
    const std::string file = write_ply(cage, format);
    const std::size_t body = file.find("end_header\n") + 11, faces = body + 4 * 24;
    EXPECT_EQ(error_of(file.substr(0, body + 24)),
              "the file ends after 1 of the 4 elements 'vertex' that line 3 announces");
    EXPECT_EQ(error_of(file.substr(0, body + 24 + 9)), "'vertex' 1: the file ends before 'y'");
    EXPECT_EQ(error_of(file.substr(0, faces)), "the file ends after 0 of the 4 elements 'face' that line 7 announces");
    EXPECT_EQ(error_of(file.substr(0, faces + 3)), "'face' 1: the file ends before 'vertex_indices'");
    EXPECT_EQ(error_of(file + '\n'), "the file goes on behind the last element that its header announces");

    Cage wrong = cage;
    wrong.vertices(2, 1) = HUGE_VAL;
    EXPECT_EQ(error_of(write_ply(wrong, format)), "'vertex' 2: the coordinate y is not finite");
    wrong.vertices(2, 1) = NAN;
    EXPECT_EQ(error_of(write_ply(wrong, format)), "'vertex' 2: the coordinate y is not finite");
    wrong = cage;
    wrong.faces[1][2] = -7;
    EXPECT_EQ(error_of(write_ply(wrong, format)),
              "'face' 2: index -7 does not exist: 4 vertices have the indices 0 to 3");
    EXPECT_EQ(error_of(write_ply(wrong, format, {"double", "uchar", "uint"})),
              "'face' 2: index 4294967289 does not exist: 4 vertices have the indices 0 to 3");
    EXPECT_EQ(error_of(replaced(file, "list uchar", "list char").replace(faces - 1, 1, "\xFD")),
              "'face' 1: -3 is no length of the list 'vertex_indices'");
    EXPECT_EQ(error_of(write_ply(cage, format, {"double", "int", "int"}).replace(faces - 2, 4, "\x7F\x7F\x7F\x7F")),
              "'face' 1: a face of more than 10000 vertices");
    // What validation finds is named as in the file: vertices from 0.
    wrong.faces[1][2] = wrong.faces[1][0];
    EXPECT_EQ(error_of(write_ply(wrong, format)), fmt::format("face 2 names vertex {} twice", wrong.faces[1][0]));
  }
}

TEST(ReadPly, counts_that_no_file_can_hold_are_refused_at_once) {
  const auto with_counts = [](std::string_view vertices, std::string_view faces) {
    return error_of(replaced(replaced(ascii(), "vertex 4", fmt::format("vertex {}", vertices)), "face 4",
                             fmt::format("face {}", faces)));
  };
  EXPECT_EQ(with_counts("9000000000000000000", "4"),
            "line 3: 9000000000000000000 elements vertex: at most 4000000 are read");
  EXPECT_EQ(with_counts("4", "99999999999999999999999"),
            "line 7: 9223372036854775807 elements face: at most 4000000 are read");
  EXPECT_EQ(with_counts("3000000", "4"), "line 14: '2' is more than the header announces") << "no memory is asked for";
  EXPECT_EQ(with_counts("0", "4"), "line 10: index 1 does not exist: there are no vertices")
      << "the first vertex is read as a face";
}

TEST(ReadPly, limits_are_no_hindrance_where_they_are_just_kept) {
  for (const std::string& format : kPlyFormatNames) {
    const std::string file = write_ply(tetrahedron(), format);
    const auto refusal = [&](const ReadLimits& limits) {
      const Result<CheckedCage> cage = read_checked_cage(file, limits);
      return cage ? "" : cage.error().message;
    };
    EXPECT_EQ(refusal({file.size(), 4, 4, 3}), "");
    EXPECT_EQ(refusal({file.size() - 1, 4, 4, 3}), fmt::format("the file has more than {} bytes", file.size() - 1));
    EXPECT_EQ(refusal({1000, 3, 4, 3}), "line 3: 4 elements vertex: at most 3 are read");
    EXPECT_EQ(refusal({1000, 4, 3, 3}), "line 7: 4 elements face: at most 3 are read");
    EXPECT_EQ(refusal({1000, 4, 4, 2}), format == "ascii" ? "line 14: a face of more than 2 vertices"
                                                          : "'face' 1: a face of more than 2 vertices");
  }
}

TEST(CageText, is_the_text_itself_or_of_bytes_the_same_cage_as_obj) {
  for (const std::string& text : {tetrahedron_obj(), tetrahedron_off(), ascii(), std::string("nonsense")}) {
    EXPECT_EQ(cage_text(text).value(), text);
  }
  Cage cage = generate_cage("two-3").value();
  cage.vertices /= 3;
  std::reverse(cage.faces[2].begin(), cage.faces[2].end());  // to be repaired, and told of, by whoever reads the text
  for (const char* format : {"binary_little_endian", "binary_big_endian"}) {
    const std::string file = write_ply(cage, format);
    const std::string text = cage_text(file).value();
    EXPECT_EQ(text, write_obj(cage));
    const CheckedCage from_text = read_checked_cage(text).value(), from_bytes = read_checked_cage(file).value();
    EXPECT_EQ(from_text.cage.vertices, from_bytes.cage.vertices);
    EXPECT_EQ(from_text.cage.faces, from_bytes.cage.faces);
    EXPECT_EQ(from_text.report.repairs,
              std::vector<std::string>{"turned 1 face, so that all faces agree on one side as the outside"});
    EXPECT_EQ(cage_text(file.substr(0, file.size() - 1)).error().message,
              fmt::format("'face' {}: the file ends before 'vertex_indices'", cage.faces.size()));
    EXPECT_EQ(cage_text(replaced(file, "1.0", "1.1")).error().message,
              "line 2: version '1.1' of the format is not 1.0");
    cage.faces.front() = {0, 1};
    EXPECT_EQ(cage_text(write_ply(cage, format)).error().message, "face 1 has 2 vertices");
    cage.faces.front() = from_bytes.cage.faces.front();
  }
}

}  // namespace umbilic::test
