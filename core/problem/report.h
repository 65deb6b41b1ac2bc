// SPDX-License-Identifier: MIT
/// \file
/// What a run, an evaluation or a gradient check has to say, as plain values. Their text form is in text.h. The words
/// in each `members` say what a member is, here and in the schema.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cage/cage.h"
#include "problem/energy_report.h"
#include "problem/estimate.h"
#include "problem/problem.h"
#include "solve/stop_reason.h"

namespace umbilic {

/// One level of a run, when it has ended.
struct LevelReport {
  int level = 0;
  int patches = 0;
  int unknowns = 0;
  double energy = 0;
  double energy_reported = 0;
  int iterations = 0;
  int evaluations = 0;
  double seconds = 0;
  StopReason stop = StopReason::kConverged;
  MetricChoice metric = MetricChoice::kIdentity;
  int metrics = 0;
  int factorizations = 0;
  int parametrization_stages = 0;
  int quadrature = 0;
  bool credible = true;
  bool thickened = false;
  bool evaluable = true;
  int cap_rings = 0;
  double narrower_caps_energy = std::numeric_limits<double>::quiet_NaN();
  int narrower_caps_evaluations = 0;
  double predicted_decrease = std::numeric_limits<double>::quiet_NaN();

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("level", self.level, "Catmull-Clark steps from the cage to the mesh whose points are moved");
    visit("patches", self.patches, "Faces of the mesh that the surface is evaluated on");
    visit("unknowns", self.unknowns, "Coordinates that the optimizer moves");
    visit("energy", self.energy, "By the minimizing rule");
    visit("energy_reported", self.energy_reported, "By the finer reporting rule");
    visit("iterations", self.iterations, "Steps of the optimizer");
    visit("evaluations", self.evaluations, "Evaluations of energy and gradient");
    visit("seconds", self.seconds, "Time that the level took");
    visit("stop", self.stop, "Why the level ended");
    visit("metric", self.metric, "What the optimizer measured steps with; never auto");
    visit("metrics", self.metrics, "How often the metric was built");
    visit("factorizations", self.factorizations,
          "How often a matrix was factored for them, also where it turned out not to be positive definite");
    visit("parametrization_stages", self.parametrization_stages,
          "Stages in which a term that keeps the parametrization even fell to 0; 0 without it");
    visit("quadrature", self.quadrature,
          "Steps by which its quadrature rules became finer than usual (core/driver/rules.h)");
    visit("evaluable", self.evaluable,
          "Whether the moved mesh is the evaluated one; coarser ones only prepare the first of these");
    visit("credible", self.credible, "Whether its energies can be those of a surface");
    visit("cap_rings", self.cap_rings, "Rings of faces of its narrowest cap that may move; 0 without caps");
    visit("narrower_caps_energy", self.narrower_caps_energy,
          "energy_reported after it was minimized once more with caps half as wide, from which the limit's error knows "
          "that of the caps; null where it was not");
    visit("narrower_caps_evaluations", self.narrower_caps_evaluations, "Evaluations which that took");
    visit("thickened", self.thickened,
          "Whether its start was made thicker, because its samples missed curvature (core/driver/thickness.h)");
    visit("predicted_decrease", self.predicted_decrease,
          "What the level could still gain when it ended, as predicted; null before the first iteration");
  }
};

/// The symmetry that a run keeps.
struct GroupReport {
  std::string name;
  int order = 1;
  std::optional<std::string> incomplete{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("name", self.name, "Schoenflies symbol, C1 where there is no symmetry");
    visit("order", self.order, "Number of its elements");
    visit("incomplete", self.incomplete, "Why there may be more symmetry than this, where the search was given up");
  }
};

/// What the levels' energies say about their limit.
enum class LimitStatus {
  kConverging,     ///< `energy` is the limit to within `error`
  kTooFewLevels,   ///< fewer than three evaluable levels
  kNotMinimized,   ///< one of the last three levels did not converge
  kNotConverging,  ///< the last three levels are in no asymptotic range: the least energy is an upper bound
  kNotResolved,    ///< the last level's energy is not the surface's: curvature hides between its samples
  kNotComparable,  ///< each level sought its own weight of the pull to the cage's own surface: nothing is extrapolated
};

/// "converging", "too_few_levels", "not_minimized", "not_converging", "not_resolved", "not_comparable".
constexpr std::string_view name_of(LimitStatus status) {
  switch (status) {
    case LimitStatus::kConverging: return "converging";
    case LimitStatus::kTooFewLevels: return "too_few_levels";
    case LimitStatus::kNotMinimized: return "not_minimized";
    case LimitStatus::kNotConverging: return "not_converging";
    case LimitStatus::kNotResolved: return "not_resolved";
    case LimitStatus::kNotComparable: return "not_comparable";
  }
  return "";
}

/// See driver/extrapolate.h. Without a limit, `energy` is the least level's (the last one's, where levels do not
/// compare), and `error` and `lower` are NaN.
struct LimitReport {
  LimitStatus status = LimitStatus::kTooFewLevels;
  double energy = 0;
  double order = 0;
  double error = 0;
  double lower = 0;
  bool caps_included = false;

  /// The error as a part of the limit; NaN unless there is one.
  double relative_error() const {
    return status == LimitStatus::kConverging ? error / std::abs(energy) : std::numeric_limits<double>::quiet_NaN();
  }

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("status", self.status, "Whether the levels tell a limit, or why they do not");
    visit("energy", self.energy, "The limit, or the least level's energy");
    visit("order", self.order, "Observed order of convergence, null where it cannot be told");
    visit("error", self.error, "The limit is within energy +- error; null where there is none");
    visit("lower", self.lower,
          "The limit is not below this: energy - error, or the least that a closed surface has; null where there is "
          "none");
    visit("caps_included", self.caps_included,
          "Whether the error knows that of the caps: not where there is no limit, nor for functionals of third order "
          "whose caps did not widen with the last level, unless that before was minimized with narrower caps, too");
  }
};

/// Whether the surface of a level is a minimum among all surfaces near it, symmetric or not. See driver/certificate.h.
struct CertificateReport {
  int level = 0;
  int unknowns = 0;
  int gauge = 0;
  double tau = 0;
  int negative = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("level", self.level, "Level of the surface");
    visit("unknowns", self.unknowns, "Of the full Hessian, whatever symmetry the surface has");
    visit("gauge", self.gauge, "Directions along which the energy cannot change, removed");
    visit("tau", self.tau, "Eigenvalues below -tau, relative to the Sobolev product, count as negative");
    visit("negative", self.negative, "Directions along which the energy decreases to second order");
  }
};

/// How strongly a held point is pulled, and where it is.
struct PinReport {
  int pin = 0;
  int copy = 0;
  std::array<double, 3> position{};
  std::array<double, 3> pull{};
  double strength = 0;
  double off_surface = 0;
  bool turned_over = false;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("pin", self.pin, "Its number in the problem, from 1");
    if (!std::is_const_v<Self> || self.copy > 0) {
      visit("copy", self.copy,
            "Of what the cage's symmetry maps a pin to: its number, from 1; left out for the pin itself");
    }
    visit("position", self.position, "Where its point of the surface is, x, y, z");
    visit("pull", self.pull,
          "Derivative of the minimal energy by the position of the pin, in energy per length: moved against it, the "
          "energy falls");
    visit("strength", self.strength, "Length of pull");
    visit("off_surface", self.off_surface,
          "Distance between the held point of the limit surface without caps and that of the surface; it falls from "
          "level to level");
    visit("turned_over", self.turned_over, "Whether the surface has its inside where the held normal points");
  }
};

/// Faces that are held and hang together.
struct HeldRegionReport {
  int faces = 0;
  int first_face = 0;
  std::array<double, 3> pull{};
  double strength = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("faces", self.faces, "Number of its faces in the cage");
    visit("first_face", self.first_face, "The first of them, counted from 1");
    visit("pull", self.pull, "Derivative of the minimal energy by moving the region as a whole, in energy per length");
    visit("strength", self.strength, "Length of pull");
  }
};

/// A boundary that is held, and how strongly it pulls.
struct HeldBoundaryReport {
  int boundary = 0;
  std::array<double, 3> center{};
  std::array<double, 3> pull{};
  double strength = 0;
  double total = 0;
  std::array<double, 3> moment{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("boundary", self.boundary, "Its number, from 1, as reports of the cage list boundaries");
    visit("center", self.center, "The mean of its vertices' points of the surface, x, y, z");
    visit("pull", self.pull,
          "Derivative of the minimal energy by moving all that is held of the boundary, in energy per length: moved "
          "against it, the energy falls");
    visit("strength", self.strength, "Length of pull");
    visit("total", self.total,
          "The lengths of the pulls at the boundary's vertices, summed: not 0 where these only cancel");
    visit(
        "moment", self.moment,
        "Derivative of the minimal energy by turning all that is held of the boundary about its center, in energy per "
        "radian: about an axis of length 1, the product with that");
  }
};

/// What the constraints of a run do to its best surface.
struct ConstraintsReport {
  int held_faces = 0;
  int free_faces = 0;
  double deviation = 0;
  std::optional<double> closeness{};
  std::vector<HeldRegionReport> regions;
  std::vector<HeldBoundaryReport> boundaries;
  std::vector<PinReport> pins;
  std::vector<std::string> notes;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("held_faces", self.held_faces, "Number of faces of the cage that are held");
    visit("free_faces", self.free_faces, "Number of the others");
    visit("deviation", self.deviation,
          "Largest distance between points of the surface and the same points of the cage's own surface");
    visit("closeness", self.closeness,
          "Weight of the term that pulls the surface to the cage's own, in energy / length^4: as given, or as found "
          "for a "
          "largest deviation");
    visit("regions", self.regions, "Held faces that hang together, in the order of their first faces");
    visit("boundaries", self.boundaries, "Boundaries at which something is held, by their numbers");
    visit("pins", self.pins, "In the order of the problem, then their copies");
    visit("notes", self.notes, "What else a user should know, a sentence each");
  }
};

struct EvaluationReport {
  int level = 0;
  int patches = 0;
  EnergyReport energies;
  std::optional<OpinionReport> second_opinion{};  ///< where it was asked for

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("level", self.level, "Catmull-Clark steps from the cage to the mesh that was evaluated");
    visit("patches", self.patches, "Its faces");
    visit("energies", self.energies, "Of the surface as it is");
    visit("second_opinion", self.second_opinion, "The same integrals, computed in another way");
  }
};

struct GradientReport {
  int level = 0;
  int unknowns = 0;
  int directions = 0;
  double analytic = 0;
  double difference = 0;
  double relative_mismatch = 0;
  double tolerance = 0;
  bool ok = false;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("level", self.level, "Catmull-Clark steps from the cage to the mesh whose points were moved");
    visit("unknowns", self.unknowns, "Coordinates of its points");
    visit("directions", self.directions, "Random directions that were tried");
    visit("analytic", self.analytic, "Derivative along the direction with the largest mismatch");
    visit("difference", self.difference, "The same by central differences");
    visit("relative_mismatch", self.relative_mismatch, "The largest");
    visit("tolerance", self.tolerance, "The largest that is allowed");
    visit("ok", self.ok, "Whether it is not larger");
  }
};

/// What came out of a run.
struct Report {
  static constexpr Unknown kUnknown = Unknown::kIgnored;
  std::string program;
  std::string instruction_set;
  Problem problem;
  CageReport cage;
  GroupReport group;
  std::optional<Estimate> estimate;
  std::vector<LevelReport> levels;
  LimitReport limit;
  EnergyReport energies;
  std::optional<OpinionReport> second_opinion;
  std::optional<ConstraintsReport> constraints;
  std::optional<CertificateReport> certificate;
  std::optional<SurfaceState> surface;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("program", self.program, "Version of the program that ran");
    visit("instruction_set", self.instruction_set, "That the kernels used (core/base/instruction_set.h)");
    visit.required("problem", self.problem, "What was asked, with its cage as text where that came from a file");
    visit("cage", self.cage, "Counts over the cage");
    visit("group", self.group, "The symmetry that the run keeps");
    visit("estimate", self.estimate, "What the run was expected to take before it began");
    visit("levels", self.levels, "Those that have ended, in order");
    visit("limit", self.limit, "What the levels say about the limit of their energies");
    visit("energies", self.energies, "Of the best surface, by the reporting rule");
    visit("second_opinion", self.second_opinion,
          "The same integrals, computed in another way, where the options ask for it");
    visit("constraints", self.constraints, "What the constraints do, where there are any");
    visit("certificate", self.certificate, "Whether the surface is a minimum among all surfaces near it");
    visit("surface", self.surface, "The best surface, where the problem goes on");
  }
};

}  // namespace umbilic
