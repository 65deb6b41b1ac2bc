// SPDX-License-Identifier: MIT
/// \file
/// A cap's surface as a function of the ring net alone, in any sector.
#pragma once

#include "surface/cap.h"

namespace umbilic::test {

/// Column of the net that stands in `sector` where column i stands in sector 0.
inline int turned(const RingNet& net, int i, int sector) {
  return i == 0 ? 0 : 1 + (i - 1 + 12 * sector) % (net.size() - 1);
}

/// Moves the columns of sector 0 to `sector`.
template <class Matrix>
Matrix turned(const RingNet& net, const Matrix& rows, int sector) {
  Matrix result(rows.rows(), rows.cols());
  for (int i = 0; i < net.size(); ++i) result.col(turned(net, i, sector)) = rows.col(i);
  return result;
}

/// Derivatives of X at (u, v) of a sector by the control points of the net, the fit included; 10 x net size. For the
/// flat cap, those of S.
inline DerivativeRows whole_basis(const CapSector& cap, int sector, double u, double v) {
  const DerivativeRows split = cap.basis(u, v);
  const int size = cap.net().size();
  DerivativeRows whole = split.leftCols(size);
  if (split.cols() > size) whole += split.rightCols(split.cols() - size) * cap.fit();
  return turned(cap.net(), whole, sector);
}

/// The largest entry of the derivatives of `order`.
inline double largest(const DerivativeRows& rows, int order) {
  return rows.middleRows(derivative_index(order, 0), order + 1).cwiseAbs().maxCoeff();
}

inline constexpr CapShape kAllShapes[] = {CapShape::kBare, CapShape::kFlat, CapShape::kOneRing, CapShape::kTwoRing};
inline constexpr CapShape kPolynomialShapes[] = {CapShape::kOneRing, CapShape::kTwoRing};

/// How far from the extraordinary vertex the cap's rim is, in sector coordinates.
inline double rim(CapShape shape) { return shape == CapShape::kTwoRing ? 2 : 1; }

}  // namespace umbilic::test
