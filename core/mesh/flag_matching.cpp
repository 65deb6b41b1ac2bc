// SPDX-License-Identifier: MIT
/// \file
/// Chooses the base half-edge, extends maps from it, and fits isometries.
#include "mesh/flag_matching.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/symmetric_eigen.h"

namespace umbilic {
namespace {

using Eigen::Matrix3d;

/// Points closer to a line or plane than this (root mean square, relative to the extent) count as lying in it.
constexpr double kFlat = 10 * kSymmetryTolerance;

/// Points of other components may be this many times farther off than those of the base component before the isometry
/// is fitted to all of them.
constexpr double kLever = 10;

/// Half-edges whose radii and lengths fall into the same cell of this size (relative to the extent) count as similar
/// when the rarest one is chosen.
constexpr double kCell = 20 * kSymmetryTolerance;

}  // namespace

FlagMatching::FlagMatching(const PolygonMesh& mesh, const Points& points, const Vector3& center, double extent)
    : mesh_(mesh),
      points_(points.rowwise() - center.transpose()),
      radius_(mesh.vertex_count()),
      length_(mesh.halfedge_count()),
      component_(mesh.halfedge_count(), -1),
      by_radius_(mesh.halfedge_count()),
      work_left_(kSymmetryWork + kSymmetryWorkPerHalfedge * mesh.halfedge_count()) {
  for (int v = 0; v < mesh.vertex_count(); ++v) radius_[v] = point(v).norm();
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    length_[h] = (point(mesh.origin(h)) - point(mesh.target(h))).norm();
    by_radius_[h] = h;
  }
  std::sort(by_radius_.begin(), by_radius_.end(), [&](int a, int b) {
    const double ra = radius_[mesh_.origin(a)], rb = radius_[mesh_.origin(b)];
    return ra != rb ? ra < rb : a < b;
  });
  find_components(extent);
  choose_base(extent);
}

void FlagMatching::find_components(double extent) {
  for (int first = 0; first < mesh_.halfedge_count(); ++first) {
    if (component_[first] >= 0) continue;
    const int number = static_cast<int>(components_.size());
    queue_.assign(1, first);
    component_[first] = number;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      for (const int h : {mesh_.next(queue_[i]), mesh_.twin(queue_[i])}) {
        if (component_[h] >= 0) continue;
        component_[h] = number;
        queue_.push_back(h);
      }
    }
    Matrix3d scatter = Matrix3d::Zero();
    for (const int h : queue_) scatter += point(mesh_.origin(h)) * point(mesh_.origin(h)).transpose();
    const double count = static_cast<double>(queue_.size());
    const Vector3 squares = symmetric_eigen(scatter / count).values;
    int dimension = 0;
    while (dimension < 3 && squares[2 - dimension] > kFlat * kFlat * extent * extent) ++dimension;
    const double spread = dimension > 0 ? std::sqrt(squares[3 - dimension]) : 0;
    components_.push_back({first, static_cast<int>(queue_.size()), dimension, spread});
  }
}

void FlagMatching::choose_base(double extent) {
  int dimension = 0;
  for (const Component& component : components_) dimension = std::max(dimension, component.dimension);
  if (dimension < 2) return;
  double spread = 0;
  for (const Component& component : components_) {
    if (component.dimension == dimension) spread = std::max(spread, component.spread);
  }
  using Key = std::array<int, 7>;
  std::vector<std::pair<Key, int>> keys;
  const auto cell = [&](double length) { return static_cast<int>(length / (kCell * extent)); };
  for (int h = 0; h < mesh_.halfedge_count(); ++h) {
    const Component& component = components_[component_[h]];
    if (component.dimension < dimension || component.spread < spread / 2) continue;
    const int o = mesh_.origin(h), t = mesh_.target(h);
    keys.push_back({{mesh_.valence(o), mesh_.valence(t), mesh_.face_size(mesh_.face(h)), cell(radius_[o]),
                     cell(radius_[t]), cell(length_[h]), cell(length_[mesh_.next(h)])},
                    h});
  }
  std::sort(keys.begin(), keys.end());
  std::size_t rarest = keys.size() + 1;
  for (std::size_t i = 0, end = 0; i < keys.size(); i = end) {
    while (end < keys.size() && keys[end].first == keys[i].first) ++end;
    if (end - i >= rarest) continue;
    rarest = end - i;
    base_ = keys[i].second;
  }
}

bool FlagMatching::agree(int h, Flag image, const Matrix3d* isometry, double tolerance) const {
  const int t = image.halfedge;
  const int v = mesh_.origin(h), w = image.reversed ? mesh_.target(t) : mesh_.origin(t);
  if (mesh_.valence(v) != mesh_.valence(w)) return false;
  const int f = mesh_.face(h), g = mesh_.face(t);
  if (mesh_.face_size(f) != mesh_.face_size(g) || mesh_.role(f) != mesh_.role(g)) return false;
  if (isometry) return (*isometry * point(v) - point(w)).squaredNorm() <= tolerance * tolerance;
  return std::abs(radius_[v] - radius_[w]) <= tolerance && std::abs(length_[h] - length_[t]) <= tolerance;
}

std::vector<Flag> FlagMatching::candidates(double tolerance) const {
  std::vector<Flag> result;
  for (int h = 0; h < mesh_.halfedge_count(); ++h) {
    for (const bool reversed : {false, true}) {
      const int next = reversed ? mesh_.previous(h) : mesh_.next(h);
      if (components_[component_[h]].size == components_[component_[base_]].size &&
          agree(base_, {h, reversed}, nullptr, tolerance) &&
          agree(mesh_.next(base_), {next, reversed}, nullptr, tolerance)) {
        result.push_back({h, reversed});
      }
    }
  }
  return result;
}

bool FlagMatching::extend(int h, Flag image, const Matrix3d* isometry, double tolerance, Automorphism& map) {
  queue_.clear();
  bool consistent = true;
  const auto reach = [&](int from, int to) {
    if (map.halfedges[from] < 0) {
      consistent = consistent && agree(from, {to, image.reversed}, isometry, tolerance);
      map.halfedges[from] = to;
      queue_.push_back(from);
    } else {
      consistent = consistent && map.halfedges[from] == to;
    }
  };
  reach(h, image.halfedge);
  for (std::size_t i = 0; i < queue_.size() && consistent; ++i) {
    const int from = queue_[i], to = map.halfedges[from];
    reach(mesh_.next(from), image.reversed ? mesh_.previous(to) : mesh_.next(to));
    reach(mesh_.twin(from), mesh_.twin(to));
  }
  charge(static_cast<double>(queue_.size()));
  // Equal valences and face sizes imply that the map covers the component of `image`; equal component sizes, that it is
  // one to one.
  if (!consistent) {
    for (const int from : queue_) map.halfedges[from] = -1;
  }
  return consistent;
}

std::vector<Flag> FlagMatching::images_of(int h, const Matrix3d& isometry, bool reverses, double tolerance) {
  const int v = mesh_.origin(h), end = mesh_.target(h);
  const auto low = std::lower_bound(by_radius_.begin(), by_radius_.end(), radius_[v] - tolerance,
                                    [&](int other, double radius) { return radius_[mesh_.origin(other)] < radius; });
  std::vector<Flag> images;
  for (auto i = low; i != by_radius_.end() && radius_[mesh_.origin(*i)] <= radius_[v] + tolerance; ++i) {
    charge(1);
    const Flag image{reverses ? mesh_.twin(*i) : *i, reverses};
    if (components_[component_[*i]].size == components_[component_[h]].size && agree(h, image, &isometry, tolerance) &&
        (isometry * point(end) - point(mesh_.target(*i))).squaredNorm() <= tolerance * tolerance) {
      images.push_back(image);
    }
  }
  std::sort(images.begin(), images.end(), [&](Flag a, Flag b) {
    return std::pair(component_[a.halfedge], a.halfedge) < std::pair(component_[b.halfedge], b.halfedge);
  });
  return images;
}

bool FlagMatching::extend_to_others(const Matrix3d& isometry, double tolerance, Automorphism& map) {
  std::vector<bool> taken(components_.size(), false);
  taken[component_[map.halfedges[base_]]] = true;
  const auto place = [&](int h, double slack) {
    for (const Flag image : images_of(h, isometry, map.reverses, slack)) {
      const int target = component_[image.halfedge];
      if (taken[target] || !extend(h, image, &isometry, slack, map)) continue;
      taken[target] = true;
      return true;
    }
    return false;
  };
  for (int c = 0; c < static_cast<int>(components_.size()); ++c) {
    if (c == component_[base_]) continue;
    if (exhausted()) return false;
    if (!place(components_[c].first, tolerance) && !place(components_[c].first, kLever * tolerance)) return false;
  }
  return true;
}

Matrix3d FlagMatching::fit(const Automorphism& map, int dimension) const {
  Matrix3d moment = Matrix3d::Zero();
  for (int h = 0; h < mesh_.halfedge_count(); ++h) {
    if (map.halfedges[h] < 0) continue;
    const int image = map.halfedges[h];
    const int v = mesh_.origin(h), w = map.reverses ? mesh_.target(image) : mesh_.origin(image);
    moment += point(w) * point(v).transpose();
  }
  const Eigen::JacobiSVD<Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3 signs = Vector3::Ones();
  if (dimension < 3) {
    const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() > 0 ? 1 : -1;
    signs[2] = map.reverses ? -sign : sign;
  }
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

bool FlagMatching::within(const Symmetry& symmetry, double tolerance) const {
  for (int h = 0; h < mesh_.halfedge_count(); ++h) {
    const int image = symmetry.map.halfedges[h];
    if (image < 0) continue;
    const int v = mesh_.origin(h), w = symmetry.map.reverses ? mesh_.target(image) : mesh_.origin(image);
    if ((symmetry.isometry * point(v) - point(w)).squaredNorm() > tolerance * tolerance) return false;
  }
  return true;
}

std::optional<Symmetry> FlagMatching::symmetry(Flag image, double tolerance) {
  charge(mesh_.halfedge_count());
  Symmetry result{Matrix3d::Identity(), {image.reversed, std::vector<int>(mesh_.halfedge_count(), -1)}};
  if (!extend(base_, image, nullptr, tolerance, result.map)) return std::nullopt;
  const int dimension = components_[component_[base_]].dimension;
  result.isometry = fit(result.map, dimension);
  if (components_.size() > 1) {
    if (!within(result, tolerance) || !extend_to_others(result.isometry, tolerance, result.map)) return std::nullopt;
    if (dimension == 3) result.isometry = fit(result.map, dimension);
  }
  if (!within(result, tolerance)) return std::nullopt;
  return result;
}

}  // namespace umbilic
