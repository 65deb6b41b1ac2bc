// SPDX-License-Identifier: MIT
/// \file
/// Decides whether a symmetry maps one flag of a mesh with points to another, within a tolerance.
#pragma once

#include <optional>

#include "mesh/symmetry.h"

namespace umbilic {

/// A half-edge and a direction around its face. A symmetry of a connected mesh is determined by the image of a single
/// flag, so that each symmetry can be found by trying the images of one.
struct Flag {
  int halfedge = 0;
  bool reversed = false;

  int index() const { return 2 * halfedge + (reversed ? 1 : 0); }
};

inline Flag image_of_flag(const Automorphism& map, Flag flag) {
  return {map.halfedges[flag.halfedge], flag.reversed != map.reverses};
}

/// Extends a map of the base flag over its component, breadth first, as long as valences, face sizes and lengths agree.
/// The isometry that fits this map best then places the other components.
class FlagMatching {
 public:
  /// `extent` > 0 is the largest distance of a point from the center. Every vertex must have an edge.
  FlagMatching(const PolygonMesh& mesh, const Points& points, const Vector3& center, double extent);

  /// Whether some component spans at least a plane through the center. Without one there is no base.
  bool has_base() const { return base_ >= 0; }
  /// The base half-edge: the one that resembles the fewest others, so that few images must be tried. It is taken from
  /// the components that span the most dimensions and are not much less spread out than the widest. The base flag is
  /// this half-edge, not reversed.
  int base() const { return base_; }

  /// The flags that resemble the base flag within `tolerance`, an absolute length.
  std::vector<Flag> candidates(double tolerance) const;

  /// The symmetry that maps the base flag to `image` and each point to within `tolerance` of its image.
  /// Also returns nothing if the work runs out before it is found.
  std::optional<Symmetry> symmetry(Flag image, double tolerance);

  /// Counts work on this many half-edges.
  void charge(double halfedges) { work_left_ -= halfedges; }
  /// Whether the work has run out, so that existing symmetries may not be found.
  bool exhausted() const { return work_left_ < 0; }

 private:
  struct Component {
    int first = 0;      ///< its first half-edge
    int size = 0;       ///< number of half-edges
    int dimension = 0;  ///< of the space that its points span about the center
    double spread = 0;  ///< smallest root mean square of its points along the principal axes of that space
  };

  void find_components(double extent);
  void choose_base(double extent);
  Vector3 point(int v) const { return points_.row(v).transpose(); }
  /// Whether h may map to `image`: face sizes and valences agree, and so do lengths, or positions if an isometry is
  /// given.
  bool agree(int h, Flag image, const Eigen::Matrix3d* isometry, double tolerance) const;
  /// Extends `map` from h to its component. Returns false, with `map` unchanged, if that is impossible.
  bool extend(int h, Flag image, const Eigen::Matrix3d* isometry, double tolerance, Automorphism& map);
  /// The flags at the place to which the isometry moves h, ordered by component. Coincident components thus keep their
  /// order, so that products of symmetries are found as well.
  std::vector<Flag> images_of(int h, const Eigen::Matrix3d& isometry, bool reverses, double tolerance);
  /// Extends `map` to all other components, each to the first unused component that lies where the isometry moves it.
  bool extend_to_others(const Eigen::Matrix3d& isometry, double tolerance, Automorphism& map);
  /// The orthogonal matrix that best maps the points that `map` reaches to their images. Points of dimension 2 do not
  /// determine its sign normal to their plane; its determinant is then chosen negative if the map reverses.
  Eigen::Matrix3d fit(const Automorphism& map, int dimension) const;
  bool within(const Symmetry& symmetry, double tolerance) const;

  const PolygonMesh& mesh_;
  Points points_;               ///< relative to the center
  std::vector<double> radius_;  ///< of each vertex: its distance from the center
  std::vector<double> length_;  ///< of each half-edge
  std::vector<int> component_;  ///< of each half-edge
  std::vector<Component> components_;
  std::vector<int> by_radius_;  ///< half-edges sorted by the radius of their origin
  std::vector<int> queue_;      ///< half-edges that the last extension has reached
  int base_ = -1;
  double work_left_;
};

}  // namespace umbilic
