// SPDX-License-Identifier: MIT
/// \file
/// Linear coordinates of the control points: all of them, or those that are symmetric under a group.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "mesh/symmetry.h"

namespace umbilic {

/// control = offset + B unknowns, where B^T B = I. B has one block of at most three columns in the rows of each
/// vertex, and vertices of one orbit share their columns, so that every function here is linear in the number of
/// vertices. The versions with a result parameter resize it if need be and allocate nothing else.
class Coordinates {
 public:
  /// Rows of B of one vertex: its position is offset + basis unknowns[first, first + dimension).
  struct Block {
    int first = 0;
    int dimension = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3> basis;  ///< 3 x dimension
  };

  /// Every coordinate free: B = I, offset 0.
  explicit Coordinates(int vertex_count);
  /// The points that are symmetric under the group, about its center.
  Coordinates(const PolygonMesh& mesh, const SymmetryGroup& group);

  /// Whether B = I.
  bool free() const { return rows_.empty(); }
  int count() const { return count_; }  ///< of unknowns
  int vertex_count() const { return vertex_count_; }

  Points control(const Eigen::VectorXd& unknowns) const;
  void control(const Eigen::VectorXd& unknowns, Points& control) const;

  /// B^T (control - offset): the unknowns of the nearest points that are symmetric.
  Eigen::VectorXd unknowns(const Points& control) const;
  void unknowns(const Points& control, Eigen::VectorXd& unknowns) const;

  /// B^T gradient, the gradient with respect to the unknowns.
  Eigen::VectorXd pull_back(const Points& gradient) const;
  void pull_back(const Points& gradient, Eigen::VectorXd& unknowns) const;

  /// The points of the first vertex of each orbit, in the order of these vertices; of every vertex where all are free.
  Points orbit_points(const Points& control) const;
  /// The symmetric points with these points of the first vertices, each moved to the nearest place that its vertex's
  /// stabilizer leaves free. `points` has `orbit_count` rows.
  Points control_from_orbits(const Points& points) const;
  int orbit_count() const { return free() ? vertex_count_ : static_cast<int>(first_of_orbit_.size()); }

  Block block(int vertex) const;
  /// B, 3 vertex_count x count.
  Eigen::SparseMatrix<double> matrix() const;

 private:
  /// Columns of `basis` from `dimension` on are not used.
  struct Rows {
    int first = 0;
    int dimension = 0;
    Eigen::Matrix3d basis;
  };

  void project(const Points& rows, const Vector3& offset, Eigen::VectorXd& unknowns) const;

  int vertex_count_ = 0;
  int count_ = 0;
  Vector3 offset_ = Vector3::Zero();  ///< of each vertex
  std::vector<Rows> rows_;            ///< of each vertex; empty where every coordinate is free
  std::vector<int> first_of_orbit_;   ///< empty where every coordinate is free
};

}  // namespace umbilic
