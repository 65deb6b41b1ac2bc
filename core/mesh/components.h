// SPDX-License-Identifier: MIT
/// \file
/// The connected components of a closed mesh.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

struct MeshComponents {
  std::vector<int> of_vertex;  ///< the component that each vertex belongs to
  std::vector<int> genera;     ///< of each component, in the order of their first half-edges
};

MeshComponents find_components(const PolygonMesh& mesh);

}  // namespace umbilic
