// SPDX-License-Identifier: MIT
/// \file
/// From control points to the jets of patches, and back: the one place that gathers a patch's points, applies the basis
/// to them and flattens flat caps.
///
/// An evaluator is moved to a surface, and then asked for the jets of any patches of one set together, in memory that
/// the next patches use again. What is made of the jets is its users' affair: the energy visits all patches and pulls
/// adjoints back (surface/jets.h), Hessian and metric take a patch and multiply its basis by what they make of its
/// jets, the tessellation asks for positions on a grid.
///
///     PatchEvaluator patches(layout, [&](const PatchKind& kind) { return PatchBasis(kind, rule); });
///     patches.move_to(control);
///     patches.for_each_range([&](PatchRange range) { use(patches.jets(range, kThirdOrderCount)); });
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "surface/flat_frame.h"
#include "surface/patch_basis.h"

namespace umbilic {

/// Some consecutive patches of a set of the layout.
struct PatchRange {
  int set, first, count;
};

/// The sum of adjoint times derivative of jets: by the layout's points, and by the normals of its flat caps.
struct PatchAdjoint {
  Points points;
  std::vector<Vector3> normals;
};

class PatchEvaluator {
 public:
  using BasisOf = std::function<PatchBasis(const PatchKind&)>;

  /// `layout` outlives the evaluator; `basis_of` is asked once for each of its sets.
  PatchEvaluator(const PatchLayout& layout, const BasisOf& basis_of);

  const PatchLayout& layout() const { return layout_; }
  const PatchBasis& basis(int set) const { return bases_[set]; }
  int set_count() const { return static_cast<int>(bases_.size()); }

  /// The surface that all of the following is about.
  void move_to(const Points& control);
  /// The layout's points: control points and caps' coefficients.
  const Points& points() const { return points_; }
  /// Of the flat cap that a patch is part of.
  const Vector3& normal(int set, int patch) const { return frames_[layout_.sets()[set].caps[patch]].normal; }

  /// Calls `visit` with ranges that cover each patch once, in a fixed order, whose jets fit into the cache.
  template <class Visit>
  void for_each_range(const Visit& visit) const {
    for (int set = 0; set < set_count(); ++set) {
      const int count = layout_.sets()[set].count(), step = patches_at_a_time(set);
      for (int first = 0; first < count; first += step) visit(PatchRange{set, first, std::min(step, count - first)});
    }
  }

  /// The derivatives [from, from + derivatives) at all samples, as a JetBlock has them; valid until the next call.
  /// Where a basis is a tensor rule `from` is 1.
  const double* jets(PatchRange range, int derivatives, int from = 1);

  /// Sums of nothing.
  void clear(PatchAdjoint& sum) const;
  /// Adds the pullback of an adjoint of the first `derivatives` of the jets that were asked for last, from 1 on.
  void pull_back(const double* adjoint, int derivatives, PatchAdjoint& sum);
  /// The gradient by the control points, control_count x 3. Spends the sum.
  void finish(PatchAdjoint& sum, Points& gradient) const;

 private:
  const PatchSet& set() const { return layout_.sets()[range_.set]; }
  int cap(int patch) const { return set().caps[range_.first + patch]; }
  bool flat() const { return set().kind.shape == CapShape::kFlat; }
  int patches_at_a_time(int set) const;

  void regular_jets();
  void pull_back_regular(const double* adjoint, int derivatives, Points& gradient);
  void gather();
  void flatten();
  void pull_back_table(const double* adjoint, int derivatives, PatchAdjoint& sum);
  void pull_back_flattening(const double* adjoint, int derivatives, std::vector<Vector3>& normals);

  const PatchLayout& layout_;
  std::vector<PatchBasis> bases_;  // of each set
  Points points_;
  std::vector<FlatFrame> frames_;
  const SurfaceKernels* kernels_ = nullptr;

  // What was asked for last.
  PatchRange range_{};
  int from_ = 1, derivatives_ = 0;
  AlignedDoubles jets_;
  AlignedDoubles local_;           // its points, columns x (3 patches)
  AlignedDoubles local_gradient_;  // by these
  AlignedDoubles along_normal_;    // columns x patches: local points along the normals, and their adjoints
  AlignedDoubles heights_;         // rows x patches: what is flattened away of the jets
  AlignedDoubles along_;           // rows x patches: adjoints along the normals
};

}  // namespace umbilic
