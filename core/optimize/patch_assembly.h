// SPDX-License-Identifier: MIT
/// \file
/// Sums the symmetric matrices of the patches into a sparse symmetric matrix over the unknowns.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "mesh/coordinates.h"
#include "surface/layout.h"

namespace umbilic {

/// A patch of a layout.
struct PatchNumber {
  int set, patch;
};

/// Goes through the patches of a layout, a part at a time.
class PatchCursor {
 public:
  /// The next patches: as many as it takes for their costs to reach `budget`, or all that are left.
  template <class Cost>
  std::vector<PatchNumber> advance(const PatchLayout& layout, int budget, const Cost& cost_in_set) {
    std::vector<PatchNumber> part;
    for (; budget > 0 && !ended(layout); budget -= cost_in_set(part.back().set)) {
      part.push_back(next_);
      if (++next_.patch == layout.sets()[next_.set].count()) next_ = {next_.set + 1, 0};
    }
    return part;
  }
  bool ended(const PatchLayout& layout) const { return next_.set == static_cast<int>(layout.sets().size()); }

 private:
  PatchNumber next_{0, 0};
};

/// What a patch adds to the sums of a PatchAssembly.
struct PatchTerms {
  /// For each pair of its control points, in the order of the rows of a lower triangle: their unknowns' block, as far
  /// as both have any.
  std::vector<Eigen::Matrix3d> pairs;
  /// If the patch has coefficients, those of the cap's: their own block, and for each pair (c, e) of coordinates, at
  /// [3 c + e], the blocks between coordinate c of the coefficients and coordinate e of the control points.
  Eigen::MatrixXd own;                   ///< coefficients x coefficients
  std::array<Eigen::MatrixXd, 9> mixed;  ///< coefficients of one coordinate x control points
};

/// The sums of a PatchAssembly over the patches added so far.
struct PatchSums {
  /// The blocks between a cap's coefficients, c * coefficients + k in the coordinates of sector 0, and the unknowns of
  /// its net.
  struct CapSums {
    Eigen::MatrixXd mixed;  ///< unknowns x coefficients
    Eigen::MatrixXd own;    ///< coefficients x coefficients
  };
  std::vector<double> values;  ///< of the entries of the pattern
  std::vector<CapSums> caps;
};

/// The sparsity pattern of all matrices that are sums over the patches of a layout, and the rules for adding to them.
/// Control points are expressed by the unknowns, and the caps' coefficients are eliminated, once per cap after all
/// patches are added. The sums are separate objects, so that several matrices share one pattern.
class PatchAssembly {
 public:
  /// For a matrix over the unknowns of `coordinates`. If these are Cartesian, it may be `scalar`: with one row and
  /// column for the three unknowns of each control point.
  PatchAssembly(const PatchLayout& layout, const Coordinates& coordinates, bool scalar = false);

  int size() const { return static_cast<int>(outer_.size()) - 1; }
  std::size_t nonzeros() const { return inner_.size(); }

  /// Sets the sums to zero.
  void clear(PatchSums& sums) const;
  /// What a patch's matrix adds to the sums. `block` is 3 columns x 3 columns, row-major, over the coordinates
  /// c * columns + i of the patch's points i. Of the entries ((c, i), (e, j)) only those with c > e, or c == e and i >=
  /// j, are read. `columns` may exceed the set's. Several threads may call this at the same time.
  void terms(int set, int patch, const double* block, int columns, PatchTerms& terms) const;
  /// The same of a matrix over the patch's points that is the same for all three coordinates. Only i >= j is read of
  /// `block`.
  void scalar_terms(int set, int patch, const Eigen::MatrixXd& block, PatchTerms& terms) const;
  /// Adds the terms of a patch.
  void add(int set, int patch, const PatchTerms& terms, PatchSums& sums) const;
  /// Adds what was summed per cap to the values. Call once, after all patches.
  void eliminate(PatchSums& sums) const;

  /// The lower triangle of the matrix with these values.
  Eigen::Map<const Eigen::SparseMatrix<double>> lower(const std::vector<double>& values) const;

 private:
  /// Vertices that share the unknowns [first, first + dimension).
  struct Orbit {
    int first, dimension;
    std::vector<int> neighbours;  ///< orbits >= this one, sorted
    std::vector<int> rows;        ///< offset of each neighbour's rows from the first entry of the column
  };
  /// A cap's coefficients as a linear function of the unknowns of its net. They depend on some of these only.
  struct Elimination {
    std::vector<int> unknowns;  ///< sorted
    std::vector<bool> fitted;   ///< of each unknown: whether the coefficients depend on it
    Eigen::MatrixXd fit;        ///< coefficients x unknowns
  };
  void build(std::vector<Coordinates::Block> blocks);
  void build_eliminations();
  std::vector<int> orbits_at(const int* vertices, std::size_t count) const;
  void add_neighbours(const std::vector<int>& some, const std::vector<int>& others);
  void build_pattern();
  void find_rows();
  /// Number of coordinates per vertex: 1 if the matrix is scalar.
  int coordinates() const { return scalar_ ? 1 : 3; }

  template <class Block>
  void terms_of(int set, int patch, const Block& block, PatchTerms& terms) const;
  template <class Block>
  void coefficient_terms(int set, int patch, const Block& block, PatchTerms& terms) const;
  void add_coefficients(int set, int patch, const PatchTerms& terms, PatchSums& sums) const;
  /// Adds the block between two orbits, and its transpose unless both are the same point of the patch (`one_place`).
  /// `first_row` as in `rows_`.
  void scatter(int row, int column, int first_row, bool one_place, const Eigen::Matrix3d& block,
               std::vector<double>& values) const;

  const PatchLayout& layout_;
  bool scalar_;
  std::vector<Coordinates::Block> blocks_;  ///< of each vertex; if scalar, the first coordinate stands for all
  std::vector<int> orbit_of_;               ///< of each vertex; -1 if it has no unknowns
  std::vector<Orbit> orbits_;
  std::vector<Elimination> eliminations_;  ///< of each cap; empty if it has no coefficients
  std::vector<int> outer_, inner_;
  /// For each set, patch and pair of its control points: offset of the later orbit's block from the first entry of the
  /// earlier orbit's column; -1 if one of them has no unknowns.
  std::vector<std::vector<int>> rows_;
};

}  // namespace umbilic
