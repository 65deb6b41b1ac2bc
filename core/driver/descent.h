// SPDX-License-Identifier: MIT
/// \file
/// From a surface that is no minimum to one of lower energy.
#pragma once

#include <optional>

#include "driver/surface.h"

namespace umbilic {

/// Of the combinations of the columns of `candidates`, one along which the quadratic form `second` decreases the most
/// relative to the positive definite form `product`; nothing where none decreases. Both forms are given as what they
/// make of the candidates: second(candidates), product(candidates).
std::optional<Eigen::VectorXd> steepest(const Eigen::MatrixXd& candidates, const Eigen::MatrixXd& second,
                                        const Eigen::MatrixXd& product);

/// The control points of the surface, moved along `direction` or against it, where the energy is the lowest of those at
/// a few distances; nothing where it is nowhere lower.
std::optional<Points> moved_down(const Surface& surface, const Points& direction);

}  // namespace umbilic
