// SPDX-License-Identifier: MIT
/// \file
/// Reduces each row by the earlier rows that it meets, in their order, and remembers by how much.
#include "solve/row_elimination.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace umbilic {
namespace {

constexpr double kRounding = 1e-17;             // entries below this, of rows of length 1, are left out
constexpr double kVanishingCoefficient = 1e-9;  // relative to the largest

}  // namespace

/// Pivots that the row meets become pending, the earliest row on top.
void RowElimination::scatter(int unknown, double value) {
  values_[unknown] += value;
  if (touched_[unknown]) return;
  touched_[unknown] = true;
  pattern_.push_back(unknown);
  if (!is_pivot(unknown)) return;
  pending_.push_back(pivot_of_[unknown]);
  std::push_heap(pending_.begin(), pending_.end(), std::greater<>());
}

bool RowElimination::add(const SparseEntries& row) {
  for (const auto& [unknown, value] : row) scatter(unknown, value);
  Row reduced{-1, {}, {}, 0};
  while (!pending_.empty()) {
    std::pop_heap(pending_.begin(), pending_.end(), std::greater<>());
    const int earlier = pending_.back();
    pending_.pop_back();
    const double factor = std::exchange(values_[rows_[earlier].pivot], 0.0);
    if (std::abs(factor) <= kRounding) continue;
    reduced.history.push_back({earlier, factor});
    for (const auto& [unknown, value] : rows_[earlier].others) scatter(unknown, -factor * value);
  }
  double square = 0;
  for (const int unknown : pattern_) {
    square += values_[unknown] * values_[unknown];
    if (reduced.pivot < 0 || std::abs(values_[unknown]) > std::abs(values_[reduced.pivot])) reduced.pivot = unknown;
  }
  const bool independent = std::sqrt(square) > kDependent;
  if (independent) {
    reduced.size = values_[reduced.pivot];
    for (const int unknown : pattern_) {
      const double value = values_[unknown] / reduced.size;
      if (unknown != reduced.pivot && std::abs(value) > kRounding) reduced.others.push_back({unknown, value});
    }
    pivot_of_[reduced.pivot] = rank();
    rows_.push_back(std::move(reduced));
  } else {
    combine(reduced.history);
  }
  for (const int unknown : pattern_) {
    values_[unknown] = 0;
    touched_[unknown] = false;
  }
  pattern_.clear();
  return independent;
}

/// Goes back through the histories: a combination of reduced rows as one of the rows as they were given.
void RowElimination::combine(const SparseEntries& reduced) {
  combination_.clear();
  std::map<int, double, std::greater<>> open;
  for (const auto& [row, factor] : reduced) open[row] = factor;
  double largest = 0;
  while (!open.empty()) {
    const auto [row, factor] = *open.begin();
    open.erase(open.begin());
    const double given = factor / rows_[row].size;
    for (const auto& [earlier, part] : rows_[row].history) open[earlier] -= given * part;
    combination_.push_back({row, given});
    largest = std::max(largest, std::abs(given));
  }
  const auto vanishes = [&](const SparseEntry& entry) {
    return std::abs(entry.value) <= kVanishingCoefficient * largest;
  };
  combination_.erase(std::remove_if(combination_.begin(), combination_.end(), vanishes), combination_.end());
  std::reverse(combination_.begin(), combination_.end());
}

/// A reduced row holds pivots of later rows only, so the last is solved first.
std::vector<SparseEntries> RowElimination::solved() const {
  std::vector<SparseEntries> result(rows_.size());
  std::vector<double> sums(pivot_of_.size(), 0.0);
  std::vector<bool> touched(pivot_of_.size(), false);
  for (int i = rank() - 1; i >= 0; --i) {
    std::vector<int> pattern;
    const auto gather = [&](int unknown, double value) {
      sums[unknown] += value;
      if (!touched[unknown]) pattern.push_back(unknown);
      touched[unknown] = true;
    };
    for (const auto& [unknown, value] : rows_[i].others) {
      if (!is_pivot(unknown)) {
        gather(unknown, -value);
        continue;
      }
      for (const auto& [free, part] : result[pivot_of_[unknown]]) gather(free, -value * part);
    }
    std::sort(pattern.begin(), pattern.end());
    for (const int unknown : pattern) {
      if (std::abs(sums[unknown]) > kRounding) result[i].push_back({unknown, sums[unknown]});
      sums[unknown] = 0;
      touched[unknown] = false;
    }
  }
  return result;
}

}  // namespace umbilic
