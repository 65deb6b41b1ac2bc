// SPDX-License-Identifier: MIT
/// \file
/// Leaves out the holes, counts by component, then sums.
#include "cage/count.h"

#include <cassert>

#include "cage/boundary.h"
#include "cage/edges.h"

namespace umbilic {

namespace {

/// Of a cage without holes and groups.
CageReport count_faces(const Cage& cage) {
  const std::vector<EdgeUse> uses = edge_uses(cage);
  const Orientation orientation = orient(cage, uses);
  CageReport report;
  report.components.resize(orientation.component_count);
  const auto of_face = [&](int face) -> CageComponent& { return report.components[orientation.component[face]]; };
  std::vector<int> component_of_vertex(cage.vertices.rows(), -1);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    CageComponent& component = of_face(static_cast<int>(f));
    ++component.faces;
    for (const int v : cage.faces[f]) {
      if (component_of_vertex[v] >= 0) continue;
      component_of_vertex[v] = orientation.component[f];
      ++component.vertices;
    }
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (i == 0 || !same_edge(uses[i - 1], uses[i])) ++of_face(uses[i].face).edges;
  }
  for (const std::vector<int>& loop : boundary_loops(cage, open_uses(uses))) {
    const int component = component_of_vertex[loop.front()];
    ++report.components[component].boundaries;
    const auto number = static_cast<int>(report.boundaries.size()) + 1;
    report.boundaries.push_back({number, static_cast<int>(loop.size()), loop.front(), component + 1});
  }
  for (CageComponent& component : report.components) {
    const int euler = component.vertices - component.edges + component.faces;
    assert((2 - component.boundaries - euler) % 2 == 0);
    component.genus = (2 - component.boundaries - euler) / 2;
    report.vertices += component.vertices;
    report.edges += component.edges;
    report.faces += component.faces;
    report.genus += component.genus;
  }
  return report;
}

}  // namespace

CageReport count(const Cage& cage) {
  CageReport report = count_faces(without_holes(cage));
  report.holes = static_cast<int>(cage.holes.size());
  for (const FaceGroup& group : cage.groups)
    report.groups.push_back({group.name, static_cast<int>(group.faces.size())});
  return report;
}

}  // namespace umbilic
