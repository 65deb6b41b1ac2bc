// SPDX-License-Identifier: MIT
/// \file
/// The linear equations that a run's control points fulfil, beside those that are held in place: those of pins and of
/// boundaries.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "driver/boundary_rows.h"
#include "driver/pin_rows.h"
#include "driver/surface.h"
#include "optimize/gauge.h"

namespace umbilic {

/// The equations over the coordinates 3 v + c of the control points.
PinRows equations_of(const RefinedCage& cage);

/// What equation `row` holds, for messages: "pin 2 (x)", "copy 3 of pin 2 (x)", "the boundary at vertex 7".
std::string name_of(const RefinedCage& cage, const PinRows& rows, int row);

/// The solutions over the unknowns of `coordinates`, nearest to the cage's control points; null without equations. The
/// equations must not contradict one another.
std::shared_ptr<const AffineSubspace> solutions_of(const RefinedCage& cage, const Coordinates& coordinates);

/// An error that names a smallest set of equations that contradict one another, or held faces, if there is one.
std::optional<Error> contradiction_of(const RefinedCage& cage, const Coordinates& coordinates);

/// The cage's control points, moved to where `coordinates` have what is held and the equations hold, as smoothly as
/// possible: of all displacements d that do it, that with the least |L d|^2 + e |d - m|^2, L the graph's Laplacian and
/// e a small number that only decides where L leaves a choice. m is `expected`, a displacement of all points, or 0.
/// Unchanged where all that holds already.
Points moved_to_equations(const RefinedCage& cage, const Coordinates& coordinates, const Points& expected = {});

/// The directions in which the functional's energy does not change and that all constraints allow: an orthonormal basis
/// over the coordinates of all control points.
Eigen::MatrixXd free_gauge(const RefinedCage& cage, const Gauge& gauge);

/// Whether the constraints leave the size of the surface open. (A pull to the cage's own surface does not.)
bool leaves_size_open(const RefinedCage& cage);

}  // namespace umbilic
