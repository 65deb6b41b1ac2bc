// SPDX-License-Identifier: MIT
/// \file
/// Entries to JSON, and comparisons of stored ones.
#include "catalog/catalog_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "driver/level.h"

namespace umbilic {
namespace {

template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string family_name(FrameFamily family) { return family == FrameFamily::kHub ? "hub" : "flag"; }

Json cage_json(const CatalogShape& shape, const CageOptions& options) {
  return {{"generator", shape.generator}, {"family", family_name(options.family)}, {"thickness", options.thickness}};
}

/// Without seconds, which no run repeats.
Json timeless(const std::vector<LevelReport>& levels) {
  Json all = json_of(levels);
  for (Json& level : all) level.erase("seconds");
  return all;
}

Json json_of(const SecondFamily& second, const LimitReport& first) {
  return {{"family", family_name(second.family)},
          {"energy", second.limit.energy},
          {"error", second.limit.error},
          {"status", std::string(name_of(second.limit.status))},
          {"agrees", optional_json(agree(first, second.limit))},
          {"levels", timeless(second.levels)}};
}

bool all_converged(const Json& levels) {
  return std::all_of(levels.begin(), levels.end(), [](const Json& level) {
    return !level.at("evaluable") || level.at("stop") == "converged" || level.at("stop") == "round_off";
  });
}

constexpr double kConvergedReproducibility = 1e-5;
constexpr double kOtherReproducibility = 0.1;
/// Of a surface that is only evaluated, relative to at least a thousandth of a sphere's bending: what vanishes, as the
/// Gaussian curvature of a torus does, is a sum of terms that rounding leaves.
constexpr double kSurfaceReproducibility = 1e-9;
constexpr double kSurfaceFloor = 1e3 * kEnergyFloor;

std::string energy_difference(double after, double before, double tolerance, double floor = kEnergyFloor) {
  const double off = std::abs(after - before) / std::max(std::abs(before), floor);
  if (off <= tolerance) return "";
  return fmt::format("{:.12g} was {:.12g}, {:.1e} off, more than {:.0e}", after, before, off, tolerance);
}

}  // namespace

std::string entry_name(const CatalogShape& shape, const CatalogFunctional& functional) {
  return shape.name + "." + functional.name;
}

Json json_of(const EntrySettings& settings) {
  const RunOptions& run = settings.run;
  Json second = nullptr;
  if (settings.second_family) {
    second = {{"family", family_name(*settings.second_family)},
              {"levels", {run.first_level, settings.second_last_level}}};
  }
  return {{"cap", "smooth"},
          {"levels", {run.first_level, run.last_level}},
          {"tolerance", run.tolerance},
          {"max_iterations", run.max_iterations},
          {"symmetry", run.symmetry},
          {"certified_faces", optional_json(settings.certified_faces)},
          {"second_family", second}};
}

Json json_of(const Entry& entry) {
  Json result{{"shape", entry.shape.name},
              {"functional", entry.functional.name},
              {"status", std::string(name_of(entry.status))},
              {"energy", entry.energy},
              {"error", optional_json(entry.error)}};
  if (!entry.reason.empty()) result["reason"] = entry.reason;
  result["paper"] = optional_json(entry.paper);
  result["exact"] = entry.exact ? Json(entry.exact->energy) : Json(nullptr);
  if (entry.exact) {
    result["exact_error"] = entry.exact->error;
    result["exact_source"] = entry.exact->source;
  }
  result["group"] = json_of(entry.group);
  result["settings"] = json_of(entry.settings);
  result["energies"] = json_of(entry.energies);
  result["quadrature_error"] = entry.energies.quadrature_error;
  result["levels"] = timeless(entry.levels);
  result["extrapolated"] = json_of(entry.limit);
  result["certificate"] = entry.certificate ? json_of(*entry.certificate) : Json(nullptr);
  result["second_family"] = entry.second ? json_of(*entry.second, entry.limit) : Json(nullptr);
  const bool found = entry.status != EntryStatus::kNoneFound;
  result["minimizer"] = found ? Json(entry_name(entry.shape, entry.functional) + ".json") : Json(nullptr);
  result["level"] = entry.result.level;
  result["faces"] = entry.result.patches;
  return result;
}

Json json_of(const StartResult& start) {
  return {{"shape", start.start.shape},         {"functional", start.start.functional},
          {"thickness", start.start.thickness}, {"energy", start.last.energy_reported},
          {"level", start.last.level},          {"stop", std::string(name_of(start.last.stop))}};
}

Json minimizer_json(const Entry& entry) {
  Json points = Json::array();
  for (Eigen::Index i = 0; i < entry.orbit_points.size(); ++i) points.push_back(entry.orbit_points.data()[i]);
  return {{"shape", entry.shape.name},
          {"functional", entry.functional.name},
          {"cage", cage_json(entry.shape, entry.settings.cage)},
          {"level", entry.result.level},
          {"group", entry.group.name},
          {"points", std::move(points)}};
}

Json empty_catalog(std::string_view version) {
  Json functionals = Json::array(), shapes = Json::array();
  for (const CatalogFunctional& f : catalog_functionals()) {
    functionals.push_back({{"name", f.name}, {"weights", json_of(f.weights)}});
  }
  for (const CatalogShape& s : catalog_shapes()) {
    shapes.push_back({{"name", s.name},
                      {"genus", s.genus},
                      {"junctions", s.junctions},
                      {"arms", s.arms},
                      {"cage", cage_json(s, {})}});
  }
  return {{"version", std::string(version)},
          {"functionals", functionals},
          {"shapes", shapes},
          {"entries", Json::array()},
          {"starts", Json::array()}};
}

double reproducibility(const Json& entry) {
  return all_converged(entry.at("levels")) ? kConvergedReproducibility : kOtherReproducibility;
}

std::string difference(const Json& stored, const Json& again) {
  if (stored.at("status") != again.at("status")) {
    return fmt::format("was {}, is {}", stored.at("status").get<std::string>(), again.at("status").get<std::string>());
  }
  if (stored.at("group") != again.at("group")) return "another symmetry group";
  if (stored.at("levels").size() != again.at("levels").size()) return "another number of levels";
  return energy_difference(again.at("levels").back().at("energy_reported"),
                           stored.at("levels").back().at("energy_reported"),
                           std::max(reproducibility(stored), reproducibility(again)));
}

std::string start_difference(const Json& stored, const Json& again) {
  if (stored.at("level") != again.at("level")) return "another level";
  const bool converged = stored.at("stop") == "converged" && again.at("stop") == "converged";
  return energy_difference(again.at("energy"), stored.at("energy"),
                           converged ? kConvergedReproducibility : kOtherReproducibility);
}

std::string misfit(const Json& entry, const Json& minimizer) {
  const Json& cage = minimizer.at("cage");
  const CageOptions options{.family = cage.at("family") == "hub" ? FrameFamily::kHub : FrameFamily::kFlag,
                            .thickness = cage.at("thickness")};
  const Result<Cage> coarse = generate_cage(cage.at("generator").get<std::string>(), options);
  if (!coarse) return coarse.error().message;
  const std::vector<double> numbers = minimizer.at("points");
  if (numbers.size() % 3 != 0) return "its points have not three coordinates each";
  const Points points = Eigen::Map<const Points>(numbers.data(), static_cast<Eigen::Index>(numbers.size() / 3), 3);
  const Result<SymmetricCage> surface = symmetric_cage(*coarse, minimizer.at("level"), points);
  if (!surface) return surface.error().message;
  RunOptions still{.weights = functional_called(entry.at("functional").get<std::string>()).weights, .last_level = 0};
  const Result<Run> run = Run::create(*surface, still);
  if (!run) return run.error().message;
  const Json energies = json_of(run->energies());
  for (const auto& [name, stored] : entry.at("energies").items()) {
    const std::string what = energy_difference(energies.at(name), stored, kSurfaceReproducibility, kSurfaceFloor);
    if (!what.empty()) return fmt::format("{} of the stored surface: {}", name, what);
  }
  return "";
}

}  // namespace umbilic
