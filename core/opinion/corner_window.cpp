// SPDX-License-Identifier: MIT
/// \file
/// Gathers control points around a corner, and averages them.
#include "opinion/corner_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace umbilic::opinion {
namespace {

Vector3 mean(const Vector3& a, const Vector3& b) { return (a + b) / 2; }
Vector3 mean(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) { return (a + b + c + d) / 4; }

}  // namespace

CornerWindow::CornerWindow(const PolygonMesh& mesh, const Points& control, int h) {
  const auto point = [&](int v) -> Vector3 { return control.row(v).transpose(); };
  std::vector<Vector3> spoke, diagonal;
  int g = h;
  do {
    spoke.push_back(point(mesh.target(g)));
    diagonal.push_back(point(mesh.target(mesh.next(g))));
    g = mesh.rotate(g);
  } while (g != h);
  // Across the edges of the face that are not at the corner, and around its far corner.
  const int right = mesh.twin(mesh.next(h)), top = mesh.twin(mesh.next(mesh.next(h)));
  const auto across = [&](int e) { return mesh.next(mesh.next(e)); };
  const int below = mesh.twin(mesh.next(right)), far = mesh.twin(mesh.previous(right));
  const int left = mesh.twin(mesh.previous(top));
  *this =
      CornerWindow(point(mesh.origin(h)), std::move(spoke), std::move(diagonal),
                   {point(mesh.target(across(below))), point(mesh.origin(across(right))),
                    point(mesh.target(across(right))), point(mesh.origin(across(far))), point(mesh.origin(across(top))),
                    point(mesh.target(across(top))), point(mesh.origin(across(left)))});
}

CornerWindow::CornerWindow(const Vector3& corner, std::vector<Vector3> spoke, std::vector<Vector3> diagonal,
                           const std::array<Vector3, 7>& outer)
    : corner_(corner), spoke_(std::move(spoke)), diagonal_(std::move(diagonal)) {
  for (Vector3& point : spoke_) point -= corner;
  for (Vector3& point : diagonal_) point -= corner;
  put_ring_in_grid();
  constexpr int kPlaces[7][2] = {{2, -1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {-1, 2}};
  for (int i = 0; i < 7; ++i) at(kPlaces[i][0], kPlaces[i][1]) = outer[i] - corner;
}

void CornerWindow::put_ring_in_grid() {
  const int n = valence();
  at(0, 0).setZero();
  at(1, 0) = spoke_[0];
  at(0, 1) = spoke_[1];
  at(1, 1) = diagonal_[0];
  at(1, -1) = diagonal_[n - 1];
  at(0, -1) = spoke_[n - 1];
  at(-1, 1) = diagonal_[1];
  at(-1, 0) = spoke_[2];
}

void CornerWindow::step() {
  const int n = valence();
  // The regular points beyond the first ring, from the old grid.
  const auto face = [&](int a, int b) { return mean(at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)); };
  const auto edge_along_u = [&](int a, int b) { return mean(at(a, b), at(a + 1, b), face(a, b - 1), face(a, b)); };
  const auto edge_along_v = [&](int a, int b) { return mean(at(a, b), at(a, b + 1), face(a - 1, b), face(a, b)); };
  const auto vertex = [&](int a, int b) -> Vector3 {
    const Vector3 faces = mean(face(a, b), face(a - 1, b), face(a - 1, b - 1), face(a, b - 1));
    const Vector3 edges = mean(mean(at(a, b), at(a + 1, b)), mean(at(a, b), at(a, b + 1)), mean(at(a, b), at(a - 1, b)),
                               mean(at(a, b), at(a, b - 1)));
    return (faces + 2 * edges + at(a, b)) / 4;
  };
  auto refined = grid_;
  for (int a = -1; a <= 3; ++a) {
    for (int b = -1; b <= 3; ++b) {
      if (a < 2 && b < 2) continue;
      const int i = (a + 2) / 2 - 1, j = (b + 2) / 2 - 1;  // a / 2 and b / 2 rounded down
      refined[a + 1][b + 1] = a % 2 == 0 ? (b % 2 == 0 ? vertex(i, j) : edge_along_v(i, j))
                                         : (b % 2 == 0 ? edge_along_u(i, j) : face(i, j));
    }
  }
  // The first ring, from the old one.
  std::vector<Vector3> faces(n), edges(n);
  const Vector3 origin = Vector3::Zero();
  for (int j = 0; j < n; ++j) faces[j] = mean(origin, spoke_[j], diagonal_[j], spoke_[(j + 1) % n]);
  Vector3 face_mean = origin, edge_mean = origin;
  for (int j = 0; j < n; ++j) {
    edges[j] = mean(origin, spoke_[j], faces[(j + n - 1) % n], faces[j]);
    face_mean += faces[j] / n;
    edge_mean += spoke_[j] / 2 / n;
  }
  const Vector3 moved = (face_mean + 2 * edge_mean) / n;
  corner_ += moved;
  for (Vector3& point : faces) point -= moved;
  for (Vector3& point : edges) point -= moved;
  for (auto& column : refined) {
    for (Vector3& point : column) point -= moved;
  }
  spoke_ = std::move(edges);
  diagonal_ = std::move(faces);
  grid_ = refined;
  put_ring_in_grid();
}

Grid CornerWindow::quarter(int i, int j) const {
  Grid grid;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) grid.row(4 * b + a) = at(i - 1 + a, j - 1 + b).transpose();
  }
  return grid;
}

namespace {

/// A function of (u, v) from one of (v, 1 - u).
Taylor turned(const Taylor& f) {
  Taylor result;
  for (int k = 0; k < 4; ++k) {
    for (int l = 0; k + l < 4; ++l) result.c[Taylor::index(l, k)] = (l % 2 == 0 ? 1 : -1) * f.c[Taylor::index(k, l)];
  }
  return result;
}

/// Within the window's quad, (u, v) from the corner; the terms are scaled to its coordinates.
TaylorPoint point_of(CornerWindow window, double u, double v) {
  int steps = 0;
  for (; std::max(u, v) < 1; ++steps) {
    u *= 2;
    v *= 2;
    window.step();
  }
  if (steps == 0) {  // on an edge
    window.step();
    steps = 1;
    u *= 2;
    v *= 2;
  }
  const int i = u >= 1, j = v >= 1;
  TaylorPoint point = bicubic(window.quarter(i, j), bspline_coefficients(u - i), bspline_coefficients(v - j));
  for (int x = 0; x < 3; ++x) {
    for (int order = 0, c = 0; order < 4; ++order) {
      for (int k = 0; k <= order; ++k, ++c) point[x].c[c] *= std::ldexp(1.0, order * steps);
    }
    point[x].c[0] += window.corner()[x];
  }
  return point;
}

}  // namespace

TaylorPoint limit_point(const PolygonMesh& mesh, const Points& control, int h, double u, double v) {
  int turns = 0, corner = h;
  while (turns < 4 && mesh.valence(mesh.origin(corner)) == 4) {
    corner = mesh.next(corner);
    ++turns;
  }
  if (turns == 4) return bicubic(regular_grid(mesh, control, h), bspline_coefficients(u), bspline_coefficients(v));
  for (int i = 0; i < turns; ++i) u = std::exchange(v, 1 - u);
  TaylorPoint point = point_of(CornerWindow(mesh, control, corner), u, v);
  for (int i = 0; i < turns; ++i) {
    for (Taylor& x : point) x = turned(x);
  }
  return point;
}

Grid regular_grid(const PolygonMesh& mesh, const Points& control, int h) {
  Grid grid;
  // From each corner of the face, the corner and the three outer points of the grid there.
  for (int corner = 0; corner < 4; ++corner, h = mesh.next(h)) {
    const auto put = [&](int a, int b, int vertex) {  // (a, b) as seen from this corner, u along h
      for (int turn = 0; turn < corner; ++turn) a = 1 - std::exchange(b, a);
      grid.row(4 * (b + 1) + a + 1) = control.row(vertex);
    };
    const int left = mesh.rotate(mesh.rotate(h)), below = mesh.rotate(left);
    put(0, 0, mesh.origin(h));
    put(-1, 0, mesh.target(left));
    put(0, -1, mesh.target(below));
    put(-1, -1, mesh.target(mesh.next(left)));
  }
  return grid;
}

}  // namespace umbilic::opinion
