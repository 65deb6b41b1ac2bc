// SPDX-License-Identifier: MIT
/// \file
/// The shape of the JSON reports.
#include "cli/json_report.h"

#include "base/instruction_set.h"
#include "cli/cage_shape.h"
#include "cli/version.h"

namespace umbilic {

namespace {

Json json_histogram(const std::map<int, int>& histogram) {
  Json counts = Json::object();
  for (const auto& [size, count] : histogram) counts[std::to_string(size)] = count;
  return counts;
}

}  // namespace

Json json_report(const CageFile& input) {
  const CageShape shape = shape_of(input.cage);
  Json components = Json::array();
  for (const CageComponent& c : input.report.components) {
    components.push_back({{"genus", c.genus}, {"vertices", c.vertices}, {"edges", c.edges}, {"faces", c.faces}});
  }
  return {{"version", std::string(version())},
          {"input",
           {{"vertices", input.report.vertices},
            {"edges", input.report.edges},
            {"faces", input.report.faces},
            {"components", components},
            {"genus", input.report.genus},
            {"valences", json_histogram(shape.valences)},
            {"face_sizes", json_histogram(shape.face_sizes)},
            {"first_level", shape.first_level ? Json(*shape.first_level) : Json(nullptr)}}}};
}

void add_objective(Json& report, const Objective& objective) {
  if (!objective.functional.empty()) {
    report["functional"] = objective.functional;
    return;
  }
  Json weights = Json::object();
  for (std::size_t i = 0; i < objective.weights.size(); ++i) {
    if (objective.weights[i] != 0) weights[std::string(kFunctionalNames[i])] = objective.weights[i];
  }
  report["weights"] = weights;
}

void add_cap(Json& report, CapKind cap) { report["cap"] = std::string(name_of(cap)); }

void add_energies(Json& report, const EnergyReport& energies) {
  Json values = Json::object();
  for (std::size_t i = 0; i < energies.functionals.size(); ++i) {
    values[std::string(kFunctionalNames[i])] = energies.functionals[i];
  }
  values["area"] = energies.area;
  values["gaussian"] = energies.gaussian;
  report["instruction_set"] = std::string(name_of(instruction_set()));
  report["energies"] = values;
  report["quadrature_error"] = energies.quadrature_error;
}

void add_levels(Json& report, const std::vector<LevelReport>& levels) {
  Json all = Json::array();
  for (const LevelReport& level : levels) {
    all.push_back({{"level", level.level},
                   {"patches", level.patches},
                   {"unknowns", level.unknowns},
                   {"energy", level.energy},
                   {"energy_reported", level.energy_reported},
                   {"iterations", level.iterations},
                   {"evaluations", level.evaluations},
                   {"seconds", level.seconds},
                   {"stop", std::string(name_of(level.stop))},
                   {"metric", std::string(level.metric)},
                   {"metrics", level.metrics},
                   {"evaluable", level.evaluable}});
  }
  report["levels"] = all;
}

void add_group(Json& report, const GroupReport& group) {
  report["group"] = {{"name", group.name}, {"order", group.order}};
}

void add_limit(Json& report, const LimitReport& limit) {
  report["extrapolated"] = {{"status", std::string(name_of(limit.status))},
                            {"energy", limit.energy},
                            {"order", limit.order},
                            {"error", limit.error}};
}

void add_certificate(Json& report, const CertificateReport& certificate) {
  report["certificate"] = {{"level", certificate.level},
                           {"unknowns", certificate.unknowns},
                           {"gauge", certificate.gauge},
                           {"tau", certificate.tau},
                           {"negative", certificate.negative}};
}

void add_levels(Json& report, const EvaluationReport& evaluation) {
  report["levels"] = Json::array({{{"level", evaluation.level}, {"patches", evaluation.patches}}});
}

void add_gradient(Json& report, const GradientReport& gradient) {
  report["levels"] = Json::array({{{"level", gradient.level}, {"unknowns", gradient.unknowns}}});
  report["gradient"] = {{"directions", gradient.directions}, {"analytic", gradient.analytic},
                        {"difference", gradient.difference}, {"relative_mismatch", gradient.relative_mismatch},
                        {"tolerance", gradient.tolerance},   {"ok", gradient.ok}};
}

std::string to_text(const Json& report) { return report.dump(2) + "\n"; }

}  // namespace umbilic
