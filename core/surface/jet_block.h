// SPDX-License-Identifier: MIT
/// \file
/// Memory layout of jets, from the evaluator to the integrals.
#pragma once

namespace umbilic {

/// Jets of some patches of one kind. Derivative d of coordinate c at sample s of patch p is [((p * 3 + c) * derivatives
/// + d) * samples + s], both in `jets` and in the adjoints, which have their own numbers of derivatives.
struct JetBlock {
  int patches;
  int samples;                   ///< per patch, a multiple of kSampleMultiple; those of the padding have weight 0
  int derivatives;               ///< number of derivatives in `jets`
  const double* weights;         ///< quadrature weight of each sample, in the measure du dv
  const double* multiplicities;  ///< how many patches of the surface each patch stands for
  const double* jets;
  double* const* adjoints;  ///< one array per channel, to be overwritten; null without channels
};

}  // namespace umbilic
