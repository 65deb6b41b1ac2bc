// SPDX-License-Identifier: MIT
/// \file
/// Linear coordinates of the control points: all of them, or those that are symmetric under a group, without those that
/// are held.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "mesh/symmetry.h"

namespace umbilic {

/// Control points that do not move, and where they are.
struct HeldPoints {
  std::vector<bool> held;  ///< of each vertex; empty if none is held
  Points points;           ///< of all vertices; only those of held ones count

  bool any() const { return !held.empty(); }
};

/// control = offset + B unknowns, with B^T B = I.
///
/// Under a symmetry group only one vertex of each orbit is free, and only in the directions that its stabilizer fixes:
/// a vertex on a mirror plane has two unknowns, one on a rotation axis has one. Vertices of one orbit share the same
/// columns of B, and each has a block of at most three, so every function here takes linear time. A held vertex has no
/// unknowns: its control point is the held one, to the last bit. Versions with a result parameter resize it when needed
/// and allocate nothing else.
class Coordinates {
 public:
  /// The rows of B of one vertex: its position is offset + basis unknowns[first, first + dimension).
  struct Block {
    int first = 0;
    int dimension = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3> basis;  ///< 3 x dimension
  };

  /// All coordinates are free: B = I, offset 0.
  explicit Coordinates(int vertex_count);
  /// Coordinates of the points that are symmetric under the group, about its center. The group must map held points to
  /// held points.
  Coordinates(const PolygonMesh& mesh, const SymmetryGroup& group, HeldPoints held = {});

  /// Whether B = I.
  bool free() const { return rows_.empty(); }
  /// Whether each vertex has its own x, y and z as unknowns, or none if it is held.
  bool cartesian() const { return cartesian_; }
  int count() const { return count_; }  ///< number of unknowns
  int vertex_count() const { return vertex_count_; }

  Points control(const Eigen::VectorXd& unknowns) const;
  void control(const Eigen::VectorXd& unknowns, Points& control) const;

  /// B^T (control - offset): the unknowns of the symmetric points nearest to `control`.
  Eigen::VectorXd unknowns(const Points& control) const;
  void unknowns(const Points& control, Eigen::VectorXd& unknowns) const;

  /// B^T gradient, the gradient with respect to the unknowns.
  Eigen::VectorXd pull_back(const Points& gradient) const;
  void pull_back(const Points& gradient, Eigen::VectorXd& unknowns) const;

  /// The points of the first vertex of each orbit, ordered by vertex; all points if every coordinate is free.
  Points orbit_points(const Points& control) const;
  /// The inverse of `orbit_points`: symmetric points from those of the first vertices, `orbit_count` x 3. Each is first
  /// projected to the nearest position that its vertex's stabilizer fixes.
  Points control_from_orbits(const Points& points) const;
  int orbit_count() const { return free() ? vertex_count_ : static_cast<int>(first_of_orbit_.size()); }

  Block block(int vertex) const;
  /// B as a sparse matrix, 3 vertex_count x count.
  Eigen::SparseMatrix<double> matrix() const;

 private:
  /// Only the first `dimension` columns of `basis` are used.
  struct Rows {
    int first = 0;
    int dimension = 0;
    Eigen::Matrix3d basis;
  };

  void project(const Points& rows, const Vector3& offset, Eigen::VectorXd& unknowns) const;

  int vertex_count_ = 0;
  int count_ = 0;
  bool cartesian_ = true;
  Vector3 offset_ = Vector3::Zero();  ///< the same for all vertices that are not held
  HeldPoints held_;
  std::vector<Rows> rows_;           ///< one per vertex; empty if every coordinate is free
  std::vector<int> first_of_orbit_;  ///< first vertex of each orbit; empty if every coordinate is free
};

}  // namespace umbilic
