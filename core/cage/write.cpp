// SPDX-License-Identifier: MIT
/// \file
/// Writes polygon meshes as OBJ text.
#include "cage/write.h"

#include <fmt/format.h>

#include <cassert>

namespace umbilic {

namespace {

void append_rows(std::string& out, const char* keyword, const Points& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    out += fmt::format("{} {} {} {}\n", keyword, rows(i, 0), rows(i, 1), rows(i, 2));
  }
}

}  // namespace

std::string write_obj(const Cage& cage) {
  std::string out;
  append_rows(out, "v", cage.vertices);
  for (const std::vector<int>& face : cage.faces) {
    out += 'f';
    for (const int vertex : face) out += fmt::format(" {}", vertex + 1);
    out += '\n';
  }
  return out;
}

std::string write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads) {
  assert(positions.rows() == normals.rows());
  std::string out;
  append_rows(out, "v", positions);
  append_rows(out, "vn", normals);
  for (const std::array<int, 4>& quad : quads) {
    out += 'f';
    for (const int vertex : quad) out += fmt::format(" {0}//{0}", vertex + 1);
    out += '\n';
  }
  return out;
}

}  // namespace umbilic
