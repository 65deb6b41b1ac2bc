// SPDX-License-Identifier: MIT
/// \file
/// A cheap quadrature rule, for tests of what holds for every rule.
#pragma once

#include "surface/quadrature.h"

namespace umbilic::test {

inline constexpr QuadratureRule kFewPoints{3, 4, 1};

}  // namespace umbilic::test
