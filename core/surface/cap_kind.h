// SPDX-License-Identifier: MIT
/// \file
/// The user's choice of what replaces the limit surface near extraordinary vertices (surface/cap.h).
#pragma once

#include <string_view>

namespace umbilic {

enum class CapKind {
  kNone,    ///< the limit surface itself; third-order functionals diverge
  kFlat,    ///< blended over one ring with its projection on the tangent plane (the paper's section 3)
  kSmooth,  ///< blended over up to four rings with a polynomial in the characteristic map
};

/// "none", "flat", "smooth".
constexpr std::string_view name_of(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return "none";
    case CapKind::kFlat: return "flat";
    case CapKind::kSmooth: return "smooth";
  }
  return "";
}

}  // namespace umbilic
