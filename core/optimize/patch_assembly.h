// SPDX-License-Identifier: MIT
/// \file
/// Sums the patches' symmetric matrices into a sparse symmetric matrix over the unknowns.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "mesh/coordinates.h"
#include "surface/layout.h"

namespace umbilic {

/// Walks through the patches of a layout in parts.
struct PatchCursor {
  int set = 0;
  int patch = 0;

  /// Calls `add(set, patch)`, which returns its cost, until `budget` is spent. Returns whether all patches are done.
  template <class Add>
  bool visit(const PatchLayout& layout, int budget, const Add& add) {
    while (budget > 0 && set < static_cast<int>(layout.sets().size())) {
      budget -= add(set, patch);
      if (++patch == layout.sets()[set].count()) {
        ++set;
        patch = 0;
      }
    }
    return set == static_cast<int>(layout.sets().size());
  }
};

/// What some patches add up to.
struct PatchSums {
  /// Of the matrix between a cap's coefficients in sector 0's coordinates, c * coefficients + k, and the unknowns that
  /// its net depends on.
  struct CapSums {
    Eigen::MatrixXd mixed;  ///< unknowns x coefficients
    Eigen::MatrixXd own;    ///< coefficients x coefficients
  };
  std::vector<double> values;  ///< of the pattern
  std::vector<CapSums> caps;
};

/// The pattern of all matrices that the patches of a layout contribute to, and how they do. Control points are replaced
/// by the unknowns that they depend on; the caps' coefficients are eliminated, once for each cap, when all patches are
/// added. Sums live outside, so that several matrices share one pattern.
class PatchAssembly {
 public:
  /// Over the unknowns of `coordinates`.
  PatchAssembly(const PatchLayout& layout, const Coordinates& coordinates);
  /// Over the control points: one row and column for each.
  explicit PatchAssembly(const PatchLayout& layout);

  int size() const { return static_cast<int>(outer_.size()) - 1; }
  std::size_t nonzeros() const { return inner_.size(); }

  /// Sums of nothing.
  void clear(PatchSums& sums) const;
  /// `block` is 3 columns x 3 columns, row-major, over the coordinates c * columns + i of the patch's points i; where
  /// c == e only i >= j is read of ((c, i), (e, j)), and of c != e only c > e. `columns` is at least the set's.
  void add(int set, int patch, const double* block, int columns, PatchSums& sums) const;
  /// `block` is a symmetric matrix over the patch's points, the same for all three coordinates, of which i >= j is
  /// read.
  void add_scalar(int set, int patch, const Eigen::MatrixXd& block, PatchSums& sums) const;
  /// Moves what waits at the caps to the values.
  void eliminate(PatchSums& sums) const;

  /// The lower triangle with these values.
  Eigen::Map<const Eigen::SparseMatrix<double>> lower(const std::vector<double>& values) const;

 private:
  /// Vertices that share the unknowns [first, first + dimension).
  struct Orbit {
    int first, dimension;
    std::vector<int> neighbours;  ///< orbits >= this one, rising
    std::vector<int> rows;        ///< where each neighbour's rows begin, counted from the column's first entry
  };
  /// A cap's coefficients as a function of its net's unknowns, of which only some decide them.
  struct Elimination {
    std::vector<int> unknowns;  ///< rising
    std::vector<bool> fitted;   ///< whether the coefficients depend on each
    Eigen::MatrixXd fit;        ///< coefficients x unknowns
  };
  void build(std::vector<Coordinates::Block> blocks);
  void build_eliminations();
  std::vector<int> orbits_at(const int* vertices, std::size_t count) const;
  void add_neighbours(const std::vector<int>& some, const std::vector<int>& others);
  void build_pattern();
  void find_rows();
  /// Of which the unknowns of a vertex are combinations: 1 where the matrix is scalar.
  int coordinates() const { return scalar_ ? 1 : 3; }

  template <class Block>
  void add_block(int set, int patch, const Block& block, PatchSums& sums) const;
  template <class Block>
  void add_coefficients(int set, int patch, const Block& block, PatchSums& sums) const;
  /// Adds the block between two orbits, and its transpose unless it belongs to one place; `first_row` as in `rows_`.
  void scatter(int row, int column, int first_row, bool one_place, const Eigen::Matrix3d& block,
               std::vector<double>& values) const;

  const PatchLayout& layout_;
  bool scalar_;
  std::vector<Coordinates::Block> blocks_;  ///< of each vertex; in a scalar matrix the first coordinate stands for all
  std::vector<int> orbit_of_;               ///< of each vertex, -1 without unknowns
  std::vector<Orbit> orbits_;
  std::vector<Elimination> eliminations_;  ///< of each cap; empty without coefficients
  std::vector<int> outer_, inner_;
  /// Of each set, patch and pair of its control points: where the block of the later orbit begins, counted from the
  /// first entry of the earlier one's column; -1 without unknowns.
  std::vector<std::vector<int>> rows_;
};

}  // namespace umbilic
