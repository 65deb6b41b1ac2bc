// SPDX-License-Identifier: MIT
/// \file
/// Jets of the whole surface, block by block, and the pullback of their adjoints to the control points.
///
/// A jet holds the derivatives of order 1 to 3 in the order of surface/derivatives.h. All blocks of an evaluation live
/// in one buffer, small enough for the cache, that does not grow with the mesh.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "surface/jet_block.h"
#include "surface/patch_evaluator.h"

namespace umbilic {

/// An adjoint that a visitor returns for each jet: its first `derivatives` entries, 2, 5 or 9.
struct AdjointChannel {
  int derivatives;
};

using JetVisitor = std::function<void(const JetBlock&)>;

/// Reuses its working memory between evaluations, so only one thread may evaluate at a time.
class JetEvaluator {
 public:
  /// `layout` must outlive the evaluator.
  JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule);

  const PatchLayout& layout() const { return patches_.layout(); }

  /// Calls `visit` with blocks that cover each patch once, in a fixed order. `derivatives` is 5 or 9. For each channel,
  /// `gradients` receives the pullback of its adjoint to the control points, control_count x 3.
  void evaluate(const Points& control, int derivatives, std::span<const AdjointChannel> channels,
                const JetVisitor& visit, std::vector<Points>& gradients) const;

  /// Number of samples with weight > 0 in one evaluation.
  long sample_count() const;
  /// Memory of all shared tables, in bytes.
  std::size_t table_bytes() const;

 private:
  struct Channel {
    AlignedDoubles adjoint;  // for one block
    PatchAdjoint sum;
  };

  mutable PatchEvaluator patches_;
  mutable std::vector<Channel> channels_;  // never shrinks, so that each keeps its memory
  mutable std::vector<double*> adjoints_;  // pointers for JetBlock::adjoints
};

}  // namespace umbilic
