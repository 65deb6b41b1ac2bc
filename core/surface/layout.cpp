// SPDX-License-Identifier: MIT
/// \file
/// Walks the quads around each extraordinary vertex and around each regular face.
#include "surface/layout.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "mesh/boundary.h"
#include "surface/cells.h"

namespace umbilic {
namespace {

/// Half-edge along u of the cell (i, j) of the sector that starts with the cell of `h`.
int sector_cell(const PolygonMesh& m, int h, int i, int j) {
  for (; j > 0; --j) h = cell_above(m, h);
  for (; i > 0; --i) h = cell_right(m, h);
  return h;
}

/// The same while the cells are surface; -1 if one is not.
int surface_cell(const PolygonMesh& m, int h, int i, int j) {
  for (; j > 0 && m.is_surface(m.face(h)); --j) h = cell_above(m, h);
  for (; i > 0 && m.is_surface(m.face(h)); --i) h = cell_right(m, h);
  return m.is_surface(m.face(h)) ? h : -1;
}

/// Counterclockwise; at a vertex on the boundary the spokes of the surface's sectors come first.
std::vector<int> spokes(const PolygonMesh& mesh, int vertex) {
  std::vector<int> result;
  const int leaving = boundary_halfedge(mesh, vertex), first = leaving < 0 ? mesh.outgoing(vertex) : leaving;
  int h = first;
  do {
    result.push_back(h);
    h = mesh.rotate(h);
  } while (h != first);
  return result;
}

/// Indices of the control points in the first `rings` rings, in the order of RingNet; -1 for all others.
std::vector<int> gather_net(const PolygonMesh& mesh, int vertex, const RingNet& net, int rings) {
  std::vector<int> points(net.size(), -1);
  points[0] = vertex;
  const std::vector<int> spoke = spokes(mesh, vertex);
  for (int sector = 0; sector < net.valence(); ++sector) {
    for (int b = 0; b <= rings; ++b) {
      for (int a = 1; a <= rings; ++a) {
        const int h = sector_cell(mesh, spoke[sector], a - 1, std::min(b, rings - 1));
        points[net.index(sector, a, b)] = b < rings ? mesh.target(h) : mesh.target(mesh.next(h));
      }
    }
  }
  return points;
}

/// The same for a vertex on the boundary, whose first `sectors` sectors carry surface: the points of the first ring,
/// and the points around the faces of these sectors, which all exist, for the faces' corners have their ghosts.
std::vector<int> gather_boundary_net(const PolygonMesh& mesh, int vertex, const RingNet& net, int sectors) {
  std::vector<int> points(net.size(), -1);
  points[0] = vertex;
  const std::vector<int> spoke = spokes(mesh, vertex);
  for (int sector = 0; sector < net.valence(); ++sector) {
    points[net.index(sector, 1, 0)] = mesh.target(spoke[sector]);
    points[net.index(sector, 1, 1)] = mesh.target(mesh.next(spoke[sector]));
  }
  for (int sector = 0; sector < sectors; ++sector) {
    const int right = cell_right(mesh, spoke[sector]), above = cell_above(mesh, spoke[sector]);
    points[net.index(sector, 2, -1)] = mesh.target(cell_below(mesh, right));
    points[net.index(sector, 2, 0)] = mesh.target(right);
    points[net.index(sector, 2, 1)] = mesh.target(mesh.next(right));
    points[net.index(sector, 2, 2)] = mesh.target(mesh.next(cell_right(mesh, above)));
    points[net.index(sector, 1, 2)] = mesh.target(mesh.next(above));
    points[net.index(sector, 0, 2)] = mesh.origin(mesh.previous(above));
    points[net.index(sector, -1, 2)] = mesh.origin(mesh.previous(cell_left(mesh, above)));
  }
  return points;
}

/// The 4 x 4 control points of a regular face, u fastest.
std::vector<int> gather_regular(const PolygonMesh& mesh, int h) {
  std::vector<int> points(16);
  int row = cell_below(mesh, cell_left(mesh, h));
  for (int b = 0; b < 4; ++b) {
    const bool top = b == 3;
    int cell = row;
    for (int a = 0; a < 3; ++a) {
      const int along = top ? mesh.twin(mesh.next(mesh.next(cell))) : cell;
      points[4 * b + a] = mesh.origin(along);
      if (a == 2) points[4 * b + 3] = mesh.target(along);
      if (a < 2) cell = cell_right(mesh, cell);
    }
    if (b < 2) row = cell_above(mesh, row);
  }
  return points;
}

/// The faces of the surface in the first `rings` rings of the vertex; a face that is reached twice is listed twice.
std::vector<int> faces_around(const PolygonMesh& mesh, int vertex, int rings) {
  std::vector<int> faces;
  for (const int spoke : spokes(mesh, vertex)) {
    for (int j = 0; j < rings; ++j) {
      for (int i = 0; i < rings; ++i) {
        const int h = surface_cell(mesh, spoke, i, j);
        if (h >= 0) faces.push_back(mesh.face(h));
      }
    }
  }
  return faces;
}

/// The faces that a cap would change if it took so many rings, or as many less as leave it on the surface.
struct Reach {
  std::vector<int> faces;
  bool whole = true;  ///< whether it is so many rings
};

Reach reach_of(const PolygonMesh& mesh, int vertex, int rings) {
  if (rings == 1 || boundary_halfedge(mesh, vertex) >= 0) return {faces_around(mesh, vertex, 1), rings == 1};
  std::vector<int> faces = faces_around(mesh, vertex, rings);
  if (static_cast<int>(faces.size()) == rings * rings * mesh.valence(vertex)) return {std::move(faces), true};
  return {reach_of(mesh, vertex, rings / 2).faces, false};
}

/// Whether no other reach has one of the faces, and all of them are held or all free.
class Room {
 public:
  Room(const PolygonMesh& mesh, const std::vector<Reach>& reaches, const std::vector<bool>& held)
      : held_(held), reached_(mesh.face_count(), 0) {
    for (const Reach& reach : reaches) {
      for (const int f : reach.faces) ++reached_[f];
    }
  }
  bool for_reach(const Reach& reach) const {
    return std::all_of(reach.faces.begin(), reach.faces.end(), [&](int f) {
      return reached_[f] == 1 && (held_.empty() || held_[f] == held_[reach.faces.front()]);
    });
  }

 private:
  const std::vector<bool>& held_;
  std::vector<int> reached_;
};

/// The shape of a cap with room for so many rings.
CapShape shape_with_room(int rings, int valence) {
  const int wide = uses_all_room(valence) ? rings : rings / 2;
  if (wide >= 16) return CapShape::kSixteenRing;
  if (wide == 8) return CapShape::kEightRing;
  return rings >= 4 ? CapShape::kFourRing : rings == 2 ? CapShape::kTwoRing : CapShape::kOneRing;
}

/// Shapes of smooth caps, as PatchLayout's constructor tells. The room is doubled only for those that have it so far:
/// where extraordinary vertices are close together the search ends soon.
std::vector<CapShape> widest_shapes(const PolygonMesh& mesh, const std::vector<int>& extraordinary,
                                    const std::vector<bool>& held, int most_rings) {
  std::vector<CapShape> shapes(extraordinary.size(), CapShape::kOneRing);
  std::vector<std::size_t> growing(extraordinary.size());
  std::iota(growing.begin(), growing.end(), 0);
  std::vector<Reach> reaches(extraordinary.size());
  const int most_room = most_rings > 4 ? 2 * most_rings : most_rings;  // some use half of it
  for (int wider = 2; wider <= most_room && !growing.empty(); wider *= 2) {
    for (const std::size_t i : growing) reaches[i] = reach_of(mesh, extraordinary[i], wider);
    const Room room(mesh, reaches, held);
    std::erase_if(growing, [&](std::size_t i) { return !reaches[i].whole || !room.for_reach(reaches[i]); });
    for (const std::size_t i : growing) {
      const CapShape shape = shape_with_room(wider, mesh.valence(extraordinary[i]));
      if (rings(shape) <= most_rings) shapes[i] = shape;
    }
  }
  return shapes;
}

/// Picks one face of each orbit to represent it.
class Representatives {
 public:
  explicit Representatives(const Orbits& orbits) : orbits_(orbits), taken_(orbits.sizes.size(), false) {}

  /// The size of the face's orbit when the orbit is met first; 0 afterwards.
  int take(int face) {
    const int orbit = orbits_.of[face];
    if (taken_[orbit]) return 0;
    taken_[orbit] = true;
    return orbits_.sizes[orbit];
  }

 private:
  const Orbits& orbits_;
  std::vector<bool> taken_;
};

Orbits single_faces(const PolygonMesh& mesh) {
  Orbits orbits{std::vector<int>(mesh.face_count()), std::vector<int>(mesh.face_count(), 1)};
  std::iota(orbits.of.begin(), orbits.of.end(), 0);
  return orbits;
}

}  // namespace

PatchLayout::PatchLayout(const PolygonMesh& mesh, CapChoice cap) : PatchLayout(mesh, cap, single_faces(mesh)) {}

PatchLayout::PatchLayout(const PolygonMesh& mesh, CapChoice cap, const Orbits& face_orbits,
                         const std::vector<bool>& held, Part part)
    : cap_(cap), control_count_(mesh.vertex_count()), point_count_(control_count_), face_count_(0) {
  const auto covers = [&](int f) { return part == Part::kAll || (!held.empty() && held[f]) == (part == Part::kHeld); };
  for (int f = 0; f < mesh.surface_face_count(); ++f) face_count_ += covers(f);
  Representatives representatives(face_orbits);
  std::vector<bool> capped(mesh.face_count(), false);
  for (Cap& here : find_caps(mesh, held)) {
    here.first_coefficient = point_count_;
    const RingNet& net = sector_of(here).net();
    const std::vector<int> spoke = spokes(mesh, here.vertex);
    bool needed = false;
    for (int cell = 0; cell < cell_count(here.shape); ++cell) {
      const PatchKind kind{here.valence, here.shape, cell};
      const PatchColumns columns = patch_columns(kind);
      for (int sector = 0; sector < here.sectors; ++sector) {
        const int h = sector_cell(mesh, spoke[sector], cell % rings(here.shape), cell / rings(here.shape));
        capped[mesh.face(h)] = true;
        if (!covers(mesh.face(h))) continue;
        const int multiplicity = representatives.take(mesh.face(h));
        if (multiplicity == 0) continue;
        needed = true;
        std::vector<int> points;
        for (const int i : columns.net) {
          points.push_back(here.net[net.turned(i, sector)]);
          assert(points.back() >= 0);
        }
        for (int i = 0; i < columns.coefficients; ++i) {
          points.push_back(here.first_coefficient + sector * columns.coefficients + i);
        }
        add_patch(kind, h, static_cast<int>(caps_.size()), points, multiplicity);
      }
    }
    if (!needed) continue;
    point_count_ += here.sectors * coefficient_count(here.shape);
    caps_.push_back(std::move(here));
  }
  for (int f = 0; f < mesh.surface_face_count(); ++f) {
    if (capped[f] || !covers(f)) continue;
    const int multiplicity = representatives.take(f);
    if (multiplicity > 0)
      add_patch({}, mesh.halfedge(f, 0), -1, gather_regular(mesh, mesh.halfedge(f, 0)), multiplicity);
  }
  std::sort(sets_.begin(), sets_.end(), [](const PatchSet& a, const PatchSet& b) { return a.kind < b.kind; });
}

int PatchLayout::patch_count() const {
  return std::accumulate(sets_.begin(), sets_.end(), 0, [](int sum, const PatchSet& set) { return sum + set.count(); });
}

std::vector<bool> PatchLayout::used_control_points() const {
  std::vector<bool> used(control_count_, false);
  for (const PatchSet& set : sets_) {
    for (const int point : set.points) {
      if (point < control_count_) used[point] = true;
    }
  }
  for (const Cap& cap : caps_) {
    for (const int i : sector_of(cap).fit_support()) used[cap.net[i]] = true;
  }
  return used;
}

std::vector<Cap> PatchLayout::find_caps(const PolygonMesh& mesh, const std::vector<bool>& held) const {
  std::vector<int> extraordinary;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_extraordinary(v) && mesh.on_surface(v)) extraordinary.push_back(v);
  }
  const std::vector<CapShape> shapes =
      cap_ == CapKind::kSmooth
          ? widest_shapes(mesh, extraordinary, held, cap_.most_rings)
          : std::vector<CapShape>(extraordinary.size(), cap_ == CapKind::kNone ? CapShape::kBare : CapShape::kFlat);
  std::vector<Cap> caps;
  for (std::size_t i = 0; i < extraordinary.size(); ++i) {
    const int v = extraordinary[i], valence = mesh.valence(v);
    Cap& cap = caps.emplace_back(Cap{v, valence, valence, shapes[i], {}, 0});
    const RingNet& net = sector_of(cap).net();
    if (boundary_halfedge(mesh, v) < 0) {
      cap.net = gather_net(mesh, v, net, control_rings(cap.shape));
    } else {
      cap.sectors = surface_valence(mesh, v);
      cap.net = gather_boundary_net(mesh, v, net, cap.sectors);
    }
  }
  return caps;
}

void PatchLayout::add_patch(PatchKind kind, int halfedge, int cap, const std::vector<int>& points,
                            double multiplicity) {
  auto set = std::find_if(sets_.begin(), sets_.end(), [&](const PatchSet& s) { return s.kind == kind; });
  if (set == sets_.end()) set = sets_.insert(set, {kind, static_cast<int>(points.size()), {}, {}, {}, {}});
  set->halfedges.push_back(halfedge);
  set->points.insert(set->points.end(), points.begin(), points.end());
  if (cap >= 0) set->caps.push_back(cap);
  set->multiplicities.push_back(multiplicity);
}

namespace {

/// The coefficients of a cap's polynomial, in the coordinates of sector 0.
using Coefficients =
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, coefficient_count(CapShape::kSixteenRing), 3>;

}  // namespace

Points PatchLayout::extend(const Points& control) const {
  Points points;
  extend(control, points);
  return points;
}

void PatchLayout::extend(const Points& control, Points& points) const {
  assert(control.rows() == control_count_);
  points.resize(point_count_, 3);
  points.topRows(control_count_) = control;
  for (const Cap& cap : caps_) {
    const int count = coefficient_count(cap.shape);
    if (count == 0) continue;
    const CapSector& sector = sector_of(cap);
    Coefficients coefficients = Coefficients::Zero(count, 3);
    for (const int i : sector.fit_support()) coefficients.noalias() += sector.fit().col(i) * control.row(cap.net[i]);
    for (int j = 0; j < cap.sectors; ++j) {
      points.middleRows(cap.first_coefficient + j * count, count) = sector.turn(j).lazyProduct(coefficients);
    }
  }
}

void PatchLayout::pull_back(Points& gradient) const {
  assert(gradient.rows() == point_count_);
  for (const Cap& cap : caps_) {
    const int count = coefficient_count(cap.shape);
    if (count == 0) continue;
    const CapSector& sector = sector_of(cap);
    Coefficients coefficients = Coefficients::Zero(count, 3);
    for (int j = 0; j < cap.sectors; ++j) {
      const auto here = gradient.middleRows(cap.first_coefficient + j * count, count);
      coefficients += sector.turn(j).transpose().lazyProduct(here);
    }
    for (const int i : sector.fit_support()) {
      gradient.row(cap.net[i]) += sector.fit().col(i).transpose().lazyProduct(coefficients);
    }
  }
}

SparseMatrix PatchLayout::extension() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < control_count_; ++v) entries.emplace_back(v, v, 1);
  for (const Cap& cap : caps_) {
    const int count = coefficient_count(cap.shape);
    if (count == 0) continue;
    const CapSector& sector = sector_of(cap);
    for (int j = 0; j < cap.sectors; ++j) {
      const Eigen::MatrixXd fit = sector.turn(j) * sector.fit();
      for (const int i : sector.fit_support()) {
        for (int k = 0; k < count; ++k) {
          entries.emplace_back(cap.first_coefficient + j * count + k, cap.net[i], fit(k, i));
        }
      }
    }
  }
  SparseMatrix matrix(point_count_, control_count_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace umbilic
