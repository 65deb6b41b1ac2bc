// SPDX-License-Identifier: MIT
/// \file
/// Weights of one functional alone.
#pragma once

#include "energy/functional.h"

namespace umbilic::test {

inline Weights only(int functional) {
  Weights weights{};
  weights[functional] = 1;
  return weights;
}

}  // namespace umbilic::test
