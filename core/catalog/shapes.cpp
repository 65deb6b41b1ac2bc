// SPDX-License-Identifier: MIT
/// \file
/// The lists of shapes, functionals and the paper's energies.
#include "catalog/shapes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace umbilic::catalog {
namespace {

struct PaperRow {
  std::string_view shape;
  double bending, mvs, mvs_cross;
};

constexpr std::array<PaperRow, 7> kTableOne{{{"two-3", 113, 343, 2408},
                                             {"two-4", 142, 1548, 6416},
                                             {"tetrahedron-frame", 144, 975, 4020},
                                             {"two-6", 195, 7331, 22688},
                                             {"cube-frame", 199, 2217, 9109},
                                             {"octahedron-frame", 250, 3566, 18426},
                                             {"two-12", 351, 75720, 212031}}};

CatalogFunctional named(std::string_view name) { return {std::string(name), weights_of(name).value()}; }

CatalogShape hole(int sides) {
  return {.name = "hole-" + std::to_string(sides), .generator = "n-sided", .sides = sides};
}

}  // namespace

const std::vector<CatalogShape>& catalog_shapes() {
  static const std::vector<CatalogShape> shapes{
      {"two-3", "two-3", 2, 2, 3},
      {"two-4", "two-4", 3, 2, 4},
      {"tetrahedron-frame", "tetrahedron-frame", 3, 4, 3},
      {"two-5", "two-5", 4, 2, 5},
      {"triangular-prism-frame", "triangular-prism-frame", 4, 6, 3},
      {"two-6", "two-6", 5, 2, 6},
      {"cube-frame", "cube-frame", 5, 8, 3},
      {"two-7", "two-7", 6, 2, 7},
      {"pentagonal-prism-frame", "pentagonal-prism-frame", 6, 10, 3},
      {"octahedron-frame", "octahedron-frame", 7, 6, 4},
      {"hexagonal-prism-frame", "hexagonal-prism-frame", 7, 12, 3},
      {"truncated-tetrahedron-frame", "truncated-tetrahedron-frame", 7, 12, 3},
      {"two-12", "two-12", 11, 2, 12},
      {"dodecahedron-frame", "dodecahedron-frame", 11, 20, 3},
      {"cuboctahedron-frame", "cuboctahedron-frame", 13, 12, 4},
      {"icosahedron-frame", "icosahedron-frame", 19, 12, 5},
      {"torus", "torus", 1, 0, 0},
      {"sphere", "cube", 0, 0, 0},
      hole(3),
      hole(4),
      hole(5),
      hole(6),
      hole(7),
      hole(8),
  };
  return shapes;
}

const std::vector<CatalogFunctional>& catalog_functionals() {
  static const std::vector<CatalogFunctional> functionals{
      named("bending"),
      named("mvs"),
      named("mvs_cross"),
      named("mehlum_tarrou"),
      named("second_form_variation"),
      {"bending_mvs_cross", parse_weights("bending=1,mvs_cross=1").value()},
  };
  return functionals;
}

bool has_entry(const CatalogShape& shape, const CatalogFunctional& functional) {
  return !shape.hole() || functional.name == "mvs_cross";
}

CageOptions cage_options(const CatalogShape& shape) {
  return shape.hole() ? CageOptions{.sides = shape.sides, .rise = kHoleRise} : CageOptions{};
}

Constraints constraints_of(const CatalogShape& shape) {
  if (!shape.hole()) return {};
  return {.boundary = BoundaryConditions{.condition = BoundaryCondition::kCurvature}};
}

std::optional<double> paper_energy(const CatalogShape& shape, const CatalogFunctional& functional) {
  const auto row =
      std::find_if(kTableOne.begin(), kTableOne.end(), [&](const PaperRow& r) { return r.shape == shape.name; });
  if (row == kTableOne.end()) return std::nullopt;
  if (functional.name == "bending") return row->bending;
  if (functional.name == "mvs") return row->mvs;
  if (functional.name == "mvs_cross") return row->mvs_cross;
  return std::nullopt;
}

}  // namespace umbilic::catalog
