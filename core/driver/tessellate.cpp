// SPDX-License-Identifier: MIT
/// \file
/// Samples one patch of each orbit on a grid, maps it by all elements of the group, and joins the grids along edges and
/// vertices.
#include "driver/tessellate.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/shared_cache.h"
#include "base/threads.h"
#include "energy/densities.h"
#include "surface/patch_evaluator.h"

namespace umbilic {
namespace {

/// Distance from an extraordinary vertex, in faces, at which its normal and curvatures are evaluated. There they have
/// reached their limit if it exists; otherwise they show how they diverge.
constexpr double kNearby = 1.0 / 256;

/// Numbers the vertices of all grids so that neighbouring patches share theirs.
class GridNames {
 public:
  GridNames(const PolygonMesh& mesh, int density)
      : mesh_(mesh), density_(density), vertices_(mesh.vertex_count()), edges_(mesh.edge_count()) {
    if (mesh.is_open()) number_surface();
  }

  int count() const {
    const int inner = density_ - 1;
    return vertices_ + edges_ * inner + mesh_.surface_face_count() * inner * inner;
  }

  /// Grid point (i, j) of the patch whose half-edge along u is `h`.
  int vertex(int h, int i, int j) const {
    const int d = density_;
    if (j == 0) return on_edge(h, i);
    if (i == d) return on_edge(mesh_.next(h), j);
    if (j == d) return on_edge(mesh_.next(mesh_.next(h)), d - i);
    if (i == 0) return on_edge(mesh_.previous(h), d - j);
    const int inner = d - 1;
    return vertices_ + edges_ * inner + (mesh_.face(h) * inner + j - 1) * inner + i - 1;
  }

 private:
  /// Leaves out the vertices and edges without surface.
  void number_surface() {
    vertices_ = edges_ = 0;
    of_vertex_.assign(mesh_.vertex_count(), -1);
    of_edge_.assign(mesh_.edge_count(), -1);
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (mesh_.on_surface(v)) of_vertex_[v] = vertices_++;
    }
    for (int h = 0; h < mesh_.surface_halfedge_count(); ++h) {
      int& number = of_edge_[mesh_.edge(h)];
      if (number < 0) number = edges_++;
    }
  }
  int of_vertex(int v) const { return of_vertex_.empty() ? v : of_vertex_[v]; }
  int on_edge(int h, int i) const {
    if (i == 0) return of_vertex(mesh_.origin(h));
    if (i == density_) return of_vertex(mesh_.target(h));
    const int along = h < mesh_.twin(h) ? i : density_ - i;
    const int edge = of_edge_.empty() ? mesh_.edge(h) : of_edge_[mesh_.edge(h)];
    return vertices_ + edge * (density_ - 1) + along - 1;
  }

  const PolygonMesh& mesh_;
  int density_;
  int vertices_, edges_;                  // on the surface
  std::vector<int> of_vertex_, of_edge_;  // their numbers; empty if all are on it
};

/// The number of derivatives, with the function itself, from which the points of a mesh follow.
constexpr int derivatives_for(bool density) { return density ? kDerivativeCount : 1 + kSecondOrderCount; }

std::vector<Sample> grid(const PatchKind& kind, int density) {
  std::vector<Sample> samples;
  for (int j = 0; j <= density; ++j) {
    for (int i = 0; i <= density; ++i) samples.push_back({double(i) / density, double(j) / density, 0});
  }
  if (kind.at_extraordinary()) samples.front() = {kNearby, kNearby, 0};
  return samples;
}

/// The derivatives at a point in the order of derivative_order.h, the function itself first.
using PointJet = Eigen::Matrix<double, kDerivativeCount, 3>;

/// Position, unit normal, and principal curvatures (positive on a sphere), from derivatives of order up to 2.
struct SurfacePoint {
  Vector3 position, normal;
  double kappa1, kappa2;
  double density = 0;  ///< of the energy, if it is asked for

  explicit SurfacePoint(const PointJet& x) : position(x.row(0)) {
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

/// The density at a point with this jet; `weights` contain their powers of the area.
double density_at(const Weights& weights, const PointJet& x) {
  const auto at = [&](int d) { return Vec3<double>{x(d, 0), x(d, 1), x(d, 2)}; };
  const Jet<double> jet{{at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8), at(9)}};
  const CurvatureFrame<double, true> frame(jet);
  Curvature<double> unused;
  return weighted_density<0>(weights.data(), frame.value(), 0.0, unused) +
         third_order_density(weights.data(), frame.value(), 0.0, unused);
}

/// The weights with their powers of the area.
Weights with_area(const EnergyDensity& energy) {
  Weights weights = energy.weights;
  for (int f = 0; f < kFunctionalCount; ++f) weights[f] *= area_to_the(area_power(f), energy.area_factor);
  return weights;
}

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

namespace {

/// The image of a patch under an element of the symmetry group, x -> center + isometry (x - center). Its half-edge runs
/// along u from its corner (0,0), or along v if the element reverses the orientation.
struct Image {
  int halfedge;
  bool swapped;
  Eigen::Matrix3d isometry;
};

/// Lists each face of the patch's orbit once.
void find_images(const PolygonMesh& mesh, const SymmetryGroup& group, int halfedge, std::vector<bool>& reached,
                 std::vector<Image>& images) {
  images.assign(1, {halfedge, false, Eigen::Matrix3d::Identity()});
  reached[mesh.face(halfedge)] = true;
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (const Symmetry& generator : group.generators) {
      const Image& from = images[i];
      const int along = generator.map.halfedges[from.halfedge];
      if (reached[mesh.face(along)]) continue;
      reached[mesh.face(along)] = true;
      // The image of the half-edge ends at the corner's image if the orientation is reversed; the next half-edge starts
      // there.
      const bool reverses = generator.map.reverses;
      images.push_back(
          {reverses ? mesh.next(along) : along, from.swapped != reverses, generator.isometry * from.isometry});
    }
  }
}

/// The first so many basis derivatives at the vertices of a grid, cached for the next picture.
std::shared_ptr<const BasisTable> grid_table(const PatchKind& kind, int density, int derivatives) {
  static SharedCache<std::pair<PatchKind, std::pair<int, int>>, BasisTable> tables(kSharedTableBytes);
  return tables.get({kind, {density, derivatives}},
                    [&] { return basis_table(kind, grid(kind, density), 0, derivatives); });
}

/// Sums over the patches that meet at each vertex.
class Tessellation {
 public:
  Tessellation(const PolygonMesh& mesh, const SymmetryGroup& group, int density, bool with_densities)
      : mesh_(mesh), group_(group), density_(density), names_(mesh, density), reached_(mesh.face_count(), false) {
    mesh_sums_.positions = Points::Zero(names_.count(), 3);
    mesh_sums_.normals = Points::Zero(names_.count(), 3);
    mesh_sums_.curvatures = decltype(mesh_sums_.curvatures)::Zero(names_.count(), 2);
    if (with_densities) mesh_sums_.densities = Eigen::VectorXd::Zero(names_.count());
    mesh_sums_.quads.resize(static_cast<std::size_t>(mesh.surface_face_count()) * density * density);
    visits_.assign(names_.count(), 0);
  }

  /// Adds a patch and its images. `points` are those of its grid, u fastest.
  void add(int halfedge, std::span<const SurfacePoint> points) {
    find_images(mesh_, group_, halfedge, reached_, images_);
    for (const Image& image : images_) {
      const Vector3 offset = group_.center - image.isometry * group_.center;
      // A symmetry of an open surface may exchange its sides.
      const bool turned_over = (image.isometry.determinant() < 0) != image.swapped;
      const double side = turned_over ? -1 : 1;
      auto* quad = &mesh_sums_.quads[static_cast<std::size_t>(mesh_.face(image.halfedge)) * density_ * density_];
      for (int j = 0, s = 0; j <= density_; ++j) {
        for (int i = 0; i <= density_; ++i, ++s) {
          const int a = image.swapped ? j : i, b = image.swapped ? i : j, h = image.halfedge;
          const int v = names_.vertex(h, a, b);
          ++visits_[v];
          mesh_sums_.positions.row(v) += (offset + image.isometry * points[s].position).transpose();
          mesh_sums_.normals.row(v) += side * (image.isometry * points[s].normal).transpose();
          const double kappa1 = points[s].kappa1, kappa2 = points[s].kappa2;
          mesh_sums_.curvatures.row(v) +=
              turned_over ? Eigen::RowVector2d(-kappa2, -kappa1) : Eigen::RowVector2d(kappa1, kappa2);
          if (mesh_sums_.densities.size() > 0) mesh_sums_.densities[v] += points[s].density;
          if (i < density_ && j < density_) {
            *quad++ = {v, names_.vertex(h, a + 1, b), names_.vertex(h, a + 1, b + 1), names_.vertex(h, a, b + 1)};
          }
        }
      }
    }
  }

  LimitMesh means() && {
    for (int v = 0; v < names_.count(); ++v) {
      mesh_sums_.positions.row(v) /= visits_[v];
      mesh_sums_.curvatures.row(v) /= visits_[v];
      mesh_sums_.normals.row(v).normalize();
      if (mesh_sums_.densities.size() > 0) mesh_sums_.densities[v] /= visits_[v];
    }
    return std::move(mesh_sums_);
  }

 private:
  const PolygonMesh& mesh_;
  const SymmetryGroup& group_;
  const int density_;
  const GridNames names_;
  LimitMesh mesh_sums_;
  std::vector<int> visits_;
  std::vector<bool> reached_;
  std::vector<Image> images_;
};

/// Evaluates the grids of the patches in a range, with the density of the weights if there are any.
void add_grids(const PatchEvaluator& patches, PatchRange range, const std::optional<Weights>& weights,
               PatchMemory& memory, std::vector<SurfacePoint>& points) {
  const int derivatives = derivatives_for(weights.has_value());
  const PatchSet& set = patches.layout().sets()[range.set];
  const BasisTable& table = patches.basis(range.set).table();
  const double* jets = patches.jets(range, derivatives, memory, 0);
  for (int p = 0; p < range.count; ++p) {
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>> rows(
        jets + static_cast<std::size_t>(3) * p * derivatives * table.samples,
        static_cast<Eigen::Index>(derivatives) * table.samples, 3);
    const std::size_t first = points.size();
    for (int s = 0; s < table.distinct; ++s) {
      PointJet x;
      for (int d = 0; d < derivatives; ++d) x.row(d) = rows.row(d * table.samples + s);
      points.emplace_back(x);
      if (weights) points.back().density = density_at(*weights, x);
    }
    if (set.kind.at_extraordinary()) {
      points[first].position = cap_centre(patches.layout().caps()[set.caps[range.first + p]], patches.points());
    }
  }
}

}  // namespace

void put_back(LimitMesh& mesh, const Placement& placement) {
  mesh.positions = placement.back(mesh.positions);
  mesh.curvatures = mesh.curvatures.unaryExpr([&](double k) { return std::ldexp(k, -placement.exponent); }).eval();
  mesh.densities = mesh.densities.unaryExpr([&](double e) { return std::ldexp(e, -2 * placement.exponent); }).eval();
}

LimitMesh tessellate(const PolygonMesh& mesh, const SymmetryGroup& group, const PatchLayout& layout,
                     const Points& control, int density, const std::optional<EnergyDensity>& energy) {
  std::optional<Weights> weights;
  if (energy) weights = with_area(*energy);
  PatchEvaluator patches(layout, [&](const PatchKind& kind) {
    return PatchBasis(grid_table(kind, density, derivatives_for(weights.has_value())));
  });
  patches.move_to(control);
  Tessellation result(mesh, group, density, weights.has_value());
  std::vector<PatchMemory> memories(thread_count());
  std::vector<std::vector<SurfacePoint>> grids(slot_count());  // of the patches of a range, one after the other
  in_order(
      static_cast<int>(patches.ranges().size()), slot_count(),
      [&](int r, int slot, int member) {
        grids[slot].clear();
        add_grids(patches, patches.ranges()[r], weights, memories[member], grids[slot]);
      },
      [&](int r, int slot) {
        const PatchRange range = patches.ranges()[r];
        const std::size_t size = grids[slot].size() / range.count;
        for (int p = 0; p < range.count; ++p) {
          result.add(layout.sets()[range.set].halfedges[range.first + p],
                     std::span(grids[slot]).subspan(p * size, size));
        }
      });
  return std::move(result).means();
}

}  // namespace umbilic
