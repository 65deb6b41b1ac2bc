// SPDX-License-Identifier: MIT
/// \file
/// Minimizers of blends on meshed tori against the torus of revolution in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cage/generate.h"
#include "driver/run.h"
#include "energy/torus.h"

namespace umbilic {
namespace {

/// Of a surface about the z axis: with the outer radius R + r and the height r.
double ratio_of(const LimitMesh& mesh) {
  const double height = mesh.positions.col(2).maxCoeff();
  const double outer = mesh.positions.leftCols<2>().rowwise().norm().maxCoeff();
  return height / (outer - height);
}

struct Minimized {
  EnergyReport energies;
  double ratio;
};

Minimized minimize(const Weights& weights, int level) {
  RunOptions options;
  options.weights = weights;
  options.last_level = level;
  umbilic::Run run = *umbilic::Run::create(*generate_cage("torus"), options);
  while (!run.step(1000)) {
  }
  return {run.energies(), ratio_of(*run.limit_mesh(2))};
}

/// The distance falls to a fifth, while the mesh width falls to an eighth.
void expect_approach(double first, double last, double exact, const char* what) {
  EXPECT_LT(std::abs(last - exact), 0.2 * std::abs(first - exact)) << what;
  EXPECT_NEAR(last, exact, 0.03 * exact) << what;
}

TEST(TorusSlow, meshes_approach_the_exact_minimizer_of_a_blend_with_the_level) {
  for (const char* text : {"bending=1,mvs_cross=1", "bending=0.95,mvs_cross=0.05"}) {
    SCOPED_TRACE(text);
    const Weights weights = *parse_weights(text);
    const auto sum = [&](double bending, double cross) {
      return weights[kBending] * bending + weights[kMvsCross] * cross;
    };
    const TorusMinimizer exact = torus_minimizer(weights);
    const auto energies = torus_energies(exact.ratio);
    std::vector<Minimized> levels;
    for (int level = 1; level <= 4; ++level) levels.push_back(minimize(weights, level));
    double gap = exact.energy;
    for (const Minimized& level : levels) {
      const auto& found = level.energies.functionals;
      const double left = sum(found[kBending], found[kMvsCross]) - exact.energy;
      EXPECT_GT(left, 0) << "these levels do not reach the best of round tori yet";
      EXPECT_LT(left, 0.5 * gap);
      gap = left;
    }
    const auto &first = levels.front().energies.functionals, &last = levels.back().energies.functionals;
    expect_approach(levels.front().ratio, levels.back().ratio, exact.ratio, "ratio");
    for (const int f : {kBending, kMvsCross})
      expect_approach(first[f], last[f], energies[f], kFunctionalNames[f].data());
  }
}

}  // namespace
}  // namespace umbilic
