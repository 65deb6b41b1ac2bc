// SPDX-License-Identifier: MIT
/// \file
/// Basis derivatives of one kind of patch at fixed samples, shared by all patches of the kind; never grows with the
/// mesh.
#pragma once

#include <Eigen/Core>
#include <compare>
#include <memory>
#include <vector>

#include "base/aligned_doubles.h"
#include "surface/cap.h"
#include "surface/quadrature.h"
#include "surface/surface_kernels.h"

namespace umbilic {

/// A regular face (valence 4, kBare, cell 0), or a face of a cap's sector.
struct PatchKind {
  int valence = 4;
  CapShape shape = CapShape::kBare;
  int cell = 0;

  bool regular() const { return valence == 4; }
  bool at_extraordinary() const { return !regular() && cell == 0; }
  friend auto operator<=>(const PatchKind&, const PatchKind&) = default;
};

/// The local control points that a kind's basis needs: columns of the sector's net (for a regular face 0..15, the 4 x 4
/// grid with u fastest), then the sector's cap coefficients.
struct PatchColumns {
  std::vector<int> net;
  int coefficients = 0;

  int count() const { return static_cast<int>(net.size()) + coefficients; }
};

/// Found once per process.
const PatchColumns& patch_columns(const PatchKind& kind);

/// X's basis at (u, v) of the face, 10 x columns, and for `kFlat` the flattening's.
DerivativeRows patch_basis(const PatchKind& kind, double u, double v);
DerivativeRows patch_flattening(const PatchKind& kind, double u, double v);

/// Derivatives from `first` on at all samples, as the kernels want them: columns start on cache lines, and both
/// directions are padded.
struct BasisTable {
  /// Surplus columns are zero.
  static constexpr int kColumnMultiple = 4;
  using View = Eigen::Map<const Eigen::MatrixXd, Eigen::Unaligned, Eigen::OuterStride<>>;

  int first = 0;               ///< the lowest derivative
  int derivatives = 0;         ///< how many
  int distinct = 0;            ///< samples, which stand first
  int samples = 0;             ///< a multiple of kSampleMultiple: the last one again with weight 0
  int columns = 0;             ///< local points
  int padded_columns = 0;      ///< a multiple of kColumnMultiple
  int stride = 0;              ///< from column to column
  Eigen::VectorXd weights;     ///< quadrature weight of each sample
  AlignedDoubles basis;        ///< entry (row, column) at [column * stride + row], row (d - first) samples + s
  AlignedDoubles flattening;   ///< the same for `kFlat`; else empty
  AlignedDoubles normal_part;  ///< basis - flattening for `kFlat`: what moves along a normal that is held fixed

  /// One of the three, from a derivative on.
  DenseTable from(int derivative, const AlignedDoubles& part) const {
    return {part.data() + (derivative - first) * samples, stride, columns};
  }
  View view(int derivative, const AlignedDoubles& part) const {
    return {from(derivative, part).entries, Eigen::Index(derivatives + first - derivative) * samples, columns,
            Eigen::OuterStride<>(stride)};
  }
  /// The functions along the normal of a flat cap while that is held fixed; elsewhere all coordinates have the same.
  const AlignedDoubles& along_normal() const { return normal_part.empty() ? basis : normal_part; }

  std::size_t bytes() const {
    return sizeof(double) * (basis.size() + flattening.size() + normal_part.size() + weights.size());
  }
};

/// Derivatives `first` up to but without `last`.
BasisTable basis_table(const PatchKind& kind, std::vector<Sample> samples, int first, int last);

/// What the tables that a process shares may take, of quadrature rules and of grids, while nobody uses them.
inline constexpr std::size_t kSharedTableBytes = 64 << 20;

/// The samples of a rule on the faces of a kind.
std::vector<Sample> samples_of(const PatchKind& kind, const QuadratureRule& rule);

/// The table of all derivatives from `first` on at these, shared by everything in the process that needs it.
std::shared_ptr<const BasisTable> shared_basis_table(const PatchKind& kind, const QuadratureRule& rule, int first);

/// Repeats the last sample with weight 0 until the count is a multiple of `lanes`.
void pad_samples(std::vector<Sample>& samples, int lanes);

}  // namespace umbilic
