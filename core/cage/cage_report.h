// SPDX-License-Identifier: MIT
/// \file
/// What validation counts in a cage and says about it.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace umbilic {

/// The genus g of a component with b boundary loops is that of the closed surface that arises when each loop is filled
/// with a face: vertices - edges + faces = 2 - 2g - b.
struct CageComponent {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int genus = 0;
  int boundaries = 0;

  /// Visits each member by name, for the text form of reports; see problem/members.h.
  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("vertices", self.vertices, "Number of vertices");
    visit("edges", self.edges, "Number of edges");
    visit("faces", self.faces, "Number of faces");
    visit("genus", self.genus, "Number of tunnels");
    visit("boundaries", self.boundaries, "Number of boundary loops, 0 where it is closed");
  }
};

/// One loop of edges that have the surface on one side only: a face that is no hole. `surface_boundaries`
/// (cage/boundary.h) has its vertices.
struct CageBoundary {
  int number = 0;        ///< from 1, in the order of the loops' first vertices
  int vertices = 0;      ///< as many as edges
  int first_vertex = 0;  ///< the one that comes first in the text, numbered as there
  int component = 0;     ///< from 1

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("number", self.number, "From 1, in the order of the loops' first vertices");
    visit("vertices", self.vertices, "Number of its vertices");
    visit("first_vertex", self.first_vertex, "Of its vertices the first in the file, numbered as there");
    visit("component", self.component, "Number of its component, from 1");
  }
};

/// A group of faces of a file.
struct CageGroup {
  std::string name;
  int faces = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("name", self.name, "As in the file");
    visit("faces", self.faces, "Number of its faces");
  }
};

/// Of the surface of a cage: faces that are holes, and the vertices and edges that only these use, are counted nowhere
/// but in `holes`.
struct CageReport {
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int holes = 0;
  int genus = 0;                          ///< sum over components
  std::vector<CageComponent> components;  ///< in the order of their first face
  std::vector<CageBoundary> boundaries;   ///< by their numbers; none where the cage is closed
  std::vector<CageGroup> groups;          ///< in the order of their first face
  std::vector<std::string> repairs;       ///< what validation changed, a sentence without a final period each
  std::vector<std::string> notes;         ///< what else a user should know, likewise

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("vertices", self.vertices, "Number of vertices");
    visit("edges", self.edges, "Number of edges");
    visit("faces", self.faces, "Number of faces");
    if (!std::is_const_v<Self> || self.holes > 0) {
      visit("holes", self.holes, "Number of faces that are holes, which nothing else counts; left out where none are");
    }
    visit("genus", self.genus, "Sum over the components");
    visit("components", self.components, "In the order of their first face");
    visit("boundaries", self.boundaries, "Loops of edges with the surface on one side only; none where it is closed");
    visit("groups", self.groups, "Groups of faces (g and o of an OBJ file), in the order of their first face");
    visit("repairs", self.repairs, "What had to be changed of the cage as it was given, a sentence each");
    visit("notes", self.notes, "What of the file was ignored, or is likely to be a mistake, a sentence each");
  }
};

}  // namespace umbilic
