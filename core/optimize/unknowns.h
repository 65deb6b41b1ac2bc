// SPDX-License-Identifier: MIT
/// \file
/// The optimizer's variables: coordinates of the evaluated mesh, or of a coarser mesh that is subdivided to it.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

#include "mesh/coordinates.h"
#include "solve/affine_subspace.h"

namespace umbilic {

/// control = offset + B (q0 + Q unknowns), where B is the matrix of `coordinates`. Of the same mesh without equations,
/// q0 = 0 and Q = I. Otherwise Q subdivides from the coarser mesh to the evaluated one, in the coordinates of both; or
/// q0 and Q are the origin and the basis of the solutions of linear equations.
class Unknowns {
 public:
  explicit Unknowns(Coordinates coordinates) : coordinates_(std::move(coordinates)) {}
  /// `stencil` maps points of the coarser mesh to those of the finer one. Both coordinates must be for the same group.
  Unknowns(Coordinates coordinates, const Coordinates& coarse, const Eigen::SparseMatrix<double>& stencil)
      : coordinates_(std::move(coordinates)),
        map_(coordinates_.matrix().transpose() * stencil_of_coordinates(stencil) * coarse.matrix()) {}

  /// Solutions of equations over the unknowns of `coordinates`.
  Unknowns(Coordinates coordinates, std::shared_ptr<const AffineSubspace> solutions)
      : coordinates_(std::move(coordinates)), solutions_(std::move(solutions)) {
    if (solutions_) map_ = solutions_->basis();
  }

  int count() const { return mapped() ? static_cast<int>(map_.cols()) : coordinates_.count(); }
  /// Whether Q is not I.
  bool mapped() const { return solutions_ || map_.size() > 0; }
  const Coordinates& coordinates() const { return coordinates_; }

  void control(const Eigen::VectorXd& unknowns, Points& control) const {
    if (!mapped()) return coordinates_.control(unknowns, control);
    Eigen::VectorXd q = map_ * unknowns;
    if (solutions_) q += solutions_->origin();
    coordinates_.control(q, control);
  }
  Points control(const Eigen::VectorXd& unknowns) const {
    Points points;
    control(unknowns, points);
    return points;
  }

  /// The change of the unknowns that moves the control points by `direction`, or by the nearest direction that they can
  /// move in. Not for unknowns of a coarser mesh.
  Eigen::VectorXd direction(const Points& direction) const {
    Eigen::VectorXd change = coordinates_.pull_back(direction);
    return solutions_ ? solutions_->coordinates(solutions_->origin() + change) : change;
  }

  /// The gradient with respect to the unknowns.
  void pull_back(const Points& gradient, Eigen::VectorXd& result) const {
    coordinates_.pull_back(gradient, result);
    if (!mapped()) return;
    // Not assigned: a vector that Eigen fails to resize is freed twice.
    Eigen::VectorXd reduced = map_.transpose() * result;
    result.swap(reduced);
  }
  Eigen::VectorXd pull_back(const Points& gradient) const {
    Eigen::VectorXd result;
    pull_back(gradient, result);
    return result;
  }

  /// The lower triangle of Q^T A Q, from the lower triangle of a symmetric matrix A over `coordinates`.
  Eigen::SparseMatrix<double> reduce(const Eigen::SparseMatrix<double>& lower) const;

 private:
  static Eigen::SparseMatrix<double> stencil_of_coordinates(const Eigen::SparseMatrix<double>& stencil);

  Coordinates coordinates_;
  Eigen::SparseMatrix<double> map_;  // Q
  std::shared_ptr<const AffineSubspace> solutions_;
};

}  // namespace umbilic
