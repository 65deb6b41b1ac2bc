// SPDX-License-Identifier: MIT
/// \file
/// The characteristic map of an extraordinary vertex in the complex plane: the planar limit surface that a step only
/// scales. Sector j is sector 0 turned by j full turns / N, so that a grid of complex numbers describes it. The point
/// two steps along spoke 0 maps to 1.
#pragma once

#include <complex>
#include <vector>

#include "opinion/corner_window.h"

namespace umbilic::opinion {

class CharacteristicMap {
 public:
  /// For sectors of `rings` rings of faces.
  CharacteristicMap(int valence, int rings);

  /// The window at the vertex, sector 0; z = 0.
  CornerWindow window() const;
  /// The control points of the face (i, j) of sector 0, not (0, 0).
  Grid grid(int i, int j) const;

 private:
  using Complex = std::complex<double>;

  Complex at(int a, int b) const;
  Vector3 point(int a, int b) const;
  void step();

  int valence_, reach_;
  Complex turn_;                 // one sector further
  std::vector<Complex> sector_;  // (a, b) of sector 0 at (a - 1)(reach + 1) + b, a from 1, b from 0 to reach
};

}  // namespace umbilic::opinion
