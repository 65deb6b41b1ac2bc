// SPDX-License-Identifier: MIT
/// \file
/// `umbilic check-gradient`: whether the analytic gradient is the derivative of the energy.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/json_report.h"
#include "cli/tables.h"
#include "driver/run.h"

namespace umbilic {

namespace {

struct CheckGradientArguments {
  std::string cage;
  Objective objective;
  CapKind cap = CapKind::kSmooth;
  bool json = false;
};

std::string json(const CageFile& input, const CheckGradientArguments& arguments, const GradientReport& gradient) {
  Json report = json_report(input);
  add_objective(report, arguments.objective);
  add_cap(report, arguments.cap);
  add_gradient(report, gradient);
  return to_text(report);
}

std::string table(const CageFile& input, const CheckGradientArguments& arguments, const GradientReport& gradient) {
  return input_line(input) +
         fmt::format("gradient of {} at level {}, cap {}: {} unknowns, {} random directions\n",
                     arguments.objective.words(), gradient.level, name_of(arguments.cap), gradient.unknowns,
                     gradient.directions) +
         fmt::format("  analytic derivative    {:>24.16g}   in the worst direction\n", gradient.analytic) +
         fmt::format("  central difference     {:>24.16g}\n", gradient.difference) +
         fmt::format("  relative mismatch      {:>24.3e}   {} {:.0e}: {}\n", gradient.relative_mismatch,
                     gradient.ok ? "<=" : ">", gradient.tolerance, gradient.ok ? "ok" : "mismatch");
}

int run(const CheckGradientArguments& arguments) {
  const auto input = load_cage(arguments.cage);
  if (!input) return fail(kBadInput, input.error().message);
  const auto gradient = check_gradient(input->cage, arguments.objective.weights, arguments.cap);
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
  add_objective_options(*command, arguments->objective);
  add_cap_option(*command, arguments->cap);
  add_json_flag(*command, arguments->json);
  command->footer(functional_help());
  command->callback([arguments, &exit_code] {
    require_objective(arguments->objective);
    exit_code = run(*arguments);
  });
}

}  // namespace umbilic
