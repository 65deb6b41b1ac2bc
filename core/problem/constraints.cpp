// SPDX-License-Identifier: MIT
/// \file
/// Checks that need no cage.
#include "problem/constraints.h"

namespace umbilic {

bool in_range(const Constraints& constraints, Error& error) {
  if (constraints.hold && constraints.free) {
    error.message = "hold and free are both given; one of them says what is held";
    return false;
  }
  return true;
}

}  // namespace umbilic
