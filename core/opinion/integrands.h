// SPDX-License-Identifier: MIT
/// \file
/// What a second opinion integrates, from a point of the surface as a function of its parameters: the principal
/// curvatures as eigenvalues of a field of matrices, and their derivatives as those of eigenvalues.
///
/// With n the unit normal, extended along the surface, and X^s, X^t the dual basis of X_s, X_t in the tangent plane,
///
///     B = n_s (X^s)^T + n_t (X^t)^T
///
/// is the derivative of the normal as a 3 x 3 matrix: symmetric, B n = 0, and B e = kappa e for principal directions,
/// with kappa > 0 on a sphere. For unit eigenvectors d kappa = e^T dB e. Neither the second fundamental form nor
/// Christoffel symbols occur.
#pragma once

#include <array>
#include <string_view>

#include "opinion/taylor.h"

namespace umbilic::opinion {

/// The names of the quantities, with the powers of the area that make them independent of size.
struct Quantity {
  std::string_view name;
  double area_exponent = 0;
  bool third_order = false;  ///< whether it diverges at an extraordinary vertex without a cap
};

inline constexpr std::array kQuantities{
    Quantity{"area"},
    Quantity{"gaussian"},
    Quantity{"bending"},
    Quantity{"willmore"},
    Quantity{"mvs", 1, true},
    Quantity{"mvs_cross", 1, true},
    Quantity{"mehlum_tarrou", 1, true},
    Quantity{"second_form_variation", 1, true},
    Quantity{"mean_curvature_variation", 1, true},
    Quantity{"curvedness_variation", 2, true},
    Quantity{"gradient_form", 1.5, true},
    Quantity{"variation_form", 1.5, true},
    Quantity{"triple_form", 2.5, true},
};

/// A value for each of kQuantities.
using Quantities = std::array<double, kQuantities.size()>;

/// The densities times |X_s x X_t|, without powers of the area.
Quantities integrands(const TaylorPoint& x);

}  // namespace umbilic::opinion
