// SPDX-License-Identifier: MIT
/// \file
/// The third-order invariants that are only evaluated: integrals that are quadratic in C, the covariant derivative of
/// II, and odd in II.
///
/// The other side of a surface has II and C of the opposite sign, so it has the opposite of each of these integrals.
/// None is bounded from below, and none is a functional to be minimized. They complete the functionals |C|^2
/// (second_form_variation), |T|^2 (mean_curvature_variation) and |v|^2 (curvedness_variation), which are even. A power
/// of the area makes them independent of size.
///
/// | invariant | density | in units of | factor |
/// |---|---|---|---|
/// | gradient_form | II(T, T), T_i = C_ikk = 2 grad H | 1/length^5 | area^(3/2) |
/// | variation_form | II_ij C_ikl C_jkl | 1/length^5 | area^(3/2) |
/// | triple_form | II_ia II_jb II_kc C_ijk C_abc | 1/length^7 | area^(5/2) |
///
/// Kernels use this file too, so it includes no library.
#pragma once

namespace umbilic {

enum Invariant { kGradientForm, kVariationForm, kTripleForm };
inline constexpr int kInvariantCount = 3;
inline constexpr const char* kInvariantNames[kInvariantCount] = {"gradient_form", "variation_form", "triple_form"};

/// The power of the area that is an invariant's factor.
constexpr double area_exponent(Invariant invariant) { return invariant == kTripleForm ? 2.5 : 1.5; }

}  // namespace umbilic
