// SPDX-License-Identifier: MIT
/// \file
/// `umbilic evaluate`: the energies of a cage's surface without minimizing it.
#include <fmt/format.h>

#include <memory>

#include "base/instruction_set.h"
#include "base/threads.h"
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

struct EvaluateArguments {
  std::string cage;
  CapChoice cap;
  int levels = 0;
  int threads = hardware_threads();
  bool json = false;
  bool second_opinion = false;
};

std::string json(const CageFile& input, const EvaluateArguments& arguments, const EvaluationReport& evaluation) {
  const EvaluationDocument document{std::string(version()),
                                    std::string(name_of(instruction_set())),
                                    input.report,
                                    arguments.cap,
                                    arguments.cap.most_rings,
                                    evaluation};
  return document_text("evaluation", document, JsonPrinter::Layout::kIndented);
}

int run(const EvaluateArguments& arguments) {
  use_threads(arguments.threads);
  const auto input = load_cage(arguments.cage);
  if (!input) return fail(kBadInput, input.error().message);
  const auto evaluation = evaluate(input->cage, arguments.cap, arguments.levels, arguments.second_opinion);
  if (!evaluation) return fail(kBadInput, fmt::format("{}: {}", input->name, evaluation.error().message));
  const std::string text =
      arguments.json ? json(*input, arguments, *evaluation)
                     : input_line(input->name, input->report) +
                           fmt::format("level {}, {} patches, cap {}\n", evaluation->level, evaluation->patches,
                                       name_of(arguments.cap)) +
                           energy_table(evaluation->energies, "bending") + invariants_table(evaluation->energies) +
                           opinion_table(evaluation->second_opinion) + credibility_lines(evaluation->energies);
  if (!print(text)) return kCannotWrite;
  return evaluation->energies.credible() ? kEnded : kNotCredible;
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("evaluate", "Print the energies of a cage's surface as it is");
  const auto arguments = std::make_shared<EvaluateArguments>();
  add_cage_argument(*command, arguments->cage);
  add_cap_options(*command, arguments->cap);
  const auto parse_level = [](const std::string& text) { return parse_count(text, 0, kMostLevels); };
  command
      ->add_option_function<std::string>(
          "--levels",
          [arguments, parse_level](const std::string& text) { arguments->levels = parse_level(text).value(); },
          "Catmull-Clark steps before evaluating; raised when the cage needs more [0]")
      ->type_name("N")
      ->check(checked(parse_level));
  command->add_flag("--second-opinion", arguments->second_opinion,
                    "Compute all energies in another way, too, which takes seconds, and print both");
  add_threads_option(*command, arguments->threads);
  add_json_flag(*command, arguments->json);
  command->footer(functional_help());
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace umbilic::cli
