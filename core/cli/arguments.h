// SPDX-License-Identifier: MIT
/// \file
/// Arguments that several commands share, and their parsing.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/result.h"
#include "energy/functional.h"
#include "problem/metric_choice.h"
#include "surface/cap_kind.h"

namespace umbilic::cli {

/// CAGE, required.
void add_cage_argument(CLI::App& command, std::string& path);

/// --cap and --cap-rings; `cap` holds the defaults.
void add_cap_options(CLI::App& command, CapChoice& cap);

/// The members of a problem's options, described for help texts.
extern const char* const kFunctionalWords;
extern const char* const kWeightsWords;
extern const char* const kCapWords;
extern const char* const kCapRingsWords;

Result<CapKind> parse_cap(const std::string& name);
Result<int> parse_cap_rings(const std::string& text);
Result<MetricChoice> parse_metric(const std::string& name);

/// --instruction-set; takes effect before the command runs.
void add_instruction_set_option(CLI::App& app);

/// --threads; `threads` holds the default.
void add_threads_option(CLI::App& command, int& threads);

/// --json.
void add_json_flag(CLI::App& command, bool& json);

/// The terms whose sum is minimized: "bending", or "0.95 bending + 0.05 mvs_cross".
std::string words(const Weights& weights);

/// --functional and --weights, not both.
void add_terms_options(CLI::App& command, Weights& weights);

/// Ends parsing with an error if neither was given.
void require_terms(const Weights& weights);

/// Rejects an argument with the error that `parse` returns for it.
template <class Parse>
CLI::Validator checked(Parse parse) {
  return {[parse](std::string& text) {
            const auto result = parse(text);
            return result ? std::string() : result.error().message;
          },
          ""};
}

/// Parses an argument as a number: independently of the locale, without trailing text, finite.
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

}  // namespace umbilic::cli
