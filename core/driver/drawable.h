// SPDX-License-Identifier: MIT
/// \file
/// Meshes as graphics hardware takes them: single precision, triangles, edges.
#pragma once

#include <cstdint>
#include <vector>

#include "cage/cage.h"
#include "driver/limit_mesh.h"

namespace umbilic {

struct DrawableMesh {
  std::vector<float> positions;          ///< 3 per vertex
  std::vector<float> normals;            ///< 3 per vertex; none for a cage
  std::vector<float> curvatures;         ///< kappa1 >= kappa2 of each vertex; none for a cage
  std::vector<std::uint32_t> triangles;  ///< 3 per triangle
  std::vector<std::uint32_t> edges;      ///< 2 per edge, each edge once; none for a limit mesh
};

/// Each face as a fan of triangles.
DrawableMesh drawable(const Cage& cage);

/// Each quad as two triangles.
DrawableMesh drawable(const LimitMesh& mesh);

}  // namespace umbilic
