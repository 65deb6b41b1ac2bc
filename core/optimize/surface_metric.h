// SPDX-License-Identifier: MIT
/// \file
/// Metrics that depend on the surface: built at one surface in parts, then used until the next one is begun.
#pragma once

#include "energy/surface_energy.h"
#include "solve/objective.h"

namespace umbilic {

class SurfaceMetric : public Metric {
 public:
  /// Begins to build the metric at a surface with these control points. `parametrization` is the weight of its density
  /// (energy/densities.h).
  virtual void begin(const Points& control, double parametrization) = 0;
  /// Does about as much work as one energy evaluation. Returns whether the metric is ready.
  virtual bool advance() = 0;
  /// Whether the metric is better than the curvature pairs collected before it was built, which may then be dropped.
  virtual bool knows_hessian() const = 0;
  /// Whether a metric built anew at the current surface would be no better. Convergence can then be trusted.
  virtual bool settled() const = 0;
  /// Begins to improve a ready metric until it is `settled`, at a surface where the optimizer has converged; continue
  /// with `advance`. Reuses the assembled matrices, so it costs much less than a new metric.
  virtual void settle() = 0;
  /// Whether it is positive definite for certain.
  virtual bool positive() const { return true; }
  /// Begins to make a ready metric that is not `positive` so, at the cost of its accuracy; continue with `advance`.
  virtual void make_positive() {}
  /// The decrease in the latest iteration, divided by what the metric had predicted, for metrics that trust themselves
  /// by it.
  virtual void gained(double part) = 0;
  /// How many matrices it has factored or tried to.
  virtual int factorizations() const = 0;
  /// The factor of the Sobolev product in the metric.
  virtual double sobolev_share() const = 0;
};

}  // namespace umbilic
