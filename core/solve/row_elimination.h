// SPDX-License-Identifier: MIT
/// \file
/// Gauss' elimination of sparse rows, one after another: which of them depend on those before, and how.
#pragma once

#include <vector>

namespace umbilic {

/// An entry of a sparse row, or of a sparse combination of rows.
struct SparseEntry {
  int index;
  double value;
};
using SparseEntries = std::vector<SparseEntry>;

/// A row is reduced by the rows before it, and the largest entry of what is left becomes its pivot. If no more than
/// kDependent is left of a row of length 1, it counts as a combination of the rows before it.
///
/// Rows that share no unknowns are never combined, so that the work for many rows of few unknowns each is linear.
class RowElimination {
 public:
  /// Rows whose angle is smaller than this are not told apart. Independent rows can then be solved for by the matrix of
  /// their products, whose condition is the square.
  static constexpr double kDependent = 1e-6;

  explicit RowElimination(int unknowns) : pivot_of_(unknowns, -1), values_(unknowns, 0.0), touched_(unknowns, false) {}

  /// Adds a row of length 1, or of less if nothing but rounding is left of it. Returns whether it is independent of
  /// those that were added before.
  bool add(const SparseEntries& row);

  /// After `add` returned false: the row as a combination of independent ones, which are numbered in the order in which
  /// they were added. There is one such combination. What is 1e-9 of the largest coefficient is left out as rounding.
  const SparseEntries& combination() const { return combination_; }

  int rank() const { return static_cast<int>(rows_.size()); }
  /// The unknown that the independent row is solved for.
  int pivot(int row) const { return rows_[row].pivot; }
  bool is_pivot(int unknown) const { return pivot_of_[unknown] >= 0; }

  /// The solutions x of all rows with right sides 0: of each independent row i, x_pivot(i) as a combination of
  /// unknowns that are no pivots.
  std::vector<SparseEntries> solved() const;

 private:
  struct Row {
    int pivot;
    SparseEntries others;   // the reduced row is x_pivot + others
    SparseEntries history;  // how much of which reduced rows was subtracted from the row as it was given
    double size;            // what the reduced row was divided by
  };

  void scatter(int unknown, double value);
  void combine(const SparseEntries& reduced);

  std::vector<Row> rows_;
  std::vector<int> pivot_of_;  // unknown -> the row with this pivot, or -1
  SparseEntries combination_;
  // The row that is reduced; all zero between calls.
  std::vector<double> values_;
  std::vector<bool> touched_;
  std::vector<int> pattern_, pending_;
};

}  // namespace umbilic
