// SPDX-License-Identifier: MIT
/// \file
/// How much there is to compute on a level, told from the layout of a coarser one, without refining anything.
///
/// A Catmull-Clark step makes four patches of one, but caps soon take no more faces than before: of as many faces as
/// they can, up to four rings. So a level has the capped patches of its caps, and regular ones otherwise. What each
/// costs is known from `npm run bench -- rates`, in seconds of the machine on which that was measured; how much faster
/// another machine is, driver/machine_speed.h tells.
#pragma once

#include <vector>

#include "energy/functional.h"
#include "problem/metric_choice.h"
#include "surface/layout.h"
#include "surface/quadrature.h"

namespace umbilic {

/// The patches at extraordinary vertices of one valence that are covered by caps of one shape.
struct CapCorners {
  int valence = 0;
  CapShape shape = CapShape::kBare;
  double sectors = 0;  ///< how many there are
  double patches = 0;  ///< how many of them are evaluated, one of each orbit
};

/// How large the surface of a level is.
struct LevelSize {
  int level = 0;          ///< that of the points that are moved
  int evaluated = 0;      ///< that of the mesh that the surface is evaluated on
  double mesh_faces = 0;  ///< of the evaluated mesh, held ones included
  double faces = 0;       ///< those that are free
  double unknowns = 0;
  int order = 1;  ///< of the symmetry
  int genus = 0;  ///< the largest of a component's
  CapChoice cap;
  std::vector<CapCorners> corners;

  /// Patches that are evaluated: one of each orbit of free faces.
  double patches() const { return faces / order; }
};

/// The size of a level with this layout.
LevelSize level_size(int level, int evaluated, const PatchLayout& layout, double mesh_faces, int order,
                     double unknowns);

/// The size of a later level. `required` is the first level that can be evaluated.
LevelSize level_size_after(LevelSize size, int level, int required);

/// Sums over the patches that are evaluated.
struct SampleCounts {
  double regular = 0;  ///< samples of regular patches
  double capped = 0;   ///< of the others
  double columns = 0;  ///< the sum of the columns of each of these
  double pairs = 0;    ///< the sum of the squared columns of all samples
  double entries = 0;  ///< the sum of the squared columns of all patches
};
SampleCounts sample_counts(const LevelSize& size, const QuadratureRule& rule);

/// What a level does, each in seconds of one thread.
struct LevelWork {
  double set_up = 0;  ///< once: mesh, layout and report
  double energy = 0;  ///< an evaluation of energy and gradient
  double step = 0;    ///< of the optimizer, beside one evaluation
  double metric = 0;  ///< each time: assembled and factored
};

/// `metric` is one that a level uses, so not kAutomatic.
LevelWork level_work(const LevelSize& size, const Weights& weights, MetricChoice metric);

}  // namespace umbilic
