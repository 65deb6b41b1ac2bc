// SPDX-License-Identifier: MIT
/// \file
/// Validates the cage anew.
#include "cage/with_points.h"

#include <fmt/format.h>

#include <utility>

namespace umbilic {

Result<Cage> with_points(Cage cage, const Points& points) {
  if (points.rows() != cage.vertices.rows()) {
    return Error{fmt::format("points: {} for the cage's {}", points.rows(), cage.vertices.rows())};
  }
  Cage moved = cage;
  moved.vertices = points;
  if (const Result<CageReport> report = validate(moved); !report) return Error{"points: " + report.error().message};
  if (moved.faces != cage.faces) return Error{"points: the cage would be inside out; that takes a new run"};
  return moved;
}

}  // namespace umbilic
