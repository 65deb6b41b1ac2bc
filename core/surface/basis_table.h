// SPDX-License-Identifier: MIT
/// \file
/// Basis derivatives of one kind of patch at fixed samples, shared by all patches of the kind; never grows with the
/// mesh.
#pragma once

#include <Eigen/Core>
#include <compare>
#include <memory>
#include <vector>

#include "surface/cap.h"
#include "surface/quadrature.h"

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

/// Derivatives `first` up to but without `last` at all samples.
struct BasisTable {
  int samples = 0;
  int columns = 0;
  Eigen::VectorXd weights;     ///< quadrature weight of each sample
  Eigen::MatrixXd basis;       ///< (derivative, sample) x columns: row (d - first) samples + s
  Eigen::MatrixXd flattening;  ///< the same for `kFlat`; else empty

  std::size_t bytes() const { return sizeof(double) * (basis.size() + flattening.size() + weights.size()); }
};

/// Where basis functions go: entry (row, column) stands at [column * stride + row].
struct BasisColumns {
  double* entries;
  Eigen::Index stride;
};

/// Derivatives `first` up to but without `last`, row (d - first) samples + s, and for `kFlat` the flattening's.
void write_basis(const PatchKind& kind, const std::vector<Sample>& samples, int first, int last, BasisColumns basis,
                 BasisColumns flattening);

BasisTable basis_table(const PatchKind& kind, const std::vector<Sample>& samples, int first, int last);

/// What tables that a process shares may take, of each form, while nobody uses them.
inline constexpr std::size_t kSharedTableBytes = 64 << 20;

/// The samples of a rule on the faces of a kind.
std::vector<Sample> samples_of(const PatchKind& kind, const QuadratureRule& rule);

/// The table of all derivatives at these, shared by everything in the process that needs it.
std::shared_ptr<const BasisTable> shared_basis_table(const PatchKind& kind, const QuadratureRule& rule);

/// Repeats the last sample with weight 0 until the count is a multiple of `lanes`.
void pad_samples(std::vector<Sample>& samples, int lanes);

}  // namespace umbilic
