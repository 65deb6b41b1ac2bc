// SPDX-License-Identifier: MIT
/// \file
/// Jets as they lie in memory between the evaluator and whoever integrates over them.
#pragma once

namespace umbilic {

/// Jets of some patches of one kind. Sample s of patch p, derivative d, coordinate c stands at
/// [((p * 3 + c) * derivatives + d) * samples + s], in `jets` and, with their own number of derivatives, in the
/// adjoints.
struct JetBlock {
  int patches;
  int samples;                   ///< per patch, a multiple of kSampleMultiple; surplus ones have weight 0
  int derivatives;               ///< in `jets`
  const double* weights;         ///< of each sample of a patch, in the measure du dv
  const double* multiplicities;  ///< of each patch: how many it stands for
  const double* jets;
  double* const* adjoints;  ///< of each channel, to be overwritten; null without channels
};

}  // namespace umbilic
