// SPDX-License-Identifier: MIT
/// \file
/// Boxes first, then everything else in the unit coordinates that they give.
#include "cage/component_size.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace umbilic {
namespace {

/// Of a component about the origin: far above what arithmetic rounds, far below what anyone means.
constexpr double kLeastRounding = 1e-12;

/// Calls visit(component, point) for each corner.
template <class Visit>
void for_each_corner(const Cage& cage, const Orientation& orientation, const Visit& visit) {
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    for (const int v : cage.faces[f]) visit(orientation.component[f], Vector3(cage.vertices.row(v)));
  }
}

void place(const Cage& cage, const Orientation& orientation, std::vector<ComponentSize>& sizes) {
  std::vector<Vector3> low(sizes.size()), high(sizes.size());
  std::vector<bool> seen(sizes.size(), false);
  for_each_corner(cage, orientation, [&](int c, const Vector3& x) {
    low[c] = seen[c] ? Vector3(low[c].cwiseMin(x)) : x;
    high[c] = seen[c] ? Vector3(high[c].cwiseMax(x)) : x;
    seen[c] = true;
  });
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    ComponentSize& size = sizes[c];
    size.placement = placement_of(low[c], high[c]);
    size.coincident = low[c] == high[c];
    Points ends(2, 3);
    ends << low[c].transpose(), high[c].transpose();
    size.rounding = std::max(kLeastRounding, 8 * size.placement.rounding(ends).maxCoeff());
  }
}

/// The point farthest from the first one, then the distances from the line through both: half the largest width or
/// more.
void measure_widths(const Cage& cage, const Orientation& orientation, std::vector<ComponentSize>& sizes) {
  std::vector<Vector3> first(sizes.size()), axis(sizes.size(), Vector3::Zero());
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    const int v = cage.faces[sizes[c].first_face].front();
    first[c] = sizes[c].placement.to_unit(Vector3(cage.vertices.row(v)));
  }
  const auto arm = [&](int c, const Vector3& x) -> Vector3 { return sizes[c].placement.to_unit(x) - first[c]; };
  for_each_corner(cage, orientation, [&](int c, const Vector3& x) {
    if (const Vector3 a = arm(c, x); a.squaredNorm() > axis[c].squaredNorm()) axis[c] = a;
  });
  for_each_corner(cage, orientation, [&](int c, const Vector3& x) {
    const double length = axis[c].norm();
    if (length > 0) sizes[c].width = std::max(sizes[c].width, axis[c].cross(arm(c, x)).norm() / length);
  });
}

void add_faces(const Cage& cage, const Orientation& orientation, std::vector<ComponentSize>& sizes) {
  // Cones from the middle of the component's corners, which keeps their sum from cancellation.
  std::vector<Vector3> apex(sizes.size(), Vector3::Zero());
  std::vector<int> corners(sizes.size(), 0);
  for_each_corner(cage, orientation, [&](int c, const Vector3& x) {
    apex[c] += sizes[c].placement.to_unit(x);
    ++corners[c];
  });
  for (std::size_t c = 0; c < sizes.size(); ++c) apex[c] /= corners[c];
  std::vector<Vector3> arms;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const int c = orientation.component[f];
    ComponentSize& size = sizes[c];
    Vector3 centroid = Vector3::Zero();
    arms.clear();
    for (const int v : cage.faces[f]) {
      arms.push_back(size.placement.to_unit(Vector3(cage.vertices.row(v))) - apex[c]);
      centroid += arms.back() / static_cast<double>(cage.faces[f].size());
    }
    Vector3 twice_area = Vector3::Zero();
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const Vector3 &from = arms[i], &to = arms[(i + 1) % arms.size()];
      size.area += (from - centroid).cross(to - centroid).norm() / 2;
      twice_area += from.cross(to);
    }
    const double cone = centroid.dot(twice_area) / 6;
    size.volume += orientation.flipped[f] ? -cone : cone;
  }
}

}  // namespace

std::vector<ComponentSize> component_sizes(const Cage& cage, const Orientation& orientation) {
  std::vector<ComponentSize> sizes(orientation.component_count);
  for (std::size_t f = cage.faces.size(); f-- > 0;) sizes[orientation.component[f]].first_face = static_cast<int>(f);
  place(cage, orientation, sizes);
  measure_widths(cage, orientation, sizes);
  add_faces(cage, orientation, sizes);
  return sizes;
}

}  // namespace umbilic
