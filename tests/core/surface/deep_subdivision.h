// SPDX-License-Identifier: MIT
/// \file
/// The limit surface by core/opinion: subdivides until the point lies in a regular face, and takes a plain bicubic
/// B-spline there. A second implementation beside the ring net.
#pragma once

#include <cmath>
#include <optional>

#include "mesh/rough_cages.h"
#include "opinion/corner_window.h"
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

/// The jet of what core/opinion finds at (u, v) of the face of h, which has one extraordinary vertex at most.
inline SurfaceJet plain_jet(const Refined& mesh, int h, double u, double v) {
  const opinion::TaylorPoint point = opinion::limit_point(mesh.mesh, mesh.control, h, u, v);
  SurfaceJet jet;
  for (int d = 0; d < kDerivativeCount; ++d) {
    for (int x = 0; x < 3; ++x) jet(d, x) = point[x].derivative(kOrderU[d], kOrderV[d]);
  }
  return jet;
}

class DeepSubdivision {
 public:
  /// A mesh of quads.
  DeepSubdivision(const PolygonMesh& mesh, const Points& control) : start_{mesh, control} {}

  /// Jet at (u, v) of the face of h, u along h, scaled to this face's coordinates.
  SurfaceJet jet(int h, double u, double v) const {
    const PolygonMesh& mesh = start_.mesh;
    int extraordinary = 0;
    for (int i = 0, g = h; i < 4; ++i, g = mesh.next(g)) extraordinary += mesh.is_extraordinary(mesh.origin(g));
    if (extraordinary <= 1) return plain_jet(start_, h, u, v);
    if (!first_) first_ = refined(mesh, start_.control, 1);
    const int quarter = child(mesh, h, u, v);
    SurfaceJet jet = plain_jet(*first_, quarter, u, v);
    for (int d = 1; d < kDerivativeCount; ++d) jet.row(d) *= std::ldexp(1.0, kOrderU[d] + kOrderV[d]);
    return jet;
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

  Refined start_;
  mutable std::optional<Refined> first_;
};

}  // namespace umbilic::test
