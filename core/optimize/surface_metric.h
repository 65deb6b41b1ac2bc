// SPDX-License-Identifier: MIT
/// \file
/// Metrics that follow the surface: built at a surface in parts, used until the next is begun.
#pragma once

#include "energy/surface_energy.h"
#include "solve/objective.h"

namespace umbilic {

class SurfaceMetric : public Metric {
 public:
  /// Starts to build the metric at a surface with these control points.
  virtual void begin(const Points& control) = 0;
  /// Does a part of the work, of about the cost of one energy evaluation; returns whether the metric is ready.
  virtual bool advance() = 0;
  /// Whether curvature pairs from before the metric was built say less than the metric.
  virtual bool knows_hessian() const = 0;
  /// Whether a metric built here and now would be no better: convergence in this one can be believed.
  virtual bool settled() const = 0;
  /// Starts to make it so from the matrices that a ready metric has, for a surface at which it has converged; `advance`
  /// ends it. Costs much less than another metric.
  virtual void settle() = 0;
  /// The factor of the Sobolev product in the metric.
  virtual double sobolev_share() const = 0;
};

}  // namespace umbilic
