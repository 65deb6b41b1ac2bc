// SPDX-License-Identifier: MIT
/// \file
/// Known energies of Lawson surfaces, tori of revolution and the sphere.
#include "catalog/reference.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "energy/torus.h"

namespace umbilic::catalog {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kZeta3 = 1.2020569031595942;
constexpr double kFifthCoefficient = 4;
constexpr double kGenusTwoArea = 21.908514;
constexpr double kGenusThreeBending = 141.5466;

ExactEnergy sphere_energy(const Weights& weights) {
  const double energy = 8 * kPi * weights[kBending] + 4 * kPi * weights[kWillmore];
  return {energy, 0, true, energy > 0 ? "the round sphere: bending 8 pi, no third-order energy" : "the round sphere"};
}

ExactEnergy torus_energy(const CatalogFunctional& functional) {
  const TorusMinimizer torus = torus_minimizer(functional.weights);
  if (!torus.attained) return {torus.energy, 0, false, "infimum over round tori, as they become thin"};
  if (functional.name == "bending") return {torus.energy, 0, true, "the Clifford torus: 8 pi^2"};
  if (torus.energy == 0) return {0, 0, true, "tori of revolution"};
  return {torus.energy, 0, true,
          fmt::format("the least of round tori, r/R = {:.6f}; other profiles have a little less", torus.ratio)};
}

}  // namespace

std::optional<ExactEnergy> lawson_bending(int genus) {
  const auto bending = [&](double area) { return 4 * area - 8 * kPi * (1 - genus); };
  const std::string name = fmt::format("Lawson's xi_{{{},1}}", genus);
  if (genus == 2) return ExactEnergy{bending(kGenusTwoArea), 4e-6, true, name};
  if (genus == 3) return ExactEnergy{kGenusThreeBending, 5e-5, true, name};
  if (genus < 4) return std::nullopt;
  const double t = 0.5 / (genus + 1);
  const double area = 8 * kPi * (1 - std::numbers::ln2 * t - 2.25 * kZeta3 * t * t * t);
  return ExactEnergy{bending(area), 32 * kPi * kFifthCoefficient * std::pow(t, 5), true,
                     name + ", its area's expansion in 1/(g+1) to third order"};
}

std::optional<ExactEnergy> exact_energy(const CatalogShape& shape, const CatalogFunctional& functional) {
  if (shape.hole()) return std::nullopt;
  if (shape.genus == 0) return sphere_energy(functional.weights);
  if (shape.genus == 1) return torus_energy(functional);
  if (functional.name == "bending" && shape.junctions == 2) return lawson_bending(shape.genus);
  return std::nullopt;
}

}  // namespace umbilic::catalog
