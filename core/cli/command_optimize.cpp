// SPDX-License-Identifier: MIT
/// \file
/// `umbilic optimize`: a run from a cage to files and tables.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "cage/text.h"
#include "cage/write.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/json_report.h"
#include "cli/tables.h"
#include "driver/run.h"

namespace umbilic {

namespace {

struct OptimizeArguments {
  std::string cage;
  Objective objective;
  RunOptions options;
  std::optional<std::string> output;
  std::optional<std::string> limit_mesh;
  std::optional<std::string> report;
  int density = 4;
  bool certify = false;
  bool quiet = false;

  /// The outputs that are wanted.
  std::vector<std::string> outputs() const {
    std::vector<std::string> wanted;
    for (const auto& path : {output, limit_mesh, report}) {
      if (path) wanted.push_back(*path);
    }
    return wanted;
  }
};

/// Two results at one place: the second would replace the first.
std::optional<std::string> shared_output(const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (same_output(outputs[i], outputs[j])) return outputs[i];
    }
  }
  return std::nullopt;
}

Result<MetricChoice> parse_metric(const std::string& name) {
  for (int i = 0; i < kMetricChoiceCount; ++i) {
    if (name == kMetricChoiceNames[i]) return static_cast<MetricChoice>(i);
  }
  return Error{fmt::format("{} is none of auto, identity, sobolev, hessian", in_quotes(name))};
}

/// Returns whether the run has come to its end by itself.
bool minimize(Run& run, const InterruptWatch& watch, bool quiet) {
  ProgressLine line(quiet);
  bool by_itself = true;
  while (!run.step(1)) {
    line.update(run);
    if (!watch.interrupted()) continue;
    run.cancel();
    by_itself = false;
  }
  line.update(run);
  return by_itself;
}

/// What there is to say of a run when it has ended.
struct Ending {
  const Run& run;
  std::optional<CertificateReport> certificate;
};

std::string json(const CageFile& input, const OptimizeArguments& arguments, const Ending& ending) {
  const Run& run = ending.run;
  Json report = json_report(input);
  add_objective(report, arguments.objective);
  add_cap(report, arguments.options.cap);
  add_group(report, run.group());
  add_energies(report, run.energies());
  add_limit(report, run.limit());
  add_levels(report, run.levels(), run.result());
  if (ending.certificate) add_certificate(report, *ending.certificate);
  return to_text(report);
}

std::string table(const CageFile& input, const OptimizeArguments& arguments, const Ending& ending) {
  const Run& run = ending.run;
  return input_line(input) +
         fmt::format("minimized {}, cap {}, {}\n", arguments.objective.words(), name_of(arguments.options.cap),
                     group_words(run.group())) +
         level_table(run.levels()) + limit_line(run.limit()) +
         (ending.certificate ? certificate_line(*ending.certificate, run.group()) : "") +
         result_line(run.levels(), run.result()) + energy_table(run.energies(), arguments.objective.words()) +
         credibility_lines(run.energies());
}

/// Nothing when the user interrupts.
Result<std::optional<CertificateReport>> certify(const Run& run, const InterruptWatch& watch) {
  Result<Certificate> certificate = run.certify();
  if (!certificate) return certificate.error();
  while (!certificate->step()) {
    if (watch.interrupted()) return std::optional<CertificateReport>();
  }
  const Result<CertificateReport> report = certificate->report();
  if (!report) return report.error();
  return std::optional(*report);
}

/// Writes everything that can be written, whatever fails.
int write_results(const CageFile& input, const OptimizeArguments& arguments, const Ending& ending) {
  const Run& run = ending.run;
  int exit_code = kEnded;
  const auto write = [&](const std::optional<std::string>& path, const auto& text) {
    if (!path) return;
    if (const auto error = write_file(*path, text())) exit_code = fail(kCannotWrite, error->message);
  };
  write(arguments.output, [&] { return write_obj(run.control_mesh()); });
  write(arguments.limit_mesh, [&] {
    const LimitMesh mesh = run.limit_mesh(arguments.density);
    return write_obj(mesh.positions, mesh.normals, mesh.quads);
  });
  write(arguments.report, [&] { return json(input, arguments, ending); });
  for (const std::string& path : arguments.outputs()) {
    if (path == "-") return exit_code;  // the table would spoil what stands there
  }
  return print(table(input, arguments, ending)) ? exit_code : kCannotWrite;
}

int run(const OptimizeArguments& arguments) {
  const std::vector<std::string> outputs = arguments.outputs();
  if (const auto path = shared_output(outputs))
    return fail(kBadUsage, fmt::format("two results would go to {}", *path));
  const auto input = load_cage(arguments.cage);
  if (!input) return fail(kBadInput, input.error().message);
  for (const std::string& path : outputs) {
    if (const auto error = check_writable(path)) return fail(kCannotWrite, error->message);
  }
  auto run = Run::create(input->cage, arguments.options);
  if (!run) return fail(kBadInput, fmt::format("{}: {}", input->name, run.error().message));
  const InterruptWatch watch;  // also while the results are written: they are what the run was for
  const bool by_itself = minimize(*run, watch, arguments.quiet);
  Ending ending{*run, std::nullopt};
  int exit_code = by_itself ? kEnded : kInterrupted;
  if (by_itself && !(run->energies().credible() && std::isfinite(run->result().energy_reported))) {
    exit_code = kNotCredible;
  }
  if (arguments.certify && !watch.interrupted()) {
    const Result<std::optional<CertificateReport>> certificate = certify(*run, watch);
    if (certificate) {
      ending.certificate = *certificate;
      if (!*certificate) exit_code = kInterrupted;
    } else {
      exit_code = fail(kBadInput, certificate.error().message);
    }
  }
  const int written = write_results(*input, arguments, ending);
  return written == kEnded ? exit_code : written;
}

void add_level_options(CLI::App& command, RunOptions& options) {
  command
      .add_option_function<std::string>(
          "--levels",
          [&options](const std::string& text) {
            const LevelRange range = parse_levels(text).value();
            options.first_level = range.first;
            options.last_level = range.last;
          },
          "Minimize, subdivide, minimize: from A to B Catmull-Clark steps of the cage;\n"
          "where the cage is too coarse to be evaluated, a finer mesh is [0..2]")
      ->type_name("A..B")
      ->check(checked(parse_levels));
  const auto parse_iterations = [](const std::string& text) {
    return parse_count(text, 0, std::numeric_limits<int>::max());
  };
  command
      .add_option_function<std::string>(
          "--max-iterations",
          [&options, parse_iterations](const std::string& text) {
            options.max_iterations = parse_iterations(text).value();
          },
          "Most iterations per level [1000]")
      ->type_name("N")
      ->check(checked(parse_iterations));
  command
      .add_option_function<std::string>(
          "--tolerance", [&options](const std::string& text) { options.tolerance = parse_real(text).value(); },
          "A level ends when the decrease still predicted is below\nT * max(energy, 1e-6 * 8 pi) [1e-6]")
      ->type_name("T")
      ->check(checked([](const std::string& text) -> Result<double> {
        const Result<double> number = parse_real(text);
        if (number && *number < 0) return Error{fmt::format("{} is negative", in_quotes(text))};
        return number;
      }));
}

void add_metric_options(CLI::App& command, RunOptions& options) {
  command.add_flag(
      "--no-symmetry", [&options](std::int64_t) { options.symmetry = false; },
      "Let the surface leave the cage's symmetry");
  command
      .add_option_function<std::string>(
          "--metric", [&options](const std::string& name) { options.metric = parse_metric(name).value(); },
          "What the optimizer measures steps with: auto, identity, sobolev or hessian [auto]")
      ->type_name("NAME")
      ->check(checked(parse_metric));
}

}  // namespace

void add_optimize_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("optimize", "Minimize a functional, level by level, and print or write the result");
  const auto arguments = std::make_shared<OptimizeArguments>();
  add_cage_argument(*command, arguments->cage);
  add_objective_options(*command, arguments->objective);
  add_cap_option(*command, arguments->options.cap);
  add_level_options(*command, arguments->options);
  add_metric_options(*command, arguments->options);
  const auto add_output = [&](const char* name, std::optional<std::string>& output, const char* type,
                              const char* what) {
    command
        ->add_option_function<std::string>(
            name, [&output](const std::string& path) { output = path; }, what)
        ->type_name(type);
  };
  add_output("-o,--output", arguments->output, "OUT.obj", "Write the final control mesh");
  add_output("--limit-mesh", arguments->limit_mesh, "OUT.obj", "Write the limit surface as quads with normals");
  const auto parse_density = [](const std::string& text) { return parse_count(text, 1, 64); };
  command
      ->add_option_function<std::string>(
          "--density",
          [arguments, parse_density](const std::string& text) { arguments->density = parse_density(text).value(); },
          "Quads of the limit mesh along each edge of a patch, 1 to 64 [4]")
      ->type_name("N")
      ->check(checked(parse_density));
  add_output("--report", arguments->report, "OUT.json", "Write energies, levels and stop reasons as JSON");
  command->add_flag("--certify", arguments->certify,
                    "Tell whether the result is a local minimum among all surfaces, symmetric or not");
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on standard error");
  command->footer(
      "Where a result goes to - (standard output), no table is printed. Ctrl-C ends the run, keeps the best\n"
      "surface so far and exits with 130; a second Ctrl-C ends the program.\n\n" +
      functional_help());
  command->callback([arguments, &exit_code] {
    require_objective(arguments->objective);
    arguments->options.weights = arguments->objective.weights;
    exit_code = run(*arguments);
  });
}

}  // namespace umbilic
