// SPDX-License-Identifier: MIT
/// \file
/// How much memory a run or a limit mesh will take, asked before any of it is allocated.
#pragma once

#include <optional>

#include "base/result.h"
#include "driver/surface.h"
#include "problem/options.h"

namespace umbilic {

/// The most that a run or a limit mesh may take. WebAssembly has 2 GB for everything, and copies each mesh once.
inline constexpr double kMostRunBytes = sizeof(void*) == 4 ? 1.5e9 : 16e9;
inline constexpr double kMostMeshBytes = sizeof(void*) == 4 ? 0.5e9 : 2e9;

/// Of a run whose last level has so many faces, of which one patch of each orbit, so many `patches`, is evaluated.
///
/// As measured on two-3, levels 2 to 5: 0.5 to 2 kB for each face, which hold connectivity, stencils and coordinates;
/// and for each patch 10 to 11.4 kB for the Sobolev product and its factors, 79 to 96 kB for the Hessian with its own.
double run_bytes(double faces, double patches, MetricChoice metric);

/// Of tessellate() without densities, which are 8 more for each vertex: 68 bytes for each vertex and 16 for each quad.
/// `density` quads along each edge of a patch.
double limit_mesh_bytes(const PolygonMesh& mesh, int density);

/// Why a run from `cage` to `options.last_level` would take too much, and the last level that would not; nothing where
/// it fits. It takes `required_steps` until the surface can be evaluated, see mesh/hierarchy.h.
std::optional<Error> too_large_a_run(const RefinedCage& cage, int required_steps, const RunOptions& options);

/// The same of a limit mesh, whose density is at least 1.
std::optional<Error> too_large_a_mesh(const PolygonMesh& mesh, int density);

}  // namespace umbilic
