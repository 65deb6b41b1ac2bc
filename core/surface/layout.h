// SPDX-License-Identifier: MIT
/// \file
/// The patches of an evaluable mesh, and the points that each of them needs.
///
/// The points of a layout are the control points, then the coefficients of all caps, one block per sector.
#pragma once

#include <vector>

#include "mesh/orbits.h"
#include "mesh/subdivision.h"
#include "surface/basis_table.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// One extraordinary vertex with its neighbourhood.
struct Cap {
  int vertex = 0;
  int valence = 0;
  int sectors = 0;  ///< those that carry surface, from sector 0 on: all, but for a vertex on the boundary
  CapShape shape = CapShape::kBare;
  std::vector<int> net;  ///< control points in the order of RingNet; -1 for those that the cap does not depend on
  /// Index of the layout point that holds sector 0's first coefficient. Sector j's are j * coefficient_count(shape)
  /// later.
  int first_coefficient = 0;
};

/// The data of the cap's sectors.
inline const CapSector& sector_of(const Cap& cap) { return cap_sector(cap.valence, cap.shape, cap.sectors); }

/// All patches of one kind.
struct PatchSet {
  PatchKind kind;
  int columns = 0;
  std::vector<int> halfedges;          ///< of each patch: the half-edge from its corner (0,0) along u
  std::vector<int> points;             ///< patches x columns: indices of layout points
  std::vector<int> caps;               ///< of each patch in a cap: index of the cap
  std::vector<double> multiplicities;  ///< size of the orbit that each patch stands for

  int count() const { return static_cast<int>(halfedges.size()); }
  /// The `columns` layout points of a patch.
  const int* points_of(int patch) const { return &points[static_cast<std::size_t>(columns) * patch]; }
};

/// Whether caps of this valence take more than four rings where they have room for no more than these.
constexpr bool uses_all_room(int valence) { return valence <= 5; }

/// Which faces of a mesh a layout covers, where the surface over some of them is held.
enum class Part { kAll, kFree, kHeld };

class PatchLayout {
 public:
  /// `mesh` must be evaluable (mesh/hierarchy.h). Each smooth cap takes as many rings as it has room for, at most
  /// `cap.most_rings`: 1, 2, 4, 8 or 16. There is room for a power of 2 if no other vertex that has half of it reaches
  /// one of these faces, and if they are all held or all free. Only caps of valence 3 and 5 use it whole beyond four
  /// rings, others half of it: faces of wide caps cost several times as much as others, and with more valence there are
  /// more.
  /// Only faces of the surface get patches. A cap may not reach over the boundary; at an extraordinary vertex on the
  /// boundary it takes one ring of the surface.
  PatchLayout(const PolygonMesh& mesh, CapChoice cap);
  /// Keeps only one patch of each orbit of faces, with the size of the orbit as its multiplicity, and only the caps of
  /// those patches. `held` tells of each face whether it is held, or is empty; orbits are held as a whole.
  PatchLayout(const PolygonMesh& mesh, CapChoice cap, const Orbits& face_orbits, const std::vector<bool>& held = {},
              Part part = Part::kAll);

  int control_count() const { return control_count_; }
  int point_count() const { return point_count_; }
  int patch_count() const;
  int face_count() const { return face_count_; }  ///< of the part of the surface that is covered
  CapChoice cap() const { return cap_; }
  const std::vector<PatchSet>& sets() const { return sets_; }
  const std::vector<Cap>& caps() const { return caps_; }

  /// The layout's points from the control points: these, followed by the caps' coefficients, a linear function of them.
  Points extend(const Points& control) const;
  void extend(const Points& control, Points& points) const;
  /// The transpose of `extend`: adds to the first control_count rows of `gradient` what its other rows contribute.
  void pull_back(Points& gradient) const;
  /// point_count x control_count: `extend` as a matrix.
  SparseMatrix extension() const;

  /// Of each control point: whether the surface over the covered faces depends on it.
  std::vector<bool> used_control_points() const;

 private:
  std::vector<Cap> find_caps(const PolygonMesh& mesh, const std::vector<bool>& held) const;
  void add_patch(PatchKind kind, int halfedge, int cap, const std::vector<int>& points, double multiplicity);

  CapChoice cap_;
  int control_count_, point_count_, face_count_;
  std::vector<Cap> caps_;
  std::vector<PatchSet> sets_;
};

}  // namespace umbilic
