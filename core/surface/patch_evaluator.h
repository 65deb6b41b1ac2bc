// SPDX-License-Identifier: MIT
/// \file
/// From control points to the jets of patches, and back. The only place that gathers a patch's points, applies the
/// basis to them and flattens flat caps.
///
/// Move an evaluator to a surface, then ask it for the jets of consecutive patches of one set. They are written to the
/// caller's memory and stay there until the next call with the same; with memory of their own, several threads may ask
/// at the same time. The callers decide what to do with the jets: the energy visits all patches and pulls adjoints
/// back (surface/jets.h), Hessian and metric multiply the basis by matrices of each jet, the tessellation asks for
/// positions on a grid.
///
///     PatchEvaluator patches(layout, [&](const PatchKind& kind) { return PatchBasis(kind, rule); });
///     patches.move_to(control);
///     PatchMemory memory;
///     for (const PatchRange& range : patches.ranges()) use(patches.jets(range, kThirdOrderCount, memory));
#pragma once

#include <functional>
#include <vector>

#include "surface/flat_frame.h"
#include "surface/patch_basis.h"

namespace umbilic {

/// Some consecutive patches of a set of the layout.
struct PatchRange {
  int set, first, count;
};

/// What an evaluator writes while it evaluates a range; its values belong to the evaluator.
struct PatchMemory {
  PatchRange range{};
  int from = 1, derivatives = 0;
  AlignedDoubles jets;
  AlignedDoubles local;         ///< the range's points, columns x (3 patches)
  AlignedDoubles along_normal;  ///< columns x patches: local points along the normals, and their adjoints
  AlignedDoubles heights;       ///< rows x patches: what is flattened away of the jets
  AlignedDoubles along;         ///< rows x patches: adjoints along the normals
  AlignedDoubles scratch;
};

/// The pullback of adjoints to the points of each patch of a range, and to the normals of their flat caps.
struct RangeAdjoint {
  AlignedDoubles points;
  std::vector<Vector3> normals;
};

/// The sum of such pullbacks: to the layout's points, and to the normals of its flat caps.
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

  /// Ranges that cover each patch once, in a fixed order, each small enough that its jets fit in the cache.
  const std::vector<PatchRange>& ranges() const { return ranges_; }

  /// The derivatives [from, from + derivatives) at all samples, in the layout of a JetBlock; valid until the next call
  /// with the same memory. `from` must be 1 if the basis is a tensor kernel.
  const double* jets(PatchRange range, int derivatives, PatchMemory& memory, int from = 1) const;

  /// The pullback of an adjoint of the first `derivatives` derivatives, from order 1 on, of the jets that were computed
  /// last in this memory.
  void pull_back(const double* adjoint, int derivatives, PatchMemory& memory, RangeAdjoint& result) const;

  /// Sets the sums to zero.
  void clear(PatchAdjoint& sum) const;
  /// Adds the pullback to the points of a range.
  void add(PatchRange range, const RangeAdjoint& adjoint, PatchAdjoint& sum) const;
  /// The gradient by the control points, control_count x 3. The sum must be cleared before it is used again.
  void finish(PatchAdjoint& sum, Points& gradient) const;

 private:
  const PatchSet& set(PatchRange range) const { return layout_.sets()[range.set]; }
  bool flat(PatchRange range) const { return set(range).kind.shape == CapShape::kFlat; }
  const Vector3& normal_at(PatchRange range, int p) const { return normal(range.set, range.first + p); }

  void regular_jets(PatchMemory& memory) const;
  void gather(PatchMemory& memory) const;
  void flatten(PatchMemory& memory) const;
  void pull_back_regular(const double* adjoint, int derivatives, PatchMemory& memory, RangeAdjoint& result) const;
  void pull_back_flattening(const double* adjoint, int derivatives, PatchMemory& memory, RangeAdjoint& result) const;

  const PatchLayout& layout_;
  std::vector<PatchBasis> bases_;  // of each set
  std::vector<PatchRange> ranges_;
  Points points_;
  std::vector<FlatFrame> frames_;
};

}  // namespace umbilic
