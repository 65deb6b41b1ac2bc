// SPDX-License-Identifier: MIT
/// \file
/// Builds the pattern from the orbits that meet in a patch, and scatters blocks into it.
#include "optimize/patch_assembly.h"

#include <algorithm>
#include <map>

namespace umbilic {
namespace {

using Block3 = Eigen::Matrix3d;

/// The control points that decide the cap, rotated to a sector.
template <class Visit>
void for_each_net_vertex(const Cap& cap, int sector, const Visit& visit) {
  const int size = static_cast<int>(cap.net.size());
  for (int i = 0; i < size; ++i) {
    const int vertex = cap.net[i == 0 ? 0 : 1 + (i - 1 + 12 * sector) % (size - 1)];
    if (vertex >= 0) visit(i, vertex);
  }
}

/// Local points of a kind as combinations of the net's vertices within the cap's control rings.
Eigen::MatrixXd expansion(const PatchSet& set, const Cap& cap) {
  const Eigen::MatrixXd& fit = cap_sector(set.kind.valence, set.kind.shape).fit();
  const PatchColumns columns = patch_columns(set.kind);
  std::vector<int> column_of(cap.net.size(), -1);
  int count = 0;
  for_each_net_vertex(cap, 0, [&](int i, int) { column_of[i] = count++; });
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(columns.count(), count);
  int row = 0;
  for (const int i : columns.net) result(row++, column_of[i]) = 1;
  for (int k = 0; k < columns.coefficients; ++k, ++row) {
    for (int i = 0; i < fit.cols(); ++i) {
      if (column_of[i] >= 0) result(row, column_of[i]) = fit(k, i);
    }
  }
  return result;
}

}  // namespace

PatchAssembly::PatchAssembly(const PatchLayout& layout, const Coordinates& coordinates)
    : layout_(layout), scalar_(false) {
  std::vector<Coordinates::Block> blocks(layout.control_count());
  for (int v = 0; v < layout.control_count(); ++v) blocks[v] = coordinates.block(v);
  build(layout, blocks);
}

PatchAssembly::PatchAssembly(const PatchLayout& layout) : layout_(layout), scalar_(true) {
  std::vector<Coordinates::Block> blocks(layout.control_count());
  for (int v = 0; v < layout.control_count(); ++v) {
    blocks[v].first = v;
    blocks[v].dimension = 1;
  }
  build(layout, blocks);
}

void PatchAssembly::build(const PatchLayout& layout, const std::vector<Coordinates::Block>& blocks) {
  blocks_ = blocks;
  std::map<int, int> first_of;  // first unknown -> dimension
  for (const auto& block : blocks) {
    if (block.dimension > 0) first_of.emplace(block.first, block.dimension);
  }
  std::map<int, int> orbit_at;
  for (const auto& [first, dimension] : first_of) {
    orbit_at[first] = static_cast<int>(orbits_.size());
    orbits_.push_back({first, dimension, {}, {}});
  }
  orbit_of_.assign(blocks.size(), -1);
  for (std::size_t v = 0; v < blocks.size(); ++v) {
    if (blocks[v].dimension > 0) orbit_of_[v] = orbit_at[blocks[v].first];
  }

  for (std::size_t set = 0; set < layout.sets().size(); ++set) {
    const PatchSet& patches = layout.sets()[set];
    const bool eliminates = coefficient_count(patches.kind.shape) > 0;
    expansions_.push_back(eliminates ? expansion(patches, layout.caps()[patches.caps.front()]) : Eigen::MatrixXd());
    for (int p = 0; p < patches.count(); ++p) {
      std::vector<int> met;
      for (const Place& place : places(static_cast<int>(set), p)) {
        if (place.orbit >= 0) met.push_back(place.orbit);
      }
      std::sort(met.begin(), met.end());
      met.erase(std::unique(met.begin(), met.end()), met.end());
      for (std::size_t i = 0; i < met.size(); ++i) {
        auto& neighbours = orbits_[met[i]].neighbours;
        neighbours.insert(neighbours.end(), met.begin() + i, met.end());
        if (neighbours.size() > 4096) {
          std::sort(neighbours.begin(), neighbours.end());
          neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        }
      }
    }
  }

  outer_.push_back(0);
  for (std::size_t o = 0; o < orbits_.size(); ++o) {
    Orbit& orbit = orbits_[o];
    auto& neighbours = orbit.neighbours;
    neighbours.push_back(static_cast<int>(o));
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
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
}

std::vector<PatchAssembly::Place> PatchAssembly::places(int set, int patch) const {
  const PatchSet& patches = layout_.sets()[set];
  const int* points = &patches.points[static_cast<std::size_t>(patches.columns) * patch];
  std::vector<Place> result;
  if (expansions_[set].size() == 0) {
    for (int i = 0; i < patches.columns; ++i) result.push_back({orbit_of_[points[i]], points[i]});
    return result;
  }
  const Cap& cap = layout_.caps()[patches.caps[patch]];
  const int coefficients = coefficient_count(cap.shape);
  const int sector = (points[patches.columns - 1] - cap.first_coefficient) / coefficients;
  for_each_net_vertex(cap, sector, [&](int, int vertex) { result.push_back({orbit_of_[vertex], vertex}); });
  return result;
}

template <class Block>
void PatchAssembly::scatter(const Place& row, const Place& column, const Block& block,
                            std::vector<double>& values) const {
  if (row.orbit < 0 || column.orbit < 0) return;
  const bool turn = row.orbit < column.orbit;
  const Place &low = turn ? column : row, &high = turn ? row : column;
  const Orbit& orbit = orbits_[high.orbit];
  const int height = orbits_[low.orbit].dimension, width = orbit.dimension;
  const auto at = std::lower_bound(orbit.neighbours.begin(), orbit.neighbours.end(), low.orbit);
  const int first_row = orbit.rows[at - orbit.neighbours.begin()];
  const bool diagonal = low.orbit == high.orbit, twice = diagonal && row.vertex != column.vertex;
  for (int k = 0; k < width; ++k) {
    // Column k of the lower triangle lacks its first k entries.
    double* column_values = values.data() + outer_[orbit.first + k] + first_row - k;
    for (int i = diagonal ? k : 0; i < height; ++i) {
      column_values[i] += turn ? block(k, i) : block(i, k);
      if (twice) column_values[i] += block(k, i);
    }
  }
}

void PatchAssembly::add(int set, int patch, const double* block, int columns, std::vector<double>& values) const {
  const std::vector<Place> where = places(set, patch);
  const double multiplicity = layout_.sets()[set].multiplicities[patch];
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(3) * columns;
  const Eigen::MatrixXd& expand = expansions_[set];
  const auto scatter_pairs = [&](const auto& entry) {
    const int count = static_cast<int>(where.size());
    for (int i = 0; i < count; ++i) {
      if (where[i].orbit < 0) continue;
      const Coordinates::Block& rows = blocks_[where[i].vertex];
      for (int j = 0; j <= i; ++j) {
        if (where[j].orbit < 0) continue;
        Block3 full;
        for (int c = 0; c < 3; ++c) {
          for (int e = 0; e < 3; ++e) full(c, e) = c >= e ? entry(c, i, e, j) : entry(e, j, c, i);
        }
        const Coordinates::Block& other = blocks_[where[j].vertex];
        // A place met twice with i != j contributes both ways also to one vertex.
        const auto reduced = (multiplicity * rows.basis.transpose() * full * other.basis).eval();
        if (i != j && where[i].vertex == where[j].vertex) {
          scatter(where[i], where[j], (reduced + reduced.transpose()).eval(), values);
        } else {
          scatter(where[i], where[j], reduced, values);
        }
      }
    }
  };
  if (expand.size() == 0) {
    scatter_pairs([&](int c, int i, int e, int j) { return block[(c * columns + i) * stride + e * columns + j]; });
    return;
  }
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd expanded[3][3];
  const Eigen::Index local = expand.rows();
  for (int c = 0; c < 3; ++c) {
    for (int e = 0; e <= c; ++e) {
      Eigen::MatrixXd part = Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>(
          block + c * columns * stride + e * columns, local, local, Eigen::OuterStride<>(stride));
      if (c == e) part = Eigen::MatrixXd(part.selfadjointView<Eigen::Lower>());
      expanded[c][e] = expand.transpose() * part * expand;
    }
  }
  scatter_pairs([&](int c, int i, int e, int j) { return expanded[c][e](i, j); });
}

void PatchAssembly::add_scalar(int set, int patch, const Eigen::MatrixXd& block, std::vector<double>& values) const {
  const std::vector<Place> where = places(set, patch);
  const double multiplicity = layout_.sets()[set].multiplicities[patch];
  const Eigen::MatrixXd& expand = expansions_[set];
  Eigen::MatrixXd expanded;
  if (expand.size() > 0) {
    expanded = expand.transpose() * Eigen::MatrixXd(block.selfadjointView<Eigen::Lower>()) * expand;
  }
  const Eigen::MatrixXd& entries = expand.size() > 0 ? expanded : block;
  for (int i = 0; i < static_cast<int>(where.size()); ++i) {
    for (int j = 0; j <= i; ++j) {
      if (where[i].orbit < 0 || where[j].orbit < 0) continue;
      const double twice = i != j && where[i].vertex == where[j].vertex ? 2 : 1;
      const double entry = twice * multiplicity * entries(i, j);
      if (scalar_) {
        scatter(where[i], where[j], Eigen::Matrix<double, 1, 1>(entry), values);
      } else {
        const auto& rows = blocks_[where[i].vertex].basis;
        scatter(where[i], where[j], (entry * rows.transpose() * blocks_[where[j].vertex].basis).eval(), values);
      }
    }
  }
}

Eigen::Map<const Eigen::SparseMatrix<double>> PatchAssembly::lower(const std::vector<double>& values) const {
  return {size(), size(), static_cast<Eigen::Index>(inner_.size()), outer_.data(), inner_.data(), values.data()};
}

}  // namespace umbilic
