// SPDX-License-Identifier: MIT
/// \file
/// What stands behind the handles of the contract.
#pragma once

#include "driver/drawable.h"
#include "driver/problem_run.h"
#include "wasm/api.h"

struct umbilic_cage {
  umbilic::Cage cage;
  umbilic::CageReport report;
};

struct umbilic_run {
  umbilic::ProblemRun run;
  umbilic::SurfaceState state{};  // what the caller has last been given
  bool broken = false;            // a step ran out of memory, and left the run in no order
};

struct umbilic_certificate {
  umbilic::Certificate certificate;
  bool ended = false;  // with a report, or with why there is none
  bool broken = false;
};

struct umbilic_mesh {
  umbilic::Cage cage;        // polygons with full digits; empty for a limit mesh
  umbilic::LimitMesh limit;  // the same; empty for a control mesh
  umbilic::DrawableMesh drawable;
};

namespace umbilic::api {

/// New handles for the caller.
inline void hand_out(Cage cage, umbilic_mesh** out) {
  DrawableMesh drawn = drawable(cage);
  *out = new umbilic_mesh{std::move(cage), {}, std::move(drawn)};
}
inline void hand_out(LimitMesh limit, umbilic_mesh** out) {
  DrawableMesh drawn = drawable(limit);
  *out = new umbilic_mesh{{}, std::move(limit), std::move(drawn)};
}

}  // namespace umbilic::api
