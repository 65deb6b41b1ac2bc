// SPDX-License-Identifier: MIT
/// \file
/// Counts samples and columns of the patches, and multiplies them with measured rates.
#include "driver/level_work.h"

#include <algorithm>
#include <cmath>

#include "driver/rules.h"
#include "optimize/metric_rules.h"

namespace umbilic {
namespace {

/// Rates, all in seconds, least squares of what `npm run bench -- rates` prints.
struct Rates {
  double regular_sample;  ///< of energy and gradient: a sample of a regular patch
  double capped_column;   ///< and of another one, for each column of its basis
  double hessian_sample;  ///< of the second derivatives, whose kernels multiply all columns with each other
  double hessian_pair;
};
constexpr Rates kSecondOrder{2.3e-8, 1.7e-9, 1.5e-7, 1.9e-9};
constexpr Rates kThirdOrder{4.4e-8, 3.7e-9, 1.7e-6, 3.8e-9};

/// What it costs to add a pair of columns to a sparse matrix: in 3 x 3 blocks, or as scalars.
constexpr double kAssembledEntry = 1e-7, kScalarEntry = 2.5e-8;
/// Of factoring and of solving, times unknowns^(3/2), as nested dissection has it (less, since separators of the sector
/// that a symmetry leaves are short).
constexpr double kFactor = 3.5e-7, kSymmetricFactor = 5e-8, kScalarFactor = 2e-8;
constexpr double kSolution = 1e-8, kSymmetricSolution = 2e-9;
/// Of a step of L-BFGS beside these, for each unknown; and of a step at least.
constexpr double kStepUnknown = 7e-8, kLeastStep = 1e-5;
/// Of refining the mesh, with its layout, for each face; and how often energies are computed by the reporting rule.
constexpr double kMeshFace = 6e-7;
constexpr double kReports = 2;

/// The columns of a patch of a cap, in the corner or not.
double columns_of(const CapCorners& corners, bool corner) {
  return (corner ? 2 * corners.valence + 8 : 16) + coefficient_count(corners.shape);
}

/// The shape of a cap after a further step. Of caps that use half of their room only, the size does not tell how much
/// that is, so that they count as if they had no more than their four rings.
CapShape wider(const CapCorners& corners) {
  switch (corners.shape) {
    case CapShape::kOneRing: return CapShape::kTwoRing;
    case CapShape::kTwoRing: return CapShape::kFourRing;
    case CapShape::kFourRing: return uses_all_room(corners.valence) ? CapShape::kEightRing : CapShape::kFourRing;
    case CapShape::kEightRing: return CapShape::kSixteenRing;
    default: return corners.shape;
  }
}

double evaluation_seconds(const SampleCounts& counts, const Rates& rates) {
  return counts.regular * rates.regular_sample + counts.columns * rates.capped_column;
}

/// Of the three parts of a metric, only the first is shared among patches of an orbit.
double metric_seconds(const LevelSize& size, const Weights& weights, MetricChoice metric) {
  const double power = std::pow(size.unknowns, 1.5);
  const bool symmetric = size.order > 1;
  if (metric == MetricChoice::kSobolev) {
    const SampleCounts counts = sample_counts(size, kSobolevRule);
    return counts.entries * kScalarEntry + (symmetric ? kSymmetricFactor : kScalarFactor) * power;
  }
  const Rates& rates = third_order(weights) ? kThirdOrder : kSecondOrder;
  const SampleCounts counts = sample_counts(size, hessian_rule(size.cap, weights));
  return (counts.regular + counts.capped) * rates.hessian_sample + counts.pairs * rates.hessian_pair +
         counts.entries * kAssembledEntry + (symmetric ? kSymmetricFactor : kFactor) * power;
}

}  // namespace

LevelSize level_size(int level, int evaluated, const PatchLayout& layout, double mesh_faces, int order,
                     double unknowns) {
  LevelSize size;
  size.level = level;
  size.evaluated = evaluated;
  size.mesh_faces = mesh_faces;
  size.faces = layout.face_count();
  size.unknowns = unknowns;
  size.order = order;
  size.cap = layout.cap();
  for (const PatchSet& set : layout.sets()) {
    if (!set.kind.at_extraordinary()) continue;
    CapCorners corners{set.kind.valence, set.kind.shape, 0, static_cast<double>(set.count())};
    for (const double multiplicity : set.multiplicities) corners.sectors += multiplicity;
    size.corners.push_back(corners);
  }
  return size;
}

LevelSize level_size_after(LevelSize size, int level, int required) {
  const int evaluated = std::max(level, required);
  const double refined = std::pow(4., evaluated - size.evaluated);
  for (int step = size.evaluated; step < evaluated; ++step) {
    for (CapCorners& corners : size.corners) {
      const CapShape shape = wider(corners);
      if (rings(shape) <= size.cap.most_rings) corners.shape = shape;
    }
  }
  // Three for each free face, but for those along the edge of what is free, or more where the edge is a mirror: a strip
  // as long as the edge, which a step doubles.
  const double coarse = 3 * size.patches() * std::pow(4., size.level - size.evaluated), strip = size.unknowns - coarse;
  const double times = std::pow(2., level - size.level);
  size.unknowns = std::max(0., coarse * times * times + strip * times);
  size.faces *= refined;
  size.mesh_faces *= refined;
  size.level = level;
  size.evaluated = evaluated;
  return size;
}

SampleCounts sample_counts(const LevelSize& size, const QuadratureRule& rule) {
  SampleCounts counts;
  const auto add = [&](double patches, double samples, double columns) {
    counts.capped += patches * samples;
    counts.columns += patches * samples * columns;
    counts.pairs += patches * samples * columns * columns;
    counts.entries += patches * columns * columns;
  };
  double covered = 0;
  const double cell = rule.cap_points * rule.cap_points;
  for (const CapCorners& corners : size.corners) {
    const double share = corners.sectors / size.order;
    const int near = samples_as_regular(corners.shape, cell_count(corners.shape) - 1) ? 4 : cell_count(corners.shape);
    add(corners.patches, cell * (3 * rule.grading + 1), columns_of(corners, true));
    add(share * (near - 1), cell, columns_of(corners, false));
    add(share * (cell_count(corners.shape) - near), rule.regular_points * rule.regular_points,
        columns_of(corners, false));
    covered += corners.sectors * cell_count(corners.shape);
  }
  constexpr double kPairs = 16 * 16;
  const double regular = std::max(0., size.faces - covered) / size.order;
  counts.regular = regular * rule.regular_points * rule.regular_points;
  counts.pairs += counts.regular * kPairs;
  counts.entries += regular * kPairs;
  return counts;
}

LevelWork level_work(const LevelSize& size, const Weights& weights, MetricChoice metric) {
  const Rates& rates = third_order(weights) ? kThirdOrder : kSecondOrder;
  LevelWork work;
  work.set_up = kMeshFace * size.mesh_faces +
                kReports * evaluation_seconds(sample_counts(size, reporting_rule(size.cap)), kThirdOrder);
  work.energy = evaluation_seconds(sample_counts(size, minimizing_rule(size.cap, weights)), rates);
  work.step = kLeastStep + kStepUnknown * size.unknowns;
  if (metric == MetricChoice::kIdentity) return work;
  work.step += (size.order > 1 ? kSymmetricSolution : kSolution) * std::pow(size.unknowns, 1.5);
  work.metric = metric_seconds(size, weights, metric);
  return work;
}

}  // namespace umbilic
