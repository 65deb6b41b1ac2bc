// SPDX-License-Identifier: MIT
/// \file
/// Every kind of cap, for tests of what all of them have in common.
#pragma once

#include "surface/cap_kind.h"

namespace umbilic::test {

inline constexpr CapKind kAllCaps[] = {CapKind::kNone, CapKind::kFlat, CapKind::kSmooth};

}  // namespace umbilic::test
