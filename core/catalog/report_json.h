// SPDX-License-Identifier: MIT
/// \file
/// Reports of runs as parts of JSON objects, the same for the catalog and the command line. Numbers that are not finite
/// become null.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "problem/report.h"

namespace umbilic {

/// Keeps its keys in the order in which they were added.
using Json = nlohmann::ordered_json;

/// {"bending": 1}: those that are not 0.
Json json_of(const Weights& weights);
/// {"name", "order"}.
Json json_of(const GroupReport& group);
/// The functionals, "area", "gaussian"; not the quadrature error.
Json json_of(const EnergyReport& energies);
Json json_of(const LimitReport& limit);
Json json_of(const CertificateReport& certificate);
Json json_of(const LevelReport& level);
Json json_of(const std::vector<LevelReport>& levels);

}  // namespace umbilic
