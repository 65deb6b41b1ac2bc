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
  } else {
    report["weights"] = json_of(objective.weights);
  }
}

void add_cap(Json& report, CapKind cap) { report["cap"] = std::string(name_of(cap)); }

void add_energies(Json& report, const EnergyReport& energies) {
  report["instruction_set"] = std::string(name_of(instruction_set()));
  report["energies"] = json_of(energies);
  report["quadrature_error"] = energies.quadrature_error;
  report["whole"] = energies.whole;
  report["below_bound"] = energies.below_bound;
  report["embedded"] = energies.embedded;
}

void add_levels(Json& report, const std::vector<LevelReport>& levels, const LevelReport& result) {
  report["result_level"] = result.level;
  report["levels"] = json_of(levels);
}
void add_group(Json& report, const GroupReport& group) { report["group"] = json_of(group); }
void add_limit(Json& report, const LimitReport& limit) { report["extrapolated"] = json_of(limit); }

void add_certificate(Json& report, const CertificateReport& certificate) {
  report["certificate"] = json_of(certificate);
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
