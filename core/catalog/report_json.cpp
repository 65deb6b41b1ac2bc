// SPDX-License-Identifier: MIT
/// \file
/// The keys.
#include "catalog/report_json.h"

namespace umbilic {

Json json_of(const Weights& weights) {
  Json result = Json::object();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] != 0) result[std::string(kFunctionalNames[i])] = weights[i];
  }
  return result;
}

Json json_of(const GroupReport& group) { return {{"name", group.name}, {"order", group.order}}; }

Json json_of(const EnergyReport& energies) {
  Json values = Json::object();
  for (std::size_t i = 0; i < energies.functionals.size(); ++i) {
    values[std::string(kFunctionalNames[i])] = energies.functionals[i];
  }
  values["area"] = energies.area;
  values["gaussian"] = energies.gaussian;
  return values;
}

Json json_of(const LimitReport& limit) {
  return {{"status", std::string(name_of(limit.status))},
          {"energy", limit.energy},
          {"order", limit.order},
          {"error", limit.error},
          {"lower", limit.lower}};
}

Json json_of(const CertificateReport& certificate) {
  return {{"level", certificate.level},
          {"unknowns", certificate.unknowns},
          {"gauge", certificate.gauge},
          {"tau", certificate.tau},
          {"negative", certificate.negative}};
}

Json json_of(const LevelReport& level) {
  Json result{{"level", level.level},
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
              {"evaluable", level.evaluable}};
  if (level.quadrature > 0) result["quadrature"] = level.quadrature;
  if (!level.credible) result["credible"] = false;
  if (level.thickened) result["thickened"] = true;
  return result;
}

Json json_of(const std::vector<LevelReport>& levels) {
  Json all = Json::array();
  for (const LevelReport& level : levels) all.push_back(json_of(level));
  return all;
}

}  // namespace umbilic
