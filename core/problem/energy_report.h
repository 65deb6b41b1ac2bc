// SPDX-License-Identifier: MIT
/// \file
/// The energies of a surface as a report has them, and what a second opinion says of them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "energy/functional.h"
#include "energy/invariants.h"

namespace umbilic {

/// A value for each functional, by its name.
struct FunctionalValues {
  std::array<double, kFunctionalCount> values{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    for (int i = 0; i < kFunctionalCount; ++i) visit(kFunctionalNames[i], self.values[i], "Of this functional");
  }
};

/// What values are before they are known: NaN.
template <std::size_t count>
constexpr std::array<double, count> unknown_values() {
  std::array<double, count> values{};
  values.fill(std::numeric_limits<double>::quiet_NaN());
  return values;
}

/// A value for each invariant, by its name.
struct InvariantValues {
  std::array<double, kInvariantCount> values = unknown_values<kInvariantCount>();

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    for (int i = 0; i < kInvariantCount; ++i) visit(kInvariantNames[i], self.values[i], "Null where it diverges");
  }
};

/// What is minimized where parts of a surface are held: the energies of its free faces.
struct FreeEnergies {
  /// Third-order ones with powers of `area_factor`. NaN where a report does not say.
  std::array<double, kFunctionalCount> functionals = unknown_values<kFunctionalCount>();
  double area = 0;
  double area_factor = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    for (int i = 0; i < kFunctionalCount; ++i) {
      visit(kFunctionalNames[i], self.functionals[i],
            "Over the free faces; third-order functionals with a power of area_factor");
    }
    visit("area", self.area, "Area of the free faces");
    visit("area_factor", self.area_factor,
          "The constant area in the factors of third-order functionals: that of the cage's own surface");
  }
};

struct EnergyReport {
  /// In the order of `Functional`; third-order values include their power of the area. NaN where the quantity diverges,
  /// or a report does not say.
  std::array<double, kFunctionalCount> functionals = unknown_values<kFunctionalCount>();
  double area = 0;      ///< in the units of the input; infinite or 0 where a double cannot hold it
  double gaussian = 0;  ///< integral of the Gaussian curvature
  /// |objective by the reporting rule - objective by the minimizing rule|, of the run's functional (of bending, where
  /// there is none).
  double quadrature_error = 0;
  /// By how much, relatively, each functional would change if the coordinates of the input were moved at random by half
  /// a unit in their last places, which is all that is known of what they were rounded from. Empty for a cage about the
  /// origin (cage/placement.h), where it is no more than other rounding errors; NaN where the quantity diverges. See
  /// driver/input_rounding.h.
  std::optional<FunctionalValues> input_rounding{};
  std::optional<FreeEnergies> free{};  ///< if something is held
  /// Of the whole surface, see energy/invariants.h; empty where a report does not say.
  std::optional<InvariantValues> invariants{};
  /// Of the term that pulls the surface to the cage's own: its part of what is minimized.
  std::optional<double> closeness{};
  /// Where the surface is open: how much its boundary turns (surface/boundary_turning.h).
  std::optional<double> boundary_turning{};
  /// Whether `gaussian` and `boundary_turning` sum to what the topology makes them, see driver/gauss_bonnet.h.
  bool resolved = true;
  /// Whether an energy is below what any closed surface of the genus has, see driver/contradiction.h.
  bool below_bound = false;
  /// Whether the surface is proved to be embedded: connected, and with its error below Li & Yau's 8 pi of `willmore`.
  bool embedded = false;

  /// Whether these can be the energies of a surface, and both rules have found some.
  bool credible() const { return resolved && !below_bound && std::isfinite(quadrature_error); }

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    for (int i = 0; i < kFunctionalCount; ++i) {
      visit(kFunctionalNames[i], self.functionals[i],
            "Null where it diverges; third-order functionals with a power of the area");
    }
    visit("area", self.area, "Area of the surface");
    visit("gaussian", self.gaussian, "Integral of the Gaussian curvature");
    visit("quadrature_error", self.quadrature_error, "By how much the reporting and the minimizing rule differ");
    visit("free", self.free, "What is minimized where faces are held: the energies of those that are free");
    visit("boundary_turning", self.boundary_turning,
          "How much the boundary of an open surface turns, with its corners");
    visit("closeness", self.closeness, "The term that pulls the surface to the cage's own, part of what is minimized");
    visit("resolved", self.resolved, "Whether the Gaussian curvature is what the topology makes it");
    visit("below_bound", self.below_bound, "Whether an energy is below what any closed surface of the genus has");
    visit("embedded", self.embedded, "Whether the Willmore energy proves that the surface does not touch itself");
    visit("invariants", self.invariants,
          "Third-order integrals that are odd in II, with powers of the area; II is positive where the surface bends "
          "away from the outward normal");
    visit("input_rounding", self.input_rounding, "Relative changes by the rounding of a cage far from the origin");
  }
};

/// A value for each integral that a second opinion has.
struct OpinionValues {
  std::array<double, kFunctionalCount> functionals = unknown_values<kFunctionalCount>();
  std::array<double, kInvariantCount> invariants = unknown_values<kInvariantCount>();
  double area = std::numeric_limits<double>::quiet_NaN();
  double gaussian = std::numeric_limits<double>::quiet_NaN();

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    constexpr std::string_view kNull = "Null where it diverges";
    for (int i = 0; i < kFunctionalCount; ++i) visit(kFunctionalNames[i], self.functionals[i], kNull);
    for (int i = 0; i < kInvariantCount; ++i) visit(kInvariantNames[i], self.invariants[i], kNull);
    visit("area", self.area, "Area of the surface");
    visit("gaussian", self.gaussian, "Integral of the Gaussian curvature");
  }
};

/// Which faces a second opinion goes over.
enum class OpinionFaces {
  kAll,          ///< whatever symmetry the surface has
  kOnePerOrbit,  ///< one of each orbit of the surface's symmetry, which it believes: as many times faster as that has
                 ///< elements
};

/// The same integrals of the same surface, computed in another way: see core/opinion/surface_integrals.h.
struct OpinionReport {
  OpinionValues values;
  OpinionValues errors;
  OpinionValues differences;
  double samples = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("values", self.values, "Of the whole surface");
    visit("errors", self.errors, "By how much these values differ by a coarser rule of the same kind");
    visit("differences", self.differences, "The report's energies minus these values");
    visit("samples", self.samples, "Number of points that were evaluated");
  }
};

}  // namespace umbilic
