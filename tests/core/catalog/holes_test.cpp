// SPDX-License-Identifier: MIT
/// \file
/// The catalog's holes: their settings, their minimizers beside the saddle over their polygon, and how they are stored.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "catalog/catalog_json.h"
#include "catalog/comparison.h"
#include "catalog/entry.h"
#include "problem/text.h"

namespace umbilic::catalog {
namespace {

const CatalogFunctional& mvs_cross() { return functional_called("mvs_cross"); }

Entry hole(int sides, int last_level) {
  const CatalogShape& shape = shape_called("hole-" + std::to_string(sides));
  return *compute_entry(shape, mvs_cross(), entry_settings(shape, mvs_cross(), last_level),
                        [](const umbilic::Run&) { return true; });
}

/// The principal curvatures of the monkey saddle z = h (x^3 - 3 x y^2), and its metric's E, F, G.
struct Saddle {
  std::array<double, 2> k;
  double e, f, g;
};

Saddle monkey_saddle(double h, double x, double y) {
  const double zx = 3 * h * (x * x - y * y), zy = -6 * h * x * y, zxx = 6 * h * x, zxy = -6 * h * y;
  const double e = 1 + zx * zx, f = zx * zy, g = 1 + zy * zy, area = e * g - f * f;
  const double gauss = -(zxx * zxx + zxy * zxy) / (area * area);
  const double mean = (zxx * (g - e) - 2 * f * zxy) / (2 * std::pow(area, 1.5));
  const double root = std::sqrt(mean * mean - gauss);
  return {{mean + root, mean - root}, e, f, g};
}

/// Its area times the integral of |grad k1|^2 + |grad k2|^2 over the equilateral triangle about the origin, of
/// circumradius 1: by midpoints over one of three parts, with differences.
double mvs_cross_of_the_monkey_saddle(double h) {
  constexpr int kSteps = 200;
  constexpr double kDifference = 1e-5;
  double area = 0, integral = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double u = (i + 0.5) / kSteps, v = (j + 0.5) / kSteps;
      const double x = u * (1 - 1.5 * v), y = u * v * std::sqrt(0.75), cell = u * std::sqrt(0.75) / kSteps / kSteps;
      const Saddle at = monkey_saddle(h, x, y);
      const double root = std::sqrt(at.e * at.g - at.f * at.f);
      area += cell * root;
      for (int c = 0; c < 2; ++c) {
        const double kx = monkey_saddle(h, x + kDifference, y).k[c] - monkey_saddle(h, x - kDifference, y).k[c];
        const double ky = monkey_saddle(h, x, y + kDifference).k[c] - monkey_saddle(h, x, y - kDifference).k[c];
        const double square = at.g * kx * kx - 2 * at.f * kx * ky + at.e * ky * ky;
        integral += cell * square / root / (4 * kDifference * kDifference);
      }
    }
  }
  return 9 * area * integral;
}

TEST(CatalogHoles, have_an_entry_for_mvs_cross_only_and_no_known_energy) {
  int holes = 0;
  for (const CatalogShape& shape : catalog_shapes()) {
    for (const CatalogFunctional& functional : catalog_functionals()) {
      EXPECT_EQ(has_entry(shape, functional), !shape.hole() || functional.name == "mvs_cross");
      if (!shape.hole()) continue;
      EXPECT_FALSE(exact_energy(shape, functional));
      EXPECT_FALSE(paper_energy(shape, functional));
    }
    if (!shape.hole()) continue;
    EXPECT_EQ(shape.name, "hole-" + std::to_string(3 + holes));
    ++holes;
  }
  EXPECT_EQ(holes, 6);
}

TEST(CatalogHoles, are_saddles_whose_curvature_is_held_at_the_boundary) {
  for (const CatalogShape& shape : catalog_shapes()) {
    const EntrySettings settings = entry_settings(shape, mvs_cross(), 6);
    EXPECT_EQ(settings.constraints.boundary.has_value(), shape.hole());
    if (!shape.hole()) continue;
    EXPECT_EQ(settings.constraints.boundary->condition, BoundaryCondition::kCurvature);
    EXPECT_EQ(settings.cage.sides, shape.sides);
    EXPECT_EQ(settings.cage.rise, kHoleRise);
    EXPECT_FALSE(settings.second_family) << "there is but one cage";
    EXPECT_FALSE(settings.descends);
    EXPECT_EQ(settings.shown_level.value_or(settings.run.last_level), 4);
    EXPECT_EQ(settings.run.last_level, shape.sides > 6 ? 5 : 4);
  }
}

TEST(CatalogHoles, of_three_sides_have_less_energy_than_the_monkey_saddle_and_than_their_start) {
  const Entry found = hole(3, 2);
  const double saddle = mvs_cross_of_the_monkey_saddle(kHoleRise);
  EXPECT_NEAR(saddle, 5.4584, 1e-4);
  EXPECT_GT(found.result.energy_reported, 0.9 * saddle);
  EXPECT_LT(found.result.energy_reported, saddle);

  EntrySettings settings = entry_settings(found.shape, mvs_cross(), 2);
  settings.run.first_level = 2;
  settings.run.max_iterations = 1;
  const Entry start = *compute_entry(found.shape, mvs_cross(), settings, [](const umbilic::Run&) { return true; });
  EXPECT_LT(found.result.energy_reported, 0.998 * start.result.energy_reported) << "after one iteration";
}

TEST(CatalogHoles, keep_the_symmetry_of_their_polygon_and_are_held_at_their_boundary) {
  for (const int sides : {3, 8}) {
    const Entry found = hole(sides, 1);
    EXPECT_EQ(found.group.name, "C" + std::to_string(sides) + "v");
    EXPECT_EQ(found.group.order, 2 * sides);
    ASSERT_TRUE(found.constraints);
    ASSERT_EQ(found.constraints->boundaries.size(), 1u);
    EXPECT_GT(found.constraints->boundaries[0].total, 0);
    EXPECT_GT(found.constraints->deviation, 1e-3) << "within it is free";
    ASSERT_TRUE(found.certificate);
    EXPECT_EQ(found.certificate->gauge, 0) << "it cannot be moved as a whole";
    ASSERT_TRUE(found.energies.free);
    EXPECT_DOUBLE_EQ(found.energies.free->functionals[kMvsCross], found.result.energy_reported);
  }
}

TEST(CatalogHoles, are_stored_with_their_constraints_and_their_file_holds_their_surface) {
  const Entry found = hole(4, 1);
  const Json stored = json_of(found);
  const std::string minimizer = minimizer_text(found, "1.2.3");
  EXPECT_EQ(misfit(Json::parse(stored.dump()), minimizer), "");
  const Report report = *parse_report(minimizer);
  ASSERT_TRUE(report.problem.constraints.boundary);
  EXPECT_EQ(report.problem.constraints.boundary->condition, BoundaryCondition::kCurvature);
  ASSERT_TRUE(report.constraints);
  EXPECT_EQ(report.constraints->boundaries.size(), 1u);

  const Json shapes = empty_catalog("1.2.3").at("shapes");
  const Json &sphere = shapes[shapes.size() - 7], &listed = shapes.back();
  EXPECT_EQ(listed.at("sides"), 8);
  EXPECT_EQ(listed.at("cage").at("rise"), kHoleRise);
  EXPECT_EQ(listed.at("constraints").at("boundary").at("condition"), "curvature");
  EXPECT_FALSE(sphere.contains("sides"));
  EXPECT_FALSE(sphere.contains("constraints"));
}

}  // namespace
}  // namespace umbilic::catalog
