// SPDX-License-Identifier: MIT
/// \file
/// `umbilic torus`: the energies of tori of revolution in closed form, and the ratio that minimizes a blend.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "cage/text.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/documents.h"
#include "cli/exit_code.h"
#include "cli/version.h"
#include "energy/torus.h"

namespace umbilic::cli {

namespace {

struct TorusArguments {
  std::optional<double> ratio;
  Weights terms{};
  bool json = false;
};

/// A line of the table.
struct Row {
  double ratio;  ///< 0 for the limit of thin tori
  std::string note;
};

constexpr double kTableStep = 0.05;
constexpr int kTableRows = 19;

/// Energies at a ratio; for ratio 0 the limits of thin tori, where bending and Willmore are infinite.
std::array<double, kFunctionalCount> energies_at(double ratio) {
  if (ratio > 0) return torus_energies(ratio);
  std::array<double, kFunctionalCount> limits = torus_energies(std::numeric_limits<double>::min());
  limits[kBending] = limits[kWillmore] = std::numeric_limits<double>::infinity();
  limits[kCurvednessVariation] = 0;
  return limits;
}

std::vector<Row> rows_of(const TorusArguments& arguments, const std::optional<TorusMinimizer>& minimizer) {
  std::vector<Row> rows;
  if (arguments.ratio) {
    rows.push_back({*arguments.ratio, ""});
  } else {
    rows.push_back({0, "limit of thin tori, 8 pi^4 for mvs_cross"});
    for (int i = 1; i <= kTableRows; ++i) rows.push_back({kTableStep * i, ""});
    rows.push_back({std::numbers::sqrt2 / 2, "Clifford torus"});
  }
  if (minimizer && minimizer->attained && std::isfinite(minimizer->ratio)) {
    rows.push_back({minimizer->ratio, "minimizes " + words(arguments.terms)});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.ratio < b.ratio; });
  return rows;
}

std::string minimizer_line(const TorusMinimizer& minimizer, const std::string& objective) {
  if (std::isnan(minimizer.ratio)) return fmt::format("{} is {:.10g} on every torus\n", objective, minimizer.energy);
  if (minimizer.attained) {
    return fmt::format("{} is least, {:.12g}, at r/R = {:.12g}\n", objective, minimizer.energy, minimizer.ratio);
  }
  return fmt::format("{} has the infimum {:.12g} as r/R -> 0, which no torus attains\n", objective, minimizer.energy);
}

std::string table(const TorusArguments& arguments, const std::optional<TorusMinimizer>& minimizer) {
  std::string text = fmt::format("{:>8} {:>12} {:>12} {:>4} {:>14} {:>14} {:>22} {:>24} {:>20}\n", "r/R", "bending",
                                 "willmore", "mvs", "mvs_cross", "mehlum_tarrou", "second_form_variation",
                                 "mean_curvature_variation", "curvedness_variation");
  for (const Row& row : rows_of(arguments, minimizer)) {
    const auto e = energies_at(row.ratio);
    text += fmt::format("{:>8.4f} {:>12.8g} {:>12.8g} {:>4.8g} {:>14.10g} {:>14.10g} {:>22.10g} {:>24.10g} {:>20.10g}",
                        row.ratio, e[kBending], e[kWillmore], e[kMvs], e[kMvsCross], e[kMehlumTarrou],
                        e[kSecondFormVariation], e[kMeanCurvatureVariation], e[kCurvednessVariation]);
    text += row.note.empty() ? "\n" : fmt::format("  {}\n", row.note);
  }
  if (minimizer) text += minimizer_line(*minimizer, words(arguments.terms));
  return text;
}

std::string json(const TorusArguments& arguments, const std::optional<TorusMinimizer>& minimizer) {
  ToriDocument document{.program = std::string(version())};
  for (const Row& row : rows_of(arguments, minimizer)) document.tori.push_back({row.ratio, {energies_at(row.ratio)}});
  if (minimizer) {
    document.terms = arguments.terms;
    document.minimizer = minimizer;
  }
  return document_text("tori", document, JsonPrinter::Layout::kIndented);
}

int run(const TorusArguments& arguments) {
  std::optional<TorusMinimizer> minimizer;
  if (arguments.terms != Weights{}) minimizer = torus_minimizer(arguments.terms);
  return print(arguments.json ? json(arguments, minimizer) : table(arguments, minimizer)) ? kEnded : kCannotWrite;
}

Result<double> parse_ratio(const std::string& text) {
  const Result<double> number = parse_real(text);
  if (number && (*number <= 0 || *number >= 1)) return Error{fmt::format("{} is not between 0 and 1", in_quotes(text))};
  return number;
}

}  // namespace

void add_torus_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("torus", "Print the exact energies of tori of revolution, and the ratio of least energy");
  const auto arguments = std::make_shared<TorusArguments>();
  command
      ->add_option_function<std::string>(
          "--ratio", [arguments](const std::string& text) { arguments->ratio = parse_ratio(text).value(); },
          "Of this torus only: the tube's radius r over the radius R of its centre line")
      ->type_name("A")
      ->check(checked(parse_ratio));
  add_terms_options(*command, arguments->terms);
  add_json_flag(*command, arguments->json);
  command->footer(functional_help());
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace umbilic::cli
