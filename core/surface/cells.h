// SPDX-License-Identifier: MIT
/// \file
/// Walks from cell to cell in a mesh of quads. A cell is named by its half-edge along u.
#pragma once

#include "mesh/polygon_mesh.h"

namespace umbilic {

/// The half-edges along u of the neighbouring cells, given the half-edge h along u of a cell.
inline int cell_right(const PolygonMesh& m, int h) { return m.next(m.twin(m.next(h))); }
inline int cell_above(const PolygonMesh& m, int h) { return m.twin(m.next(m.next(h))); }
inline int cell_left(const PolygonMesh& m, int h) { return m.previous(m.twin(m.previous(h))); }
inline int cell_below(const PolygonMesh& m, int h) { return m.next(m.next(m.twin(h))); }

}  // namespace umbilic
