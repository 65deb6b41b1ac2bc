// SPDX-License-Identifier: MIT
/// \file
/// What is compared, and how closely.
#include "catalog/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/instruction_set.h"
#include "driver/level.h"
#include "driver/problem_run.h"
#include "problem/text.h"

namespace umbilic::catalog {
namespace {

constexpr double kConvergedReproducibility = 1e-5;
constexpr double kOtherReproducibility = 0.1;
/// With other kernels, where there is no error bar.
constexpr double kOtherKernelsReproducibility = 1e-3;
/// Tolerance of the energies of a surface that is only evaluated, relative to the energy but at least to a thousandth
/// of a sphere's bending. (A quantity that vanishes, like the Gaussian curvature of a torus, is a sum whose terms leave
/// rounding errors.)
constexpr double kSurfaceReproducibility = 1e-9;
constexpr double kSurfaceFloor = 1e3 * kEnergyFloor;

bool all_converged(const Json& levels) {
  return std::all_of(levels.begin(), levels.end(), [](const Json& level) {
    return !level.at("evaluable") || level.at("stop") == "converged" || level.at("stop") == "round_off";
  });
}

std::string energy_difference(double after, double before, double tolerance, double floor = kEnergyFloor) {
  const double off = std::abs(after - before) / std::max(std::abs(before), floor);
  if (off <= tolerance) return "";
  return fmt::format("{:.12g} was {:.12g}, {:.1e} off, more than {:.0e}", after, before, off, tolerance);
}

/// Numbers that are not finite are null once they have been written.
bool is_finite(const Json& number) { return number.is_number() && std::isfinite(number.get<double>()); }

/// The same of numbers that may be null, which agree with each other only.
std::string number_difference(const Json& after, const Json& before, double tolerance) {
  if (is_finite(after) && is_finite(before)) return energy_difference(after, before, tolerance);
  return is_finite(after) == is_finite(before) ? "" : fmt::format("{} was {}", after.dump(), before.dump());
}

std::string prefixed(std::string_view what, const std::string& difference) {
  return difference.empty() ? "" : fmt::format("{}: {}", what, difference);
}

/// The first that is not empty.
std::string first_of(std::initializer_list<std::string> differences) {
  for (const std::string& difference : differences) {
    if (!difference.empty()) return difference;
  }
  return "";
}

std::string findings_difference(const Json& stored, const Json& again) {
  if (stored.at("group") != again.at("group")) return "another symmetry group";
  if (stored.at("levels").size() != again.at("levels").size()) return "another number of levels";
  if (stored.contains("below") != again.contains("below")) return "another finding about what it descends to";
  return "";
}

std::string below_difference(const Json& stored, const Json& again, double tolerance) {
  if (!stored.contains("below")) return "";
  return prefixed("what it descends to",
                  energy_difference(again.at("below").at("energy"), stored.at("below").at("energy"), tolerance));
}

/// Entries that an earlier version wrote have none.
std::string opinion_difference(const Json& stored, const Json& again, double tolerance) {
  if (!stored.contains("second_opinion") || !again.contains("second_opinion")) return "";
  return prefixed("second opinion", number_difference(again.at("second_opinion").at("energy"),
                                                      stored.at("second_opinion").at("energy"), tolerance));
}

std::string level_difference(const Json& stored, const Json& again, std::size_t level, double tolerance) {
  return number_difference(again.at("levels")[level].at("energy_reported"),
                           stored.at("levels")[level].at("energy_reported"), tolerance);
}

std::string status_difference(const Json& stored, const Json& again) {
  if (stored.at("status") == again.at("status")) return "";
  return fmt::format("was {}, is {}", stored.at("status").get<std::string>(), again.at("status").get<std::string>());
}

/// Whether the energy of `bound` is an upper bound that the limit of `converged` allows.
bool bounds(const Json& bound, const Json& converged) {
  return bound.at("status") == "upper_bound" && converged.at("status") == "converged" &&
         bound.at("energy").get<double>() >= converged.at("energy").get<double>() - converged.at("error").get<double>();
}

/// Of what the same kernels computed.
std::string same_kernels_difference(const Json& stored, const Json& again) {
  const std::string found = first_of({status_difference(stored, again), findings_difference(stored, again)});
  if (!found.empty()) return found;
  const double tolerance = std::max(reproducibility(stored), reproducibility(again));
  return first_of({below_difference(stored, again, kConvergedReproducibility),
                   level_difference(stored, again, stored.at("levels").size() - 1, tolerance),
                   opinion_difference(stored, again, tolerance)});
}

/// The relative tolerance of an entry's energies with other kernels: its error bar. It is never less than what the same
/// kernels are allowed.
double other_kernels_tolerance(const Json& stored, const Json& again) {
  const Json& error = stored.at("error");
  const double bar = error.is_null() ? kOtherKernelsReproducibility
                                     : error.get<double>() / std::abs(stored.at("energy").get<double>());
  return std::max({bar, reproducibility(stored), reproducibility(again)});
}

/// Of what other kernels computed.
std::string other_kernels_difference(const Json& stored, const Json& again) {
  const bool bounded = bounds(stored, again) || bounds(again, stored);
  const std::string found =
      first_of({bounded ? "" : status_difference(stored, again), findings_difference(stored, again)});
  if (!found.empty()) return found;
  const double tolerance = other_kernels_tolerance(stored, again);
  for (std::size_t level = 0; level < stored.at("levels").size(); ++level) {
    const std::string what = level_difference(stored, again, level, tolerance);
    if (!what.empty()) return fmt::format("level {}: {}", level, what);
  }
  return first_of({bounded ? "" : number_difference(again.at("energy"), stored.at("energy"), tolerance),
                   below_difference(stored, again, kOtherKernelsReproducibility),
                   opinion_difference(stored, again, tolerance)});
}

}  // namespace

Kernels kernels_of(std::string_view set) {
  return set.empty() || set == name_of(instruction_set()) ? Kernels::kSame : Kernels::kOther;
}

double reproducibility(const Json& entry) {
  return all_converged(entry.at("levels")) ? kConvergedReproducibility : kOtherReproducibility;
}

std::string difference(const Json& stored, const Json& again, Kernels kernels) {
  return kernels == Kernels::kSame ? same_kernels_difference(stored, again) : other_kernels_difference(stored, again);
}

std::string start_difference(const Json& stored, const Json& again, Kernels kernels) {
  if (stored.at("level") != again.at("level")) return "another level";
  const bool converged = stored.at("stop") == "converged" && again.at("stop") == "converged";
  const double closest = kernels == Kernels::kSame ? kConvergedReproducibility : kOtherKernelsReproducibility;
  return energy_difference(again.at("energy"), stored.at("energy"), converged ? closest : kOtherReproducibility);
}

std::string misfit(const Json& entry, std::string_view minimizer) {
  const Result<Problem> problem = parse_problem(minimizer);
  if (!problem) return problem.error().message;
  if (!problem->start) return "it holds no surface";
  const Result<ProblemRun> run = begin_run(*problem);
  if (!run) return run.error().message;
  const Json energies = part_json(run->run.energies());
  const Json& stored = entry.at("energies");
  for (const auto& [name, energy] : energies.items()) {
    // A stored entry may be older than a functional.
    if (!energy.is_number() || name == "quadrature_error" || !stored.contains(name)) continue;
    const std::string what = energy_difference(energy, stored.at(name), kSurfaceReproducibility, kSurfaceFloor);
    if (!what.empty()) return fmt::format("{} of the stored surface: {}", name, what);
  }
  return "";
}

}  // namespace umbilic::catalog
