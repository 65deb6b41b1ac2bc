// SPDX-License-Identifier: MIT
/// \file
/// Finds the places and targets of pins, and writes them as rows.
#include "driver/pin_rows.h"

#include <fmt/format.h>

#include <cmath>

namespace umbilic {
namespace {

constexpr double kSameTarget = 1e-10, kSameWeight = 1e-9;
/// Of a cage whose size is about 1: farther out, numbers have no digits left for its shape.
constexpr double kFarthest = 1e15;

Error refused(std::size_t pin, std::string_view words) { return {fmt::format("constraints.pins[{}].{}", pin, words)}; }

Result<SurfacePlace> place_of(const Pin& pin, std::size_t index, const PolygonMesh& mesh) {
  if (Error error; !in_range(pin, error)) return refused(index, error.message);
  if (pin.vertex) {
    if (*pin.vertex <= mesh.vertex_count()) return SurfacePlace{.vertex = *pin.vertex - 1};
    return refused(index, fmt::format("vertex: {}, but the cage has {} vertices", *pin.vertex, mesh.vertex_count()));
  }
  if (*pin.face > mesh.face_count()) {
    return refused(index, fmt::format("face: {}, but the cage has {} faces", *pin.face, mesh.face_count()));
  }
  const int face = *pin.face - 1, size = mesh.face_size(face);
  if (pin.corner && *pin.corner > size) {
    return refused(index, fmt::format("corner: {}, but face {} has {} corners", *pin.corner, *pin.face, size));
  }
  if (size == 4 && pin.corner) {
    return refused(index, fmt::format("corner: face {} is a quad, in which uv alone says where", *pin.face));
  }
  if (size != 4 && !pin.corner) {
    return refused(index, fmt::format("face: face {} has {} corners, and (u, v) only in the quads after one step: name "
                                      "one by \"corner\", 1 to {}, or refine the cage by one step",
                                      *pin.face, size, size));
  }
  const int halfedge = mesh.halfedge(face, pin.corner.value_or(1) - 1);
  return SurfacePlace{.halfedge = halfedge, .u = (*pin.uv)[0], .v = (*pin.uv)[1]};
}

std::vector<LimitStencil> stencils_of(const std::vector<HeldPoint>& held, const PolygonMesh& mesh) {
  std::vector<SurfacePlace> places;
  places.reserve(held.size());
  for (const HeldPoint& point : held) places.push_back(point.place);
  return limit_stencils(mesh, places);
}

/// The place to which an automorphism maps another. A mirror exchanges u and v: the image of h ends where the image of
/// its origin is, and the half-edge after it starts there.
SurfacePlace image_of(const SurfacePlace& place, const Automorphism& map, const PolygonMesh& mesh) {
  SurfacePlace image = place;
  if (place.is_vertex()) {
    image.vertex = image_of_vertex(mesh, map, place.vertex);
    return image;
  }
  image.halfedge = map.halfedges[place.halfedge];
  if (!map.reverses) return image;
  image.halfedge = mesh.next(image.halfedge);
  std::swap(image.u, image.v);
  return image;
}

/// Whether both give the same point of every surface.
bool same_point(const LimitStencil& a, const LimitStencil& b) {
  std::size_t i = 0, j = 0;
  const auto weight = [](const LimitStencil& stencil, std::size_t k) {
    return stencil.weights(0, static_cast<Eigen::Index>(k));
  };
  while (i < a.points.size() || j < b.points.size()) {
    const bool of_a = j == b.points.size() || (i < a.points.size() && a.points[i] <= b.points[j]);
    const bool of_b = i == a.points.size() || (j < b.points.size() && b.points[j] <= a.points[i]);
    if (std::abs((of_a ? weight(a, i) : 0) - (of_b ? weight(b, j) : 0)) > kSameWeight) return false;
    i += of_a;
    j += of_b;
  }
  return true;
}

Eigen::Matrix3d held_coordinates(const HeldPoint& point) {
  return Vector3(point.holds[0], point.holds[1], point.holds[2]).asDiagonal();
}

/// Whether the isometry about the center maps what `from` holds to what `to` holds.
bool maps_targets(const Eigen::Matrix3d& isometry, const Vector3& center, const HeldPoint& from, const HeldPoint& to) {
  const Eigen::Matrix3d before = held_coordinates(from), after = held_coordinates(to);
  if ((isometry * before * isometry.transpose() - after).norm() > kSameTarget) return false;
  const Vector3 moved = isometry * (before * (from.position - center)), expected = after * (to.position - center);
  return (moved - expected).norm() <= kSameTarget && (isometry * from.normal - to.normal).norm() <= kSameTarget;
}

}  // namespace

Result<std::vector<HeldPoint>> hold(const std::vector<Pin>& pins, const RefinedCage& cage) {
  std::vector<HeldPoint> held(pins.size());
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const Result<SurfacePlace> place = place_of(pins[i], i, cage.mesh);
    if (!place) return place.error();
    held[i].pin = static_cast<int>(i);
    held[i].place = *place;
  }
  const std::vector<LimitStencil> stencils = stencils_of(held, cage.mesh);
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const Eigen::Matrix3d here = stencils[i].apply(cage.control);
    held[i].position = here.col(0);
    Vector3 at(0, 0, 0);
    if (pins[i].at) at = cage.placement.to_unit(Vector3(Eigen::Map<const Vector3>(pins[i].at->data())));
    for (int c = 0; c < 3; ++c) {
      held[i].holds[c] = pins[i].position && !std::isnan(at[c]);
      if (pins[i].at && held[i].holds[c]) held[i].position[c] = at[c];
      if (!(std::abs(held[i].position[c]) <= kFarthest)) {
        return refused(i, fmt::format("at[{}]: too large for the cage", c));
      }
    }
    if (!pins[i].holds_normal()) continue;
    const auto* given = std::get_if<Coordinates3>(&*pins[i].normal);
    const Vector3 normal = given ? Vector3(Eigen::Map<const Vector3>(given->data())) : here.col(1).cross(here.col(2));
    const double tangents = here.col(1).norm() * here.col(2).norm();
    if (!given && !(normal.norm() > 1e-9 * tangents)) return refused(i, "normal: the cage's surface has none there");
    held[i].normal = normal.stableNormalized();
  }
  return held;
}

std::vector<HeldPoint> refined(std::vector<HeldPoint> held, const PolygonMesh& mesh) {
  for (HeldPoint& point : held) point.place = refined(point.place, mesh);
  return held;
}

PinRows pin_rows(const std::vector<HeldPoint>& held, const PolygonMesh& mesh) {
  PinRows result;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> right;
  const std::vector<LimitStencil> stencils = stencils_of(held, mesh);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::vector<int>& points = stencils[i].points;
    const auto& weights = stencils[i].weights;
    const auto add = [&](int coordinate, int derivative, double scale, const Vector3& direction, double value) {
      const int row = static_cast<int>(right.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
          const double entry = scale * weights(derivative, static_cast<Eigen::Index>(k)) * direction[c];
          if (entry != 0) entries.emplace_back(row, 3 * points[k] + c, entry);
        }
      }
      right.push_back(value);
      result.owners.push_back({static_cast<int>(i), coordinate});
    };
    for (int c = 0; c < 3; ++c) {
      if (held[i].holds[c]) add(c, 0, 1, Vector3::Unit(c), held[i].position[c]);
    }
    for (int t = 1; t <= 2 && held[i].holds_normal(); ++t) {
      add(2 + t, t, 1 / weights.row(t).norm(), held[i].normal, 0);
    }
  }
  const int count = static_cast<int>(right.size());
  result.rows.matrix.resize(count, 3 * mesh.vertex_count());
  result.rows.matrix.setFromTriplets(entries.begin(), entries.end());
  result.rows.right = Eigen::Map<const Eigen::VectorXd>(right.data(), count);
  result.rows.scales = Eigen::VectorXd::Ones(count);
  return result;
}

LinearRows in_coordinates(const LinearRows& rows, const Coordinates& coordinates) {
  if (coordinates.free()) return rows;
  const Points offset = coordinates.control(Eigen::VectorXd::Zero(coordinates.count()));
  const Eigen::SparseMatrix<double, Eigen::RowMajor> basis = coordinates.matrix();
  LinearRows result{rows.matrix * basis, rows.right, rows.scales};
  result.right -= rows.matrix * Eigen::Map<const Eigen::VectorXd>(offset.data(), offset.size());
  return result;
}

Vector3 pull(const PinRows& rows, const Eigen::VectorXd& multipliers, int pin) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t row = 0; row < rows.owners.size(); ++row) {
    const PinRow& owner = rows.owners[row];
    if (owner.pin == pin && owner.coordinate < 3) sum[owner.coordinate] += multipliers[static_cast<Eigen::Index>(row)];
  }
  return sum;
}

std::vector<int> turned_over(const std::vector<HeldPoint>& held, const PolygonMesh& mesh, const Points& control) {
  std::vector<int> result;
  const std::vector<LimitStencil> stencils = stencils_of(held, mesh);
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i].holds_normal()) continue;
    const Eigen::Matrix3d here = stencils[i].apply(control);
    if (!(here.col(1).cross(here.col(2)).dot(held[i].normal) > 0)) result.push_back(static_cast<int>(i));
  }
  return result;
}

bool keeps(const Symmetry& symmetry, const Vector3& center, const std::vector<HeldPoint>& held,
           const PolygonMesh& mesh) {
  std::vector<HeldPoint> images = held;
  for (HeldPoint& image : images) image.place = image_of(image.place, symmetry.map, mesh);
  const std::vector<LimitStencil> before = stencils_of(held, mesh), after = stencils_of(images, mesh);
  for (std::size_t i = 0; i < held.size(); ++i) {
    bool found = false;
    for (std::size_t j = 0; j < held.size() && !found; ++j) {
      found = same_point(after[i], before[j]) && maps_targets(symmetry.isometry, center, held[i], held[j]);
    }
    if (!found) return false;
  }
  return true;
}

namespace {

/// What the isometry about the center maps the targets to, if that can be held.
bool map_targets(const Eigen::Matrix3d& isometry, const Vector3& center, HeldPoint& point) {
  const Eigen::Matrix3d held = isometry * held_coordinates(point) * isometry.transpose();
  const Vector3 rounded = held.diagonal().array().round();
  if ((held - Eigen::Matrix3d(rounded.asDiagonal())).norm() > kSameTarget) return false;
  for (int c = 0; c < 3; ++c) point.holds[c] = rounded[c] != 0;
  point.position = center + isometry * (point.position - center);
  point.normal = isometry * point.normal;
  return true;
}

}  // namespace

Result<std::vector<HeldPoint>> with_images(const std::vector<HeldPoint>& held, const std::vector<Symmetry>& symmetries,
                                           const Vector3& center, const PolygonMesh& mesh) {
  std::vector<HeldPoint> result = held;
  std::vector<LimitStencil> stencils = stencils_of(held, mesh);
  for (std::size_t i = 0; i < held.size(); ++i) {
    std::vector<HeldPoint> images;
    for (const Symmetry& symmetry : symmetries) {
      HeldPoint image = held[i];
      image.place = image_of(image.place, symmetry.map, mesh);
      if (!map_targets(symmetry.isometry, center, image)) {
        return refused(i,
                       "at: only some coordinates are held, which the cage's symmetry does not map to coordinates; "
                       "hold all three, or leave out constraints.symmetric");
      }
      images.push_back(image);
    }
    const std::vector<LimitStencil> places = stencils_of(images, mesh);
    int copies = 0;
    for (std::size_t k = 0; k < images.size(); ++k) {
      bool known = false;
      for (std::size_t j = 0; j < result.size() && !known; ++j) {
        known = maps_targets(Eigen::Matrix3d::Identity(), center, images[k], result[j]) &&
                same_point(places[k], stencils[j]);
      }
      if (known) continue;
      images[k].copy = ++copies;
      result.push_back(images[k]);
      stencils.push_back(places[k]);
    }
  }
  return result;
}

}  // namespace umbilic
