// SPDX-License-Identifier: MIT
/// \file
/// The functionals' names and weighted sums.
#pragma once

#include <array>
#include <string_view>

#include "base/result.h"
#include "energy/functional_list.h"

namespace umbilic {

inline constexpr std::array<std::string_view, kFunctionalCount> kFunctionalNames{"bending",
                                                                                 "willmore",
                                                                                 "mvs",
                                                                                 "mvs_cross",
                                                                                 "mehlum_tarrou",
                                                                                 "second_form_variation",
                                                                                 "mean_curvature_variation",
                                                                                 "curvedness_variation"};

/// Weights of the functionals, in the order of the enum. Generalizes Joshi & Sequin's eq. 9 to all functionals.
using Weights = std::array<double, kFunctionalCount>;

/// The powers of the area of the functionals that have a nonzero weight.
constexpr AreaPowers area_powers(const Weights& weights) {
  AreaPowers powers;
  for (int f = 0; f < kFunctionalCount; ++f) powers.has[area_power(f)] |= weights[f] != 0;
  return powers;
}

/// Whether some functional of third order has a nonzero weight.
constexpr bool third_order(const Weights& weights) { return area_powers(weights).third_order(); }

/// Weights with 1 for the functional called `name`. Errors name the unknown functional and list the known ones.
Result<Weights> weights_of(std::string_view name);

/// "bending=0.95,mvs_cross=0.05". Weights are finite, >= 0 and not all zero; errors name the part at fault.
Result<Weights> parse_weights(std::string_view text);

/// Whether the weights are finite, >= 0 and not all zero; otherwise `error` says what is wrong.
bool usable(const Weights& weights, Error& error);

}  // namespace umbilic
