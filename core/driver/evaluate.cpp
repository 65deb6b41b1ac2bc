// SPDX-License-Identifier: MIT
/// \file
/// Evaluates a surface without optimizing it: its energies, and whether its gradient is right.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "driver/input_rounding.h"
#include "driver/run.h"
#include "driver/second_opinion.h"
#include "driver/surface.h"
#include "mesh/hierarchy.h"

namespace umbilic {
namespace {

constexpr int kDirections = 5;
constexpr double kGradientTolerance = 1e-7;

/// Steps of the difference quotient, relative to the cage's extent. The best one counts, since no step suits all
/// energies.
constexpr std::array kSteps{1e-3, 1e-4, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8};

/// Fourth-order central difference of f at 0.
template <class F>
double central_difference(const F& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

}  // namespace

Result<EvaluationReport> evaluate(const Cage& cage, CapChoice cap, int levels, bool opinion) {
  Result<RefinedCage> prepared = prepare(cage, levels, false);
  if (!prepared) return prepared.error();
  const int steps = std::max(levels, required_level(prepared->mesh).value());
  Weights bending{};
  bending[kBending] = 1;
  const Surface surface(refine(*prepared, steps), cap, bending);
  EvaluationReport report{surface.level(), surface.mesh().surface_face_count(), surface.report(surface.start())};
  if (std::isnan(report.energies.functionals[kBending])) {
    return Error{"the surface shrinks to a curve or a point somewhere: it has no energies"};
  }
  report.energies.input_rounding = input_rounding(*prepared, cage.vertices, surface, report.energies);
  if (opinion) report.second_opinion = second_opinion(refine_otherwise(*prepared, steps), cap, report.energies);
  return report;
}

Result<GradientReport> check_gradient(const Cage& cage, const Weights& weights, CapChoice cap) {
  Error error;
  if (!usable(weights, error)) return error;
  Result<RefinedCage> refined = refine_to_evaluable(cage, 0, false);
  if (!refined) return refined.error();
  if (diverges(refined->mesh, cap, weights, error)) return error;
  const Surface surface(std::move(refined).value(), cap, weights);
  const Points& control = surface.start();

  Points gradient;
  surface.energy().evaluate(control, &gradient);
  const double extent = (control.colwise().maxCoeff() - control.colwise().minCoeff()).maxCoeff();
  GradientReport report;
  report.level = surface.level();
  report.unknowns = static_cast<int>(control.size());
  report.directions = kDirections;
  report.tolerance = kGradientTolerance;

  std::mt19937 random(1);
  for (int i = 0; i < kDirections; ++i) {
    Points direction(control.rows(), 3);
    for (int k = 0; k < direction.size(); ++k) direction.data()[k] = 2.0 * random() / std::mt19937::max() - 1;
    const double analytic = gradient.cwiseProduct(direction).sum();
    // In a direction in which the energy hardly changes, errors are compared with the gradient's typical slope.
    const double scale = std::max(std::abs(analytic), gradient.norm() / std::sqrt(3.0));
    double difference = 0, mismatch = std::numeric_limits<double>::infinity();
    for (const double step : kSteps) {
      const double quotient = central_difference(
          [&](double t) { return surface.energy().evaluate(control + t * direction, nullptr).energy; }, step * extent);
      if (std::abs(quotient - analytic) / scale < mismatch) {
        mismatch = std::abs(quotient - analytic) / scale;
        difference = quotient;
      }
    }
    if (i == 0 || !(mismatch <= report.relative_mismatch)) {
      report.analytic = analytic;
      report.difference = difference;
      report.relative_mismatch = mismatch;
    }
  }
  report.ok = report.relative_mismatch <= kGradientTolerance;
  for (double* slope : {&report.analytic, &report.difference})
    *slope = std::ldexp(*slope, -surface.placement().exponent);
  return report;
}

}  // namespace umbilic
