// SPDX-License-Identifier: MIT
/// \file
/// The limit surface by subdividing until the point lies in a regular face, and a plain bicubic B-spline there. A
/// second implementation beside the ring net: it knows only the Catmull-Clark step of a mesh.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mesh/rough_cages.h"
#include "surface/derivatives.h"

namespace umbilic::test {

/// Position and derivatives, in the order of surface/derivatives.h.
using SurfaceJet = Eigen::Matrix<double, kDerivativeCount, 3>;

/// The largest absolute difference in the derivatives of `order`, relative to the largest of them.
inline double relative_difference(const SurfaceJet& actual, const SurfaceJet& expected, int order) {
  const int first = derivative_index(order, 0), count = order + 1;
  return (actual - expected).middleRows(first, count).cwiseAbs().maxCoeff() /
         expected.middleRows(first, count).cwiseAbs().maxCoeff();
}

/// A derivative at x of the cardinal B-spline with support [0, degree + 1], from the recursion B_i^d = ((x - i)
/// B_i^(d-1) + (i + d + 1 - x) B_(i+1)^(d-1)) / d and d/dx B_i^d = B_i^(d-1) - B_(i+1)^(d-1).
inline double cardinal_bspline(int degree, double x, int derivative) {
  if (derivative > 0) {
    return cardinal_bspline(degree - 1, x, derivative - 1) - cardinal_bspline(degree - 1, x - 1, derivative - 1);
  }
  if (degree == 0) return x >= 0 && x < 1 ? 1 : 0;
  return (x * cardinal_bspline(degree - 1, x, 0) + (degree + 1 - x) * cardinal_bspline(degree - 1, x - 1, 0)) / degree;
}

/// Jet of a regular face at (u, v), u along the half-edge h.
inline SurfaceJet regular_jet(const PolygonMesh& mesh, const Points& control, int h, double u, double v) {
  // The face's corners and, from each of them, the three outer points of the grid.
  std::map<std::pair<int, int>, int> grid;
  for (int corner = 0; corner < 4; ++corner, h = mesh.next(h)) {
    const auto put = [&](int a, int b, int vertex) {  // (a, b) as seen from this corner, u along h
      for (int turn = 0; turn < corner; ++turn) a = 1 - std::exchange(b, a);
      grid[{a, b}] = vertex;
    };
    const int left = mesh.rotate(mesh.rotate(h)), below = mesh.rotate(left);
    put(0, 0, mesh.origin(h));
    put(-1, 0, mesh.target(left));
    put(0, -1, mesh.target(below));
    put(-1, -1, mesh.target(mesh.next(left)));
  }
  SurfaceJet jet = SurfaceJet::Zero();
  for (const auto& [ab, vertex] : grid) {
    for (int d = 0; d < kDerivativeCount; ++d) {
      // The B-spline with support [0, 4] peaks at 2, that of control point a at a.
      jet.row(d) += cardinal_bspline(3, u + 2 - ab.first, kOrderU[d]) *
                    cardinal_bspline(3, v + 2 - ab.second, kOrderV[d]) * control.row(vertex);
    }
  }
  return jet;
}

inline bool is_regular_face(const PolygonMesh& mesh, int f) {
  for (int i = 0; i < mesh.face_size(f); ++i) {
    int h = mesh.halfedge(f, i);
    if (mesh.valence(mesh.origin(h)) != 4) return false;
    for (int k = 0; k < 4; ++k, h = mesh.rotate(h)) {
      if (mesh.face_size(mesh.face(h)) != 4) return false;
    }
  }
  return mesh.face_size(f) == 4;
}

class DeepSubdivision {
 public:
  /// A mesh of quads.
  DeepSubdivision(const PolygonMesh& mesh, const Points& control)
      : start_{mesh, control}, first_(refined(mesh, control, 1)) {}

  /// Jet at (u, v) of the face of h, u along h, scaled to this face's coordinates.
  SurfaceJet jet(int h, double u, double v) const {
    if (is_regular_face(start_.mesh, start_.mesh.face(h))) return regular_jet(start_.mesh, start_.control, h, u, v);
    const int quarter = child(start_.mesh, h, u, v);
    SurfaceJet jet;
    if (is_regular_face(first_.mesh, first_.mesh.face(quarter))) {
      jet = regular_jet(first_.mesh, first_.control, quarter, u, v);
    } else {
      jet = descend(quarter, 0, {first_, quarter}, u, v);
    }
    return rescaled(jet);
  }

 private:
  /// The half-edge along u of the quarter of h's face that holds (u, v), which become coordinates of the quarter.
  static int child(const PolygonMesh& mesh, int h, double& u, double& v) {
    const int corner = v < 0.5 ? (u < 0.5 ? 0 : 1) : (u < 0.5 ? 3 : 2);
    for (int i = 0; i < corner; ++i) h = mesh.next(h);
    u = 2 * u - (corner == 1 || corner == 2);
    v = 2 * v - (corner >= 2);
    return 4 * h + (4 - corner) % 4;  // the quad of a half-edge starts at its origin and runs along it
  }

  static SurfaceJet rescaled(SurfaceJet jet) {
    for (int d = 1; d < kDerivativeCount; ++d) jet.row(d) *= std::ldexp(1.0, kOrderU[d] + kOrderV[d]);
    return jet;
  }

  /// A mesh around an irregular face, and its refinement.
  struct Window {
    Refined mesh;
    int halfedge;
    Refined next;
  };

  /// Jet at (u, v) of the irregular face of the half-edge in `level`. An irregular face has one irregular quarter, so
  /// that the first such face and the depth name the window.
  SurfaceJet descend(int first, int depth, const std::pair<const Refined&, int>& level, double u, double v) const {
    auto found = windows_.find({first, depth});
    if (found == windows_.end()) {
      auto [mesh, halfedge] = neighbourhood(level.first, level.second);
      Refined next = refined(mesh.mesh, mesh.control, 1);
      found = windows_.try_emplace({first, depth}, Window{std::move(mesh), halfedge, std::move(next)}).first;
    }
    const Window& window = found->second;
    const int quarter = child(window.mesh.mesh, window.halfedge, u, v);
    const PolygonMesh& mesh = window.next.mesh;
    return rescaled(is_regular_face(mesh, mesh.face(quarter))
                        ? regular_jet(mesh, window.next.control, quarter, u, v)
                        : descend(first, depth + 1, {window.next, quarter}, u, v));
  }

  /// The face of h with two rings of faces around it, closed by one large polygon; and h in it. Small, so that many
  /// steps are cheap; refining it gives the true control points at least two rings of faces around the quarters of h's
  /// face.
  static std::pair<Refined, int> neighbourhood(const Refined& level, int h) {
    const PolygonMesh& mesh = level.mesh;
    std::vector<bool> inside(mesh.face_count(), false);
    std::vector<int> faces{mesh.face(h)};
    inside[faces[0]] = true;
    for (int ring = 0; ring < 2; ++ring) {
      for (const int f : std::vector<int>(faces)) {
        for (int i = 0; i < mesh.face_size(f); ++i) {
          const int begin = mesh.halfedge(f, i);
          int g = begin;
          do {
            if (!inside[mesh.face(g)]) faces.push_back(mesh.face(g));
            inside[mesh.face(g)] = true;
            g = mesh.rotate(g);
          } while (g != begin);
        }
      }
    }
    std::vector<int> number(mesh.vertex_count(), -1);
    std::vector<int> vertices;
    std::vector<std::vector<int>> polygons;
    int boundary = -1;
    for (const int f : faces) {
      polygons.emplace_back();
      for (int i = 0; i < mesh.face_size(f); ++i) {
        const int g = mesh.halfedge(f, i), v = mesh.origin(g);
        if (number[v] < 0) {
          number[v] = static_cast<int>(vertices.size());
          vertices.push_back(v);
        }
        polygons.back().push_back(number[v]);
        if (!inside[mesh.face(mesh.twin(g))]) boundary = mesh.twin(g);
      }
    }
    if (boundary >= 0) {
      polygons.emplace_back();
      int g = boundary;
      do {
        polygons.back().push_back(number[mesh.origin(g)]);
        for (g = mesh.next(g); inside[mesh.face(mesh.twin(g))] == false;) g = mesh.next(mesh.twin(g));
      } while (g != boundary);
    }
    Refined window{PolygonMesh(static_cast<int>(vertices.size()), polygons), Points(vertices.size(), 3)};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      window.control.row(static_cast<int>(i)) = level.control.row(vertices[i]);
    }
    return {std::move(window), h - mesh.halfedge(mesh.face(h), 0)};
  }

  Refined start_, first_;
  mutable std::map<std::pair<int, int>, Window> windows_;
};

}  // namespace umbilic::test
