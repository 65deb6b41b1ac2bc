// SPDX-License-Identifier: MIT
/// \file
/// Finds generators by trying images of one flag, completes the group that they generate, and finds orbits.
#include "mesh/symmetry.h"

#include <cmath>

#include "mesh/coordinates.h"
#include "mesh/exact_group.h"
#include "mesh/schoenflies.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

using Eigen::Matrix3d;

/// If points lie within e of exactly symmetric ones, and the center within e of the exact one, images are off by up to
/// 4 e.
constexpr double kErrorsPerImage = 4;

/// How often the search is repeated, each time with a quarter of the tolerance, when the symmetries found form no
/// group.
constexpr int kMaxSearches = 8;

/// An isometry closer to the identity than this is the identity, since elements of a finite group lie far apart.
constexpr double kIdentity = 1e-8;

enum FlagState : char { kUnknown, kReached, kRefused };

/// Tries all flags that resemble the base flag as its image. The group acts freely on flags, so each new symmetry at
/// least doubles the order of the group, and a refused flag rules out its whole orbit.
std::vector<Symmetry> find_generators(const PolygonMesh& mesh, FlagMatching& matching, double tolerance) {
  std::vector<Symmetry> generators;
  std::vector<FlagState> state(2 * static_cast<std::size_t>(mesh.halfedge_count()), kUnknown);
  state[Flag{matching.base(), false}.index()] = kReached;
  for (const Flag candidate : matching.candidates(tolerance)) {
    if (state[candidate.index()] != kUnknown) continue;
    if (matching.exhausted()) break;
    std::optional<Symmetry> found = matching.symmetry(candidate, tolerance);
    if (found) generators.push_back(std::move(*found));
    matching.charge(mesh.halfedge_count());
    const Elements orbit =
        elements(generators, found ? Flag{matching.base(), false} : candidate, mesh.halfedge_count());
    for (const Flag flag : orbit.flags) state[flag.index()] = found ? kReached : kRefused;
  }
  return generators;
}

/// Drops each generator, from the first on, that the others make redundant.
void drop_redundant(std::vector<Symmetry>& generators, int base, const PolygonMesh& mesh) {
  const int order = elements(generators, {base, false}, mesh.halfedge_count()).count();
  for (std::size_t i = 0; i < generators.size() && generators.size() > 1;) {
    std::vector<Symmetry> others = generators;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (elements(others, {base, false}, mesh.halfedge_count()).count() == order) {
      generators = std::move(others);
    } else {
      ++i;
    }
  }
}

/// Whether projecting the points to symmetric ones moves none of them farther than `tolerance`.
bool nearly_symmetric(const PolygonMesh& mesh, const Points& points, const SymmetryGroup& group, double tolerance) {
  const Coordinates coordinates(mesh, group);
  const Points symmetric = coordinates.control(coordinates.unknowns(points));
  return (symmetric - points).rowwise().norm().maxCoeff() <= tolerance;
}

/// Fills in `group` from its generators. Returns false if they do not generate a finite group of isometries.
bool complete(SymmetryGroup& group, int base, const PolygonMesh& mesh) {
  drop_redundant(group.generators, base, mesh);
  const Elements all = elements(group.generators, {base, false}, mesh.halfedge_count());
  if (!make_exact(all, group.generators)) return false;
  const std::vector<Matrix3d> matrices = isometries(all, group.generators);
  for (int i = 1; i < all.count(); ++i) {
    if ((matrices[i] - Matrix3d::Identity()).norm() < kIdentity) return false;
  }
  group.order = all.count();
  group.name = schoenflies_symbol(matrices);
  return true;
}

}  // namespace

SymmetryGroup find_symmetry(const PolygonMesh& mesh, const Points& points) {
  SymmetryGroup trivial;
  if (points.rows() == 0 || !points.allFinite()) return trivial;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.valence(v) == 0) return trivial;
  }
  trivial.center = points.colwise().mean().transpose();
  const double extent = (points.rowwise() - trivial.center.transpose()).rowwise().norm().maxCoeff();
  if (!(extent > 0) || !std::isfinite(extent)) return trivial;
  FlagMatching matching(mesh, points, trivial.center, extent);
  if (!matching.has_base()) return trivial;

  double tolerance = kSymmetryTolerance * extent;
  for (int search = 0; search < kMaxSearches; ++search, tolerance /= 4) {
    SymmetryGroup group = trivial;
    group.generators = find_generators(mesh, matching, kErrorsPerImage * tolerance);
    group.complete = trivial.complete = !matching.exhausted();
    if (group.generators.empty()) break;
    if (complete(group, matching.base(), mesh) && nearly_symmetric(mesh, points, group, kSymmetryTolerance * extent)) {
      return group;
    }
  }
  return trivial;
}

SymmetryGroup refined(const SymmetryGroup& group, const PolygonMesh& mesh) {
  if (mesh.is_open() && !group.generators.empty()) return refined(group, mesh, catmull_clark_mesh(mesh));
  SymmetryGroup result = group;
  for (Symmetry& generator : result.generators) generator.map = refined(generator.map, mesh);
  return result;
}

SymmetryGroup refined(const SymmetryGroup& group, const PolygonMesh& mesh, const PolygonMesh& finer) {
  SymmetryGroup result = group;
  for (Symmetry& generator : result.generators) generator.map = refined(generator.map, mesh, finer);
  return result;
}

Orbits face_orbits(const PolygonMesh& mesh, const SymmetryGroup& group) {
  Orbits orbits{std::vector<int>(mesh.face_count(), -1), {}};
  std::vector<int> orbit;
  for (int first = 0; first < mesh.face_count(); ++first) {
    if (orbits.of[first] >= 0) continue;
    const int number = static_cast<int>(orbits.sizes.size());
    orbits.of[first] = number;
    orbit.assign(1, first);
    for (std::size_t i = 0; i < orbit.size(); ++i) {
      for (const Symmetry& generator : group.generators) {
        const int image = image_of_face(mesh, generator.map, orbit[i]);
        if (orbits.of[image] >= 0) continue;
        orbits.of[image] = number;
        orbit.push_back(image);
      }
    }
    orbits.sizes.push_back(static_cast<int>(orbit.size()));
  }
  return orbits;
}

}  // namespace umbilic
