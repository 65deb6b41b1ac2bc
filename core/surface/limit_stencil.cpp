// SPDX-License-Identifier: MIT
/// \file
/// Gathers the control points around a vertex or a face by walking over quads, and takes their weights from the ring
/// net.
#include "surface/limit_stencil.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "surface/bspline.h"
#include "surface/cap.h"
#include "surface/cells.h"

namespace umbilic {
namespace {

/// A control point and its place in a RingNet.
struct NetPoint {
  int vertex;
  int sector, a, b;
};

int upper_right(const PolygonMesh& m, int h) { return m.target(m.next(h)); }
int upper_left(const PolygonMesh& m, int h) { return m.target(m.next(m.next(h))); }

bool has_quads_around(const PolygonMesh& mesh, int vertex) {
  int h = mesh.outgoing(vertex);
  do {
    // An outer face of an open surface (mesh/polygon_mesh.h) is no face to walk over, even if it has four sides.
    if (mesh.face_size(mesh.face(h)) != 4 || mesh.role(mesh.face(h)) == FaceRole::kOuter) return false;
    h = mesh.rotate(h);
  } while (h != mesh.outgoing(vertex));
  return true;
}

/// The vertex at the origin of h with its first ring; h is the first spoke.
std::vector<NetPoint> first_ring(const PolygonMesh& mesh, int h) {
  std::vector<NetPoint> points{{mesh.origin(h), 0, 0, 0}};
  for (int sector = 0; sector < mesh.valence(mesh.origin(h)); ++sector) {
    points.push_back({mesh.target(h), sector, 1, 0});
    points.push_back({upper_right(mesh, h), sector, 1, 1});
    h = mesh.rotate(h);
  }
  return points;
}

/// The control points of the face of h, whose corners are regular except perhaps the origin of h.
std::vector<NetPoint> around_face(const PolygonMesh& mesh, int h) {
  std::vector<NetPoint> points = first_ring(mesh, h);
  const int right = cell_right(mesh, h), above = cell_above(mesh, h);
  const int below_right = cell_below(mesh, right), left_above = cell_left(mesh, above);
  points.push_back({mesh.target(right), 0, 2, 0});
  points.push_back({upper_right(mesh, right), 0, 2, 1});
  points.push_back({upper_right(mesh, cell_right(mesh, above)), 0, 2, 2});
  points.push_back({upper_right(mesh, above), 0, 1, 2});
  points.push_back({upper_left(mesh, above), 0, 0, 2});
  points.push_back({mesh.target(below_right), 0, 2, -1});
  points.push_back({upper_left(mesh, left_above), 0, -1, 2});
  return points;
}

/// Adds the weights of net points that are the same vertex, which happens on small meshes.
LimitStencil collect(std::vector<std::pair<int, Vector3>> weights) {
  std::stable_sort(weights.begin(), weights.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  LimitStencil stencil;
  stencil.weights.setZero(3, static_cast<Eigen::Index>(weights.size()));
  for (const auto& [vertex, column] : weights) {
    if (stencil.points.empty() || stencil.points.back() != vertex) stencil.points.push_back(vertex);
    stencil.weights.col(static_cast<Eigen::Index>(stencil.points.size()) - 1) += column;
  }
  stencil.weights.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(stencil.points.size()));
  return stencil;
}

LimitStencil at_vertex(const PolygonMesh& mesh, int vertex) {
  const RingNet& net = cap_sector(mesh.valence(vertex), CapShape::kBare).net();
  const Eigen::RowVectorXd position = net.limit_position();
  std::vector<std::pair<int, Vector3>> weights;
  for (const auto& [point, sector, a, b] : first_ring(mesh, mesh.outgoing(vertex))) {
    const int i = net.index(sector, a, b);
    weights.emplace_back(point, Vector3(position[i], net.limit_tangents()(0, i), net.limit_tangents()(1, i)));
  }
  return collect(std::move(weights));
}

/// At (u, v) of a face as in `around_face`, not both 0 if its corner is extraordinary.
LimitStencil at_face(const PolygonMesh& mesh, int h, double u, double v) {
  const int valence = mesh.valence(mesh.origin(h));
  std::vector<std::pair<int, Vector3>> weights;
  if (valence == 4) {
    const Eigen::Matrix4d along_u = cubic_bspline(u), along_v = cubic_bspline(v);
    for (auto [point, sector, a, b] : around_face(mesh, h)) {
      for (; sector > 0; --sector) a = -std::exchange(b, a);
      const int i = a + 1, j = b + 1;
      weights.emplace_back(
          point, Vector3(along_u(0, i) * along_v(0, j), along_u(1, i) * along_v(0, j), along_u(0, i) * along_v(1, j)));
    }
    return collect(std::move(weights));
  }
  const RingNet& net = cap_sector(valence, CapShape::kBare).net();
  const DerivativeRows rows = net.face_basis(0, u, v);
  const std::vector<int>& support = net.support(0);
  for (const auto& [point, sector, a, b] : around_face(mesh, h)) {
    const auto place = std::lower_bound(support.begin(), support.end(), net.index(sector, a, b));
    weights.emplace_back(point, rows.col(place - support.begin()).head<3>());
  }
  return collect(std::move(weights));
}

/// An extraordinary corner of a quad as a vertex: there are no derivatives by u and v.
SurfacePlace without_corners(const PolygonMesh& mesh, SurfacePlace place) {
  const bool corner = (place.u == 0 || place.u == 1) && (place.v == 0 || place.v == 1);
  if (place.is_vertex() || !corner || mesh.face_size(mesh.face(place.halfedge)) != 4) return place;
  int h = place.halfedge;
  for (int turn = place.v == 0 ? (place.u == 0 ? 0 : 1) : (place.u == 0 ? 3 : 2); turn > 0; --turn) h = mesh.next(h);
  return mesh.is_extraordinary(mesh.origin(h)) ? SurfacePlace{.vertex = mesh.origin(h)} : place;
}

/// Nothing if the mesh must be refined before.
std::optional<LimitStencil> stencil_here(const PolygonMesh& mesh, const SurfacePlace& place) {
  if (place.is_vertex()) {
    if (!has_quads_around(mesh, place.vertex)) return std::nullopt;
    return at_vertex(mesh, place.vertex);
  }
  int first = 0, extraordinary = 0, h = place.halfedge;
  if (mesh.face_size(mesh.face(h)) != 4) return std::nullopt;
  for (int corner = 0; corner < 4; ++corner, h = mesh.next(h)) {
    if (!has_quads_around(mesh, mesh.origin(h))) return std::nullopt;
    if (!mesh.is_extraordinary(mesh.origin(h))) continue;
    first = corner;
    ++extraordinary;
  }
  if (extraordinary > 1) return std::nullopt;
  // Seen from the next corner, (u, v) is (v, 1 - u): the derivatives by the old u and v are those by -v and u.
  double u = place.u, v = place.v;
  for (int corner = 0; corner < first; ++corner) {
    u = std::exchange(v, 1 - u);
    h = mesh.next(h);
  }
  LimitStencil stencil = at_face(mesh, h, u, v);
  for (int corner = 0; corner < first; ++corner) {
    const Eigen::RowVectorXd by_u = stencil.weights.row(1);
    stencil.weights.row(1) = -stencil.weights.row(2);
    stencil.weights.row(2) = by_u;
  }
  stencil.weights.bottomRows<2>() *= std::ldexp(1.0, place.steps);
  return stencil;
}

/// A stencil over refined points as one over the points that they are refined from.
LimitStencil pulled_back(const LimitStencil& stencil, const SparseMatrix& refinement) {
  std::vector<std::pair<int, Vector3>> weights;
  for (std::size_t i = 0; i < stencil.points.size(); ++i) {
    const Vector3 weight = stencil.weights.col(static_cast<Eigen::Index>(i));
    for (SparseMatrix::InnerIterator it(refinement, stencil.points[i]); it; ++it) {
      weights.emplace_back(static_cast<int>(it.col()), it.value() * weight);
    }
  }
  return collect(std::move(weights));
}

}  // namespace

/// The quad of a half-edge starts at its origin and runs along it, so in the quad of corner k of the face, whose own
/// corner k comes first, the old direction u starts k corners before.
SurfacePlace refined(const SurfacePlace& place, const PolygonMesh& mesh) {
  SurfacePlace result = place;
  if (place.is_vertex()) {
    // Vertices that only holes use are left out (mesh/open_subdivision.h).
    for (int v = 0; mesh.is_open() && v < place.vertex; ++v) result.vertex -= !mesh.on_surface(v);
    return result;
  }
  if (mesh.face_size(mesh.face(place.halfedge)) != 4) {
    result.halfedge = 4 * place.halfedge;
    return result;
  }
  ++result.steps;
  const int corner = place.v < 0.5 ? (place.u < 0.5 ? 0 : 1) : (place.u < 0.5 ? 3 : 2);
  int h = place.halfedge;
  for (int i = 0; i < corner; ++i) h = mesh.next(h);
  result.halfedge = 4 * h + (4 - corner) % 4;
  result.u = 2 * place.u - (corner == 1 || corner == 2);
  result.v = 2 * place.v - (corner >= 2);
  return result;
}

Eigen::Matrix3d LimitStencil::apply(const Points& control) const {
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    result += control.row(points[i]).transpose() * weights.col(static_cast<Eigen::Index>(i)).transpose();
  }
  return result;
}

std::vector<LimitStencil> limit_stencils(const PolygonMesh& mesh, const std::vector<SurfacePlace>& places) {
  std::vector<LimitStencil> stencils(places.size());
  std::vector<std::size_t> waiting;
  std::vector<SurfacePlace> next;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SurfacePlace place = without_corners(mesh, places[i]);
    if (std::optional<LimitStencil> stencil = stencil_here(mesh, place)) {
      stencils[i] = std::move(*stencil);
    } else {
      waiting.push_back(i);
      next.push_back(refined(place, mesh));
    }
  }
  if (waiting.empty()) return stencils;
  const Refinement refinement = catmull_clark(mesh);
  const std::vector<LimitStencil> fine = limit_stencils(refinement.mesh, next);
  for (std::size_t i = 0; i < waiting.size(); ++i) stencils[waiting[i]] = pulled_back(fine[i], refinement.stencil);
  return stencils;
}

}  // namespace umbilic
