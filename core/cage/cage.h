// SPDX-License-Identifier: MIT
/// \file
/// A control cage as given by a user: a closed, orientable polygon mesh with faces of any size. Also its validation and
/// its counts.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/types.h"

namespace umbilic {

struct Cage {
  Points vertices;
  std::vector<std::vector<int>> faces;  ///< corners in cyclic order, zero-based
  std::vector<int> holes{};             ///< faces that take part in subdivision but carry no surface, sorted
};

struct CageComponent {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int genus = 0;

  /// Visits each member by name, for the text form of reports; see problem/members.h.
  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("vertices", self.vertices, "Number of vertices");
    visit("edges", self.edges, "Number of edges");
    visit("faces", self.faces, "Number of faces");
    visit("genus", self.genus, "Number of tunnels");
  }
};

struct CageReport {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int genus = 0;                          ///< sum over components
  std::vector<CageComponent> components;  ///< in the order of their first face
  std::vector<std::string> repairs;       ///< what validation changed, a sentence without a final period each

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("vertices", self.vertices, "Number of vertices");
    visit("edges", self.edges, "Number of edges");
    visit("faces", self.faces, "Number of faces");
    visit("genus", self.genus, "Sum over the components");
    visit("components", self.components, "In the order of their first face");
    visit("repairs", self.repairs, "What had to be changed of the cage as it was given, a sentence each");
  }
};

/// Where a cage's elements are in the text from which it was read, for messages; empty if it was not read.
struct CageSource {
  std::vector<int> vertex_lines;  ///< one-based line of each vertex
  std::vector<int> face_lines;    ///< one-based line of each face
  int first_index = 1;            ///< the index of the first vertex in the text
};

/// Checks that the cage is a closed, edge- and vertex-manifold, orientable surface with finite vertices, every index in
/// range, at least three vertices in a face and none twice, and at least one face, and that no component's vertices lie
/// in one point or on one line and no component's faces are without area. Then turns the faces of each component to one
/// orientation that encloses positive volume (or, where the volume vanishes, to that of most of its faces), and drops
/// the vertices that no face uses, because the surface does not depend on them; the others keep their order. What it
/// turns or drops the report says. The cage is unchanged when there is an error. A validated cage validates unchanged.
///
/// Errors name the vertex, edge or face, and its line if `source` has it. Vertices are numbered as in the text, faces
/// from 1.
Result<CageReport> validate(Cage& cage, const CageSource& source = {});

}  // namespace umbilic
