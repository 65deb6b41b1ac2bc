// SPDX-License-Identifier: MIT
/// \file
/// Layout of the tables.
#include "cli/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cage/text.h"

namespace umbilic::cli {

namespace {

constexpr double kPi = 3.14159265358979323846;

std::string plural(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string energy_line(std::string_view name, double value, const std::string& note = "") {
  const std::string number = std::isfinite(value) ? fmt::format("{:.10g}", value) : "diverges";
  return fmt::format("  {:<24} {:>16}{}{}\n", name, number, note.empty() ? "" : "   = ", note);
}

std::string area_line(double area) {
  if (std::isinf(area)) return fmt::format("  {:<24} {:>16}\n", "area", "above 1.8e+308");
  if (area == 0) return fmt::format("  {:<24} {:>16}\n", "area", "below 4.9e-324");
  return energy_line("area", area);
}

/// How many digits the input leaves, where it leaves fewer than are printed.
std::string input_rounding_lines(const EnergyReport& energies) {
  constexpr double kHarmless = 1e-12;
  if (!energies.input_rounding) return "";
  double second_order = 0, third_order = 0;
  for (int i = 0; i < kFunctionalCount; ++i) {
    double& largest = is_third_order(i) ? third_order : second_order;
    if (const double change = energies.input_rounding->values[i]; change > largest) largest = change;
  }
  if (!(std::max(second_order, third_order) > kHarmless)) return "";
  return fmt::format(
      "note: the cage lies so far from the origin for its size that its coordinates' last digits decide:\n"
      "their rounding changes energies of second order by up to {:.1e} of their value, of third order by up to "
      "{:.1e}\n",
      second_order, third_order);
}

/// Seven digits of a bound >= 0, rounded downwards: one that is rounded up is none.
std::string bound_words(double bound) {
  const double unit = bound > 0 ? std::pow(10.0, std::floor(std::log10(bound)) - 6) : 1;
  return fmt::format("{:.7g}", std::floor(bound / unit) * unit);
}

std::string ratio(double value, double unit, std::string_view unit_name) {
  return fmt::format("{:.6g} * {}", value / unit, unit_name);
}

}  // namespace

std::string input_line(std::string_view name, const CageReport& report) {
  std::string text = fmt::format("{}: {}, {}, {}", printable(name), plural(report.vertices, "vertex", "vertices"),
                                 plural(report.edges, "edge", "edges"), plural(report.faces, "face", "faces"));
  if (report.holes > 0) text += fmt::format(", {}", plural(report.holes, "hole", "holes"));
  if (report.components.size() > 1) text += fmt::format(", {} components", report.components.size());
  text += fmt::format(", genus {}", report.genus);
  if (!report.boundaries.empty()) {
    text += ", " + plural(static_cast<int>(report.boundaries.size()), "boundary", "boundaries");
  }
  text += '\n';
  for (const std::string& repair : report.repairs) text += fmt::format("repaired: {}\n", repair);
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  return text;
}

/// What was minimized, where that is not the whole surface's.
std::string free_energy_lines(const FreeEnergies& free) {
  std::string text = "over the free faces, which is what was minimized\n";
  for (std::size_t i = 0; i < free.functionals.size(); ++i)
    text += energy_line(kFunctionalNames[i], free.functionals[i]);
  text += area_line(free.area);
  if (free.area_factor > 0) {
    text += fmt::format(
        "  the area in the factors of third-order functionals is the constant {:.10g}, that of the cage's own "
        "surface\n",
        free.area_factor);
  }
  return text + "of the whole surface\n";
}

std::string energy_table(const EnergyReport& energies, const std::string& objective) {
  std::string text = energies.free ? free_energy_lines(*energies.free) : "";
  for (std::size_t i = 0; i < energies.functionals.size(); ++i) {
    const double value = energies.functionals[i];
    std::string note;
    if (i == kBending) note = ratio(value, 8 * kPi, "8 pi");
    if (i == kWillmore) note = ratio(value, 4 * kPi, "4 pi");
    text += energy_line(kFunctionalNames[i], value, note);
  }
  text += area_line(energies.area);
  text += energy_line("gaussian", energies.gaussian, ratio(energies.gaussian, 4 * kPi, "4 pi"));
  if (const auto turning = energies.boundary_turning) {
    text += energy_line("boundary_turning", *turning, ratio(*turning, 2 * kPi, "2 pi"));
  }
  if (std::isfinite(energies.quadrature_error)) {
    text += fmt::format("  quadrature error of {}: {:.1e}\n", objective, energies.quadrature_error);
  }
  return text + input_rounding_lines(energies);
}

std::string invariants_table(const EnergyReport& energies) {
  constexpr const char* kFormulas[kInvariantCount] = {"A^(3/2) * integral of II(T, T), T = 2 grad H",
                                                      "A^(3/2) * integral of II_ij C_ikl C_jkl, C = grad II",
                                                      "A^(5/2) * integral of II_ia II_jb II_kc C_ijk C_abc"};
  if (!energies.invariants) return "";
  std::string text = "invariants that change their sign with the side of the surface\n";
  for (int i = 0; i < kInvariantCount; ++i) {
    text += energy_line(kInvariantNames[i], energies.invariants->values[i], kFormulas[i]);
  }
  return text;
}

std::string opinion_table(const std::optional<OpinionReport>& opinion) {
  if (!opinion) return "";
  std::string text = fmt::format("second opinion, of {:.0f} points              value    difference    its own error\n",
                                 opinion->samples);
  const auto line = [&](std::string_view name, double value, double difference, double error) {
    if (!std::isfinite(value)) return;
    text += fmt::format("  {:<24} {:>16}   {:>11.1e}   {:>14.1e}\n", name, fmt::format("{:.10g}", value), difference,
                        error);
  };
  const auto &values = opinion->values, &differences = opinion->differences, &errors = opinion->errors;
  for (int i = 0; i < kFunctionalCount; ++i)
    line(kFunctionalNames[i], values.functionals[i], differences.functionals[i], errors.functionals[i]);
  line("area", values.area, differences.area, errors.area);
  line("gaussian", values.gaussian, differences.gaussian, errors.gaussian);
  for (int i = 0; i < kInvariantCount; ++i)
    line(kInvariantNames[i], values.invariants[i], differences.invariants[i], errors.invariants[i]);
  return text;
}

std::string constraints_table(const ConstraintsReport& report) {
  const auto pull_words = [](const std::array<double, 3>& pull, double strength) {
    return fmt::format("pulls with {:.6g} per length, ({:.6g}, {:.6g}, {:.6g})", strength, pull[0], pull[1], pull[2]);
  };
  std::string text;
  if (report.held_faces > 0) {
    text += fmt::format("held: {}, free: {}\n", plural(report.held_faces, "face", "faces"),
                        plural(report.free_faces, "face", "faces"));
  }
  for (const HeldRegionReport& region : report.regions) {
    text += fmt::format("  region of face {}, {}: {}\n", region.first_face, plural(region.faces, "face", "faces"),
                        pull_words(region.pull, region.strength));
  }
  for (const HeldBoundaryReport& boundary : report.boundaries) {
    text += fmt::format("  boundary {}: {}; {:.6g} without regard to direction\n", boundary.boundary,
                        pull_words(boundary.pull, boundary.strength), boundary.total);
  }
  for (const PinReport& pin : report.pins) {
    text += fmt::format("  pin {}{} at ({:.10g}, {:.10g}, {:.10g}): {}", pin.pin,
                        pin.copy > 0 ? fmt::format(", copy {},", pin.copy) : "", pin.position[0], pin.position[1],
                        pin.position[2], pull_words(pin.pull, pin.strength));
    if (pin.off_surface > 0) text += fmt::format("; the surface passes at {:.1e}", pin.off_surface);
    text += '\n';
    if (pin.turned_over && pin.copy == 0) {
      text += fmt::format("warning: the surface at pin {} is inside out\n", pin.pin);
    }
  }
  text += fmt::format("  largest deviation from the cage's own surface {:.6g}\n", report.deviation);
  if (report.closeness) {
    text += fmt::format("  pulled to the cage's own surface with weight {:.6g} per length^4\n", *report.closeness);
  }
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  return text;
}

std::string credibility_lines(const EnergyReport& energies) {
  std::string text;
  if (energies.below_bound) {
    text +=
        "warning: no closed surface of this genus has so little bending or Willmore energy: these energies are not the "
        "surface's\n";
  }
  if (!energies.resolved) {
    text += fmt::format(
        "warning: the Gaussian curvature does not add up{} to 2 pi times the Euler characteristic: some "
        "hides in folds or necks,\nand these energies are not the surface's\n",
        energies.boundary_turning ? " with the boundary's turning" : "");
  }
  if (energies.embedded) {
    text += "embedded: with a Willmore energy below 8 pi no surface touches or crosses itself (Li & Yau 1982)\n";
  }
  return text;
}

std::string result_line(const std::vector<LevelReport>& levels, const LevelReport& result) {
  if (result.level == levels.back().level) return "energies of the last level\n";
  return fmt::format("energies of level {}, which is better than the last one\n", result.level);
}

std::string level_table(const std::vector<LevelReport>& levels) {
  std::string text = fmt::format("  {:>5} {:>8} {:>9} {:>16} {:>10} {:>11} {:>8}  {:<8}  {}\n", "level", "patches",
                                 "unknowns", "energy", "iterations", "evaluations", "seconds", "metric", "stop");
  for (const LevelReport& level : levels) {
    text += fmt::format("  {:>5} {:>8} {:>9} {:>16.10g} {:>10} {:>11} {:>8.2f}  {:<8}  {}\n", level.level,
                        level.patches, level.unknowns, level.energy_reported, level.iterations, level.evaluations,
                        level.seconds, name_of(level.metric), name_of(level.stop));
  }
  std::string even;
  for (const LevelReport& level : levels) {
    if (level.parametrization_stages > 0) even += fmt::format("{}{}", even.empty() ? "" : ", ", level.level);
  }
  if (!even.empty()) text += fmt::format("  a term kept the parametrization even, and fell to 0: levels {}\n", even);
  for (const LevelReport& level : levels) {
    if (!std::isfinite(level.narrower_caps_energy)) continue;
    text += fmt::format("  level {} with caps half as wide: {:.10g} after {} evaluations\n", level.level,
                        level.narrower_caps_energy, level.narrower_caps_evaluations);
  }
  for (const LevelReport& level : levels) {
    if (!level.thickened) continue;
    text +=
        fmt::format("  level {} began thicker than it was: its samples missed curvature of its rims\n", level.level);
  }
  return text;
}

std::string group_words(const GroupReport& group) {
  return fmt::format("symmetry {}, order {}{}", group.name, group.order,
                     group.incomplete ? fmt::format(" ({}: there may be more)", *group.incomplete) : "");
}

std::string limit_line(const LimitReport& limit) {
  switch (limit.status) {
    case LimitStatus::kConverging: {
      const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(limit.error))), 0, 12);
      const std::string order =
          std::isfinite(limit.order) ? fmt::format("observed order {:.1f}", limit.order) : "the last levels agree";
      const std::string cut = limit.lower > limit.energy - limit.error
                                  ? ", but not below " + bound_words(limit.lower) + ", as no surface is"
                                  : "";
      const std::string caps = limit.caps_included ? "" : ", without the caps' own error";
      return fmt::format("extrapolated {:.{}f} +- {:.{}f} ({}){}{}\n", limit.energy, places, limit.error, places, order,
                         caps, cut);
    }
    case LimitStatus::kTooFewLevels: return "not extrapolated: too few levels; three are needed\n";
    case LimitStatus::kNotMinimized: return "not extrapolated: one of the last three levels did not converge\n";
    case LimitStatus::kNotConverging:
      return fmt::format("not extrapolated: {:.10g} is an upper bound, the levels do not converge\n", limit.energy);
    case LimitStatus::kNotResolved: return "not extrapolated: the last level's energy is not the surface's\n";
    case LimitStatus::kNotComparable:
      return "not extrapolated: each level has its own weight with which it stays within the distance, so that their "
             "energies do not compare\n";
  }
  return "";
}

namespace {

/// A part in percent, rounded up to two digits: an error is not told to be smaller than it is.
double percent(double part) {
  const double unit = std::pow(10, std::floor(std::log10(100 * part)) - 1);
  return unit * std::ceil(100 * part / unit * (1 - 1e-12));
}

}  // namespace

std::string accuracy_line(const LimitReport& limit, double accuracy) {
  const double reached = limit.relative_error();
  if (reached <= accuracy) return fmt::format("{:.4g}, within {:.2g} %\n", limit.energy, percent(reached));
  return fmt::format("not within {:.4g} %: {}\n", 100 * accuracy,
                     std::isfinite(reached) ? fmt::format("the levels tell the limit within {:.2g} %", percent(reached))
                                            : "the levels tell no limit");
}

std::string descent_words(const CertificateReport& certificate) {
  return plural(certificate.negative, "direction lowers the energy", "directions lower the energy");
}

std::string certificate_line(const CertificateReport& certificate, const GroupReport& group) {
  std::string words = "a local minimum among all surfaces near it";
  if (certificate.negative > 0) {
    words = descent_words(certificate);
    words += group.order > 1 ? fmt::format(": a minimum only within its symmetry {}", group.name) : ": no minimum";
  }
  return fmt::format("certificate: {} (level {}, {} unknowns, {} gauge directions, tau {:g})\n", words,
                     certificate.level, certificate.unknowns, certificate.gauge, certificate.tau);
}

}  // namespace umbilic::cli
