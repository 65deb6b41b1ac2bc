// SPDX-License-Identifier: MIT
/// \file
/// Caps: what replaces the limit surface S near an extraordinary vertex, where its curvature is unbounded or
/// discontinuous.
///
/// A cap is X = (1 - b) S + b Q. The blend b is 1 at the vertex and 0 at the rim. Q is smooth: the projection of S on a
/// plane (`kFlat`), or a polynomial fitted to S. The polynomial's variables are the coordinates of the characteristic
/// map, the planar limit surface in which a subdivision step is a mere scaling. This file owns one of the N equal
/// sectors of a cap: the basis of X over the control points of the ring net and the coefficients of Q.
///
/// paper | code
/// S       limit surface, RingNet::basis
/// b       blend (eq. 8 for `kFlat`)
/// Q       plane or polynomial that replaces S at the extraordinary vertex
///
/// A smooth cap takes up to four rings of faces, or sixteen where it is asked to, as there is room (surface/layout.h).
/// Wider is better: beyond its R rings the surface is S, and in ring k around an extraordinary vertex splines of mesh
/// size h reproduce the gradient of the curvature only to O(kappa / (k^2 h)), since their sectors meet at the wrong
/// angle. Its square sums to O(kappa^2 / R^2), an error of third-order energies that does not vanish with h, but with
/// rings that double from level to level. `npm run bench -- caps` shows it.
#pragma once

#include <algorithm>
#include <vector>

#include "surface/ring_net.h"

namespace umbilic {

/// What covers an extraordinary vertex. The number of rings depends on how much room there is.
enum class CapShape {
  kBare,         ///< no cap: Q = S
  kFlat,         ///< one ring; Q = S projected on the limit tangent plane
  kOneRing,      ///< one ring; Q of degree 3 in the characteristic map
  kTwoRing,      ///< two rings; Q of degree 4
  kFourRing,     ///< four rings; Q of degree 5
  kEightRing,    ///< eight rings; Q of degree 6
  kSixteenRing,  ///< sixteen rings; Q of degree 6
};

/// What sets the caps apart.
struct CapDesign {
  int rings;   ///< of faces that the cap changes
  int degree;  ///< of Q as a polynomial in the characteristic map; 0 if Q is no such polynomial
};

/// Degree 7 gains nothing.
constexpr CapDesign design(CapShape shape) {
  switch (shape) {
    case CapShape::kBare:
    case CapShape::kFlat: return {1, 0};
    case CapShape::kOneRing: return {1, 3};
    case CapShape::kTwoRing: return {2, 4};
    case CapShape::kFourRing: return {4, 5};
    case CapShape::kEightRing: return {8, 6};
    case CapShape::kSixteenRing: return {16, 6};
  }
  return {};
}

/// The rings of faces over which Q is fitted to S, from 0.
struct FitRings {
  int first, last;
};

/// Q is fitted near the vertex, where S has no control points that could make up for Q's errors; in wide caps not
/// nearer than in the fourth ring or so, since over a narrower range higher degrees are ill determined: fitted over the
/// second ring, sixteen rings end in surfaces that are none. So they do at valence 3 and 5 where {3, 6} serves higher
/// valences: the lower the valence, the faster the characteristic map grows with the rings, and the further a
/// polynomial goes beyond the rings that it is fitted over. {4, 9} is what eight rings have, on a mesh refined once
/// more.
constexpr FitRings fit_rings(CapShape shape, int valence) {
  constexpr int kLowValence = 5;
  switch (shape) {
    case CapShape::kBare:
    case CapShape::kFlat:
    case CapShape::kOneRing: return {0, 0};
    case CapShape::kTwoRing:
    case CapShape::kFourRing: return {1, 1};
    case CapShape::kEightRing: return {2, 4};
    case CapShape::kSixteenRing: return valence <= kLowValence ? FitRings{4, 9} : FitRings{3, 6};
  }
  return {};
}

/// Number of rings of faces that the cap changes.
constexpr int rings(CapShape shape) { return design(shape).rings; }

/// Number of faces in a sector that the cap changes; cell c is the face (c % rings, c / rings).
constexpr int cell_count(CapShape shape) { return rings(shape) * rings(shape); }

/// The ring that a cell is in, from 0.
constexpr int ring_of(CapShape shape, int cell) { return std::max(cell % rings(shape), cell / rings(shape)); }

/// Number of rings of control points that the cap depends on.
constexpr int control_rings(CapShape shape) { return rings(shape) + 1; }

/// Degree of Q as a polynomial in the characteristic map; 0 if Q is no such polynomial.
constexpr int degree(CapShape shape) { return design(shape).degree; }

/// Polynomial coefficients of Q per sector.
constexpr int coefficient_count(CapShape shape) {
  return degree(shape) == 0 ? 0 : (degree(shape) + 1) * (degree(shape) + 2) / 2;
}

/// All data of a cap's sector that depend only on the valence and the shape, and on how many sectors carry surface, if
/// the vertex is on a boundary.
class CapSector {
 public:
  /// Sectors 0 to `fitted` - 1 are those that carry surface.
  CapSector(int valence, CapShape shape, int fitted);

  const RingNet& net() const { return net_; }
  CapShape shape() const { return shape_; }

  /// Derivatives of the basis functions of X at (u, v) in [0, 1]^2 of a face of the sector: 10 x (net().support(cell) +
  /// coefficients). For `kFlat` those of S; see `flattening`.
  DerivativeRows basis(int cell, double u, double v) const;

  /// For `kFlat`: derivatives of b (basis - limit position), 10 x net().support(0). With P the control points and n the
  /// unit normal at the extraordinary vertex, X = S - (flattening P n) n^T.
  DerivativeRows flattening(double u, double v) const;

  /// The coefficients of Q in the sector's own coordinates as a linear function of the net, coefficients x net size:
  /// the least-squares fit to S over `fit_rings`, weighted by |grad b|^2. Only the sectors that carry surface
  /// are fitted: in the others S would depend on more ghosts than there are. The fit is invariant under the mirror that
  /// exchanges the first of them with the last.
  const Eigen::MatrixXd& fit() const { return fit_; }
  /// The nonzero columns of `fit`, sorted.
  const std::vector<int>& fit_support() const { return fit_support_; }

  /// Q is a single polynomial in all sectors, but each sector writes it in its own coordinates. This matrix takes the
  /// coefficients in sector 0's coordinates to those in the given sector's, coefficients x coefficients.
  const Eigen::MatrixXd& turn(int sector) const { return turns_[sector]; }

 private:
  Derivatives blend(int cell, double u, double v) const;
  DerivativeRows polynomials(const Derivatives& x, const Derivatives& y) const;
  void build_turns();
  void build_fit(int fitted);

  RingNet net_;
  CapShape shape_;
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 2>> characteristic_;  ///< on the net's support of each face
  std::vector<Eigen::MatrixXd> turns_;
  Eigen::MatrixXd fit_;
  std::vector<int> fit_support_;
};

/// The sector of a valence and shape, made once per process.
const CapSector& cap_sector(int valence, CapShape shape, int fitted);
inline const CapSector& cap_sector(int valence, CapShape shape) { return cap_sector(valence, shape, valence); }

}  // namespace umbilic
