// SPDX-License-Identifier: MIT
/// \file
/// Reads functionals and weights from words.
#include "energy/functional.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace umbilic {
namespace {

Result<int> functional_called(std::string_view name) {
  const auto found = std::find(kFunctionalNames.begin(), kFunctionalNames.end(), name);
  if (found == kFunctionalNames.end()) {
    return Error{fmt::format("unknown functional \"{}\"; known are {}", name, fmt::join(kFunctionalNames, ", "))};
  }
  return static_cast<int>(found - kFunctionalNames.begin());
}

}  // namespace

Result<Weights> weights_of(std::string_view name) {
  const Result<int> functional = functional_called(name);
  if (!functional) return functional.error();
  Weights weights{};
  weights[*functional] = 1;
  return weights;
}

Result<Weights> parse_weights(std::string_view text) {
  Weights weights{};
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) return Error{fmt::format("weight \"{}\": expected NAME=NUMBER", part)};
    const Result<int> functional = functional_called(part.substr(0, equals));
    if (!functional) return functional.error();
    const std::string_view number = part.substr(equals + 1);
    double weight = 0;
    const auto [end, error] = fast_float::from_chars(number.data(), number.data() + number.size(), weight);
    if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(weight) || weight < 0) {
      return Error{fmt::format("weight \"{}\": \"{}\" is not a finite number >= 0", part, number)};
    }
    weights[*functional] += weight;
  }
  if (Error error; !usable(weights, error)) return error;
  return weights;
}

bool usable(const Weights& weights, Error& error) {
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (!std::isfinite(weights[i]) || weights[i] < 0) {
      error.message = fmt::format("weight of {} is not a finite number >= 0", kFunctionalNames[i]);
      return false;
    }
  }
  if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; })) {
    error.message = "all weights are zero";
    return false;
  }
  return true;
}

}  // namespace umbilic
