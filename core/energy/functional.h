// SPDX-License-Identifier: MIT
/// \file
/// The functionals' names and weighted sums.
#pragma once

#include <array>
#include <string_view>

#include "base/result.h"
#include "energy/functional_list.h"

namespace umbilic {

/// "bending", "willmore", "mvs", "mvs_cross", "mehlum_tarrou", "second_form_variation".
inline constexpr std::array<std::string_view, kFunctionalCount> kFunctionalNames{
    "bending", "willmore", "mvs", "mvs_cross", "mehlum_tarrou", "second_form_variation"};

/// Weights of the functionals, in the order of the enum. Generalizes Joshi & Sequin's eq. 9 to all functionals.
using Weights = std::array<double, kFunctionalCount>;

/// Whether some functional of third order has a nonzero weight.
constexpr bool third_order(const Weights& weights) {
  for (int f = kMvs; f < kFunctionalCount; ++f) {
    if (weights[f] != 0) return true;
  }
  return false;
}

/// Weights with 1 for the functional called `name`. Errors name the unknown functional and list the known ones.
Result<Weights> weights_of(std::string_view name);

/// "bending=0.95,mvs_cross=0.05". Weights are finite, >= 0 and not all zero; errors name the part at fault.
Result<Weights> parse_weights(std::string_view text);

/// Whether the weights are finite, >= 0 and not all zero; otherwise `error` says what is wrong.
bool usable(const Weights& weights, Error& error);

}  // namespace umbilic
