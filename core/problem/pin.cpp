// SPDX-License-Identifier: MIT
/// \file
/// Which pins make sense on any cage.
#include "problem/pin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbilic {

bool in_range(const Pin& pin, Error& error) {
  const auto refuse = [&](std::string words) {
    error = {std::move(words)};
    return false;
  };
  if (pin.vertex.has_value() == pin.face.has_value()) {
    return refuse("vertex: expected either vertex, or face and uv");
  }
  if (pin.face && !pin.uv) return refuse("uv: missing");
  if (pin.vertex && pin.uv) return refuse("uv: stands beside a vertex, which has none");
  if (pin.vertex && pin.corner) return refuse("corner: stands beside a vertex, which has none");
  if (pin.vertex && *pin.vertex < 1) return refuse(fmt::format("vertex: {} is below 1", *pin.vertex));
  if (pin.face && *pin.face < 1) return refuse(fmt::format("face: {} is below 1", *pin.face));
  if (pin.corner && *pin.corner < 1) return refuse(fmt::format("corner: {} is below 1", *pin.corner));
  for (std::size_t i = 0; pin.uv && i < 2; ++i) {
    const double t = (*pin.uv)[i];
    if (!(t >= 0 && t <= 1)) return refuse(fmt::format("uv[{}]: {} is not between 0 and 1", i, t));
  }
  if (pin.at) {
    const auto& at = *pin.at;
    if (!pin.position) return refuse("at: stands beside position false");
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::isinf(at[i])) return refuse(fmt::format("at[{}]: {} is not finite", i, at[i]));
    }
    if (std::all_of(at.begin(), at.end(), [](double x) { return std::isnan(x); })) {
      return refuse("at: every coordinate is null; leave it out to hold the point where it is");
    }
  }
  if (const auto* normal = pin.normal ? std::get_if<Coordinates3>(&*pin.normal) : nullptr) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!std::isfinite((*normal)[i])) return refuse(fmt::format("normal[{}]: {} is not finite", i, (*normal)[i]));
    }
    if (std::all_of(normal->begin(), normal->end(), [](double x) { return x == 0; })) {
      return refuse("normal: has no direction, all coordinates are 0");
    }
  }
  if (!pin.position && !pin.holds_normal()) return refuse("position: false, without a normal nothing is held");
  return true;
}

}  // namespace umbilic
