// SPDX-License-Identifier: MIT
/// \file
/// Eliminates groups of unknowns symbolically, and merges them into supernodes.
#include "solve/elimination_tree.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <numeric>

namespace umbilic {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Lists = std::vector<std::vector<int>>;

/// Supernodes up to `width` columns may be merged if at most this fraction of the panel is stored zeros.
struct Relaxation {
  int width;
  double zeros;
};
constexpr Relaxation kRelaxations[] = {{4, 0.8}, {16, 0.2}, {32, 0.1}, {1 << 30, 0.02}};

/// For each unknown, the unknown itself and its neighbours; sorted, since rows are sorted in each column.
Lists neighbourhoods(const Matrix& lower) {
  Lists result(lower.cols());
  for (int j = 0; j < lower.cols(); ++j) {
    result[j].push_back(j);
    for (Matrix::InnerIterator it(lower, j); it; ++it) {
      if (it.row() <= j) continue;
      result[j].push_back(static_cast<int>(it.row()));
      result[it.row()].push_back(j);
    }
  }
  return result;
}

/// Consecutive unknowns that have the same neighbours.
struct Groups {
  std::vector<int> first;  ///< first unknown of each group; at the end the number of unknowns
  Lists neighbours;        ///< for each group, its neighbours and itself, sorted

  explicit Groups(const Lists& neighbourhoods) {
    const int unknowns = static_cast<int>(neighbourhoods.size());
    std::vector<int> group_of(unknowns);
    for (int j = 0; j < unknowns; ++j) {
      if (j == 0 || neighbourhoods[j] != neighbourhoods[j - 1]) first.push_back(j);
      group_of[j] = static_cast<int>(first.size()) - 1;
    }
    for (int start : first) {
      std::vector<int>& list = neighbours.emplace_back();
      for (int j : neighbourhoods[start]) {
        if (list.empty() || list.back() != group_of[j]) list.push_back(group_of[j]);
      }
    }
    first.push_back(unknowns);
  }

  int count() const { return static_cast<int>(neighbours.size()); }
  int size(int group) const { return first[group + 1] - first[group]; }
};

/// The groups in an order of approximate minimum degree.
std::vector<int> minimum_degree(const Groups& groups) {
  if (groups.count() == 0) return {};  // Eigen cannot compress an empty matrix
  Matrix graph(groups.count(), groups.count());
  std::vector<int> sizes(groups.count());
  for (int g = 0; g < groups.count(); ++g) sizes[g] = static_cast<int>(groups.neighbours[g].size());
  graph.reserve(sizes);
  for (int g = 0; g < groups.count(); ++g) {
    for (int h : groups.neighbours[g]) graph.insert(h, g) = 1;
  }
  graph.makeCompressed();
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().begin(), order.indices().end()};
}

/// A supernode in terms of groups. Its index is the step at which its last group is eliminated.
struct Node {
  std::vector<int> columns, rows;  ///< each group given by its step
  std::vector<int> children;
  int width = 0, below = 0;  ///< counted in unknowns
  double zeros = 0;          ///< number of zeros stored in its panel
  bool merged = false;       ///< into its parent

  double stored() const { return 0.5 * width * (width + 1.0) + static_cast<double>(width) * below; }
};

/// The number of stored zeros after the child is merged into its parent.
double zeros_together(const Node& parent, const Node& child) {
  Node both;
  both.width = parent.width + child.width;
  both.below = parent.below;
  return parent.zeros + child.zeros + both.stored() - parent.stored() - child.stored();
}

void merge(Node& parent, Node& child) {
  parent.zeros = zeros_together(parent, child);
  child.columns.insert(child.columns.end(), parent.columns.begin(), parent.columns.end());
  parent.columns = std::move(child.columns);
  parent.children.insert(parent.children.end(), child.children.begin(), child.children.end());
  parent.width += child.width;
  child = {};
  child.merged = true;
}

/// Merges each node with its first child that has the same rows, which stores no zeros.
std::vector<Node> eliminate(const Groups& groups, const std::vector<int>& order) {
  const int count = groups.count();
  std::vector<int> step_of(count), seen(count, -1);
  for (int k = 0; k < count; ++k) step_of[order[k]] = k;
  std::vector<Node> nodes(count);
  for (int k = 0; k < count; ++k) {
    Node& node = nodes[k];
    node.columns = {k};
    node.width = groups.size(order[k]);
    const auto see = [&](int step) {
      if (step <= k || seen[step] == k) return;
      seen[step] = k;
      node.rows.push_back(step);
      node.below += groups.size(order[step]);
    };
    for (int g : groups.neighbours[order[k]]) see(step_of[g]);
    for (int child : node.children) {
      for (int step : nodes[child].rows) see(step);
    }
    const auto same = std::find_if(node.children.begin(), node.children.end(),
                                   [&](int child) { return nodes[child].below == node.width + node.below; });
    if (same != node.children.end()) {
      const int child = *same;
      node.children.erase(same);
      merge(node, nodes[child]);
    }
    if (!node.rows.empty()) nodes[*std::min_element(node.rows.begin(), node.rows.end())].children.push_back(k);
  }
  return nodes;
}

bool worthwhile(const Node& parent, const Node& child) {
  Node both;
  both.width = parent.width + child.width;
  both.below = parent.below;
  for (const Relaxation& relaxation : kRelaxations) {
    if (both.width <= relaxation.width) return zeros_together(parent, child) <= relaxation.zeros * both.stored();
  }
  return false;
}

/// Merges more children into their parents, those with the most rows first.
void relax(std::vector<Node>& nodes) {
  for (Node& node : nodes) {
    std::vector<int> candidates;
    std::swap(candidates, node.children);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](int a, int b) { return nodes[a].below > nodes[b].below; });
    for (int child : candidates) {
      if (worthwhile(node, nodes[child])) {
        merge(node, nodes[child]);
      } else {
        node.children.push_back(child);
      }
    }
    std::sort(node.children.begin(), node.children.end());
  }
}

}  // namespace

double Supernode::flops() const {
  const double w = width, h = height();
  return w * h * h - w * w * h + w * w * w / 3;
}

EliminationTree::EliminationTree(const Matrix& lower) : positions_(lower.cols()) {
  const Groups groups(neighbourhoods(lower));
  const std::vector<int> order = minimum_degree(groups);
  std::vector<Node> nodes = eliminate(groups, order);
  relax(nodes);

  std::vector<int> position(nodes.size()), supernode_of(nodes.size());
  int next = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k].merged) continue;
    supernode_of[k] = static_cast<int>(supernodes_.size());
    Supernode& supernode = supernodes_.emplace_back();
    supernode.first = next;
    supernode.width = nodes[k].width;
    for (int step : nodes[k].columns) {
      position[step] = next;
      for (int j = groups.first[order[step]]; j < groups.first[order[step] + 1]; ++j) positions_[j] = next++;
    }
    for (int child : nodes[k].children) supernode.children.push_back(supernode_of[child]);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k].merged) continue;
    Supernode& supernode = supernodes_[supernode_of[k]];
    for (int step : nodes[k].rows) {
      for (int i = 0; i < groups.size(order[step]); ++i) supernode.rows.push_back(position[step] + i);
    }
    std::sort(supernode.rows.begin(), supernode.rows.end());
    supernode.panel = panel_size_;
    panel_size_ += static_cast<std::size_t>(supernode.height()) * supernode.width;
  }
  for (const Supernode& parent : supernodes_) {
    for (int child : parent.children) {
      int place = 0;
      for (int row : supernodes_[child].rows) {
        if (row < parent.first + parent.width) {
          supernodes_[child].in_parent.push_back(row - parent.first);
          continue;
        }
        while (parent.rows[place] != row) ++place;
        supernodes_[child].in_parent.push_back(parent.width + place);
      }
    }
  }
  locate_entries(lower);
}

void EliminationTree::locate_entries(const Matrix& lower) {
  std::vector<int> supernode_of(lower.cols());
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    std::fill_n(supernode_of.begin() + supernodes_[s].first, supernodes_[s].width, static_cast<int>(s));
  }
  entries_.resize(supernodes_.size());
  int source = 0;
  for (int j = 0; j < lower.cols(); ++j) {
    for (Matrix::InnerIterator it(lower, j); it; ++it, ++source) {
      if (it.row() < j) continue;
      const int column = std::min(positions_[it.row()], positions_[j]);
      const int row = std::max(positions_[it.row()], positions_[j]);
      const Supernode& node = supernodes_[supernode_of[column]];
      const int within = row - node.first;
      const auto below = [&] {
        return node.width +
               static_cast<int>(std::lower_bound(node.rows.begin(), node.rows.end(), row) - node.rows.begin());
      };
      entries_[supernode_of[column]].push_back(
          {source, (column - node.first) * node.height() + (within < node.width ? within : below())});
    }
  }
  for (auto& entries : entries_) {
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.target < b.target; });
  }
}

}  // namespace umbilic
