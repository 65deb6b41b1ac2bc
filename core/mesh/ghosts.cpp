// SPDX-License-Identifier: MIT
/// \file
/// Points first, then the quads across the boundary's edges and those that complete the fan of each vertex.
#include "mesh/ghosts.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "mesh/boundary.h"

namespace umbilic {
namespace {

/// The surface's fan at a boundary vertex.
struct Fan {
  int vertex;
  std::vector<int> spokes;     ///< P0 = Pa to Pk = Pb, counterclockwise
  std::vector<int> diagonals;  ///< Q1 to Qk
  int faces() const { return static_cast<int>(diagonals.size()); }
};

/// `leaving` is the half-edge with which the boundary leaves the vertex.
Fan fan_at(const PolygonMesh& mesh, int leaving) {
  Fan fan{mesh.origin(leaving), {mesh.target(leaving)}, {}};
  for (int h = leaving; mesh.is_surface(mesh.face(h)); h = mesh.rotate(h)) {
    assert(mesh.face_size(mesh.face(h)) == 4);
    fan.diagonals.push_back(mesh.target(mesh.next(h)));
    fan.spokes.push_back(mesh.origin(mesh.previous(h)));
  }
  return fan;
}

class GhostBuilder {
 public:
  explicit GhostBuilder(int first_new) : first_(first_new) {}

  /// The sum of weights times vertices.
  int point(std::initializer_list<std::pair<int, double>> terms) {
    const int row = first_ + ghosts.count++;
    for (const auto& [vertex, weight] : terms) ghosts.stencil.emplace_back(row, vertex, weight);
    return row;
  }
  /// 2 (V + c T + c^2 E) - P.
  int mirrored(const Fan& fan, double c, int p) {
    return point(
        {{fan.vertex, 2 - 2 * c * c}, {fan.spokes.front(), c + c * c}, {fan.spokes.back(), c * c - c}, {p, -1}});
  }

  Ghosts ghosts;

 private:
  int first_;
};

}  // namespace

Ghosts make_ghosts(const PolygonMesh& mesh, const std::vector<bool>& wanted, int first_new) {
  constexpr double pi = std::numbers::pi;
  GhostBuilder builder(first_new);
  for (const std::vector<int>& loop : boundary_loops(mesh)) {
    if (!wanted[mesh.origin(loop.front())]) continue;
    // The ghost spokes of each vertex, in clockwise order: the first belongs to the edge that leaves, the last to the
    // one that arrives.
    std::vector<Fan> fans;
    std::vector<std::vector<int>> spokes;
    for (const int h : loop) {
      const Fan& fan = fans.emplace_back(fan_at(mesh, h));
      const int v = fan.vertex, a = fan.spokes.front(), b = fan.spokes.back(), k = fan.faces();
      std::vector<int>& mirrored = spokes.emplace_back();
      if (k == 1) {
        mirrored = {builder.point({{v, 2}, {b, -1}}), builder.point({{v, 2}, {a, -1}})};
      } else if (k == 2) {
        mirrored = {builder.point({{v, 2}, {fan.spokes[1], -1}})};
      } else {
        for (int j = 1; j < k; ++j) mirrored.push_back(builder.mirrored(fan, std::cos(pi * j / k), fan.spokes[j]));
      }
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      const Fan& fan = fans[i];
      builder.ghosts.quads.push_back({fans[next].vertex, fan.vertex, spokes[i].front(), spokes[next].back()});
      if (fan.faces() == 1) {
        const int diagonal =
            builder.point({{fan.vertex, 4}, {fan.spokes[0], -2}, {fan.spokes[1], -2}, {fan.diagonals[0], 1}});
        builder.ghosts.quads.push_back({fan.vertex, spokes[i][1], diagonal, spokes[i][0]});
      }
      for (int j = 2; j < fan.faces(); ++j) {  // the face between the ghost spokes j and j - 1
        const double c = std::cos(pi * (j - 0.5) / fan.faces()) / std::cos(pi / (2 * fan.faces()));
        const int diagonal = builder.mirrored(fan, c, fan.diagonals[j - 1]);
        builder.ghosts.quads.push_back({fan.vertex, spokes[i][j - 1], diagonal, spokes[i][j - 2]});
      }
    }
  }
  return std::move(builder.ghosts);
}

}  // namespace umbilic
