// SPDX-License-Identifier: MIT
/// \file
/// Arguments that several commands share, and how they are read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/result.h"
#include "energy/functional.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// CAGE, required.
void add_cage_argument(CLI::App& command, std::string& path);

/// --cap; `cap` holds the default.
void add_cap_option(CLI::App& command, CapKind& cap);

/// --instruction-set; takes effect before the command runs.
void add_instruction_set_option(CLI::App& app);

/// --json.
void add_json_flag(CLI::App& command, bool& json);

/// "none", "flat", "smooth".
std::string_view name_of(CapKind cap);

/// What a run minimizes, as the user named it.
struct Objective {
  std::string functional;  ///< empty when weights were given
  Weights weights{};

  /// "bending", or "0.95 bending + 0.05 mvs_cross".
  std::string words() const;
};

/// --functional and --weights, not both.
void add_objective_options(CLI::App& command, Objective& objective);

/// Ends parsing with an error where neither was given.
void require_objective(const Objective& objective);

/// Refuses an argument with the message of the Result that `parse` makes of it.
template <class Parse>
CLI::Validator checked(Parse parse) {
  return {[parse](std::string& text) {
            const auto result = parse(text);
            return result ? std::string() : result.error().message;
          },
          ""};
}

/// Numbers as arguments: no locale, nothing behind them, nothing infinite.
Result<int> parse_count(std::string_view text, int least, int most);
Result<double> parse_real(std::string_view text);

inline constexpr int kMostLevels = 20;

struct LevelRange {
  int first = 0;
  int last = 0;
};

/// "A..B" or "A", as numbers of Catmull-Clark steps.
Result<LevelRange> parse_levels(std::string_view text);

/// The formulas of the functionals, for help texts.
std::string functional_help();

}  // namespace umbilic
