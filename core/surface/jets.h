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

/// Receives the number of each block, too. Blocks may come in any order and on several threads at the same time.
using JetVisitor = std::function<void(int number, const JetBlock& block)>;

/// Shares an evaluation among threads (base/threads.h). Reuses its working memory between evaluations, so there may be
/// only one at a time.
class JetEvaluator {
 public:
  /// `layout` must outlive the evaluator.
  JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule);

  const PatchLayout& layout() const { return patches_.layout(); }

  /// Number of blocks in an evaluation.
  int block_count() const { return static_cast<int>(patches_.ranges().size()); }

  /// Calls `visit` with blocks that cover each patch once, always the same. `derivatives` is 5 or 9. For each channel,
  /// `gradients` receives the pullback of its adjoint to the control points, control_count x 3, summed in the order of
  /// the blocks' numbers.
  void evaluate(const Points& control, int derivatives, std::span<const AdjointChannel> channels,
                const JetVisitor& visit, std::vector<Points>& gradients) const;

  /// Number of samples with weight > 0 in one evaluation.
  long sample_count() const;
  /// Memory of all shared tables, in bytes.
  std::size_t table_bytes() const;

 private:
  /// What a thread writes while it evaluates a block.
  struct Memory {
    PatchMemory patches;
    std::vector<AlignedDoubles> adjoints;  // of each channel
    std::vector<double*> starts;           // of these, for JetBlock::adjoints
  };

  void reserve_memory(std::size_t channels) const;
  void evaluate_block(int number, int derivatives, std::span<const AdjointChannel> channels, const JetVisitor& visit,
                      Memory& memory, std::vector<RangeAdjoint>& pulled_back) const;

  mutable PatchEvaluator patches_;
  // They never shrink, so that each keeps its memory.
  mutable std::vector<Memory> memories_;                        // of each thread
  mutable std::vector<std::vector<RangeAdjoint>> pulled_back_;  // in each slot, of each channel
  mutable std::vector<PatchAdjoint> sums_;                      // of each channel
};

}  // namespace umbilic
