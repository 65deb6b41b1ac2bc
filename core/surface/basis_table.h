// SPDX-License-Identifier: MIT
/// \file
/// Tables of basis derivatives at fixed samples. Patches of the same kind share one, so memory does not grow with the
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

/// What determines a patch's basis: a regular face (valence 4, kBare, cell 0), or the face `cell` in a sector of a cap.
struct PatchKind {
  int valence = 4;
  CapShape shape = CapShape::kBare;
  int cell = 0;

  bool regular() const { return valence == 4; }
  bool at_extraordinary() const { return !regular() && cell == 0; }
  friend auto operator<=>(const PatchKind&, const PatchKind&) = default;
};

/// The local control points that a kind's basis acts on: points of the sector's net (on a regular face 0..15, the 4 x 4
/// grid with u fastest), then the sector's cap coefficients.
struct PatchColumns {
  std::vector<int> net;
  int coefficients = 0;

  int count() const { return static_cast<int>(net.size()) + coefficients; }
};

/// Computed once per process and kind.
const PatchColumns& patch_columns(const PatchKind& kind);

/// Derivatives of the basis functions of X at (u, v) in the face, 10 x columns.
DerivativeRows patch_basis(const PatchKind& kind, double u, double v);
DerivativeRows patch_flattening(const PatchKind& kind, double u, double v);

/// Derivatives of order `first` and up at all samples, laid out for the kernels: each column starts on a cache line,
/// and rows and columns are padded.
struct BasisTable {
  /// Columns are padded with zeros to a multiple of this.
  static constexpr int kColumnMultiple = 4;
  using View = Eigen::Map<const Eigen::MatrixXd, Eigen::Unaligned, Eigen::OuterStride<>>;

  int first = 0;               ///< index of the first derivative
  int derivatives = 0;         ///< number of derivatives
  int distinct = 0;            ///< number of samples before padding
  int samples = 0;             ///< padded to a multiple of kSampleMultiple: the last sample repeated with weight 0
  int columns = 0;             ///< local points
  int padded_columns = 0;      ///< a multiple of kColumnMultiple
  int stride = 0;              ///< doubles from one column to the next
  Eigen::VectorXd weights;     ///< quadrature weight of each sample
  AlignedDoubles basis;        ///< entry (row, column) at [column * stride + row], row (d - first) samples + s
  AlignedDoubles flattening;   ///< the same for `kFlat`; else empty
  AlignedDoubles normal_part;  ///< basis - flattening for `kFlat`; else empty

  /// The rows of `part` (one of the three tables) from a derivative on.
  DenseTable from(int derivative, const AlignedDoubles& part) const {
    return {part.data() + (derivative - first) * samples, stride, columns};
  }
  View view(int derivative, const AlignedDoubles& part) const {
    return {from(derivative, part).entries, Eigen::Index(derivatives + first - derivative) * samples, columns,
            Eigen::OuterStride<>(stride)};
  }
  /// The basis functions of the coordinate along the normal of a flat cap, with the normal held fixed. Without a flat
  /// cap all coordinates have the same basis.
  const AlignedDoubles& along_normal() const { return normal_part.empty() ? basis : normal_part; }

  std::size_t bytes() const {
    return sizeof(double) * (basis.size() + flattening.size() + normal_part.size() + weights.size());
  }
};

/// The table of the derivatives [first, last).
BasisTable basis_table(const PatchKind& kind, std::vector<Sample> samples, int first, int last);

/// Memory that the tables shared by the process may take while nobody uses them: those of quadrature rules, and those
/// of tessellations.
inline constexpr std::size_t kSharedTableBytes = 64 << 20;

/// Whether a cell of a cap takes as many samples as a regular face: so far from the vertex, where the blend is so slow,
/// X is as smooth as on others. On the genus-2 frame at level 3 that changes energies by less than 1e-6.
constexpr bool samples_as_regular(CapShape shape, int cell) { return rings(shape) >= 8 && ring_of(shape, cell) >= 2; }

/// The rule's samples on a face of this kind.
std::vector<Sample> samples_of(const PatchKind& kind, const QuadratureRule& rule);

/// The table of all derivatives from `first` on at `samples_of(kind, rule)`, shared by the process.
std::shared_ptr<const BasisTable> shared_basis_table(const PatchKind& kind, const QuadratureRule& rule, int first);

/// Repeats the last sample with weight 0 until the count is a multiple of `lanes`.
void pad_samples(std::vector<Sample>& samples, int lanes);

}  // namespace umbilic
