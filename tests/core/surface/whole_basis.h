// SPDX-License-Identifier: MIT
/// \file
/// A cap's surface as a function of the ring net alone, in any sector.
#pragma once

#include <algorithm>

#include "surface/cap.h"

namespace umbilic::test {

/// Moves the columns of sector 0 to `sector`.
template <class Matrix>
Matrix turned(const RingNet& net, const Matrix& rows, int sector) {
  Matrix result(rows.rows(), rows.cols());
  for (int i = 0; i < net.size(); ++i) result.col(net.turned(i, sector)) = rows.col(i);
  return result;
}

/// The face of sector 0 that the cap's surface is evaluated on at (u, v), and the coordinates there.
struct SectorFace {
  int cell;
  double u, v;

  SectorFace(const CapSector& cap, double sector_u, double sector_v) {
    const int n = cap.shape() == CapShape::kBare ? 2 : rings(cap.shape());
    const int i = std::min(static_cast<int>(sector_u), n - 1), j = std::min(static_cast<int>(sector_v), n - 1);
    cell = i + cap.net().rings() * j;
    u = sector_u - i;
    v = sector_v - j;
  }
};

/// Columns of a face's support moved to those of the net; what follows them stays behind these.
inline DerivativeRows over_net(const RingNet& net, int cell, const DerivativeRows& here) {
  const int count = static_cast<int>(net.support(cell).size()), rest = static_cast<int>(here.cols()) - count;
  DerivativeRows rows = DerivativeRows::Zero(kDerivativeCount, net.size() + rest);
  for (int k = 0; k < count; ++k) rows.col(net.support(cell)[k]) = here.col(k);
  rows.rightCols(rest) = here.rightCols(rest);
  return rows;
}

/// Derivatives at (u, v) of sector 0 by all control points of the net and the cap's coefficients; 10 x (net size +
/// coefficients). For the flat cap, those of S.
inline DerivativeRows sector_basis(const CapSector& cap, double u, double v) {
  const SectorFace face(cap, u, v);
  return over_net(cap.net(), face.cell, cap.basis(face.cell, face.u, face.v));
}

/// Those of the limit surface on the same face.
inline DerivativeRows sector_limit(const CapSector& cap, double u, double v) {
  const SectorFace face(cap, u, v);
  return over_net(cap.net(), face.cell, cap.net().face_basis(face.cell, face.u, face.v));
}

inline DerivativeRows sector_flattening(const CapSector& cap, double u, double v) {
  return over_net(cap.net(), 0, cap.flattening(u, v));
}

/// Derivatives of X at (u, v) of a sector by the control points of the net, the fit included; 10 x net size. For the
/// flat cap, those of S.
inline DerivativeRows whole_basis(const CapSector& cap, int sector, double u, double v) {
  const DerivativeRows split = sector_basis(cap, u, v);
  const int size = cap.net().size();
  DerivativeRows whole = split.leftCols(size);
  if (split.cols() > size) whole += split.rightCols(split.cols() - size) * cap.fit();
  return turned(cap.net(), whole, sector);
}

/// The largest entry of the derivatives of `order`.
inline double largest(const DerivativeRows& rows, int order) {
  return rows.middleRows(derivative_index(order, 0), order + 1).cwiseAbs().maxCoeff();
}

inline constexpr CapShape kAllShapes[] = {CapShape::kBare,       CapShape::kFlat,     CapShape::kOneRing,
                                          CapShape::kTwoRing,    CapShape::kFourRing, CapShape::kEightRing,
                                          CapShape::kSixteenRing};
inline constexpr CapShape kPolynomialShapes[] = {CapShape::kOneRing, CapShape::kTwoRing, CapShape::kFourRing,
                                                 CapShape::kEightRing, CapShape::kSixteenRing};

/// How far from the extraordinary vertex the cap's rim is, in sector coordinates.
inline double rim(CapShape shape) { return rings(shape); }

}  // namespace umbilic::test
