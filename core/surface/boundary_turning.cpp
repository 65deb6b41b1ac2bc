// SPDX-License-Identifier: MIT
/// \file
/// Visits the patches that have an edge or a corner on the boundary.
#include "surface/boundary_turning.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include "mesh/boundary.h"
#include "surface/quadrature.h"

namespace umbilic {
namespace {

/// Halvings towards an extraordinary vertex, since the characteristic map is a spline between each two. On what is
/// left, t = 2^-20 s^3: there the map is, roughly, a power of t of 0.6 at least, and one of s that suits Gauss's rule.
/// Nearer to the vertex second derivatives have no digits left: each halving takes two bits.
constexpr int kHalvings = 20;
constexpr int kPower = 3;

double angle_between(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Parameters along an edge and weights. Extraordinary vertices, if any, are at t = 0.
std::vector<std::pair<double, double>> edge_samples(const GaussRule& rule, bool extraordinary) {
  std::vector<std::pair<double, double>> samples;
  double end = 1;
  for (int piece = 0; extraordinary && piece < kHalvings; ++piece, end /= 2) {
    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
      samples.emplace_back(end / 2 * (1 + rule.nodes[i]), end / 2 * rule.weights[i]);
    }
  }
  const int power = extraordinary ? kPower : 1;
  for (Eigen::Index i = 0; i < rule.nodes.size(); ++i) {
    const double s = rule.nodes[i];
    samples.emplace_back(end * std::pow(s, power), end * power * std::pow(s, power - 1) * rule.weights[i]);
  }
  return samples;
}

class Turning {
 public:
  Turning(const PolygonMesh& mesh, const PatchLayout& layout, const Points& points, int gauss_points)
      : mesh_(mesh), layout_(layout), points_(points), rule_(gauss_legendre(gauss_points)) {}

  double sum() {
    double sum = 0;
    for (const std::vector<int>& loop : boundary_loops(mesh_))
      sum += std::numbers::pi * static_cast<double>(loop.size());
    for (const PatchSet& set : layout_.sets()) {
      for (int p = 0; p < set.count(); ++p) sum += set.multiplicities[p] * of_patch(set, p);
    }
    return sum;
  }

 private:
  double of_patch(const PatchSet& set, int patch) {
    double sum = 0;
    int h = set.halfedges[patch];
    for (int corner = 0; corner < 4; ++corner, h = mesh_.next(h)) {
      const bool on_boundary = mesh_.is_boundary(h) || mesh_.is_boundary(mesh_.previous(h)) ||
                               boundary_halfedge(mesh_, mesh_.origin(h)) >= 0;
      if (!on_boundary) continue;
      sum -= corner_angle(set, patch, corner);
      if (mesh_.is_boundary(h)) sum += edge(set, patch, corner);
    }
    return sum;
  }

  /// The patch's angle at a corner.
  double corner_angle(const PatchSet& set, int patch, int corner) {
    if (corner == 0 && set.kind.at_extraordinary())
      return extraordinary_angle(layout_.caps()[set.caps[patch]], set, patch);
    const double u = corner == 1 || corner == 2 ? 1 : 0, v = corner >= 2 ? 1 : 0;
    const auto jet = derivatives(set, patch, {corner, -1, 0}, u, v);
    // Along the sides that leave the corner, u and v point into the patch or out of it.
    const Vector3 along_u = jet.row(1).transpose() * (u > 0 ? -1 : 1),
                  along_v = jet.row(2).transpose() * (v > 0 ? -1 : 1);
    return angle_between(along_u, along_v);
  }

  /// The surface's tangents a, b along the axes of the characteristic map; the sector lies between the angles 0 and
  /// 2 pi / N.
  double extraordinary_angle(const Cap& cap, const PatchSet& set, int patch) const {
    const double angle = 2 * std::numbers::pi / cap.valence;
    const int* const local = set.points_of(patch);
    const CapSector& sector = sector_of(cap);
    Vector3 a = Vector3::Zero(), b = Vector3::Zero();
    const int coefficients = coefficient_count(cap.shape), net = set.columns - coefficients;
    if (coefficients > 0) {
      a = points_.row(local[net + 1]).transpose();
      b = points_.row(local[net + 2]).transpose();
    } else {
      const auto& weights = sector.net().limit_tangents();
      int turn = 0;
      while (cap.net[sector.net().index(turn, 1, 0)] != mesh_.target(set.halfedges[patch])) ++turn;
      for (int i = 0; i < sector.net().size(); ++i) {
        const int from = cap.net[sector.net().turned(i, turn)];
        if (from < 0) continue;
        a += weights(0, i) * points_.row(from).transpose();
        b += weights(1, i) * points_.row(from).transpose();
      }
    }
    return angle_between(a, std::cos(angle) * a + std::sin(angle) * b);
  }

  /// The integral of the geodesic curvature along the side that starts at the corner.
  double edge(const PatchSet& set, int patch, int corner) {
    const bool at_start = set.kind.at_extraordinary() && corner == 0,
               at_end = set.kind.at_extraordinary() && corner == 3;
    double sum = 0;
    int number = 0;
    for (const auto& [t, weight] : edge_samples(rule_, at_start || at_end)) {
      // t runs along the side, or against it if an extraordinary vertex is at its end.
      const double s = at_end ? 1 - t : t;
      const double u = corner == 0 ? s : corner == 1 ? 1 : corner == 2 ? 1 - s : 0;
      const double v = corner == 0 ? 0 : corner == 1 ? s : corner == 2 ? 1 : at_end ? t : 1 - s;
      const auto jet = derivatives(set, patch, {corner, number++, 1}, u, v);
      const double direction = corner < 2 ? 1 : -1;
      const bool along_u = corner % 2 == 0;
      const Vector3 normal = Vector3(jet.row(1)).cross(Vector3(jet.row(2))).normalized();
      const Vector3 first = direction * jet.row(along_u ? 1 : 2).transpose(),
                    second = jet.row(along_u ? 3 : 5).transpose();
      sum += weight * normal.dot(first.cross(second)) / first.squaredNorm();
    }
    return sum;
  }

  /// Position and derivatives of order up to 2 of a patch. `key` names the place for patches of one kind.
  Eigen::Matrix<double, 6, 3> derivatives(const PatchSet& set, int patch, const std::tuple<int, int, int>& key,
                                          double u, double v) {
    auto [found, is_new] = bases_.try_emplace({set.kind, key});
    if (is_new) found->second = patch_basis(set.kind, u, v).topRows(6);
    const int* const local = set.points_of(patch);
    Eigen::Matrix<double, 6, 3> jet = Eigen::Matrix<double, 6, 3>::Zero();
    for (int i = 0; i < set.columns; ++i) jet += found->second.col(i) * points_.row(local[i]);
    return jet;
  }

  const PolygonMesh& mesh_;
  const PatchLayout& layout_;
  const Points& points_;
  const GaussRule rule_;
  std::map<std::pair<PatchKind, std::tuple<int, int, int>>, Eigen::Matrix<double, 6, Eigen::Dynamic>> bases_;
};

}  // namespace

double boundary_turning(const PolygonMesh& mesh, const PatchLayout& layout, const Points& points, int gauss_points) {
  if (!mesh.is_open()) return 0;
  return Turning(mesh, layout, points, gauss_points).sum();
}

}  // namespace umbilic
