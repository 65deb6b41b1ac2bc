// SPDX-License-Identifier: MIT
/// \file
/// Definitions and formulas of the shared arguments.
#include "cli/arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/instruction_set.h"
#include "base/threads.h"
#include "cage/text.h"
#include "problem/members.h"

namespace umbilic::cli {

namespace {

/// The enumerator with this name.
template <class E>
Result<E> called(const std::string& name) {
  const auto names = names_of<E>();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return Error{fmt::format("{} is none of {}", in_quotes(name), fmt::join(names, ", "))};
  return static_cast<E>(found - names.begin());
}

/// Weights with 1 for one functional and 0 for the others.
Weights single(int functional) {
  Weights weights{};
  weights[functional] = 1;
  return weights;
}

}  // namespace

const char* const kFunctionalWords = "The functional, see below";
const char* const kWeightsWords = "Or a weighted sum of functionals, as in bending=0.95,mvs_cross=0.05";
const char* const kCapWords =
    "Surface near extraordinary vertices: smooth (polynomial, energies converge),\n"
    "flat (the tangent plane, as Joshi & Sequin 2007) or none (the limit surface itself,\n"
    "where third-order energies diverge) [smooth]";

const char* const kCapRingsWords =
    "The most rings of faces that a smooth cap takes: 1, 2, 4, 8 or 16; two widths\n"
    "tell how much an energy depends on it. More than 4 are for coarse cages [4]";

Result<CapKind> parse_cap(const std::string& name) { return called<CapKind>(name); }
Result<int> parse_cap_rings(const std::string& text) {
  for (int rings = 1; rings <= kMostCapRings; rings *= 2) {
    if (text == std::to_string(rings)) return rings;
  }
  return Error{fmt::format("{} is none of 1, 2, 4, 8, 16", in_quotes(text))};
}
Result<MetricChoice> parse_metric(const std::string& name) { return called<MetricChoice>(name); }

void add_cage_argument(CLI::App& command, std::string& path) {
  command.add_option("CAGE", path, "OBJ, OFF or PLY file of a polygon mesh, or - for standard input")
      ->required()
      ->type_name("");
}

void add_cap_options(CLI::App& command, CapChoice& cap) {
  command
      .add_option_function<std::string>(
          "--cap", [&cap](const std::string& name) { cap.kind = parse_cap(name).value(); }, kCapWords)
      ->type_name("CAP")
      ->check(checked(parse_cap));
  command
      .add_option_function<std::string>(
          "--cap-rings", [&cap](const std::string& text) { cap.most_rings = parse_cap_rings(text).value(); },
          kCapRingsWords)
      ->type_name("R")
      ->check(checked(parse_cap_rings));
}

void add_instruction_set_option(CLI::App& app) {
  app.add_option_function<std::string>(
         "--instruction-set", [](const std::string& name) { use_instruction_set(parse_instruction_set(name).value()); },
         "Kernels that compute: portable, avx2 or avx512; before the command\n[the last one that this processor has]")
      ->type_name("SET")
      ->check(checked(parse_instruction_set));
}

void add_threads_option(CLI::App& command, int& threads) {
  const auto parse = [](const std::string& text) { return parse_count(text, 1, kMostThreads); };
  command
      .add_option_function<std::string>(
          "--threads", [&threads, parse](const std::string& text) { threads = parse(text).value(); },
          "Threads that compute; every number gives the same result [one per processor]")
      ->type_name("N")
      ->check(checked(parse));
}

void add_json_flag(CLI::App& command, bool& json) { command.add_flag("--json", json, "Print JSON instead of a table"); }

std::string words(const Weights& weights) {
  std::string sum;
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (weights == single(i)) return std::string(kFunctionalNames[i]);
    if (weights[i] != 0) sum += fmt::format("{}{} {}", sum.empty() ? "" : " + ", weights[i], kFunctionalNames[i]);
  }
  return sum;
}

void add_terms_options(CLI::App& command, Weights& weights) {
  CLI::Option* functional = command.add_option_function<std::string>(
      "--functional", [&weights](const std::string& name) { weights = weights_of(name).value(); }, kFunctionalWords);
  functional->type_name("NAME")->check(checked([](const std::string& name) { return weights_of(name); }));
  CLI::Option* sum = command.add_option_function<std::string>(
      "--weights", [&weights](const std::string& text) { weights = parse_weights(text).value(); }, kWeightsWords);
  sum->type_name("SUM")->check(checked([](const std::string& text) { return parse_weights(text); }));
  sum->excludes(functional);
}

void require_terms(const Weights& weights) {
  if (weights == Weights{}) throw CLI::RequiredError("--functional or --weights");
}

Result<int> parse_count(std::string_view text, int least, int most) {
  const auto number = parse_integer(text);
  if (number && *number >= least && *number <= most) return static_cast<int>(*number);
  return Error{fmt::format("{} is not an integer from {} to {}", in_quotes(text), least, most)};
}

Result<double> parse_real(std::string_view text) {
  const auto number = parse_number(text);
  if (number && std::isfinite(*number)) return *number;
  return Error{fmt::format("{} is not a number", in_quotes(text))};
}

Result<LevelRange> parse_levels(std::string_view text) {
  const std::size_t dots = text.find("..");
  const Result<int> first = parse_count(text.substr(0, dots), 0, kMostLevels);
  const Result<int> last = dots == std::string_view::npos ? first : parse_count(text.substr(dots + 2), 0, kMostLevels);
  if (first && last && *first <= *last) return LevelRange{*first, *last};
  return Error{fmt::format("{} is not A..B or A with 0 <= A <= B <= {}", in_quotes(text), kMostLevels)};
}

std::string functional_help() {
  return "Functionals: integrals over the surface, with principal curvatures k1 >= k2 along e1, e2, mean curvature H,\n"
         "second fundamental form II and area A. None depends on the surface's size.\n"
         "  bending                   integral of k1^2 + k2^2                             sphere: 8 pi\n"
         "  willmore                  integral of H^2                                     sphere: 4 pi\n"
         "  mvs                       A * integral of (dk1/de1)^2 + (dk2/de2)^2           0 on cyclides\n"
         "  mvs_cross                 A * integral of |grad k1|^2 + |grad k2|^2           0 on spheres\n"
         "  mehlum_tarrou             A * integral of the mean over directions of (dk_n/ds)^2\n"
         "  second_form_variation     A * integral of |grad II|^2\n"
         "  mean_curvature_variation  A * integral of 4 |grad H|^2                        0 on spheres\n"
         "  curvedness_variation      A^2 * integral of |grad (k1^2 + k2^2)/2|^2          0 on spheres";
}

}  // namespace umbilic::cli
