// SPDX-License-Identifier: MIT
/// \file
/// What replaces the limit surface near extraordinary vertices.
#pragma once

namespace umbilic {

enum class CapKind {
  kNone,    ///< the limit surface itself; third-order functionals diverge
  kFlat,    ///< blended over one ring with its projection on the tangent plane (the paper's section 3)
  kSmooth,  ///< blended over up to four rings with a polynomial in the characteristic map
};

}  // namespace umbilic
