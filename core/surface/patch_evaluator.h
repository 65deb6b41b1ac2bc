// SPDX-License-Identifier: MIT
/// \file
/// From control points to the jets of patches, and back. The only place that gathers a patch's points, applies the
/// basis to them and flattens flat caps.
///
/// Move an evaluator to a surface, then ask it for the jets of consecutive patches of one set. The result stays valid
/// until the next call. The callers decide what to do with the jets: the energy visits all patches and pulls adjoints
/// back (surface/jets.h), Hessian and metric multiply the basis by matrices of each jet, the tessellation asks for
/// positions on a grid.
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

/// The accumulated pullback of adjoints: to the layout's points, and to the normals of its flat caps.
struct PatchAdjoint {
  Points points;
  std::vector<Vector3> normals;
};

class PatchEvaluator {
 public:
  using BasisOf = std::function<PatchBasis(const PatchKind&)>;

  /// `layout` must outlive the evaluator; `basis_of` is called once for each set.
  PatchEvaluator(const PatchLayout& layout, const BasisOf& basis_of);

  const PatchLayout& layout() const { return layout_; }
  const PatchBasis& basis(int set) const { return bases_[set]; }
  int set_count() const { return static_cast<int>(bases_.size()); }

  /// Chooses the surface for all following calls.
  void move_to(const Points& control);
  /// The layout's points: control points, then cap coefficients.
  const Points& points() const { return points_; }
  /// The normal of the flat cap that the patch belongs to.
  const Vector3& normal(int set, int patch) const { return frames_[layout_.sets()[set].caps[patch]].normal; }

  /// Calls `visit` with ranges that cover each patch once, in a fixed order, each small enough that its jets fit in the
  /// cache.
  template <class Visit>
  void for_each_range(const Visit& visit) const {
    for (int set = 0; set < set_count(); ++set) {
      const int count = layout_.sets()[set].count(), step = patches_at_a_time(set);
      for (int first = 0; first < count; first += step) visit(PatchRange{set, first, std::min(step, count - first)});
    }
  }

  /// The derivatives [from, from + derivatives) at all samples, in the layout of a JetBlock; valid until the next call.
  /// `from` must be 1 if the basis is a tensor kernel.
  const double* jets(PatchRange range, int derivatives, int from = 1);

  /// Sets the sums to zero.
  void clear(PatchAdjoint& sum) const;
  /// Adds the pullback of an adjoint of the first `derivatives` derivatives, from order 1 on, of the jets that were
  /// computed last.
  void pull_back(const double* adjoint, int derivatives, PatchAdjoint& sum);
  /// The gradient by the control points, control_count x 3. The sum must be cleared before it is used again.
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

  // The last call of `jets`.
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
