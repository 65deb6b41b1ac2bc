// SPDX-License-Identifier: MIT
/// \file
/// A control cage as given by a user: an orientable polygon mesh, closed or with boundaries, with faces of any size and
/// named groups of faces. Also its validation.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/types.h"
#include "cage/cage_report.h"

namespace umbilic {

/// Faces that a user calls by one name. A face may be in several groups.
struct FaceGroup {
  std::string name;        ///< without blanks, control characters and '#', so that an OBJ file can hold it
  std::vector<int> faces;  ///< zero-based, ascending, at least one
};

struct Cage {
  Points vertices{};
  std::vector<std::vector<int>> faces{};  ///< corners in cyclic order, zero-based
  std::vector<FaceGroup> groups{};        ///< in the order of their first faces
  /// The faces that are holes, ascending: they take part in subdivision, as the others do, but the surface has no
  /// points over them. A ring of them beyond a boundary says how the surface meets it.
  std::vector<int> holes{};
};

/// Where a cage's elements are in the text from which it was read, for messages; empty if it was not read.
struct CageSource {
  std::vector<int> vertex_lines;  ///< one-based line of each vertex
  std::vector<int> face_lines;    ///< one-based line of each face
  int first_index = 1;            ///< the index of the first vertex in the text
};

/// Checks that the cage is an edge- and vertex-manifold, orientable surface, closed or with boundary loops, with finite
/// vertices, every index in range, at least three vertices in a face and none twice, and at least one face, and that no
/// component's vertices lie in one point or on one line and no component's faces are without area. A vertex belongs to
/// one boundary loop at most, since it joins a single fan of faces.
///
/// Then turns the faces of each component to one orientation: that which encloses positive volume where the component
/// is closed; that of most of its faces where it has a boundary, because it encloses nothing, or where the volume
/// vanishes. Drops the vertices that no face uses, because the surface does not depend on them; the others keep their
/// order, and so do all faces. What it turns or drops the report says. The cage is unchanged when there is an error. A
/// validated cage validates unchanged.
///
/// Errors name the vertex, edge or face, and its line if `source` has it. Vertices are numbered as in the text, faces
/// from 1.
Result<CageReport> validate(Cage& cage, const CageSource& source = {});

}  // namespace umbilic
