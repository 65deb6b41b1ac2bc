// SPDX-License-Identifier: MIT
/// \file
/// One sector of a cap: the basis of X = (1 - b) S + b Q over the control points of the ring net and the cap's
/// coefficients.
///
/// paper | code
/// S       limit surface, RingNet::basis
/// b       blend (eq. 8 for `kFlat`)
/// Q       plane or polynomial that replaces S at the extraordinary vertex
#pragma once

#include <array>
#include <vector>

#include "surface/ring_net.h"

namespace umbilic {

/// What covers an extraordinary vertex, once it is known how much room there is.
enum class CapShape {
  kBare,     ///< no cap: Q = S
  kFlat,     ///< one ring; Q = S projected on the limit tangent plane
  kOneRing,  ///< one ring; Q of degree 3 in the characteristic map
  kTwoRing,  ///< two rings; Q of degree 4 in the characteristic map
};

/// Faces of a sector that the cap changes: its own, and for two rings the three behind it.
constexpr int cell_count(CapShape shape) { return shape == CapShape::kTwoRing ? 4 : 1; }

/// The rings of control points that decide the cap.
constexpr int control_rings(CapShape shape) { return shape == CapShape::kTwoRing ? 3 : 2; }

/// Polynomial coefficients of Q per sector; 0 where Q is no polynomial.
constexpr int coefficient_count(CapShape shape) {
  return shape == CapShape::kTwoRing ? 15 : shape == CapShape::kOneRing ? 10 : 0;
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
  /// the weighted least-squares fit to S where b varies (second ring; for one ring the whole of it), weight |grad b|^2.
  const Eigen::MatrixXd& fit() const { return fit_; }

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
  std::array<Eigen::Matrix<double, Eigen::Dynamic, 2>, 4> characteristic_;  ///< on the support of each face
  std::vector<Eigen::MatrixXd> turns_;
  Eigen::MatrixXd fit_;
};

/// The sector of a valence and shape, made once per process.
const CapSector& cap_sector(int valence, CapShape shape);

}  // namespace umbilic
