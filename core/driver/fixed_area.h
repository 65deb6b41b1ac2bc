// SPDX-License-Identifier: MIT
/// \file
/// The constant factor of third-order functionals where the constraints leave the size no freedom.
#pragma once

#include <optional>

#include "driver/surface.h"

namespace umbilic {

/// The area of the cage's own surface at the level `required`, in unit coordinates; see Surface. None where the
/// constraints leave the size open. `cage` is at level 0.
std::optional<double> fixed_area_of(const RefinedCage& cage, int required, CapChoice cap);

}  // namespace umbilic
