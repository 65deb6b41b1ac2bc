// SPDX-License-Identifier: MIT
/// \file
/// Meshes in the form that graphics hardware takes: single precision, triangles, edges.
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.h"
#include "cage/cage.h"
#include "driver/limit_mesh.h"

namespace umbilic {

struct DrawableMesh {
  Vector3 centre = Vector3::Zero();      ///< the middle of the bounding box, in the coordinates of the cage
  std::vector<float> positions;          ///< 3 per vertex, from the centre: a small mesh far away keeps its digits
  std::vector<float> normals;            ///< 3 per vertex; none for a cage
  std::vector<float> curvatures;         ///< kappa1 >= kappa2 of each vertex; none for a cage
  std::vector<float> densities;          ///< of the energy, in 1/length^2; none unless the limit mesh has them
  std::vector<std::uint32_t> triangles;  ///< 3 per triangle
  std::vector<std::uint32_t> faces;      ///< of each triangle: the face of the cage that it descends from, from 0
  std::vector<std::uint32_t> edges;      ///< 2 per edge, each edge once; none for a limit mesh
};

/// Each face as a fan of triangles. `cage_faces` has the face of the cage that each face descends from; empty for a
/// cage itself.
DrawableMesh drawable(const Cage& cage, const std::vector<int>& cage_faces = {});

/// Each quad as two triangles.
DrawableMesh drawable(const LimitMesh& mesh);

}  // namespace umbilic
