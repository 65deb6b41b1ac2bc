// SPDX-License-Identifier: MIT
/// \file
/// The objects behind the handles of the contract.
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
  umbilic::SurfaceState state{};  // the state that the caller received last
  bool broken = false;            // a step ran out of memory, so the run may be inconsistent
};

struct umbilic_certificate {
  umbilic::Certificate certificate;
  umbilic::SurfaceState lower{};  // the last one handed out
  bool ended = false;             // has a report, or failed
  bool broken = false;
};

struct umbilic_mesh {
  umbilic::Cage cage;        // polygons in double precision; empty for a limit mesh
  umbilic::LimitMesh limit;  // the same for a limit mesh; empty for a control mesh
  umbilic::DrawableMesh drawable;
};

namespace umbilic::api {

/// Returns new handles to the caller.
inline void hand_out(Cage cage, const std::vector<int>& cage_faces, umbilic_mesh** out) {
  DrawableMesh drawn = drawable(cage, cage_faces);
  *out = new umbilic_mesh{std::move(cage), {}, std::move(drawn)};
}
inline void hand_out(LimitMesh limit, umbilic_mesh** out) {
  DrawableMesh drawn = drawable(limit);
  *out = new umbilic_mesh{{}, std::move(limit), std::move(drawn)};
}

}  // namespace umbilic::api
