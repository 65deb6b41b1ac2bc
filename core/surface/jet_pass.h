// SPDX-License-Identifier: MIT
/// \file
/// One evaluation of jets and the pullback of their adjoints, in memory that the next evaluation uses again.
#pragma once

#include <span>
#include <vector>

#include "surface/flat_frame.h"
#include "surface/jet_group.h"
#include "surface/jets.h"

namespace umbilic {

class JetPass {
 public:
  explicit JetPass(const PatchLayout& layout) : layout_(layout) {}

  /// As JetEvaluator::evaluate: first `begin`, then `run` for every group, then `finish`.
  void begin(const Points& control, int derivatives, std::span<const AdjointChannel> channels);
  void run(const JetGroup& group, const JetVisitor& visit);
  void finish(std::vector<Points>& gradients);

 private:
  /// What is pulled back from one channel.
  struct Channel {
    int derivatives = 0;
    AlignedDoubles adjoint;                // of a block's jets
    Points gradient;                       // by the layout's points
    std::vector<Vector3> normal_adjoints;  // of the caps' frames
  };

  /// Some patches of a group.
  struct Block {
    const JetGroup& group;
    int begin, patches;

    const int* points(int patch) const;
    const double* normal(const JetPass& pass, int patch) const;
    int cap(int patch) const { return group.set().caps[begin + patch]; }
  };

  void reserve_for(const JetGroup& group, int patches);
  void regular_jets(const Block& block);
  void pull_back_regular(const Block& block, Channel& channel);
  void capped_jets(const Block& block);
  void pull_back_capped(const Block& block, Channel& channel);
  void flatten(const Block& block);
  void pull_back_flattening(const Block& block, Channel& channel);
  void gather(const Block& block);

  const PatchLayout& layout_;
  const SurfaceKernels* kernels_ = nullptr;
  int derivatives_ = 0;
  Points points_;
  std::vector<FlatFrame> frames_;
  std::vector<Channel> channels_;
  std::size_t channel_count_ = 0;  // of channels_, which keep their memory
  std::vector<double*> adjoints_;  // as a block shows them
  AlignedDoubles jets_;            // of the block
  AlignedDoubles local_;           // its points, columns x (3 patches)
  AlignedDoubles local_gradient_;  // by these
  AlignedDoubles along_normal_;    // columns x patches: local points along the normals, and their adjoints
  AlignedDoubles heights_,
      along_;  // rows x patches: what is flattened away of the jets, and the adjoints along the normals
};

}  // namespace umbilic
