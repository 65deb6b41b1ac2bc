// SPDX-License-Identifier: MIT
/// \file
/// Orientation by enclosed volume.
#include "cage/outward.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace umbilic {

namespace {

/// What a component's volume is measured in: a size that keeps its cube from overflow, and an apex that keeps it from
/// cancellation.
struct Gauge {
  double size = std::numeric_limits<double>::min();
  Vector3 apex = Vector3::Zero();
  int corners = 0;
};

/// A sum of cones over a component's faces.
struct Volume {
  double signed_sum = 0;
  double absolute_sum = 0;
};

std::vector<Gauge> gauges(const Cage& cage, const Orientation& orientation) {
  std::vector<Gauge> gauges(orientation.component_count);
  const auto for_each_corner = [&](auto visit) {
    for (std::size_t f = 0; f < cage.faces.size(); ++f) {
      Gauge& gauge = gauges[orientation.component[f]];
      for (const int v : cage.faces[f]) visit(gauge, cage.vertices.row(v).transpose());
    }
  };
  for_each_corner([](Gauge& g, const auto& point) { g.size = std::max(g.size, point.cwiseAbs().maxCoeff()); });
  for_each_corner([](Gauge& g, const auto& point) {
    g.apex += point / g.size;
    ++g.corners;
  });
  for (Gauge& gauge : gauges) gauge.apex /= gauge.corners;
  return gauges;
}

/// Signed volumes up to positive factors; a face counts as the fan around its centroid, which favours no corner.
std::vector<Volume> volumes(const Cage& cage, const Orientation& orientation) {
  const std::vector<Gauge> gauge = gauges(cage, orientation);
  std::vector<Volume> volume(gauge.size());
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    const int c = orientation.component[f];
    const auto arm = [&](std::size_t corner) -> Vector3 {
      return cage.vertices.row(face[corner % face.size()]).transpose() / gauge[c].size - gauge[c].apex;
    };
    Vector3 centroid = Vector3::Zero();
    Vector3 area = Vector3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      centroid += arm(i) / static_cast<double>(face.size());
      area += arm(i).cross(arm(i + 1));
    }
    const double cone = centroid.dot(area);
    volume[c].signed_sum += orientation.flipped[f] ? -cone : cone;
    volume[c].absolute_sum += std::abs(cone);
  }
  return volume;
}

}  // namespace

void turn_outward(Cage& cage, const Orientation& orientation) {
  constexpr double kRoundOff = 1e-12;
  const std::vector<Volume> volume = volumes(cage, orientation);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const Volume& v = volume[orientation.component[f]];
    const bool inward = v.signed_sum < -kRoundOff * v.absolute_sum;
    if (orientation.flipped[f] != inward) std::reverse(cage.faces[f].begin() + 1, cage.faces[f].end());
  }
}

}  // namespace umbilic
