// SPDX-License-Identifier: MIT
/// \file
/// Generated open cages: what their boundary states, where their limit surface lies, counts, symmetry and ranges.
#include "cage/open_cages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "cage/boundary.h"
#include "cage/generate.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;

/// The part of the cage that is surface.
Cage surface_of(const Cage& cage) {
  const std::set<int> holes(cage.holes.begin(), cage.holes.end());
  Cage surface{cage.vertices};
  for (int f = 0; f < static_cast<int>(cage.faces.size()); ++f) {
    if (holes.count(f) == 0) surface.faces.push_back(cage.faces[f]);
  }
  return surface;
}

/// What the three points across the boundary say at a vertex: C, D and E of open_cages.h.
struct Across {
  Vector3 c, d, e;
};

/// Along each loop of a surface whose boundary vertices all have two faces and two holes.
std::vector<std::vector<Across>> boundary_splines(const Cage& cage) {
  const std::set<int> holes(cage.holes.begin(), cage.holes.end());
  std::vector<std::vector<Across>> splines;
  for (const std::vector<int>& loop : boundary_loops(surface_of(cage))) {
    splines.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int v = loop[i], before = loop[(i + loop.size() - 1) % loop.size()];
      std::map<bool, int> across;  // by whether it is in a hole
      for (int f = 0; f < static_cast<int>(cage.faces.size()); ++f) {
        const std::vector<int>& face = cage.faces[f];
        for (int k = 0; k < 4; ++k) {
          if (face[k] != v) continue;
          if (face[(k + 3) % 4] == before) across[holes.count(f) > 0] = face[(k + 1) % 4];
          if (face[(k + 1) % 4] == before) across[holes.count(f) > 0] = face[(k + 3) % 4];
        }
      }
      const Vector3 p = cage.vertices.row(v), g = cage.vertices.row(across.at(true)),
                    q = cage.vertices.row(across.at(false));
      splines.back().push_back({(g + 4 * p + q) / 6, (q - g) / 2, g - 2 * p + q});
    }
  }
  return splines;
}

/// The closed cubic spline with the control points `of(i)` at the parameter i + t.
template <class Of>
Vector3 spline(int count, int i, double t, const Of& of) {
  const double s = 1 - t;
  const double weights[] = {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
                            t * t * t / 6};
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 4; ++k) sum += weights[k] * of((i + k + count - 1) % count);
  return sum;
}

Vector3 turned(const Vector3& x, double angle) { return Eigen::AngleAxisd(angle, Vector3::UnitZ()) * x; }

/// Expects each loop to interpolate at its knots a circle with C, D and E, which are given at angle 0.
void expect_boundaries(const Cage& cage, const std::vector<Across>& exact) {
  const std::vector<std::vector<Across>> splines = boundary_splines(cage);
  ASSERT_EQ(splines.size(), exact.size());
  for (std::size_t b = 0; b < splines.size(); ++b) {
    const auto count = static_cast<int>(splines[b].size());
    for (int i = 0; i < count; ++i) {
      const Vector3 c = spline(count, i, 0, [&](int k) { return splines[b][k].c; });
      const Vector3 d = spline(count, i, 0, [&](int k) { return splines[b][k].d; });
      const Vector3 e = spline(count, i, 0, [&](int k) { return splines[b][k].e; });
      const double angle = std::atan2(c.y(), c.x());
      // E is a difference of points that cancels, which costs a digit.
      EXPECT_LT((c - turned(exact[b].c, angle)).norm(), 1e-14);
      EXPECT_LT((d - turned(exact[b].d, angle)).norm(), 1e-14);
      EXPECT_LT((e - turned(exact[b].e, angle)).norm(), 1e-14);
    }
  }
}

Vector3 limit_at(const Cage& cage, int vertex) {
  Vector3 sum = Vector3::Zero();
  double n = 0;
  for (const std::vector<int>& face : cage.faces) {
    for (int k = 0; k < 4; ++k) {
      if (face[k] != vertex) continue;
      ++n;
      sum += 2 * (cage.vertices.row(face[(k + 1) % 4]) + cage.vertices.row(face[(k + 3) % 4])) +
             cage.vertices.row(face[(k + 2) % 4]);
    }
  }
  return (n * n * cage.vertices.row(vertex).transpose() + sum) / (n * (n + 5));
}

/// The vertices that have all their faces.
std::vector<int> inner_vertices(const Cage& cage) {
  std::set<int> outer;
  for (const std::vector<int>& loop : boundary_loops(Cage{cage.vertices, cage.faces})) {
    outer.insert(loop.begin(), loop.end());
  }
  std::vector<int> inner;
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    if (outer.count(v) == 0) inner.push_back(v);
  }
  return inner;
}

std::map<int, int> inner_valences(const Cage& cage) {
  std::vector<int> valence(cage.vertices.rows(), 0);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) ++valence[v];
  }
  std::map<int, int> histogram;
  for (const int v : inner_vertices(cage)) ++histogram[valence[v]];
  return histogram;
}

/// What is said of the cage with its holes is what is said of its surface alone.
void expect_report_of_surface(const CageReport& whole, const CageReport& surface, std::size_t holes) {
  EXPECT_EQ(whole.holes, static_cast<int>(holes));
  EXPECT_EQ(whole.vertices, surface.vertices);
  EXPECT_EQ(whole.edges, surface.edges);
  EXPECT_EQ(whole.faces, surface.faces);
  EXPECT_EQ(whole.genus, surface.genus);
  ASSERT_EQ(whole.boundaries.size(), surface.boundaries.size());
  for (std::size_t i = 0; i < whole.boundaries.size(); ++i) {
    EXPECT_EQ(whole.boundaries[i].number, surface.boundaries[i].number);
    EXPECT_EQ(whole.boundaries[i].vertices, surface.boundaries[i].vertices);
    EXPECT_EQ(whole.boundaries[i].first_vertex, surface.boundaries[i].first_vertex);
  }
}

const char* const kOpenNames[] = {"disk", "cylinder", "catenoid", "spherical-cap", "n-sided"};

TEST(OpenCages, have_their_surface_first_and_a_ring_of_holes_last) {
  for (const char* name : kOpenNames) {
    const Cage cage = *generate_cage(name);
    const std::set<int> holes(cage.holes.begin(), cage.holes.end());
    ASSERT_FALSE(holes.empty()) << name;
    EXPECT_TRUE(std::is_sorted(cage.holes.begin(), cage.holes.end()));
    EXPECT_EQ(*holes.begin(), static_cast<int>(cage.faces.size() - holes.size())) << name;
    Cage surface = surface_of(cage), whole = cage;
    EXPECT_TRUE(validate(whole)->repairs.empty()) << name << ": holes are oriented with the surface";
    const CageReport report = *validate(surface);
    EXPECT_EQ(report.genus, 0);
    const bool annulus = std::string_view(name) == "cylinder" || std::string_view(name) == "catenoid";
    EXPECT_EQ(report.boundaries.size(), annulus ? 2u : 1u) << name;
    expect_report_of_surface(*validate(whole), report, holes.size());
    // Each face of the surface has its whole neighbourhood, and no hole is farther away.
    const std::vector<int> inner = inner_vertices(cage);
    std::set<int> on_surface;
    for (const std::vector<int>& face : surface_of(cage).faces) on_surface.insert(face.begin(), face.end());
    EXPECT_EQ(std::set<int>(inner.begin(), inner.end()), on_surface) << name;
  }
}

TEST(OpenCages, state_position_slope_and_curvature_of_their_boundary_circles_exactly_at_the_knots) {
  const CageOptions options{.major_segments = 32, .minor_segments = 6, .radius = 0.5, .height = 2};
  expect_boundaries(*generate_cage("cylinder", options),
                    {{{0.5, 0, -1}, {0, 0, 1. / 3}, {0, 0, 0}}, {{0.5, 0, 1}, {0, 0, -1. / 3}, {0, 0, 0}}});
  const double ring = 1 / (6 + 32 / 8.);
  expect_boundaries(*generate_cage("disk", options), {{{0.5, 0, 0}, {-0.5 * ring, 0, 0}, {0, 0, 0}}});
  for (const double degrees : {30., 90., 150.}) {
    CageOptions cap = options;
    cap.half_angle = degrees;
    cap.radius = 1;
    const double angle = degrees * pi / 180, pace = angle * ring;
    const Vector3 at(std::sin(angle), 0, std::cos(angle)), inward(-std::cos(angle), 0, std::sin(angle));
    expect_boundaries(*generate_cage("spherical-cap", cap), {{at, pace * inward, -pace * pace * at}});
  }
  // By arc length s from the waist: (sqrt(1 + s^2), asinh s), with curvature 1 / (1 + s^2) away from the axis.
  for (const double height : {1., 2.}) {
    const double half = height / 2, s = std::sinh(half), r = std::cosh(half), step = 2 * s / 6;
    const Vector3 down(r, 0, -half), up(r, 0, half);
    const double bend = step * step / (r * r * r), slope = step / r;
    CageOptions chain = options;
    chain.height = height;
    expect_boundaries(*generate_cage("catenoid", chain), {{down, slope * Vector3(-s, 0, 1), bend * Vector3(1, 0, s)},
                                                          {up, slope * Vector3(-s, 0, -1), bend * Vector3(1, 0, -s)}});
  }
}

TEST(OpenCages, have_boundary_curves_that_approach_circles_like_the_fourth_power_of_their_edges) {
  double last = 0;
  for (const int around : {8, 16, 32, 64}) {
    const Cage cage = *generate_cage("disk", {.major_segments = around});
    const std::vector<Across> points = boundary_splines(cage)[0];
    double most = 0;
    for (int i = 0; i < around; ++i) {
      for (const double t : {0.25, 0.5, 0.75}) {
        most = std::max(most, std::abs(spline(around, i, t, [&](int k) { return points[k].c; }).norm() - 1));
      }
    }
    const double factor = around == 8 ? 16 : last / most;
    EXPECT_NEAR(factor, 16, 2) << around << "; the next order adds an eighth where 8 become 16";
    if (around == 32) {
      EXPECT_LT(most, 4e-6);
      EXPECT_GT(most, 1e-6);
    }
    last = most;
  }
}

TEST(OpenCages, have_limit_surfaces_through_the_exact_ones_at_vertices_away_from_the_boundary) {
  // |f| is the distance to first order. Vertices on the boundary are exact, those next to it of the spline's order.
  const auto distance = [](std::string_view name, const Vector3& x) {
    const double r = std::hypot(x.x(), x.y());
    if (name == "cylinder") return std::abs(r - 1);
    if (name == "catenoid") return std::abs(r - std::cosh(x.z())) / std::cosh(x.z());
    if (name == "spherical-cap") return std::abs(x.norm() - 1);
    return std::abs(x.z());
  };
  for (const char* name : kOpenNames) {
    const Cage cage = *generate_cage(name);
    std::set<int> boundary, next;
    for (const int f : cage.holes) boundary.insert(cage.faces[f].begin(), cage.faces[f].end());
    for (const std::vector<int>& face : cage.faces) {
      const bool touches = std::any_of(face.begin(), face.end(), [&](int v) { return boundary.count(v) > 0; });
      if (touches) next.insert(face.begin(), face.end());
    }
    for (const int v : inner_vertices(cage)) {
      if (boundary.count(v) > 0) continue;
      EXPECT_LT(distance(name, limit_at(cage, v)), next.count(v) > 0 ? 1e-3 : 1e-8) << name << " at " << v;
    }
  }
}

TEST(OpenCages, have_few_extraordinary_vertices) {
  EXPECT_EQ(inner_valences(*generate_cage("cylinder")), (std::map<int, int>{{4, 32 * 11}}));
  EXPECT_EQ(inner_valences(*generate_cage("disk")), (std::map<int, int>{{3, 4}, {4, 32 * 4 + 49 - 4}}));
  EXPECT_EQ(inner_valences(*generate_cage("spherical-cap", {.minor_segments = 2})),
            (std::map<int, int>{{3, 4}, {4, 32 * 3 + 49 - 4}}));
  for (int sides = 3; sides <= 12; ++sides) {
    const Cage cage = *generate_cage("n-sided", {.major_segments = 6, .sides = sides});
    EXPECT_EQ(cage.faces.size() - cage.holes.size(), static_cast<std::size_t>(9 * sides));
    std::map<int, int> found = inner_valences(cage);
    const int vertices = 9 * sides + 3 * sides + 1;  // of each side 9 and its spoke's 3, and the middle
    EXPECT_EQ(found[4] + (sides == 4 ? 0 : found[sides]), vertices) << "the boundary and its corners are regular";
    EXPECT_EQ(found[sides], sides == 4 ? vertices : 1) << "the middle";
  }
}

TEST(OpenCages, are_symmetric) {
  const auto expect_symmetric = [](const Cage& cage, const Eigen::Matrix3d& isometry) {
    const Points images = cage.vertices * isometry.transpose();
    for (const auto& image : images.rowwise()) {
      ASSERT_LT((cage.vertices.rowwise() - image).rowwise().norm().minCoeff(), 1e-12);
    }
  };
  const auto turn = [](int n) { return Eigen::AngleAxisd(2 * pi / n, Vector3::UnitZ()).toRotationMatrix(); };
  const Eigen::Matrix3d across = Vector3(1, -1, 1).asDiagonal(), upside_down = Vector3(1, 1, -1).asDiagonal();
  for (const char* name : kOpenNames) {
    const Cage cage = *generate_cage(name);
    const std::string_view view = name;
    const bool annulus = view == "cylinder" || view == "catenoid";
    expect_symmetric(cage, turn(annulus ? 32 : view == "n-sided" ? 5 : 4));
    expect_symmetric(cage, across);
    if (view != "spherical-cap") expect_symmetric(cage, upside_down);
  }
  for (const int sides : {3, 4, 8}) {
    const Cage saddle = *generate_cage("n-sided", {.sides = sides, .rise = 0.5});
    expect_symmetric(saddle, turn(sides));
    expect_symmetric(saddle, across);
  }
}

TEST(OpenCages, of_n_sides_have_straight_evenly_divided_sides_that_end_in_the_corners) {
  const Cage cage = *generate_cage("n-sided", {.major_segments = 4, .radius = 2, .sides = 3});
  // A corner's limit is itself, as the diagonal point beyond is mirrored in both sides.
  for (int i = 0; i < 3; ++i) {
    const Vector3 corner(2 * std::cos(2 * pi * i / 3), 2 * std::sin(2 * pi * i / 3), 0);
    double nearest = 1;
    for (const int v : inner_vertices(cage)) nearest = std::min(nearest, (limit_at(cage, v) - corner).norm());
    EXPECT_LT(nearest, 1e-14);
  }
  for (const std::vector<int>& loop : boundary_loops(surface_of(cage))) {
    EXPECT_EQ(loop.size(), 12u);
    for (const int v : loop) EXPECT_LT((limit_at(cage, v) - cage.vertices.row(v).transpose()).norm(), 1e-14);
  }
}

TEST(OpenCages, of_n_sides_are_flat_without_a_rise_and_with_it_lie_above_the_same_points) {
  for (int sides = 3; sides <= 12; ++sides) {
    const Points flat = generate_cage("n-sided", {.sides = sides})->vertices;
    EXPECT_TRUE((flat.col(2).array() == 0).all());
    EXPECT_FALSE(flat.col(2).array().unaryExpr([](double z) { return std::signbit(z); }).any())
        << "would be written -0";
    const Points saddle = generate_cage("n-sided", {.sides = sides, .rise = -0.5})->vertices;
    EXPECT_EQ(saddle.leftCols(2), flat.leftCols(2));
  }
}

TEST(OpenCages, of_n_sides_with_a_rise_have_their_control_points_on_a_harmonic_saddle) {
  const double radius = 2, rise = 0.75;
  const auto expect_on = [&](int sides, const auto& polynomial) {
    const Cage cage = *generate_cage("n-sided", {.major_segments = 4, .radius = radius, .sides = sides, .rise = rise});
    for (const auto& point : cage.vertices.rowwise()) {
      EXPECT_NEAR(point.z(), rise * polynomial(point.x() / radius, point.y() / radius), 1e-13);
    }
  };
  expect_on(3, [](double x, double y) { return x * x * x - 3 * x * y * y; });
  expect_on(4, [](double x, double y) { return x * x * x * x - 6 * x * x * y * y + y * y * y * y; });
  const Cage cage = *generate_cage("n-sided", {.radius = radius, .sides = 7, .rise = rise});
  for (int i = 0; i < 7; ++i) {
    const Vector3 corner(radius * std::cos(2 * pi * i / 7), radius * std::sin(2 * pi * i / 7), rise);
    EXPECT_LT((cage.vertices.rowwise() - corner.transpose()).rowwise().norm().minCoeff(), 1e-13);
  }
}

TEST(OpenCages, are_refused_out_of_range_by_name) {
  const auto option_error = [](std::string_view name, const CageOptions& options) {
    const Result<Cage> cage = generate_cage(name, options);
    return cage ? "" : cage.error().message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0., -1., nan, 101., std::numeric_limits<double>::infinity()}) {
    for (const char* name : {"disk", "cylinder", "spherical-cap", "n-sided"}) {
      const std::string message = option_error(name, {.radius = bad});
      EXPECT_EQ(message.rfind("radius ", 0), 0u) << message;
      EXPECT_NE(message.find(" is not between 0.01 and 100"), std::string::npos) << message;
    }
    EXPECT_EQ(option_error("cylinder", {.height = bad}).rfind("height ", 0), 0u);
    EXPECT_EQ(option_error("catenoid", {.height = bad}).rfind("height ", 0), 0u);
    EXPECT_EQ(option_error("catenoid", {.waist = bad}).rfind("waist ", 0), 0u);
  }
  EXPECT_EQ(option_error("catenoid", {.height = 6, .waist = 0.5}), "height 6 is not between 0.01 and 5");
  EXPECT_EQ(option_error("spherical-cap", {.half_angle = 180}), "half_angle 180 is not between 1 and 179");
  EXPECT_EQ(option_error("spherical-cap", {.half_angle = nan}), "half_angle nan is not between 1 and 179");
  EXPECT_EQ(option_error("disk", {.major_segments = 30}), "30 segments around are not 8 to 1000 and divisible by 4");
  EXPECT_EQ(option_error("disk", {.minor_segments = 1}), "1 segments across are not 2 to 200");
  EXPECT_EQ(option_error("cylinder", {.major_segments = 1001}), "1001 segments around are not 8 to 1000");
  EXPECT_EQ(option_error("cylinder", {.minor_segments = 2}), "2 segments across are not 3 to 1000");
  EXPECT_EQ(option_error("cylinder", {.minor_segments = -1}), "-1 segments across are not 3 to 1000");
  EXPECT_EQ(option_error("n-sided", {.sides = 13}), "sides 13 is not between 3 and 12");
  EXPECT_EQ(option_error("n-sided", {.rise = -101}), "rise -101 is not between -100 and 100");
  EXPECT_EQ(option_error("n-sided", {.rise = nan}), "rise nan is not between -100 and 100");
  EXPECT_EQ(option_error("n-sided", {.major_segments = 5}), "5 segments along a side are not 2 to 100 and even");
  EXPECT_EQ(option_error("n-sided", {.major_segments = 8, .minor_segments = 3}),
            "3 segments across are not half of the 8 along a side");
  for (const int across : {3, 4, 5, 40}) EXPECT_EQ(option_error("catenoid", {.minor_segments = across}), "") << across;
}

TEST(OpenCages, have_quads_about_square_at_their_boundary_by_default) {
  EXPECT_EQ(with_default_segments("cylinder", {}).minor_segments, 10);
  EXPECT_EQ(with_default_segments("cylinder", {.radius = 0.3}).minor_segments, 34);
  EXPECT_EQ(with_default_segments("spherical-cap", {.half_angle = 150}).minor_segments, 9);
  EXPECT_EQ(with_default_segments("spherical-cap", {.half_angle = 30}).minor_segments, 3);
  EXPECT_EQ(with_default_segments("n-sided", {}).minor_segments, 4);
  EXPECT_EQ(with_default_segments("torus", {}).major_segments, 6);
  EXPECT_EQ(with_default_segments("torus", {}).minor_segments, 8);
}

}  // namespace
}  // namespace umbilic::test
