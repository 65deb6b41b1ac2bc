// SPDX-License-Identifier: MIT
/// \file
/// Reports as tables for human readers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/report.h"

namespace umbilic::cli {

/// One line: the cage's name, counts and genus; and one for each repair.
std::string input_line(std::string_view name, const CageReport& cage);

/// All energies, with the ratios that are a topological constant or a sphere's energy, the quadrature error of
/// `objective`, and what the rounding of the input does to them, where that shows.
std::string energy_table(const EnergyReport& energies, const std::string& objective);

/// "symmetry D3h, order 12".
std::string group_words(const GroupReport& group);
/// What the energies prove of the surface, or why they are not to be believed; empty where there is nothing to say.
std::string credibility_lines(const EnergyReport& energies);
/// The invariants that are no functionals; empty where the report does not have them.
std::string invariants_table(const EnergyReport& energies);
/// What another way of computing finds; empty where none was asked for.
std::string opinion_table(const std::optional<OpinionReport>& opinion);
/// "energies of the last level", or of the level that is better.
/// What constraints do to the surface; lengths in the units of the file.
std::string constraints_table(const ConstraintsReport& report);
std::string result_line(const std::vector<LevelReport>& levels, const LevelReport& result);
/// The limit with its error bar, or why there is none.
std::string limit_line(const LimitReport& limit);

/// How well the limit is known, where an accuracy was asked for: "3913, within 0.8 %".
std::string accuracy_line(const LimitReport& limit, double accuracy);
/// "2 directions lower the energy".
std::string descent_words(const CertificateReport& certificate);
/// Whether the surface is a local minimum. `group` is the symmetry that the run kept.
std::string certificate_line(const CertificateReport& certificate, const GroupReport& group);

std::string level_table(const std::vector<LevelReport>& levels);

}  // namespace umbilic::cli
