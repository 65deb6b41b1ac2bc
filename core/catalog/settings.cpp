// SPDX-License-Identifier: MIT
/// \file
/// Chooses levels, certificates and second families.
#include "catalog/settings.h"

#include <algorithm>

#include "catalog/reference.h"
#include "driver/certificate.h"

namespace umbilic::catalog {
namespace {

/// MVS minimizers do not converge; more iterations only lower an upper bound that the next level lowers anyway.
constexpr int kUnsettledIterations = 400;

/// Hub cages of 3-way junctions are evaluable from level 2 on, and a limit needs three levels. For functionals of third
/// order these must be levels whose caps have at least two rings. At higher genus this takes minutes.
constexpr int kHubLevels = 4, kThirdOrderHubLevels = 5, kLargestGenusInDetail = 7;

/// For energies that tend to 0, or whose infimum is only approached by ever thinner tori.
constexpr int kVanishingLevels = 2;
constexpr int kVanishingIterations = 200;

/// Whether the symmetry takes each arm to each other, so that few patches of a level are evaluated.
bool has_equal_arms(const CatalogShape& shape) {
  return shape.junctions == 2 || shape.name == "tetrahedron-frame" || shape.name == "cube-frame" ||
         shape.name == "octahedron-frame";
}

/// Whether the functional's minimizers are expected to converge, as in the paper.
bool principal(const CatalogFunctional& functional) {
  return functional.name == "bending" || functional.name == "mvs_cross";
}

/// Cages of holes are not coarse: caps wider than the usual ones have all their rings at level 2 and shrink from there.
/// They are then fitted where the level before left the limit surface to chance, and of three sides end in surfaces
/// that are none. The more sides, the larger the angles at the corners and the lower the order of convergence: of eight
/// sides the limit is told from level 5 only, which is too large to view. In another metric than the Hessian's that
/// level ends far above its minimum, of seven sides at 1161.96 instead of 1161.65.
EntrySettings hole_settings(const CatalogShape& shape, const CatalogFunctional& functional, int last_level) {
  constexpr int kShown = 4, kMostSidesInFourLevels = 6;
  EntrySettings settings;
  settings.cage = cage_options(shape);
  settings.constraints = constraints_of(shape);
  settings.run.weights = functional.weights;
  settings.run.last_level = std::min(kShown, last_level);
  if (shape.sides > kMostSidesInFourLevels && last_level > kShown) {
    settings.run.last_level = kShown + 1;
    settings.run.metric = MetricChoice::kHessian;
    settings.shown_level = kShown;
  }
  settings.certified_faces = kMaxCertifiedFaces;
  return settings;
}

bool settles_slowly(const CatalogShape& shape) { return shape.junctions == 2 && shape.arms >= 6; }

template <class Named>
const Named& called(const std::vector<Named>& list, std::string_view name) {
  return *std::find_if(list.begin(), list.end(), [&](const Named& item) { return item.name == name; });
}

}  // namespace

EntrySettings entry_settings(const CatalogShape& shape, const CatalogFunctional& functional, int last_level) {
  if (shape.hole()) return hole_settings(shape, functional, last_level);
  EntrySettings settings;
  settings.run.weights = functional.weights;
  settings.run.cap_rings = kMostCapRings;  // coarse cages, which are refined
  int levels = third_order(functional.weights) || settles_slowly(shape) ? 4 : 3;
  if (functional.name == "mvs") settings.run.max_iterations = kUnsettledIterations;
  const std::optional<ExactEnergy> exact = exact_energy(shape, functional);
  if (exact && (!exact->attained || exact->energy == 0)) {
    levels = kVanishingLevels;
    settings.run.max_iterations = kVanishingIterations;
  } else {
    settings.certified_faces = kMaxCertifiedFaces;
    settings.descends = !third_order(functional.weights);
  }
  const bool in_detail = functional.name == "mvs_cross" && shape.frame() && shape.genus <= kLargestGenusInDetail;
  if (in_detail && last_level > levels) settings.shown_level = levels++;
  // Where arms differ, level 5 has more unknowns than the automatic choice gives the Hessian's metric, and would end at
  // its iteration limit.
  if (in_detail && !has_equal_arms(shape)) settings.run.metric = MetricChoice::kHessian;
  settings.run.last_level = std::min(levels, last_level);
  if (shape.frame() && principal(functional)) {
    settings.second_family = FrameFamily::kHub;
    const bool hub_in_detail = in_detail && has_equal_arms(shape);
    settings.second_last_level = std::min(hub_in_detail ? kThirdOrderHubLevels : kHubLevels, last_level);
  }
  return settings;
}

const std::vector<Start>& catalog_starts() {
  static const std::vector<Start> starts = [] {
    std::vector<Start> list;
    for (const char* shape : {"two-3", "tetrahedron-frame"}) {
      for (const char* functional : {"bending", "mvs_cross"}) {
        for (const double thickness : {0.5, 1.0, 1.5}) list.push_back({shape, functional, thickness});
      }
    }
    return list;
  }();
  return starts;
}

EntrySettings start_settings(const Start& start, int last_level) {
  EntrySettings settings = entry_settings(shape_called(start.shape), functional_called(start.functional), last_level);
  settings.run.last_level = std::min(settings.run.last_level, 3);
  settings.cage.thickness = start.thickness;
  settings.certified_faces.reset();
  settings.descends = false;
  settings.shown_level.reset();
  settings.second_family.reset();
  return settings;
}

const CatalogShape& shape_called(std::string_view name) { return called(catalog_shapes(), name); }
const CatalogFunctional& functional_called(std::string_view name) { return called(catalog_functionals(), name); }

}  // namespace umbilic::catalog
