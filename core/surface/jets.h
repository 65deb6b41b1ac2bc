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

/// The adjoints that a visitor may leave: the first `derivatives` of each jet, 2, 5 or 9.
struct AdjointChannel {
  int derivatives;
};

using JetVisitor = std::function<void(const JetBlock&)>;

/// Keeps its working memory between evaluations, so that only one thread evaluates at a time.
class JetEvaluator {
 public:
  /// `layout` outlives the evaluator.
  JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule);

  const PatchLayout& layout() const { return patches_.layout(); }

  /// Calls `visit` for blocks that cover each patch once, in a fixed order. `derivatives` is 5 or 9. For every channel,
  /// `gradients` receives the sum of adjoint times derivative of the jets by the control points, control_count x 3.
  void evaluate(const Points& control, int derivatives, std::span<const AdjointChannel> channels,
                const JetVisitor& visit, std::vector<Points>& gradients) const;

  /// Samples with weight > 0 that one evaluation visits.
  long sample_count() const;
  /// Of all shared tables.
  std::size_t table_bytes() const;

 private:
  struct Channel {
    AlignedDoubles adjoint;  // of a block
    PatchAdjoint sum;
  };

  mutable PatchEvaluator patches_;
  mutable std::vector<Channel> channels_;  // never fewer than before, as they keep their memory
  mutable std::vector<double*> adjoints_;  // as a block shows them
};

}  // namespace umbilic
