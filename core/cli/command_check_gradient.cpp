// SPDX-License-Identifier: MIT
/// \file
/// `umbilic check-gradient`: whether the analytic gradient is the derivative of the energy.
#include <fmt/format.h>

#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/documents.h"
#include "cli/exit_code.h"
#include "cli/files.h"
#include "cli/tables.h"
#include "cli/version.h"
#include "driver/run.h"

namespace umbilic::cli {

namespace {

struct CheckGradientArguments {
  std::string cage;
  Weights terms{};
  CapChoice cap;
  bool json = false;
};

std::string json(const CageFile& input, const CheckGradientArguments& arguments, const GradientReport& gradient) {
  const GradientDocument document{std::string(version()),   input.report, arguments.terms, arguments.cap,
                                  arguments.cap.most_rings, gradient};
  return document_text("gradient", document, JsonPrinter::Layout::kIndented);
}

std::string table(const CageFile& input, const CheckGradientArguments& arguments, const GradientReport& gradient) {
  return input_line(input.name, input.report) +
         fmt::format("gradient of {} at level {}, cap {}: {} unknowns, {} random directions\n", words(arguments.terms),
                     gradient.level, name_of(arguments.cap), gradient.unknowns, gradient.directions) +
         fmt::format("  analytic derivative    {:>24.16g}   in the worst direction\n", gradient.analytic) +
         fmt::format("  central difference     {:>24.16g}\n", gradient.difference) +
         fmt::format("  relative mismatch      {:>24.3e}   {} {:.0e}: {}\n", gradient.relative_mismatch,
                     gradient.ok ? "<=" : ">", gradient.tolerance, gradient.ok ? "ok" : "mismatch");
}

int run(const CheckGradientArguments& arguments) {
  const auto input = load_cage(arguments.cage);
  if (!input) return fail(kBadInput, input.error().message);
  const auto gradient = check_gradient(input->cage, arguments.terms, arguments.cap);
  if (!gradient) return fail(kBadInput, fmt::format("{}: {}", input->name, gradient.error().message));
  const std::string text = arguments.json ? json(*input, arguments, *gradient) : table(*input, arguments, *gradient);
  if (!print(text)) return kCannotWrite;
  return gradient->ok ? kEnded : kMismatch;
}

}  // namespace

void add_check_gradient_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "check-gradient", "Compare the analytic gradient with differences of the energy; exit code 1 on a mismatch");
  const auto arguments = std::make_shared<CheckGradientArguments>();
  add_cage_argument(*command, arguments->cage);
  add_terms_options(*command, arguments->terms);
  add_cap_options(*command, arguments->cap);
  add_json_flag(*command, arguments->json);
  command->footer(functional_help());
  command->callback([arguments, &exit_code] {
    require_terms(arguments->terms);
    exit_code = run(*arguments);
  });
}

}  // namespace umbilic::cli
