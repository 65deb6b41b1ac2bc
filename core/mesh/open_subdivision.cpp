// SPDX-License-Identifier: MIT
/// \file
/// Numbers what remains, then applies the rules to it.
#include "mesh/open_subdivision.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/boundary.h"
#include "mesh/ghosts.h"

namespace umbilic {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

class OpenStep {
 public:
  explicit OpenStep(const PolygonMesh& mesh)
      : mesh_(mesh),
        bare_(bare_vertices(mesh)),
        of_vertex_(mesh.vertex_count(), -1),
        of_edge_(mesh.edge_count(), -1),
        of_face_(mesh.face_count(), -1) {
    number_surface();
    add_ghosts();
    if (!bare_.empty()) add_new_ghosts();
  }

  PolygonMesh mesh() const { return PolygonMesh::of_quads(count_, quads_, mesh_.surface_halfedge_count()); }

  SparseMatrix stencil() const {
    Triplets entries;
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (of_vertex_[v] >= 0) add_vertex_point(v, entries);
    }
    for (int h = 0; h < mesh_.halfedge_count(); ++h) {
      if (of_edge_[mesh_.edge(h)] >= 0 && h < mesh_.twin(h)) add_edge_point(h, entries);
    }
    for (int f = 0; f < mesh_.face_count(); ++f) {
      if (of_face_[f] >= 0) add_face_point(f, 1, of_face_[f], entries);
    }
    SparseMatrix stencil(count_, mesh_.vertex_count());
    stencil.setFromTriplets(entries.begin(), entries.end());
    if (new_ghosts_.count == 0) return stencil;
    SparseMatrix ghosts(count_, count_);
    Triplets ghost_entries = new_ghosts_.stencil;
    for (int v = 0; v < count_ - new_ghosts_.count; ++v) ghost_entries.emplace_back(v, v, 1);
    ghosts.setFromTriplets(ghost_entries.begin(), ghost_entries.end());
    return ghosts * stencil;
  }

 private:
  bool bare(int v) const { return !bare_.empty() && bare_[v]; }
  std::array<int, 4> quad(int h) const {
    return {of_vertex_[mesh_.origin(h)], of_edge_[mesh_.edge(h)], of_face_[mesh_.face(h)],
            of_edge_[mesh_.edge(mesh_.previous(h))]};
  }

  void number_surface() {
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (mesh_.on_surface(v)) of_vertex_[v] = count_++;
    }
    for (int h = 0; h < mesh_.surface_halfedge_count(); ++h) of_edge_[mesh_.edge(h)] = 0;
    for (int& number : of_edge_) {
      if (number == 0) number = count_++;
    }
    for (int f = 0; f < mesh_.surface_face_count(); ++f) of_face_[f] = count_++;
    for (int h = 0; h < mesh_.surface_halfedge_count(); ++h) quads_.push_back(quad(h));
  }

  /// The new faces of ghosts at boundaries with ghosts.
  void add_ghosts() {
    std::vector<int> kept;
    for (int h = mesh_.surface_halfedge_count(); h < mesh_.halfedge_count(); ++h) {
      const int v = mesh_.origin(h);
      if (mesh_.role(mesh_.face(h)) == FaceRole::kGhost && mesh_.on_surface(v) && !bare(v)) kept.push_back(h);
    }
    constexpr int kWanted = -2;
    for (const int h : kept) {
      for (int* number :
           {&of_edge_[mesh_.edge(h)], &of_edge_[mesh_.edge(mesh_.previous(h))], &of_face_[mesh_.face(h)]}) {
        if (*number < 0) *number = kWanted;
      }
    }
    for (std::vector<int>* numbers : {&of_edge_, &of_face_}) {
      for (int& number : *numbers) {
        if (number == kWanted) number = count_++;
      }
    }
    for (const int h : kept) quads_.push_back(quad(h));
  }

  void add_new_ghosts() {
    const PolygonMesh surface = mesh();
    std::vector<bool> wanted(count_, false);
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (bare(v)) wanted[of_vertex_[v]] = true;
    }
    for (int h = 0; h < mesh_.surface_halfedge_count(); ++h) {
      if (mesh_.is_boundary(h) && bare(mesh_.origin(h))) wanted[of_edge_[mesh_.edge(h)]] = true;
    }
    new_ghosts_ = make_ghosts(surface, wanted, count_);
    quads_.insert(quads_.end(), new_ghosts_.quads.begin(), new_ghosts_.quads.end());
    count_ += new_ghosts_.count;
  }

  void add_face_point(int f, double weight, int row, Triplets& entries) const {
    const int size = mesh_.face_size(f);
    for (int i = 0; i < size; ++i) entries.emplace_back(row, mesh_.origin(mesh_.halfedge(f, i)), weight / size);
  }

  void add_edge_point(int h, Triplets& entries) const {
    const int t = mesh_.twin(h), row = of_edge_[mesh_.edge(h)];
    const bool boundary = mesh_.is_boundary(h) || mesh_.is_boundary(t);
    const bool midpoint = boundary && bare(mesh_.origin(h));
    for (const int side : {h, t}) {
      entries.emplace_back(row, mesh_.origin(side), midpoint ? 0.5 : 0.25);
      if (!midpoint) add_face_point(mesh_.face(side), 0.25, row, entries);
    }
  }

  void add_vertex_point(int v, Triplets& entries) const {
    const int row = of_vertex_[v];
    if (bare(v)) {
      const int leaving = boundary_halfedge(mesh_, v);
      if (surface_valence(mesh_, v) == 1) {
        entries.emplace_back(row, v, 1);
        return;
      }
      int arriving = mesh_.rotate(leaving);
      while (mesh_.is_surface(mesh_.face(arriving))) arriving = mesh_.rotate(arriving);
      entries.emplace_back(row, v, 0.75);
      entries.emplace_back(row, mesh_.target(leaving), 0.125);
      entries.emplace_back(row, mesh_.target(arriving), 0.125);
      return;
    }
    const double n = mesh_.valence(v);
    entries.emplace_back(row, v, (n - 3) / n);
    int h = mesh_.outgoing(v);
    do {
      entries.emplace_back(row, v, 1 / (n * n));
      entries.emplace_back(row, mesh_.target(h), 1 / (n * n));
      add_face_point(mesh_.face(h), 1 / (n * n), row, entries);
      h = mesh_.rotate(h);
    } while (h != mesh_.outgoing(v));
  }

  const PolygonMesh& mesh_;
  const std::vector<bool> bare_;
  // The refined vertex of each vertex, edge and face; -1 for what is dropped.
  std::vector<int> of_vertex_, of_edge_, of_face_;
  int count_ = 0;
  std::vector<std::array<int, 4>> quads_;
  Ghosts new_ghosts_;
};

}  // namespace

Refinement open_catmull_clark(const PolygonMesh& mesh) {
  const OpenStep step(mesh);
  return {step.mesh(), step.stencil()};
}

PolygonMesh open_catmull_clark_mesh(const PolygonMesh& mesh) { return OpenStep(mesh).mesh(); }

}  // namespace umbilic
