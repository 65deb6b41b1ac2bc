// SPDX-License-Identifier: MIT
/// \file
/// The control points in the first rings around an extraordinary vertex, and the limit surface that they determine. R +
/// 1 rings of points determine R rings of faces.
///
/// Sector j of N lies between the spokes j and j + 1. Its grid point (a, b) is a steps along spoke j and b steps along
/// spoke j + 1; its face corners (0,0), (1,0), (1,1), (0,1) run counterclockwise. Points of the surface have
/// coordinates (u, v) with the same origin and axes.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "surface/derivatives.h"

namespace umbilic {

class RingNet {
 public:
  /// `rings` >= 2 is the number of rings of faces.
  explicit RingNet(int valence, int rings = 2);

  int valence() const { return valence_; }
  int rings() const { return rings_; }
  int control_rings() const { return rings_ + 1; }
  int size() const { return valence_ * control_rings() * (control_rings() + 1) + 1; }

  /// Index of the control point (a, b) of a sector. A negative a or b refers to the next or previous sector.
  int index(int sector, int a, int b) const;
  /// Index of the control point that has the same place in `sector` as point i has in sector 0.
  int turned(int i, int sector) const;

  /// One Catmull-Clark step of the net onto the same rings of the refined net, size x size.
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& step() const { return step_; }

  /// The control points that determine the limit surface over the face (cell % rings, cell / rings) of sector 0,
  /// sorted.
  const std::vector<int>& support(int cell) const { return support_[cell]; }

  /// Derivatives in (u, v) of the limit surface's basis functions at a point of a face, (u, v) in [0, 1]^2, except (0,
  /// 0) of cell 0; 10 x support. Refines until the point lies in a regular face, as Stam 1998 but without diagonalizing
  /// the matrix. Each halving of the distance to the vertex loses a factor 8 in the absolute accuracy of derivatives of
  /// order 3.
  DerivativeRows face_basis(int cell, double u, double v) const;
  /// The same at a point of sector 0, (u, v) in [0, rings]^2 except (0, 0), over all control points; 10 x size.
  DerivativeRows basis(double u, double v) const;

  /// Weights of the limit position of the extraordinary vertex; 1 x size.
  Eigen::RowVectorXd limit_position() const;
  /// Weights of two limit tangents whose cross product points outward; 2 x size. They are the left eigenvectors of the
  /// subdominant eigenvalue.
  const Eigen::Matrix<double, 2, Eigen::Dynamic>& limit_tangents() const { return limit_tangents_; }

  /// The subdominant eigenvalue of the step.
  double subdominant_eigenvalue() const;
  /// Control points of the characteristic map, size x 2, rotated and scaled so that point (2, 0) of sector 0 maps to
  /// (1, 0).
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
  std::vector<std::array<int, 16>> grids_;  ///< of each cell but 0: indices of its 4 x 4 points, u fastest, in support_
  /// refined_[n - 1][k] gives the 4 x 4 control points of the cells (1,0), (0,1), (1,1) (k = 0, 1, 2) after n steps, as
  /// functions of the support of cell 0.
  std::vector<std::array<Rows, 3>> refined_;
  Rows step_near_;  ///< the step on the support of cell 0
};

}  // namespace umbilic
