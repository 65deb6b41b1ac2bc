// SPDX-License-Identifier: MIT
/// \file
/// Converts entries to JSON.
#include "catalog/catalog_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/instruction_set.h"
#include "driver/level.h"
#include "problem/cage_of.h"
#include "problem/text.h"

namespace umbilic::catalog {
namespace {

template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Removes the seconds, which differ in every run.
std::vector<LevelReport> without_times(std::vector<LevelReport> levels) {
  for (LevelReport& level : levels) level.seconds = std::numeric_limits<double>::quiet_NaN();
  return levels;
}

Json json_of(const SecondFamily& second, const LimitReport& first) {
  return {{"family", std::string(name_of(second.family))},
          {"energy", second.limit.energy},
          {"error", second.limit.error},
          {"status", std::string(name_of(second.limit.status))},
          {"agrees", optional_json(agree(first, second.limit))},
          {"levels", part_json(without_times(second.levels))}};
}

std::string file_of(const Entry& entry, std::string_view suffix = "") {
  return fmt::format("{}{}.json", entry_name(entry.shape, entry.functional), suffix);
}

constexpr std::string_view kBelow = ".below";

Json json_of(const LowerMinimizer& below, const Entry& entry) {
  return {{"energy", below.result.energy_reported},
          {"group", part_json(below.group)},
          {"level", below.result.level},
          {"faces", below.result.patches},
          {"certificate", below.certificate ? part_json(*below.certificate) : Json(nullptr)},
          {"minimizer", file_of(entry, kBelow)}};
}

/// What the second opinion says of the minimized functional, the difference relative to it.
Json json_of(const OpinionReport& opinion, const Weights& weights) {
  double energy = 0, difference = 0;
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (weights[i] == 0) continue;
    energy += weights[i] * opinion.values.functionals[i];
    difference += weights[i] * opinion.differences.functionals[i];
  }
  return {{"energy", energy}, {"difference", difference / std::max(std::abs(energy), kEnergyFloor)}};
}

}  // namespace

std::string entry_name(const CatalogShape& shape, const CatalogFunctional& functional) {
  return shape.name + "." + functional.name;
}

Json json_of(const EntrySettings& settings) {
  const RunOptions& run = settings.run;
  Json second = nullptr;
  if (settings.second_family) {
    second = {{"family", std::string(name_of(*settings.second_family))},
              {"levels", {run.first_level, settings.second_last_level}}};
  }
  Json result = part_json(run);
  result["certified_faces"] = optional_json(settings.certified_faces);
  if (settings.descends) result["descends"] = true;
  result["second_family"] = second;
  return result;
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
  result["group"] = part_json(entry.group);
  result["settings"] = json_of(entry.settings);
  result["energies"] = part_json(entry.energies);
  result["second_opinion"] = json_of(entry.second_opinion, entry.functional.weights);
  result["levels"] = part_json(without_times(entry.levels));
  result["limit"] = part_json(entry.limit);
  result["certificate"] = entry.certificate ? part_json(*entry.certificate) : Json(nullptr);
  if (entry.below) result["below"] = json_of(*entry.below, entry);
  result["second_family"] = entry.second ? json_of(*entry.second, entry.limit) : Json(nullptr);
  const bool found = entry.status != EntryStatus::kNoneFound;
  result["minimizer"] = found ? Json(file_of(entry)) : Json(nullptr);
  result["level"] = entry.result.level;
  result["faces"] = entry.result.patches;
  return result;
}

Json json_of(const StartResult& start) {
  return {{"shape", start.start.shape},
          {"functional", start.start.functional},
          {"thickness", start.start.thickness},
          {"energy", start.last.energy_reported},
          {"level", start.last.level},
          {"stop", std::string(name_of(start.last.stop))},
          {"instruction_set", std::string(name_of(instruction_set()))}};
}

/// The levels up to that of the minimizer that is shown.
std::vector<LevelReport> levels_to_the_shown(const Entry& entry) {
  std::vector<LevelReport> levels = without_times(entry.levels);
  if (entry.settings.shown_level) {
    std::erase_if(levels, [&](const LevelReport& level) { return level.level > entry.result.level; });
  }
  return levels;
}

/// What reports of the entry's runs have in common.
Report report_on(const Entry& entry, std::string_view version) {
  Report report;
  report.program = version;
  report.instruction_set = name_of(instruction_set());
  report.problem.cage = GeneratedCage{entry.shape.generator, entry.settings.cage};
  report.problem.options = entry.settings.run;
  report.problem.constraints = entry.settings.constraints;
  report.cage = cage_of(report.problem.cage).value().report;
  return report;
}

std::string minimizer_text(const Entry& entry, std::string_view version) {
  Report report = report_on(entry, version);
  report.group = entry.group;
  report.levels = levels_to_the_shown(entry);
  if (entry.settings.shown_level) report.problem.options.last_level = entry.result.level;
  report.limit = entry.limit;
  report.energies = entry.energies;
  report.second_opinion = entry.second_opinion;
  report.constraints = entry.constraints;
  report.certificate = entry.certificate;
  report.surface = SurfaceState{entry.result.level, entry.orbit_points};
  return report_text(report, JsonPrinter::Layout::kCompact);
}

std::optional<std::string> below_text(const Entry& entry, std::string_view version) {
  if (!entry.below) return std::nullopt;
  Report report = report_on(entry, version);
  report.problem.options.last_level = entry.below->result.level;
  report.group = entry.below->group;
  report.levels = without_times({entry.below->result});
  report.energies = entry.below->energies;
  report.certificate = entry.below->certificate;
  report.surface = SurfaceState{entry.below->result.level, entry.below->orbit_points};
  return report_text(report, JsonPrinter::Layout::kCompact);
}

Json empty_catalog(std::string_view version) {
  Json functionals = Json::array(), shapes = Json::array();
  for (const CatalogFunctional& f : catalog_functionals()) {
    functionals.push_back({{"name", f.name}, {"weights", part_json(f.weights)}});
  }
  for (const CatalogShape& s : catalog_shapes()) {
    Json shape{{"name", s.name}, {"genus", s.genus}, {"junctions", s.junctions}, {"arms", s.arms}};
    if (s.hole()) shape["sides"] = s.sides;
    shape["cage"] = part_json(GeneratedCage{s.generator, cage_options(s)});
    if (s.hole()) shape["constraints"] = part_json(constraints_of(s));
    shapes.push_back(std::move(shape));
  }
  return {{"version", std::string(version)},
          {"functionals", functionals},
          {"shapes", shapes},
          {"entries", Json::array()},
          {"starts", Json::array()}};
}

}  // namespace umbilic::catalog
