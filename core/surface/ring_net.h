// SPDX-License-Identifier: MIT
/// \file
/// The rings of control points around an extraordinary vertex, and the limit surface over its rings of faces, one
/// fewer.
///
/// Sector j of N lies between the spokes j and j + 1. Its grid point (a, b) is a steps along spoke j and b steps along
/// spoke j + 1, and its face corners (0,0), (1,0), (1,1), (0,1) run counterclockwise. Sector coordinates (u, v) agree
/// with (a, b).
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "surface/derivatives.h"

namespace umbilic {

class RingNet {
 public:
  /// `rings` >= 2 of faces.
  explicit RingNet(int valence, int rings = 2);

  int valence() const { return valence_; }
  int rings() const { return rings_; }
  int control_rings() const { return rings_ + 1; }
  int size() const { return valence_ * control_rings() * (control_rings() + 1) + 1; }

  /// The control point (a, b) of a sector; either a or b may be negative and then lies in the next or previous sector.
  int index(int sector, int a, int b) const;
  /// The control point that stands to `sector` as point i to sector 0.
  int turned(int i, int sector) const;

  /// One Catmull-Clark step of the net onto the same rings of the refined net, size x size.
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& step() const { return step_; }

  /// The control points that decide the limit surface over the face (cell % rings, cell / rings) of sector 0, rising.
  const std::vector<int>& support(int cell) const { return support_[cell]; }

  /// Derivatives in (u, v) of the limit surface's basis functions at a point of a face, (u, v) in [0, 1]^2 and in cell
  /// 0 without (0, 0); 10 x support. Exact refinement until the point lies in a regular face, as Stam 1998 with the
  /// matrix power not diagonalized; derivatives of order 3 lose a factor 8 in absolute accuracy with every halving of
  /// the distance.
  DerivativeRows face_basis(int cell, double u, double v) const;
  /// The same at a point of sector 0, (u, v) in [0, rings]^2 without (0, 0), over all control points; 10 x size.
  DerivativeRows basis(double u, double v) const;

  /// Weights of the limit position of the extraordinary vertex; 1 x size.
  Eigen::RowVectorXd limit_position() const;
  /// Weights of two limit tangents whose cross product points outward; 2 x size. The left eigenvectors of the
  /// subdominant eigenvalue.
  const Eigen::Matrix<double, 2, Eigen::Dynamic>& limit_tangents() const { return limit_tangents_; }

  /// The subdominant eigenvalue of the step.
  double subdominant_eigenvalue() const;
  /// Control points of the characteristic map, size x 2, turned and scaled such that the point (2, 0) of sector 0 maps
  /// to (1, 0).
  Eigen::Matrix<double, Eigen::Dynamic, 2> characteristic_net() const;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void build_step();
  void build_limit_tangents();
  void build_refinements();

  int valence_, rings_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> step_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> limit_tangents_;
  std::vector<std::vector<int>> support_;
  std::vector<std::array<int, 16>> grids_;  ///< of all cells but 0: where the 4 x 4 control points, u fastest, stand
  /// Of the cells (1,0), (0,1), (1,1) of the net after 1, 2, … steps: their 4 x 4 control points by the support of
  /// cell 0.
  std::vector<std::array<Rows, 3>> refined_;
  Rows step_near_;  ///< the step on the support of cell 0
};

}  // namespace umbilic
