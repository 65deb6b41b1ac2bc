// SPDX-License-Identifier: MIT
/// \file
/// Iterates the Catmull-Clark step on points with the symmetry of the map until only the map is left.
#include "opinion/characteristic_map.h"

#include <algorithm>
#include <numbers>

namespace umbilic::opinion {
namespace {

/// Each step leaves less than half of what is not the map.
constexpr int kPowers = 80;

}  // namespace

CharacteristicMap::CharacteristicMap(int valence, int rings)
    : valence_(valence),
      reach_(std::max(3, rings + 1)),
      turn_(std::polar(1.0, 2 * std::numbers::pi / valence)),
      sector_(reach_ * (reach_ + 1)) {
  for (int a = 1; a <= reach_; ++a) {
    for (int b = 0; b <= reach_; ++b) sector_[(a - 1) * (reach_ + 1) + b] = double(a) + double(b) * turn_;
  }
  for (int i = 0; i < kPowers; ++i) {
    step();
    const Complex scale = at(1, 0);
    for (Complex& z : sector_) z /= scale;
  }
  // The limit point of the regular vertex (2, 0).
  const Complex edges = at(1, 0) + at(3, 0) + at(2, 1) + at(2, -1);
  const Complex corners = at(1, 1) + at(1, -1) + at(3, 1) + at(3, -1);
  const Complex limit = (16.0 * at(2, 0) + 4.0 * edges + corners) / 36.0;
  for (Complex& z : sector_) z /= limit;
}

CharacteristicMap::Complex CharacteristicMap::at(int a, int b) const {
  if (b < 0) return at(-b, a) / turn_;
  if (a < 0) return at(b, -a) * turn_;
  if (a == 0) return b == 0 ? 0 : at(b, 0) * turn_;
  return sector_[(a - 1) * (reach_ + 1) + b];
}

Vector3 CharacteristicMap::point(int a, int b) const {
  const Complex z = at(a, b);
  return {z.real(), z.imag(), 0};
}

void CharacteristicMap::step() {
  const auto face = [&](int a, int b) { return (at(a, b) + at(a + 1, b) + at(a + 1, b + 1) + at(a, b + 1)) / 4.0; };
  std::vector<Complex> refined(sector_.size());
  for (int a = 1; a <= reach_; ++a) {
    for (int b = 0; b <= reach_; ++b) {
      const int i = a / 2, j = b / 2;
      Complex& z = refined[(a - 1) * (reach_ + 1) + b];
      if (a % 2 == 1 && b % 2 == 1) {
        z = face(i, j);
      } else if (a % 2 == 1) {
        z = (at(i, j) + at(i + 1, j) + face(i, j) + face(i, j - 1)) / 4.0;
      } else if (b % 2 == 1) {
        z = (at(i, j) + at(i, j + 1) + face(i, j) + face(i - 1, j)) / 4.0;
      } else {
        const Complex faces = (face(i, j) + face(i - 1, j) + face(i - 1, j - 1) + face(i, j - 1)) / 4.0;
        const Complex ends = (at(i + 1, j) + at(i - 1, j) + at(i, j + 1) + at(i, j - 1)) / 4.0;
        z = (faces + at(i, j) + ends + at(i, j)) / 4.0;  // the mean of the edges' midpoints is half of both
      }
    }
  }
  sector_ = std::move(refined);
}

CornerWindow CharacteristicMap::window() const {
  std::vector<Vector3> spoke, diagonal;
  Complex turned = 1;
  for (int j = 0; j < valence_; ++j, turned *= turn_) {
    const Complex s = at(1, 0) * turned, d = at(1, 1) * turned;
    spoke.emplace_back(s.real(), s.imag(), 0);
    diagonal.emplace_back(d.real(), d.imag(), 0);
  }
  return {Vector3::Zero(),
          std::move(spoke),
          std::move(diagonal),
          {point(2, -1), point(2, 0), point(2, 1), point(2, 2), point(1, 2), point(0, 2), point(-1, 2)}};
}

Grid CharacteristicMap::grid(int i, int j) const {
  Grid grid;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) grid.row(4 * b + a) = point(i - 1 + a, j - 1 + b).transpose();
  }
  return grid;
}

}  // namespace umbilic::opinion
