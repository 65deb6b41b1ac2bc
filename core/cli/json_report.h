// SPDX-License-Identifier: MIT
/// \file
/// Reports as JSON: every command prints a part of one object. Numbers that are not finite become null.
#pragma once

#include <string>
#include <vector>

#include "catalog/report_json.h"
#include "cli/arguments.h"
#include "cli/files.h"
#include "problem/report.h"

namespace umbilic {

/// {"version", "input": {"vertices", "edges", "faces", "components", "genus", "valences", "face_sizes",
/// "first_level"}}; first_level is null when the cage has no surface that can be evaluated.
Json json_report(const CageFile& input);

/// Adds "functional" or "weights".
void add_objective(Json& report, const Objective& objective);
void add_cap(Json& report, CapKind cap);
/// Adds "energies", "quadrature_error", "whole", "below_bound" and "embedded".
void add_energies(Json& report, const EnergyReport& energies);
/// Adds "levels", and as "result_level" the number of the one whose surface is the result.
void add_levels(Json& report, const std::vector<LevelReport>& levels, const LevelReport& result);
/// Adds "group".
void add_group(Json& report, const GroupReport& group);
/// Adds "extrapolated".
void add_limit(Json& report, const LimitReport& limit);
/// Adds "certificate".
void add_certificate(Json& report, const CertificateReport& certificate);
void add_levels(Json& report, const EvaluationReport& evaluation);
/// Adds "levels" and "gradient".
void add_gradient(Json& report, const GradientReport& gradient);

/// Indented text with all digits that numbers need.
std::string to_text(const Json& report);

}  // namespace umbilic
