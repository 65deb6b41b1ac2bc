// SPDX-License-Identifier: MIT
/// \file
/// The generated cages: names, counts, genus, valences, options.
#include "cage/generate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "cages.h"

namespace umbilic::test {

namespace {

using std::numbers::pi;

std::string refusal_of(std::string_view name, const CageOptions& options) {
  const Result<Cage> cage = generate_cage(name, options);
  return cage ? "" : cage.error().message;
}

/// How many vertices there are of each valence.
std::map<int, int> valences(const Cage& cage) {
  std::vector<int> valence(cage.vertices.rows(), 0);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) ++valence[v];
  }
  std::map<int, int> histogram;
  for (const int n : valence) ++histogram[n];
  return histogram;
}

std::map<int, int> face_sizes(const Cage& cage) {
  std::map<int, int> histogram;
  for (const std::vector<int>& face : cage.faces) ++histogram[static_cast<int>(face.size())];
  return histogram;
}

}  // namespace

TEST(GenerateCage, every_cage_is_valid_outward_and_of_the_genus_it_is_listed_with) {
  ASSERT_EQ(cage_names().size(), 27u);
  for (const CageName& name : cage_names()) {
    for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
      CageOptions options;
      options.family = family;
      const Cage cage = generate_cage(name.name, options).value();
      Cage validated = cage;
      const Result<CageReport> report = validate(validated);
      ASSERT_TRUE(report.ok()) << name.name << ": " << report.error().message;
      EXPECT_EQ(report->genus, name.genus) << name.name;
      EXPECT_EQ(report->components.size(), 1u) << name.name;
      EXPECT_EQ(validated.faces, cage.faces) << name.name << " is outward";
      EXPECT_EQ(validated.vertices, cage.vertices) << name.name << " has no unused vertex";
      EXPECT_NE(name.description.find("genus " + std::to_string(name.genus)), std::string::npos);
    }
  }
}

TEST(GenerateCage, a_frame_has_genus_edges_minus_vertices_plus_1) {
  std::map<std::string, int> genus;
  for (const CageName& name : cage_names()) genus[name.name] = name.genus;
  for (int arms = 3; arms <= 12; ++arms) EXPECT_EQ(genus.at("two-" + std::to_string(arms)), arms - 1);
  EXPECT_EQ(genus.at("tetrahedron-frame"), 6 - 4 + 1);
  EXPECT_EQ(genus.at("cube-frame"), 12 - 8 + 1);
  EXPECT_EQ(genus.at("octahedron-frame"), 12 - 6 + 1);
  EXPECT_EQ(genus.at("hexagonal-prism-frame"), 18 - 12 + 1);
  EXPECT_EQ(genus.at("truncated-tetrahedron-frame"), 18 - 12 + 1);
  EXPECT_EQ(genus.at("dodecahedron-frame"), 30 - 20 + 1);
  EXPECT_EQ(genus.at("triangular-prism-frame"), 9 - 6 + 1);
  EXPECT_EQ(genus.at("pentagonal-prism-frame"), 15 - 10 + 1);
  EXPECT_EQ(genus.at("cuboctahedron-frame"), 24 - 12 + 1);
  EXPECT_EQ(genus.at("icosahedron-frame"), 30 - 12 + 1);
  EXPECT_EQ(genus.at("cube"), 0);
  EXPECT_EQ(genus.at("torus"), 1);
}

TEST(GenerateCage, the_only_extraordinary_vertices_of_a_flag_cage_are_its_axis_points) {
  const auto expect = [](const char* name, const std::map<int, int>& expected) {
    const Cage cage = generate_cage(name).value();
    EXPECT_EQ(valences(cage), expected) << name;
    EXPECT_EQ(face_sizes(cage).size(), 1u) << name << " has quads only";
  };
  expect("two-3", {{6, 4}, {4, 18}});
  expect("two-12", {{24, 4}, {4, 72}});
  expect("tetrahedron-frame", {{6, 8}, {4, 36}});
  expect("octahedron-frame", {{8, 12}, {4, 72}});
  expect("dodecahedron-frame", {{6, 40}, {4, 180}});
  EXPECT_EQ(generate_cage("two-3")->faces.size(), 24u);
}

TEST(GenerateCage, a_hub_cage_has_two_polygons_per_junction_and_corners_of_valence_5) {
  const auto expect = [](const char* name, const std::map<int, int>& corners, const std::map<int, int>& faces) {
    CageOptions options;
    options.family = FrameFamily::kHub;
    const Cage cage = generate_cage(name, options).value();
    EXPECT_EQ(valences(cage), corners) << name;
    EXPECT_EQ(face_sizes(cage), faces) << name;
  };
  expect("two-3", {{5, 12}, {4, 12}}, {{3, 4}, {4, 24}});
  expect("two-5", {{5, 20}, {4, 20}}, {{5, 4}, {4, 40}});
  expect("cube-frame", {{5, 48}, {4, 48}}, {{3, 16}, {4, 96}});
}

TEST(GenerateCage, a_torus_has_no_extraordinary_vertex_and_the_radii_that_were_asked_for) {
  CageOptions options;
  options.ratio = 0.3;
  options.major_segments = 5;
  options.minor_segments = 7;
  const Cage torus = generate_cage("torus", options).value();
  EXPECT_EQ(valences(torus), (std::map<int, int>{{4, 35}}));
  for (const auto& point : torus.vertices.rowwise()) {
    EXPECT_NEAR(std::hypot(std::hypot(point.x(), point.y()) - 1, point.z()), 0.3, 1e-15);
  }
  options.thickness = 2;
  const Cage fat = generate_cage("torus", options).value();
  EXPECT_NEAR(fat.vertices.col(2).maxCoeff(), 0.6 * std::sin(2 * pi * 2 / 7), 1e-15);
}

TEST(GenerateCage, thickness_scales_the_width_of_the_arms) {
  for (const double thickness : {0.5, 1., 1.5}) {
    CageOptions options;
    options.thickness = thickness;
    const Cage frame = generate_cage("tetrahedron-frame", options).value();
    const Eigen::VectorXd radius = frame.vertices.rowwise().norm();
    EXPECT_NEAR(radius.maxCoeff(), 1 + thickness / 3, 1e-14);
    EXPECT_NEAR(radius.minCoeff(), 1 - thickness / 3, 1e-14);
  }
}

TEST(GenerateCage, spread_moves_the_arms_and_not_the_junctions_of_two_junction_frames) {
  CageOptions options;
  for (const double spread : {0.5, 1., 3.}) {
    options.spread = spread;
    const Cage frame = generate_cage("two-3", options).value();
    const double half_width = std::min(1., spread) / 3;
    EXPECT_NEAR(frame.vertices.col(2).maxCoeff(), 1 + half_width, 1e-14);
    EXPECT_NEAR(frame.vertices.leftCols(2).rowwise().norm().maxCoeff(), spread + half_width, 1e-14);
  }
  EXPECT_EQ(generate_cage("cube-frame", options)->vertices, generate_cage("cube-frame")->vertices) << "no spread there";
}

TEST(GenerateCage, unknown_names_are_answered_with_the_known_ones) {
  for (const char* name : {"", "two-2", "two-13", "two-03", "Cube", "tetrahedron"}) {
    const std::string message = refusal_of(name, {});
    EXPECT_EQ(message.rfind(std::string("there is no cage called ") + name + "; there are cube, torus, two-3, ", 0), 0u)
        << message;
  }
  EXPECT_EQ(refusal_of(std::string("a\0\x1b[2J", 6), {}).rfind("there is no cage called a??[2J; there are ", 0), 0u)
      << "what a terminal would obey is not printed";
}

TEST(GenerateCage, options_out_of_range_are_answered_with_the_range) {
  const auto with = [](auto set) {
    CageOptions options;
    set(options);
    return options;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double thickness : {0., -1., 0.001, 2.26, 1e300, nan, std::numeric_limits<double>::infinity()}) {
    const std::string message = refusal_of("tetrahedron-frame", with([&](auto& o) { o.thickness = thickness; }));
    EXPECT_NE(message.find(" is not between 0.01 and 2.25"), std::string::npos) << message;
  }
  EXPECT_EQ(refusal_of("tetrahedron-frame", with([](auto& o) { o.thickness = 2.25; })), "");
  EXPECT_EQ(refusal_of("tetrahedron-frame", with([](auto& o) { o.thickness = 0.01; })), "");
  for (const double spread : {0., -1., 0.4, 3.5, nan}) {
    const std::string message = refusal_of("two-4", with([&](auto& o) { o.spread = spread; }));
    EXPECT_NE(message.find(" is not between 0.5 and 3"), std::string::npos) << message;
  }
  for (const double ratio : {0., -1., 1., 2., nan}) {
    const std::string message = refusal_of("torus", with([&](auto& o) { o.ratio = ratio; }));
    EXPECT_NE(message.find(" is not between 0 and 1"), std::string::npos) << message;
  }
  EXPECT_EQ(refusal_of("torus", with([](auto& o) { o.thickness = 2; })),
            "thickness 2 is not at least 0.01 and less than 2 (1 / ratio)");
  EXPECT_EQ(refusal_of("torus", with([](auto& o) { o.major_segments = 2; })), "2 segments are not 3 to 1000");
  EXPECT_EQ(refusal_of("torus", with([](auto& o) { o.minor_segments = 1001; })), "1001 segments are not 3 to 1000");
}

}  // namespace umbilic::test
