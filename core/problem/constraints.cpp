// SPDX-License-Identifier: MIT
/// \file
/// Checks that need no cage.
#include "problem/constraints.h"

#include <fmt/format.h>

#include <cmath>

namespace umbilic {

bool in_range(const Closeness& closeness, Error& error) {
  if (closeness.weight.has_value() == closeness.within.has_value()) {
    error.message = "weight: expected either this or within";
  } else if (closeness.weight && !(*closeness.weight >= 0 && std::isfinite(*closeness.weight))) {
    error.message = fmt::format("weight: {} is not a finite number >= 0", *closeness.weight);
  } else if (closeness.within && !(*closeness.within > 0 && std::isfinite(*closeness.within))) {
    error.message = fmt::format("within: {} is not a finite number > 0", *closeness.within);
  }
  return error.message.empty();
}

bool in_range(const Constraints& constraints, Error& error) {
  if (constraints.hold && constraints.free) {
    error.message = "hold and free are both given; one of them says what is held";
    return false;
  }
  if (constraints.closeness && !in_range(*constraints.closeness, error)) {
    error.message = "closeness." + error.message;
    return false;
  }
  return true;
}

}  // namespace umbilic
