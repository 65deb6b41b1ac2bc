// SPDX-License-Identifier: MIT
/// \file
/// Lists the elements of a group, and generates the subgroup of some of them.
#include "mesh/subgroup.h"

#include <cassert>
#include <map>
#include <utility>
#include <vector>

#include "mesh/components.h"
#include "mesh/flag_matching.h"
#include "mesh/schoenflies.h"

namespace umbilic {
namespace {

Symmetry product(const Symmetry& second, const Symmetry& first) {
  Symmetry result{second.isometry * first.isometry, {second.map.reverses != first.map.reverses, {}}};
  result.map.halfedges.reserve(first.map.halfedges.size());
  for (const int h : first.map.halfedges) result.map.halfedges.push_back(second.map.halfedges[h]);
  return result;
}

/// Names elements by where they map one half-edge of each component, which determines them.
class ElementNames {
 public:
  explicit ElementNames(const PolygonMesh& mesh) {
    const std::vector<int> component = find_components(mesh).of_vertex;
    for (int h = 0; h < mesh.halfedge_count(); ++h) {
      if (component[mesh.origin(h)] == static_cast<int>(seeds_.size())) seeds_.push_back(h);
    }
  }

  std::vector<int> operator()(const Symmetry& element) const {
    std::vector<int> name;
    for (const int h : seeds_) name.push_back(image_of_flag(element.map, {h, false}).index());
    return name;
  }

 private:
  std::vector<int> seeds_;
};

/// The elements that `generators` generate, with their names; the identity first.
struct Listed {
  std::vector<Symmetry> elements;
  std::map<std::vector<int>, std::size_t> index;

  Listed(const std::vector<Symmetry>& generators, const ElementNames& name, const PolygonMesh& mesh) {
    Symmetry identity{Eigen::Matrix3d::Identity(), {false, std::vector<int>(mesh.halfedge_count())}};
    for (int h = 0; h < mesh.halfedge_count(); ++h) identity.map.halfedges[h] = h;
    index.emplace(name(identity), 0);
    elements.push_back(std::move(identity));
    for (std::size_t i = 0; i < elements.size(); ++i) {
      for (const Symmetry& generator : generators) {
        Symmetry next = product(generator, elements[i]);
        if (index.emplace(name(next), elements.size()).second) elements.push_back(std::move(next));
      }
    }
  }
};

bool too_many(const SymmetryGroup& group, const PolygonMesh& mesh) {
  return static_cast<double>(group.order) * mesh.halfedge_count() > kMostListedHalfedges;
}

}  // namespace

std::vector<Symmetry> elements_of(const SymmetryGroup& group, const PolygonMesh& mesh) {
  if (too_many(group, mesh)) return {};
  return Listed(group.generators, ElementNames(mesh), mesh).elements;
}

SymmetryGroup subgroup(const SymmetryGroup& group, const PolygonMesh& mesh,
                       const std::function<bool(const Symmetry&)>& keeps) {
  SymmetryGroup result;
  result.center = group.center;
  result.complete = group.complete;
  if (group.generators.empty()) return result;
  if (too_many(group, mesh)) {
    result.complete = false;
    return result;
  }
  const ElementNames name(mesh);
  const Listed all(group.generators, name, mesh);
  std::vector<const Symmetry*> kept;
  for (const Symmetry& element : all.elements) {
    if (keeps(element)) kept.push_back(&element);
  }
  if (static_cast<int>(kept.size()) == group.order) return group;
  std::vector<Symmetry> generators;
  Listed generated(generators, name, mesh);
  for (const Symmetry* element : kept) {
    if (generated.index.count(name(*element)) > 0) continue;
    generators.push_back(*element);
    generated = Listed(generators, name, mesh);
  }
  assert(generated.elements.size() == kept.size());
  std::vector<Eigen::Matrix3d> isometries;
  for (const Symmetry& element : generated.elements) isometries.push_back(element.isometry);
  result.generators = std::move(generators);
  result.order = static_cast<int>(isometries.size());
  result.name = schoenflies_symbol(isometries);
  return result;
}

}  // namespace umbilic
