// SPDX-License-Identifier: MIT
/// \file
/// The bounds against surfaces that attain them.
#include "energy/lower_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "energy/torus.h"

namespace umbilic {
namespace {

using std::numbers::pi;

TEST(LowerBounds, of_genus_0_are_the_energies_of_round_spheres) {
  // k1 = k2 = H = 1 over an area of 4 pi.
  EXPECT_DOUBLE_EQ(lower_bound(kWillmore, 0), 4 * pi);
  EXPECT_DOUBLE_EQ(lower_bound(kBending, 0), 8 * pi);
}

TEST(LowerBounds, of_genus_1_are_attained_by_the_clifford_torus_and_by_no_other_torus_of_revolution) {
  double least = 1e9;
  for (int i = 1; i < 1000; ++i) {
    const double ratio = 1e-3 * i;
    const auto energies = torus_energies(ratio);
    EXPECT_GE(energies[kWillmore], lower_bound(kWillmore, 1)) << ratio;
    EXPECT_GE(energies[kBending], lower_bound(kBending, 1)) << ratio;
    least = std::min(least, energies[kBending]);
  }
  const auto clifford = torus_energies(std::sqrt(0.5));
  EXPECT_NEAR(clifford[kWillmore], lower_bound(kWillmore, 1), 1e-13 * clifford[kWillmore]);
  EXPECT_NEAR(clifford[kBending], lower_bound(kBending, 1), 1e-13 * clifford[kBending]);
  EXPECT_LT(least, 1.00001 * lower_bound(kBending, 1));
}

TEST(LowerBounds, of_bending_follow_from_willmores_by_gauss_and_bonnet) {
  for (int genus = 0; genus < 12; ++genus) {
    const double gaussian = 4 * pi * (1 - genus);
    EXPECT_NEAR(lower_bound(kBending, genus), 4 * lower_bound(kWillmore, genus) - 2 * gaussian, 1e-12);
    if (genus > 0) {
      EXPECT_NEAR(lower_bound(kBending, genus), 8 * pi * pi + 8 * pi * (genus - 1), 1e-12);
    }
  }
  // Lawson's xi_{g,1}, the least energies known.
  EXPECT_LT(lower_bound(kBending, 2), 112.7668);
  EXPECT_LT(lower_bound(kBending, 3), 141.5466);
}

TEST(LowerBounds, add_up_over_components_and_weights) {
  const Weights weights{2, 3, 5, 7, 11, 13, 17, 19};
  const double expected = 2 * (8 * pi + 8 * pi * pi) + 3 * (4 * pi + 2 * pi * pi);
  EXPECT_NEAR(lower_bound(weights, {0, 1}), expected, 1e-12 * expected);
  EXPECT_EQ(lower_bound(Weights{0, 0, 1, 1, 1, 1, 1, 1}, {0, 3}), 0) << "integrals of squares";
}

}  // namespace
}  // namespace umbilic
