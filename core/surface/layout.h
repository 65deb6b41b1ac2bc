// SPDX-License-Identifier: MIT
/// \file
/// Which patches an evaluable mesh consists of, and which points each of them needs.
///
/// The points of a layout are the control points followed by the coefficients of all caps, a block for each sector.
#pragma once

#include <vector>

#include "mesh/orbits.h"
#include "mesh/subdivision.h"
#include "surface/basis_table.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// The neighbourhood of one extraordinary vertex.
struct Cap {
  int vertex = 0;
  int valence = 0;
  CapShape shape = CapShape::kBare;
  std::vector<int> net;       ///< control points in the order of RingNet; -1 beyond the shape's control rings
  int first_coefficient = 0;  ///< point of the layout; sector j starts j * coefficient_count(shape) later
};

/// All patches of one kind.
struct PatchSet {
  PatchKind kind;
  int columns = 0;
  std::vector<int> halfedges;          ///< of each patch: from its corner (0,0) along u
  std::vector<int> points;             ///< patches x columns: points of the layout
  std::vector<int> caps;               ///< of each patch at a cap: the cap
  std::vector<double> multiplicities;  ///< how many patches each one stands for

  int count() const { return static_cast<int>(halfedges.size()); }
  /// Those of a patch, `columns` of them.
  const int* points_of(int patch) const { return &points[static_cast<std::size_t>(columns) * patch]; }
};

class PatchLayout {
 public:
  /// `mesh` is evaluable (mesh/hierarchy.h). Smooth caps take four rings, or two, or one, such that those of all
  /// extraordinary vertices would not overlap.
  PatchLayout(const PolygonMesh& mesh, CapKind cap);
  /// One patch of each orbit of faces, which stands for the whole orbit; only the caps that these patches need.
  PatchLayout(const PolygonMesh& mesh, CapKind cap, const Orbits& face_orbits);

  int control_count() const { return control_count_; }
  int point_count() const { return point_count_; }
  int patch_count() const;
  int face_count() const { return face_count_; }  ///< of the mesh
  CapKind cap() const { return cap_; }
  const std::vector<PatchSet>& sets() const { return sets_; }
  const std::vector<Cap>& caps() const { return caps_; }

  /// The control points, followed by the caps' coefficients that they decide.
  Points extend(const Points& control) const;
  void extend(const Points& control, Points& points) const;
  /// Adds to the control points' part of a gradient by the layout's points what the coefficients' part contributes.
  void pull_back(Points& gradient) const;
  /// point_count x control_count: `extend` as a matrix.
  SparseMatrix extension() const;

 private:
  std::vector<Cap> find_caps(const PolygonMesh& mesh) const;
  void add_patch(PatchKind kind, int halfedge, int cap, const std::vector<int>& points, double multiplicity);

  CapKind cap_;
  int control_count_, point_count_, face_count_;
  std::vector<Cap> caps_;
  std::vector<PatchSet> sets_;
};

}  // namespace umbilic
