// SPDX-License-Identifier: MIT
/// \file
/// Estimates in doubles, which no request makes overflow.
#include "driver/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/metric_for_level.h"

namespace umbilic {
namespace {

std::string gigabytes(double bytes) { return fmt::format("{:.2g} GB", bytes / 1e9); }

}  // namespace

double run_bytes(double faces, double patches, MetricChoice metric) {
  constexpr double kFace = 2e3, kIdentity = 500, kSobolev = 12e3, kHessian = 95e3;
  if (metric == MetricChoice::kAutomatic) {
    metric = 3 * patches <= kMostHessianUnknowns ? MetricChoice::kHessian : MetricChoice::kSobolev;
  }
  const double patch = metric == MetricChoice::kHessian || metric == MetricChoice::kNewton ? kHessian
                       : metric == MetricChoice::kSobolev                                  ? kSobolev
                                                                                           : kIdentity;
  return kFace * faces + patch * patches;
}

double limit_mesh_bytes(const PolygonMesh& mesh, int density) {
  const double inner = density - 1., quads = static_cast<double>(density) * density * mesh.surface_face_count();
  const double vertices = mesh.vertex_count() + mesh.edge_count() * inner + mesh.surface_face_count() * inner * inner;
  return 68 * vertices + 16 * quads;
}

std::optional<Error> too_large_a_run(const RefinedCage& cage, int required_steps, const RunOptions& options) {
  const auto bytes = [&](int level) {
    const double faces = faces_after(cage.mesh, std::max(level - cage.level, required_steps));
    return run_bytes(faces, faces / cage.symmetry.order, options.metric);
  };
  if (bytes(options.last_level) <= kMostRunBytes) return std::nullopt;
  int fits = options.last_level;
  while (fits >= 0 && bytes(fits) > kMostRunBytes) --fits;
  const std::string rest = fits < 0 ? "no level" : fmt::format("at most level {}", fits);
  return Error{fmt::format("level {} would take {}; {} fits in {}", options.last_level,
                           gigabytes(bytes(options.last_level)), rest, gigabytes(kMostRunBytes))};
}

std::optional<Error> too_large_a_mesh(const PolygonMesh& mesh, int density) {
  const double bytes = limit_mesh_bytes(mesh, density);
  if (bytes <= kMostMeshBytes) return std::nullopt;
  int fits = 0, beyond = density;
  while (beyond - fits > 1) {
    const int middle = fits + (beyond - fits) / 2;
    (limit_mesh_bytes(mesh, middle) <= kMostMeshBytes ? fits : beyond) = middle;
  }
  const std::string rest = fits == 0 ? "none" : fmt::format("at most {}", fits);
  return Error{fmt::format("density {} would take {}; {} fits in {}", density, gigabytes(bytes), rest,
                           gigabytes(kMostMeshBytes))};
}

}  // namespace umbilic
