// SPDX-License-Identifier: MIT
/// \file
/// How each entry of the catalog is computed.
#pragma once

#include <optional>

#include "catalog/shapes.h"
#include "driver/run.h"

namespace umbilic::catalog {

struct EntrySettings {
  CageOptions cage;
  RunOptions run;
  Constraints constraints;
  /// If set, a certificate is computed on the finest level with at most this many faces.
  std::optional<int> certified_faces;
  /// Whether the entry also has what its minimizer descends to, where the certificate counts directions of descent.
  bool descends = false;
  /// If set, the entry shows the minimizer of this level; finer ones only tell the limit, and are too large to view.
  std::optional<int> shown_level{};
  /// If set, the entry is also computed from the other family of cages; and the last level of that run.
  std::optional<FrameFamily> second_family;
  int second_last_level = 0;
};

/// Levels from 0 to 3 for bending; to 4 for third-order functionals, and if three levels leave an error above 0.05 %;
/// to 5 for mvs_cross of frames up to genus 7, of their second family where all arms are alike, and of holes of 7 and 8
/// sides; fewer if the infimum is known and is not attained, or is 0. `last_level` is an upper bound. Only energies of
/// second order descend: along the directions that a certificate counts for those of third order, which are not smooth
/// at umbilics, hardly anything is gained.
EntrySettings entry_settings(const CatalogShape& shape, const CatalogFunctional& functional, int last_level);

/// One run of the paper's figure 3, which minimizes one shape from a thin and from a thick cage.
struct Start {
  std::string shape;
  std::string functional;
  double thickness;
};

const std::vector<Start>& catalog_starts();
EntrySettings start_settings(const Start& start, int last_level);

const CatalogShape& shape_called(std::string_view name);
const CatalogFunctional& functional_called(std::string_view name);

}  // namespace umbilic::catalog
