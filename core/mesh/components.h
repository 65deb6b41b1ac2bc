// SPDX-License-Identifier: MIT
/// \file
/// The connected components of a mesh's surface.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

struct MeshComponents {
  std::vector<int> of_vertex;   ///< the component that each vertex belongs to, or that its ghosts belong to
  std::vector<int> genera;      ///< of each component, in the order of their first half-edges; as if it were closed
  std::vector<int> boundaries;  ///< number of boundary loops of each component
};

MeshComponents find_components(const PolygonMesh& mesh);

}  // namespace umbilic
