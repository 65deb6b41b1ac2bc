// SPDX-License-Identifier: MIT
/// \file
/// The user's choice of what replaces the limit surface near extraordinary vertices (surface/cap.h).
#pragma once

#include <string_view>

namespace umbilic {

enum class CapKind {
  kNone,    ///< the limit surface itself; third-order functionals diverge
  kFlat,    ///< blended over one ring with its projection on the tangent plane (the paper's section 3)
  kSmooth,  ///< blended over up to sixteen rings with a polynomial in the characteristic map
};

/// The most rings of faces that a smooth cap can take, and does take unless asked. Wider caps are for meshes whose
/// faces come from subdivision: only there S is nearly a polynomial of the characteristic map so far from the vertex. A
/// fine mesh of another kind they would change.
inline constexpr int kMostCapRings = 16, kUsualCapRings = 4;

/// "none", "flat", "smooth".
constexpr std::string_view name_of(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return "none";
    case CapKind::kFlat: return "flat";
    case CapKind::kSmooth: return "smooth";
  }
  return "";
}

/// A kind, and for `kSmooth` the most rings that a cap may take.
struct CapChoice {
  CapKind kind;
  int most_rings;

  constexpr CapChoice(CapKind of_kind = CapKind::kSmooth, int rings = kUsualCapRings)
      : kind(of_kind), most_rings(rings) {}
  constexpr operator CapKind() const { return kind; }
};

}  // namespace umbilic
