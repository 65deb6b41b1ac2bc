// SPDX-License-Identifier: MIT
/// \file
/// Samples every patch on a grid and joins the grids along edges and vertices.
#include "driver/tessellate.h"

#include <algorithm>
#include <cmath>

#include "surface/basis_table.h"
#include "surface/flat_frame.h"

namespace umbilic {
namespace {

constexpr int kDerivatives = 1 + kSecondOrderCount;

/// Distance from an extraordinary vertex, in faces, at which its normal and curvature are taken: there they have
/// reached their limit where it exists, and elsewhere show how they diverge.
constexpr double kNearby = 1.0 / 256;

/// Names the vertices of all grids such that neighbouring patches share theirs.
class GridNames {
 public:
  GridNames(const PolygonMesh& mesh, int density) : mesh_(mesh), density_(density) {}

  int count() const {
    const int inner = density_ - 1;
    return mesh_.vertex_count() + mesh_.edge_count() * inner + mesh_.face_count() * inner * inner;
  }

  /// Grid point (i, j) of the patch whose half-edge along u is `h`.
  int vertex(int h, int i, int j) const {
    const int d = density_;
    if (j == 0) return on_edge(h, i);
    if (i == d) return on_edge(mesh_.next(h), j);
    if (j == d) return on_edge(mesh_.next(mesh_.next(h)), d - i);
    if (i == 0) return on_edge(mesh_.previous(h), d - j);
    const int inner = d - 1;
    return mesh_.vertex_count() + mesh_.edge_count() * inner + (mesh_.face(h) * inner + j - 1) * inner + i - 1;
  }

 private:
  int on_edge(int h, int i) const {
    if (i == 0) return mesh_.origin(h);
    if (i == density_) return mesh_.target(h);
    const int along = h < mesh_.twin(h) ? i : density_ - i;
    return mesh_.vertex_count() + mesh_.edge(h) * (density_ - 1) + along - 1;
  }

  const PolygonMesh& mesh_;
  int density_;
};

std::vector<Sample> grid(const PatchKind& kind, int density) {
  std::vector<Sample> samples;
  for (int j = 0; j <= density; ++j) {
    for (int i = 0; i <= density; ++i) samples.push_back({double(i) / density, double(j) / density, 0});
  }
  if (kind.at_extraordinary()) samples.front() = {kNearby, kNearby, 0};
  return samples;
}

/// Position, unit normal, and principal curvatures with the sphere's positive, from derivatives through order 2.
struct SurfacePoint {
  Vector3 position, normal;
  double kappa1, kappa2;

  explicit SurfacePoint(const Eigen::Matrix<double, kDerivatives, 3>& x) : position(x.row(0)) {
    const Vector3 a = x.row(1), b = x.row(2), cross = a.cross(b);
    const double area = cross.norm();
    normal = cross / area;
    const double e = a.squaredNorm(), f = a.dot(b), g = b.squaredNorm();
    const double l = normal.dot(x.row(3)), m = normal.dot(x.row(4)), n = normal.dot(x.row(5));
    const double mean = (e * n - 2 * f * m + g * l) / (2 * area * area);
    const double gauss = (l * n - m * m) / (area * area);
    const double half_difference = std::sqrt(std::max(0.0, mean * mean - gauss));
    kappa1 = -mean + half_difference;
    kappa2 = -mean - half_difference;
  }
};

Vector3 cap_centre(const Cap& cap, const Points& points) {
  if (coefficient_count(cap.shape) > 0) return points.row(cap.first_coefficient);
  const Eigen::RowVectorXd weights = cap_sector(cap.valence, cap.shape).net().limit_position();
  Vector3 centre = Vector3::Zero();
  for (int i = 0; i < weights.size(); ++i) {
    if (cap.net[i] >= 0) centre += weights[i] * points.row(cap.net[i]).transpose();
  }
  return centre;
}

}  // namespace

LimitMesh tessellate(const PolygonMesh& mesh, const PatchLayout& layout, const Points& control, int density) {
  const GridNames names(mesh, density);
  const Points points = layout.extend(control);
  const std::vector<FlatFrame> frames = flat_frames(layout, points);
  LimitMesh result;
  result.positions = Points::Zero(names.count(), 3);
  result.normals = Points::Zero(names.count(), 3);
  result.curvatures = decltype(result.curvatures)::Zero(names.count(), 2);
  std::vector<int> visits(names.count(), 0);

  for (const PatchSet& set : layout.sets()) {
    const BasisTable table = basis_table(set.kind, grid(set.kind, density), 0, kDerivatives);
    Eigen::Matrix<double, Eigen::Dynamic, 3> local(set.columns, 3);
    for (int p = 0; p < set.count(); ++p) {
      for (int i = 0; i < set.columns; ++i) local.row(i) = points.row(set.points[set.columns * p + i]);
      Eigen::Matrix<double, Eigen::Dynamic, 3> jets = table.basis * local;
      if (set.kind.shape == CapShape::kFlat) {
        const Vector3& n = frames[set.caps[p]].normal;
        jets -= (table.flattening * (local * n)) * n.transpose();
      }
      for (int j = 0, s = 0; j <= density; ++j) {
        for (int i = 0; i <= density; ++i, ++s) {
          Eigen::Matrix<double, kDerivatives, 3> x;
          for (int d = 0; d < kDerivatives; ++d) x.row(d) = jets.row(d * table.samples + s);
          const SurfacePoint point(x);
          const int v = names.vertex(set.halfedges[p], i, j);
          ++visits[v];
          result.positions.row(v) += point.position;
          result.normals.row(v) += point.normal;
          result.curvatures.row(v) += Eigen::RowVector2d(point.kappa1, point.kappa2);
          if (i < density && j < density) {
            const int h = set.halfedges[p];
            result.quads.push_back(
                {v, names.vertex(h, i + 1, j), names.vertex(h, i + 1, j + 1), names.vertex(h, i, j + 1)});
          }
        }
      }
    }
  }
  for (int v = 0; v < names.count(); ++v) {
    result.positions.row(v) /= visits[v];
    result.curvatures.row(v) /= visits[v];
    result.normals.row(v).normalize();
  }
  for (const Cap& cap : layout.caps()) result.positions.row(cap.vertex) = cap_centre(cap, points);
  return result;
}

}  // namespace umbilic
