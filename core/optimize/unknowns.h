// SPDX-License-Identifier: MIT
/// \file
/// The optimizer's variables: coordinates of the evaluated mesh, or of a coarser mesh that is subdivided to it.
#pragma once

#include <Eigen/SparseCore>

#include "mesh/coordinates.h"

namespace umbilic {

/// control = offset + B Q unknowns. B is the matrix of `coordinates`; Q subdivides from the coarser mesh to the
/// evaluated one, in the coordinates of both. Q = I if they are the same mesh.
class Unknowns {
 public:
  explicit Unknowns(Coordinates coordinates) : coordinates_(std::move(coordinates)) {}
  /// `stencil` maps points of the coarser mesh to those of the finer one. Both coordinates must be for the same group.
  Unknowns(Coordinates coordinates, const Coordinates& coarse, const Eigen::SparseMatrix<double>& stencil)
      : coordinates_(std::move(coordinates)),
        prolongation_(coordinates_.matrix().transpose() * stencil_of_coordinates(stencil) * coarse.matrix()) {}

  int count() const { return coarse() ? static_cast<int>(prolongation_.cols()) : coordinates_.count(); }
  bool coarse() const { return prolongation_.size() > 0; }
  const Coordinates& coordinates() const { return coordinates_; }

  void control(const Eigen::VectorXd& unknowns, Points& control) const {
    if (!coarse()) return coordinates_.control(unknowns, control);
    coordinates_.control(Eigen::VectorXd(prolongation_ * unknowns), control);
  }
  Points control(const Eigen::VectorXd& unknowns) const {
    Points points;
    control(unknowns, points);
    return points;
  }

  /// The gradient with respect to the unknowns.
  void pull_back(const Points& gradient, Eigen::VectorXd& result) const {
    coordinates_.pull_back(gradient, result);
    if (coarse()) result = (prolongation_.transpose() * result).eval();
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
  Eigen::SparseMatrix<double> prolongation_;
};

}  // namespace umbilic
