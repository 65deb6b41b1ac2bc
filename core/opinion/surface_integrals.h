// SPDX-License-Identifier: MIT
/// \file
/// A second opinion on the integrals of a surface: the same surface, evaluated, differentiated and integrated in other
/// ways than in core/surface and core/energy, of which it uses nothing. Slow, and made to be believed.
///
/// what         | core/surface, core/energy                     | here
/// S            | powers of a matrix on a ring net              | averages of points around the vertex
/// char. map    | power iteration on the ring net               | the same in complex numbers, on one sector
/// caps         | rows of a linear map                          | X = S + b (Q - S) in truncated power series
/// densities    | second fundamental form, covariant derivative | eigenvalues of the normal's derivative
/// quadrature   | Gauss & Legendre, some graded levels          | Clenshaw & Curtis, graded until nothing is left
/// symmetry     | one patch of each orbit                       | all faces, unless the caller says how often each
/// counts
///
/// What they share are the half-edges of the mesh, and what defines a surface: its control points (and where an open
/// surface's ghosts begin), which vertices have which caps, and the coefficients of the caps' polynomials, which are a
/// fit.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"
#include "opinion/integrands.h"

namespace umbilic::opinion {

/// What S is blended into near an extraordinary vertex.
enum class CapForm {
  kNone,
  kPlane,       ///< its projection on the tangent plane; Joshi & Sequin's eq. 8 as the blend
  kPolynomial,  ///< a polynomial of the characteristic map; a smoothstep of degree 7 as the blend
};

struct PlainCap {
  int halfedge = 0;  ///< leaves the vertex; along u of sector 0
  int sectors = 0;   ///< with surface
  int rings = 1;
  int degree = 0;
  Points coefficients{};  ///< of x^(k-l) y^l, sorted by k, then l, in the coordinates of sector 0
};

struct PlainSurface {
  const PolygonMesh& mesh;  ///< quads with one extraordinary vertex at most
  const Points& control;
  CapForm form = CapForm::kNone;
  std::vector<PlainCap> caps{};
  std::vector<int> times{};  ///< how often each face counts, each once if empty: a face of a symmetric surface may
                             ///< stand for all of its orbit, whose others count 0 times
};

struct Integrals {
  Quantities values{};  ///< with the powers of the area; NaN where they diverge
  Quantities errors{};  ///< by how much they differ by the rule with half as many intervals
  double samples = 0;
};

Integrals integrate(const PlainSurface& surface);

}  // namespace umbilic::opinion
