// SPDX-License-Identifier: MIT
/// \file
/// One sector of a cap: the basis of X = (1 - b) S + b Q over the control points of the ring net and the cap's
/// coefficients.
///
/// paper | code
/// S       limit surface, RingNet::basis
/// b       blend (eq. 8 for `kFlat`)
/// Q       plane or polynomial that replaces S at the extraordinary vertex
///
/// A smooth cap takes four rings where there is room, else two or one. Beyond its R rings S alone follows the surface,
/// and in ring k around an extraordinary vertex splines of mesh size h can give the curvature's gradient to O(kappa /
/// (k^2 h)) only, since their sectors meet at the wrong angle. Its square sums up to O(kappa^2 / R^2): what that adds
/// to an energy of third order does not vanish with h. MVS_cross of a sphere from the cube's cage is 2.6 at level 4
/// with two rings and 1.2 with four.
#pragma once

#include <vector>

#include "surface/ring_net.h"

namespace umbilic {

/// What covers an extraordinary vertex, once it is known how much room there is.
enum class CapShape {
  kBare,      ///< no cap: Q = S
  kFlat,      ///< one ring; Q = S projected on the limit tangent plane
  kOneRing,   ///< one ring; Q of degree 3 in the characteristic map
  kTwoRing,   ///< two rings; Q of degree 4
  kFourRing,  ///< four rings; Q of degree 5
};

/// Rings of faces that the cap changes.
constexpr int rings(CapShape shape) { return shape == CapShape::kFourRing ? 4 : shape == CapShape::kTwoRing ? 2 : 1; }

/// Faces of a sector that the cap changes; cell c is the face (c % rings, c / rings).
constexpr int cell_count(CapShape shape) { return rings(shape) * rings(shape); }

/// The rings of control points that decide the cap.
constexpr int control_rings(CapShape shape) { return rings(shape) + 1; }

/// Of Q in the characteristic map; 0 where Q is no such polynomial.
constexpr int degree(CapShape shape) {
  switch (shape) {
    case CapShape::kBare:
    case CapShape::kFlat: return 0;
    case CapShape::kOneRing: return 3;
    case CapShape::kTwoRing: return 4;
    case CapShape::kFourRing: return 5;
  }
  return 0;
}

/// Polynomial coefficients of Q per sector.
constexpr int coefficient_count(CapShape shape) {
  return degree(shape) == 0 ? 0 : (degree(shape) + 1) * (degree(shape) + 2) / 2;
}

/// Everything of a cap that depends only on the valence and the shape.
class CapSector {
 public:
  CapSector(int valence, CapShape shape);

  const RingNet& net() const { return net_; }
  CapShape shape() const { return shape_; }

  /// X's basis at (u, v) of a face of the sector, (u, v) in [0, 1]^2: 10 x (net().support(cell) + coefficients). For
  /// `kFlat` this is S; see `flattening`.
  DerivativeRows basis(int cell, double u, double v) const;

  /// `kFlat`: derivatives of b (basis - limit position), 10 x net().support(0): X = S - (flattening P n) n^T with n the
  /// unit normal at the extraordinary vertex.
  DerivativeRows flattening(double u, double v) const;

  /// The coefficients of Q in the sector's own coordinates as a linear function of the net, coefficients x net size:
  /// the weighted least-squares fit to S over the second ring (for one ring over that), weight |grad b|^2. Farther out
  /// S can make up for Q, since it has control points that Q has not.
  const Eigen::MatrixXd& fit() const { return fit_; }
  /// The columns of `fit` that are not 0, rising.
  const std::vector<int>& fit_support() const { return fit_support_; }

  /// All sectors see one polynomial: the coefficients in the coordinates of a sector as a linear function of those in
  /// sector 0's, coefficients x coefficients.
  const Eigen::MatrixXd& turn(int sector) const { return turns_[sector]; }

 private:
  Derivatives blend(int cell, double u, double v) const;
  DerivativeRows polynomials(const Derivatives& x, const Derivatives& y) const;
  void build_turns();
  void build_fit();

  RingNet net_;
  CapShape shape_;
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 2>> characteristic_;  ///< on the net's support of each face
  std::vector<Eigen::MatrixXd> turns_;
  Eigen::MatrixXd fit_;
  std::vector<int> fit_support_;
};

/// The sector of a valence and shape, made once per process.
const CapSector& cap_sector(int valence, CapShape shape);

}  // namespace umbilic
