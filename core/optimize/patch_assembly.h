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

/// The pattern of all matrices that the patches of a layout contribute to, and how they do. The caps' coefficients are
/// eliminated, and control points are replaced by the unknowns that they depend on. Values live outside, so that
/// several matrices share one pattern.
class PatchAssembly {
 public:
  /// Over the unknowns of `coordinates`.
  PatchAssembly(const PatchLayout& layout, const Coordinates& coordinates);
  /// Over the control points: one row and column for each.
  explicit PatchAssembly(const PatchLayout& layout);

  int size() const { return static_cast<int>(outer_.size()) - 1; }
  std::size_t nonzeros() const { return inner_.size(); }

  /// `block` is 3 columns x 3 columns, row-major, over the coordinates c * columns + i of the patch's points i; where
  /// c == e only i >= j is read of ((c, i), (e, j)), and of c != e only c > e. `columns` is at least the set's.
  void add(int set, int patch, const double* block, int columns, std::vector<double>& values) const;
  /// `block` is a symmetric matrix over the patch's points, the same for all three coordinates, of which i >= j is
  /// read.
  void add_scalar(int set, int patch, const Eigen::MatrixXd& block, std::vector<double>& values) const;

  /// The lower triangle with these values.
  Eigen::Map<const Eigen::SparseMatrix<double>> lower(const std::vector<double>& values) const;

 private:
  /// A control point that a patch depends on.
  struct Place {
    int orbit = -1;  ///< -1: no unknowns
    int vertex = 0;
  };
  /// Vertices that share the unknowns [first, first + dimension).
  struct Orbit {
    int first, dimension;
    std::vector<int> neighbours;  ///< orbits >= this one, rising
    std::vector<int> rows;        ///< where each neighbour's rows begin, counted from the column's first entry
  };

  void build(const PatchLayout& layout, const std::vector<Coordinates::Block>& blocks);
  std::vector<Place> places(int set, int patch) const;
  /// Adds the 3 x 3 (or 1 x 1) block between two places, both ways.
  template <class Block>
  void scatter(const Place& row, const Place& column, const Block& block, std::vector<double>& values) const;

  const PatchLayout& layout_;
  bool scalar_;
  std::vector<Coordinates::Block> blocks_;  ///< of each vertex
  std::vector<int> orbit_of_;               ///< of each vertex, -1 without unknowns
  std::vector<Orbit> orbits_;
  std::vector<Eigen::MatrixXd> expansions_;  ///< of each set: local points x vertices; empty where they are the same
  std::vector<int> outer_, inner_;
};

}  // namespace umbilic
