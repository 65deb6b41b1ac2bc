// SPDX-License-Identifier: MIT
/// \file
/// The catalog's rows: their topology, and what the paper and mathematics say of them.
#include "catalog/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "catalog/reference.h"
#include "catalog/settings.h"

namespace umbilic::catalog {
namespace {

using std::numbers::pi;

TEST(CatalogShapes, have_the_genus_of_their_cages_and_of_their_graphs_of_junctions) {
  for (const CatalogShape& shape : catalog_shapes()) {
    Cage cage = *generate_cage(shape.generator, cage_options(shape));
    EXPECT_EQ(validate(cage)->genus, shape.genus) << shape.name;
    if (shape.frame()) {
      EXPECT_EQ(shape.junctions * shape.arms / 2 - shape.junctions + 1, shape.genus) << shape.name;
    }
  }
}

TEST(CatalogShapes, have_the_papers_numbers_in_three_columns_of_seven_rows) {
  int numbers = 0;
  for (const CatalogShape& shape : catalog_shapes()) {
    for (const CatalogFunctional& functional : catalog_functionals()) {
      if (!paper_energy(shape, functional)) continue;
      ++numbers;
      EXPECT_TRUE(shape.frame());
    }
  }
  EXPECT_EQ(numbers, 21);
  EXPECT_EQ(paper_energy(shape_called("cube-frame"), functional_called("mvs_cross")), 9109);
  EXPECT_FALSE(paper_energy(shape_called("cube-frame"), functional_called("mehlum_tarrou")));
}

TEST(LawsonSurfaces, bend_less_with_each_genus_than_two_spheres_and_more_than_the_last) {
  // 4 W - 8 pi (1 - g) with W < 8 pi, the area of two spheres (Kusner 1987), growing with the genus.
  double last = 2 * pi * pi;
  for (const int genus : {2, 3, 4, 5, 6, 7, 11}) {
    const ExactEnergy bending = *lawson_bending(genus);
    const double area = (bending.energy + 8 * pi * (1 - genus)) / 4;
    EXPECT_LT(area, 8 * pi);
    EXPECT_GT(area, last);
    last = area;
  }
  EXPECT_NEAR(lawson_bending(2)->energy, 112.7668, 5e-5);
  EXPECT_NEAR(lawson_bending(11)->energy, 348.9, 0.05);
  // As other computations have them, to more digits than the expansion promises.
  EXPECT_NEAR(lawson_bending(4)->energy, 168.6859, lawson_bending(4)->error);
  EXPECT_NEAR(lawson_bending(6)->energy, 221.1176, lawson_bending(6)->error);
}

TEST(LawsonSurfaces, of_genus_2_and_3_lie_within_the_error_of_the_areas_expansion) {
  for (const int genus : {2, 3}) {
    const double t = 0.5 / (genus + 1), zeta3 = 1.2020569031595942;
    const double area = 8 * pi * (1 - std::numbers::ln2 * t - 9 * zeta3 / 4 * t * t * t);
    const double exact = (lawson_bending(genus)->energy + 8 * pi * (1 - genus)) / 4;
    EXPECT_LT(exact, area);
    EXPECT_GT(exact, area - 8 * pi * 4 * std::pow(t, 5));
  }
}

TEST(ExactEnergies, are_known_of_spheres_tori_and_lawson_surfaces_only) {
  const auto exact = [](const char* shape, const char* functional) {
    return exact_energy(shape_called(shape), functional_called(functional));
  };
  EXPECT_NEAR(exact("sphere", "bending_mvs_cross")->energy, 8 * pi, 1e-14);
  EXPECT_EQ(exact("sphere", "mvs_cross")->energy, 0);
  EXPECT_TRUE(exact("torus", "mvs")->attained);
  EXPECT_EQ(exact("torus", "mvs")->energy, 0);
  EXPECT_FALSE(exact("torus", "second_form_variation")->attained);
  EXPECT_NEAR(exact("torus", "second_form_variation")->energy, 24 * std::pow(pi, 4), 1e-9);
  EXPECT_NEAR(exact("torus", "bending_mvs_cross")->energy, 1021.2358, 5e-5);
  EXPECT_NEAR(exact("two-4", "bending")->energy, 141.5466, 5e-5);
  EXPECT_FALSE(exact("tetrahedron-frame", "bending"));
  EXPECT_FALSE(exact("two-3", "mvs_cross"));
}

}  // namespace
}  // namespace umbilic::catalog
