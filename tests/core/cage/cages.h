// SPDX-License-Identifier: MIT
/// \file
/// Small cages as text, and shorthands for what reading them says.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"
#include "cage/generate.h"
#include "cage/read.h"

namespace umbilic::test {

inline constexpr std::string_view kTetrahedronVertices = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n";
inline constexpr std::string_view kTetrahedronFaces = "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

inline std::string tetrahedron_obj() { return std::string(kTetrahedronVertices) + std::string(kTetrahedronFaces); }

inline std::string tetrahedron_off() {
  return "OFF\n4 4 6\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";
}

/// The error of reading `text`, or "" when it is a cage.
inline std::string error_of(std::string_view text) {
  const Result<Cage> cage = read_cage(text);
  return cage ? "" : cage.error().message;
}

/// Reads a text that must be a cage.
inline Cage cage_of(std::string_view text) {
  Result<Cage> cage = read_cage(text);
  EXPECT_TRUE(cage.ok()) << cage.error().message;
  return cage ? std::move(cage).value() : Cage{};
}

inline Cage generated(std::string_view name) { return generate_cage(name).value(); }

/// A cube whose coordinates are any doubles, by their bits.
inline Cage cube_of_any_doubles(std::mt19937_64& random) {
  Cage cage = generated("cube");
  for (double& x : cage.vertices.reshaped()) {
    const std::uint64_t bits = random();
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) x = -0.0;
  }
  return cage;
}

/// Of a cage that must be valid.
inline CageReport report_of(Cage cage) {
  const Result<CageReport> report = validate(cage);
  EXPECT_TRUE(report.ok()) << report.error().message;
  return report ? *report : CageReport{};
}

/// `tetrahedron` without regard to what stands around it: 4 vertices at the corners of a cube, 4 triangles.
inline void expect_tetrahedron(std::string_view text) {
  const Cage cage = cage_of(text);
  const Cage expected = cage_of(tetrahedron_obj());
  EXPECT_EQ(cage.vertices, expected.vertices) << text;
  EXPECT_EQ(cage.faces, expected.faces) << text;
}

/// The cages side by side, `distance` apart along x.
inline Cage together(const std::vector<Cage>& cages, double distance) {
  Cage all;
  for (std::size_t c = 0; c < cages.size(); ++c) {
    const auto first = static_cast<int>(all.vertices.rows());
    all.vertices.conservativeResize(first + cages[c].vertices.rows(), 3);
    all.vertices.bottomRows(cages[c].vertices.rows()) = cages[c].vertices;
    all.vertices.bottomRows(cages[c].vertices.rows()).col(0).array() += distance * static_cast<double>(c);
    for (std::vector<int> face : cages[c].faces) {
      for (int& v : face) v += first;
      all.faces.push_back(face);
    }
  }
  return all;
}

/// Replaces vertex `b` by `a` in all faces.
inline void identify(Cage& cage, int a, int b) {
  for (std::vector<int>& face : cage.faces) std::replace(face.begin(), face.end(), b, a);
}

}  // namespace umbilic::test
