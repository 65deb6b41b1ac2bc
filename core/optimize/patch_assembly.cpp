// SPDX-License-Identifier: MIT
/// \file
/// Builds the pattern from the orbits that occur together in a patch or a cap, and adds blocks to it.
///
/// H_pp, H_pq and H_qq are the blocks of a patch's matrix between its control points p and the coefficients c of its
/// sector. c = T q, with q the cap's coefficients in sector 0, and q = F y, a linear function of the unknowns y. So the
/// patch contributes H_pp + H_pq T F + (H_pq T F)^T + F^T T^T H_qq T F. H_pp is added at once; H_pq T and T^T H_qq T
/// are summed per cap until `eliminate`.
#include "optimize/patch_assembly.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace umbilic {
namespace {

/// A patch's matrix as the caller passes it; only half of it is read.
struct FullBlock {
  static constexpr bool kSameForAllCoordinates = false;
  const double* entries;
  int columns;

  double operator()(int c, int i, int e, int j) const {
    const bool lower = c > e || (c == e && i >= j);
    const std::ptrdiff_t row = lower ? c * columns + i : e * columns + j,
                         column = lower ? e * columns + j : c * columns + i;
    return entries[row * 3 * columns + column];
  }
};

struct ScalarBlock {
  static constexpr bool kSameForAllCoordinates = true;
  const Eigen::MatrixXd& entries;

  double operator()(int c, int i, int e, int j) const { return c != e ? 0 : i >= j ? entries(i, j) : entries(j, i); }
};

void sort_unique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The index of a value in a sorted list.
int index_in(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

/// Replaces `values` by turn^T values. A turn mixes only monomials of the same degree.
void turn_rows(const Eigen::MatrixXd& turn, Eigen::MatrixXd& values) {
  Eigen::MatrixXd before;
  for (Eigen::Index first = 0, size = 1; first < turn.rows(); first += size, ++size) {
    before = values.middleRows(first, size);
    values.middleRows(first, size) = turn.block(first, first, size, size).transpose().lazyProduct(before);
  }
}

/// Number of a patch's points that are control points; they come first.
int net_count(const PatchSet& patches) { return patches.columns - coefficient_count(patches.kind.shape); }

}  // namespace

PatchAssembly::PatchAssembly(const PatchLayout& layout, const Coordinates& coordinates, bool scalar)
    : layout_(layout), scalar_(scalar) {
  assert(!scalar || coordinates.cartesian());
  std::vector<Coordinates::Block> blocks(layout.control_count());
  for (int v = 0; v < layout.control_count(); ++v) {
    Coordinates::Block block = coordinates.block(v);
    if (scalar && block.dimension > 0) block = {block.first / 3, 1, Vector3::UnitX()};
    blocks[v] = std::move(block);
  }
  build(std::move(blocks));
}

void PatchAssembly::build(std::vector<Coordinates::Block> blocks) {
  blocks_ = std::move(blocks);
  std::map<int, int> first_of;  // first unknown -> dimension
  for (const auto& block : blocks_) {
    if (block.dimension > 0) first_of.emplace(block.first, block.dimension);
  }
  std::map<int, int> orbit_at;
  for (const auto& [first, dimension] : first_of) {
    orbit_at[first] = static_cast<int>(orbits_.size());
    orbits_.push_back({first, dimension, {}, {}});
  }
  orbit_of_.assign(blocks_.size(), -1);
  for (std::size_t v = 0; v < blocks_.size(); ++v) {
    if (blocks_[v].dimension > 0) orbit_of_[v] = orbit_at[blocks_[v].first];
  }
  build_eliminations();
  build_pattern();
}

void PatchAssembly::build_eliminations() {
  for (const Cap& cap : layout_.caps()) {
    eliminations_.emplace_back();
    const int count = coefficient_count(cap.shape);
    if (count == 0) continue;
    Elimination& here = eliminations_.back();
    const CapSector& sector = sector_of(cap);
    for (const int vertex : cap.net) {
      if (vertex < 0) continue;
      const Coordinates::Block& block = blocks_[vertex];
      for (int k = 0; k < block.dimension; ++k) here.unknowns.push_back(block.first + k);
    }
    sort_unique(here.unknowns);
    here.fitted.assign(here.unknowns.size(), false);
    const Eigen::MatrixXd& fit = sector.fit();
    here.fit.setZero(static_cast<Eigen::Index>(coordinates()) * count, static_cast<Eigen::Index>(here.unknowns.size()));
    for (const int i : sector.fit_support()) {
      const Coordinates::Block& block = blocks_[cap.net[i]];
      for (int k = 0; k < block.dimension; ++k) {
        const int unknown = index_in(here.unknowns, block.first) + k;
        here.fitted[unknown] = true;
        auto column = here.fit.col(unknown);
        for (int c = 0; c < coordinates(); ++c) column.segment(c * count, count) += block.basis(c, k) * fit.col(i);
      }
    }
  }
}

/// The orbits with unknowns to which the vertices belong, sorted.
std::vector<int> PatchAssembly::orbits_at(const int* vertices, std::size_t count) const {
  std::vector<int> met;
  for (std::size_t i = 0; i < count; ++i) {
    if (vertices[i] >= 0 && orbit_of_[vertices[i]] >= 0) met.push_back(orbit_of_[vertices[i]]);
  }
  sort_unique(met);
  return met;
}

/// Notes that each orbit of `some` has entries with each orbit of `others`.
void PatchAssembly::add_neighbours(const std::vector<int>& some, const std::vector<int>& others) {
  for (const int orbit : some) {
    auto& neighbours = orbits_[orbit].neighbours;
    neighbours.insert(neighbours.end(), std::lower_bound(others.begin(), others.end(), orbit), others.end());
    if (neighbours.size() > 4096) sort_unique(neighbours);
  }
}

void PatchAssembly::build_pattern() {
  for (const PatchSet& patches : layout_.sets()) {
    for (int p = 0; p < patches.count(); ++p) {
      const std::vector<int> met = orbits_at(patches.points_of(p), static_cast<std::size_t>(net_count(patches)));
      add_neighbours(met, met);
    }
  }
  for (const Cap& cap : layout_.caps()) {
    std::vector<int> fitted;
    for (const int i : sector_of(cap).fit_support()) fitted.push_back(cap.net[i]);
    const std::vector<int> deciding = orbits_at(fitted.data(), fitted.size());
    if (deciding.empty()) continue;
    const std::vector<int> all = orbits_at(cap.net.data(), cap.net.size());
    add_neighbours(deciding, all);
    add_neighbours(all, deciding);
  }

  outer_.push_back(0);
  for (std::size_t o = 0; o < orbits_.size(); ++o) {
    Orbit& orbit = orbits_[o];
    auto& neighbours = orbit.neighbours;
    neighbours.push_back(static_cast<int>(o));
    sort_unique(neighbours);
    neighbours.shrink_to_fit();
    int rows = 0;
    for (const int n : neighbours) {
      orbit.rows.push_back(rows);
      rows += orbits_[n].dimension;
    }
    for (int i = 0; i < orbit.dimension; ++i) {
      for (const int n : neighbours) {
        const Orbit& other = orbits_[n];
        for (int k = 0; k < other.dimension; ++k) {
          if (other.first + k >= orbit.first + i) inner_.push_back(other.first + k);
        }
      }
      outer_.push_back(static_cast<int>(inner_.size()));
    }
  }
  find_rows();
}

/// Visits pairs in the same order as `add_block`.
void PatchAssembly::find_rows() {
  for (const PatchSet& patches : layout_.sets()) {
    std::vector<int>& rows = rows_.emplace_back();
    const int count = net_count(patches);
    rows.reserve(static_cast<std::size_t>(patches.count()) * count * (count + 1) / 2);
    for (int p = 0; p < patches.count(); ++p) {
      const int* points = patches.points_of(p);
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j <= i; ++j) {
          const int low = std::max(orbit_of_[points[i]], orbit_of_[points[j]]);
          const int high = std::min(orbit_of_[points[i]], orbit_of_[points[j]]);
          rows.push_back(high < 0 ? -1 : orbits_[high].rows[index_in(orbits_[high].neighbours, low)]);
        }
      }
    }
  }
}

void PatchAssembly::clear(PatchSums& sums) const {
  sums.values.assign(nonzeros(), 0.0);
  sums.caps.resize(eliminations_.size());
  for (std::size_t c = 0; c < eliminations_.size(); ++c) {
    const Eigen::MatrixXd& fit = eliminations_[c].fit;
    sums.caps[c].mixed.setZero(fit.rows(), fit.cols());
    sums.caps[c].own.setZero(fit.rows(), fit.rows());
  }
}

void PatchAssembly::scatter(int row, int column, int first_row, bool one_place, const Eigen::Matrix3d& block,
                            std::vector<double>& values) const {
  const bool turn = row < column;
  const int low = turn ? column : row, high = turn ? row : column;
  const Orbit& orbit = orbits_[high];
  const int height = orbits_[low].dimension;
  for (int k = 0; k < orbit.dimension; ++k) {
    // Column k of the lower triangle has no entries above row k.
    double* to = values.data() + outer_[orbit.first + k] + first_row - k;
    if (low != high) {
      for (int i = 0; i < height; ++i) to[i] += turn ? block(k, i) : block(i, k);
    } else {
      for (int i = k; i < height; ++i) to[i] += one_place ? block(i, k) : block(i, k) + block(k, i);
    }
  }
}

template <class Block>
void PatchAssembly::terms_of(int set, int patch, const Block& block, PatchTerms& terms) const {
  const PatchSet& patches = layout_.sets()[set];
  const int* points = patches.points_of(patch);
  const double multiplicity = patches.multiplicities[patch];
  const int count = net_count(patches);
  terms.pairs.resize(static_cast<std::size_t>(count) * (count + 1) / 2);
  Eigen::Matrix3d* pair = terms.pairs.data();
  for (int i = 0; i < count; ++i) {
    const Coordinates::Block& left = blocks_[points[i]];
    for (int j = 0; j <= i; ++j, ++pair) {
      const Coordinates::Block& right = blocks_[points[j]];
      Eigen::Matrix3d half;  // entries right.basis; the pair is left.basis^T entries right.basis
      for (int c = 0; c < coordinates(); ++c) {
        for (int k = 0; k < right.dimension; ++k) {
          double sum = 0;
          if constexpr (Block::kSameForAllCoordinates) {
            sum = block(c, i, c, j) * right.basis(c, k);
          } else {
            for (int e = 0; e < 3; ++e) sum += block(c, i, e, j) * right.basis(e, k);
          }
          half(c, k) = multiplicity * sum;
        }
      }
      for (int k = 0; k < right.dimension; ++k) {
        for (int l = 0; l < left.dimension; ++l) {
          double sum = 0;
          for (int c = 0; c < coordinates(); ++c) sum += left.basis(c, l) * half(c, k);
          (*pair)(l, k) = sum;
        }
      }
    }
  }
  if (coefficient_count(patches.kind.shape) > 0) coefficient_terms(set, patch, block, terms);
}

template <class Block>
void PatchAssembly::coefficient_terms(int set, int patch, const Block& block, PatchTerms& terms) const {
  const PatchSet& patches = layout_.sets()[set];
  const int* points = patches.points_of(patch);
  const Cap& cap = layout_.caps()[patches.caps[patch]];
  const int count = coefficient_count(cap.shape), net = net_count(patches);
  const int sector = (points[net] - cap.first_coefficient) / count;
  const Eigen::MatrixXd& turn = sector_of(cap).turn(sector);
  const double multiplicity = patches.multiplicities[patch];
  Eigen::MatrixXd part(count, count), mixed(count, net);
  terms.own.setZero(coordinates() * count, coordinates() * count);
  for (int c = 0; c < coordinates(); ++c) {
    for (int e = 0; e < coordinates(); ++e) {
      if (Block::kSameForAllCoordinates && c != e) continue;
      if (!Block::kSameForAllCoordinates || c == 0) {
        for (int i = 0; i < count; ++i) {
          for (int k = 0; k < count; ++k) part(k, i) = multiplicity * block(c, net + k, e, net + i);
        }
        for (int i = 0; i < net; ++i) {
          for (int k = 0; k < count; ++k) mixed(k, i) = multiplicity * block(c, net + k, e, i);
        }
        if (sector > 0) {
          turn_rows(turn, part);
          part.transposeInPlace();
          turn_rows(turn, part);
          part.transposeInPlace();
          turn_rows(turn, mixed);
        }
      }
      terms.own.block(c * count, e * count, count, count) = part;
      terms.mixed[3 * c + e] = mixed;
    }
  }
}

void PatchAssembly::terms(int set, int patch, const double* block, int columns, PatchTerms& terms) const {
  terms_of(set, patch, FullBlock{block, columns}, terms);
}

void PatchAssembly::scalar_terms(int set, int patch, const Eigen::MatrixXd& block, PatchTerms& terms) const {
  terms_of(set, patch, ScalarBlock{block}, terms);
}

void PatchAssembly::add(int set, int patch, const PatchTerms& terms, PatchSums& sums) const {
  const PatchSet& patches = layout_.sets()[set];
  const int* points = patches.points_of(patch);
  const int count = net_count(patches);
  const int* first_row = &rows_[set][static_cast<std::size_t>(patch) * terms.pairs.size()];
  const Eigen::Matrix3d* pair = terms.pairs.data();
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j <= i; ++j, ++first_row, ++pair) {
      if (*first_row < 0) continue;
      scatter(orbit_of_[points[i]], orbit_of_[points[j]], *first_row, i == j, *pair, sums.values);
    }
  }
  if (coefficient_count(patches.kind.shape) > 0) add_coefficients(set, patch, terms, sums);
}

void PatchAssembly::add_coefficients(int set, int patch, const PatchTerms& terms, PatchSums& sums) const {
  const PatchSet& patches = layout_.sets()[set];
  const int* points = patches.points_of(patch);
  const Elimination& elimination = eliminations_[patches.caps[patch]];
  PatchSums::CapSums& waiting = sums.caps[patches.caps[patch]];
  const int count = coefficient_count(patches.kind.shape);
  waiting.own += terms.own;
  std::vector<int> first(net_count(patches));  // of each control point's unknowns among those of the cap's net
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = index_in(elimination.unknowns, blocks_[points[i]].first);
  for (int c = 0; c < coordinates(); ++c) {
    for (int e = 0; e < coordinates(); ++e) {
      const Eigen::MatrixXd& mixed = terms.mixed[3 * c + e];
      for (Eigen::Index i = 0; i < mixed.cols(); ++i) {
        const Coordinates::Block& unknowns = blocks_[points[i]];
        for (int k = 0; k < unknowns.dimension; ++k) {
          waiting.mixed.col(first[i] + k).segment(c * count, count) += unknowns.basis(e, k) * mixed.col(i);
        }
      }
    }
  }
}

void PatchAssembly::eliminate(PatchSums& sums) const {
  for (std::size_t c = 0; c < eliminations_.size(); ++c) {
    const auto& [unknowns, fitted, fit] = eliminations_[c];
    PatchSums::CapSums& waiting = sums.caps[c];
    const Eigen::MatrixXd half = fit.transpose() * (waiting.mixed + 0.5 * waiting.own * fit);
    for (std::size_t j = 0; j < unknowns.size(); ++j) {
      int at = outer_[unknowns[j]];
      for (std::size_t i = j; i < unknowns.size(); ++i) {
        if (!fitted[i] && !fitted[j]) continue;
        while (inner_[at] != unknowns[i]) ++at;
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        sums.values[at] += half(row, column) + half(column, row);
      }
    }
    waiting.mixed.setZero();
    waiting.own.setZero();
  }
}

Eigen::Map<const Eigen::SparseMatrix<double>> PatchAssembly::lower(const std::vector<double>& values) const {
  return {size(), size(), static_cast<Eigen::Index>(inner_.size()), outer_.data(), inner_.data(), values.data()};
}

}  // namespace umbilic
