// SPDX-License-Identifier: MIT
/// \file
/// Whether one flag of a mesh with points can be mapped to another by a symmetry, within a tolerance.
#pragma once

#include <optional>

#include "mesh/symmetry.h"

namespace umbilic {

/// A half-edge and a sense of going around its face: a symmetry of a connected mesh is determined by the image of one.
struct Flag {
  int halfedge = 0;
  bool reversed = false;

  int index() const { return 2 * halfedge + (reversed ? 1 : 0); }
};

inline Flag image_of_flag(const Automorphism& map, Flag flag) {
  return {map.halfedges[flag.halfedge], flag.reversed != map.reverses};
}

/// Symmetries are extended from the base flag over its component, breadth first, as long as lengths agree; the isometry
/// that fits best then maps the other components.
class FlagMatching {
 public:
  /// `extent` is the largest distance of a point from the center, and positive. Every vertex has an edge.
  FlagMatching(const PolygonMesh& mesh, const Points& points, const Vector3& center, double extent);

  /// Whether the points of some component span a plane with the center; without one there is no base.
  bool has_base() const { return base_ >= 0; }
  /// The half-edge that resembles the fewest others, of the components that span the most dimensions and are about as
  /// spread out as any. Taken as not reversed it is the base flag.
  int base() const { return base_; }

  /// The flags that resemble the base flag within `tolerance`, an absolute length.
  std::vector<Flag> candidates(double tolerance) const;

  /// The symmetry that maps the base flag to `image` and each point to within `tolerance` of its image. None, too,
  /// where the work runs out on the way.
  std::optional<Symmetry> symmetry(Flag image, double tolerance);

  /// Takes so many half-edges' work off what may be done.
  void charge(double halfedges) { work_left_ -= halfedges; }
  /// Whether no work is left, so that a symmetry that is not found may be there all the same.
  bool exhausted() const { return work_left_ < 0; }

 private:
  struct Component {
    int first = 0;      ///< its first half-edge
    int size = 0;       ///< number of half-edges
    int dimension = 0;  ///< of the space that its points span with the center
    double spread = 0;  ///< least root mean square of its points along the axes of that space
  };

  void find_components(double extent);
  void choose_base(double extent);
  Vector3 point(int v) const { return points_.row(v).transpose(); }
  /// Whether one step of the extension is possible: faces, valences, and either lengths or, if given, positions.
  bool agree(int h, Flag image, const Eigen::Matrix3d* isometry, double tolerance) const;
  /// Extends `map` from h to its component; leaves it as it was where that fails.
  bool extend(int h, Flag image, const Eigen::Matrix3d* isometry, double tolerance, Automorphism& map);
  /// The flags at the image of h, the components that come first first: components that coincide keep their order, so
  /// that products of symmetries are found as well.
  std::vector<Flag> images_of(int h, const Eigen::Matrix3d& isometry, bool reverses, double tolerance);
  /// Extends `map` from the base component to each other, each to the first component in its place.
  bool extend_to_others(const Eigen::Matrix3d& isometry, double tolerance, Automorphism& map);
  /// The orthogonal matrix that maps the points that `map` reaches best to their images. It is unique up to its
  /// sign off the plane of points of dimension 2; then its determinant is negative where the map reverses.
  Eigen::Matrix3d fit(const Automorphism& map, int dimension) const;
  bool within(const Symmetry& symmetry, double tolerance) const;

  const PolygonMesh& mesh_;
  Points points_;               ///< relative to the center
  std::vector<double> radius_;  ///< of each vertex: its distance from the center
  std::vector<double> length_;  ///< of each half-edge
  std::vector<int> component_;  ///< of each half-edge
  std::vector<Component> components_;
  std::vector<int> by_radius_;  ///< half-edges in the order of their origins' radii
  std::vector<int> queue_;      ///< half-edges that the last extension has reached
  int base_ = -1;
  double work_left_;
};

}  // namespace umbilic
