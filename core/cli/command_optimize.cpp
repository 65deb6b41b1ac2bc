// SPDX-License-Identifier: MIT
/// \file
/// `umbilic optimize`: a run from a cage to files and tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/threads.h"
#include "cage/write.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/estimates.h"
#include "cli/exit_code.h"
#include "cli/files.h"
#include "cli/interrupt.h"
#include "cli/problem_file.h"
#include "cli/problem_options.h"
#include "cli/tables.h"
#include "cli/version.h"
#include "driver/problem_run.h"
#include "problem/text.h"

namespace umbilic::cli {

namespace {

struct OptimizeArguments {
  std::string input;
  ProblemChanges changes;
  std::optional<std::string> output;
  std::optional<std::string> limit_mesh;
  std::optional<std::string> report;
  int density = 4;
  int threads = hardware_threads();
  bool certify = false;
  bool descend = false;
  bool quiet = false;
  bool estimate = false;
  bool print_problem = false;
  bool print_schema = false;

  /// The outputs that were requested.
  std::vector<std::string> outputs() const {
    std::vector<std::string> wanted;
    for (const auto& path : {output, limit_mesh, report}) {
      if (path) wanted.push_back(*path);
    }
    return wanted;
  }
};

/// An error if two outputs have the same path, since the second would replace the first.
std::optional<std::string> shared_output(const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (same_output(outputs[i], outputs[j])) return outputs[i];
    }
  }
  return std::nullopt;
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

/// The results of a run that has ended.
struct Ending {
  const std::string& cage;  ///< its name
  const ProblemRun& run;
  std::optional<CertificateReport> certificate{};
  std::vector<std::string> left{};  ///< lines about the surfaces that it went on from, since they were no minima
};

std::string json(const Ending& ending) {
  Report report = ending.run.report();
  report.program = version();
  report.certificate = ending.certificate;
  return report_text(report);
}

std::string table(const Ending& ending) {
  const Run& run = ending.run.run;
  const RunOptions& options = ending.run.problem.options;
  const std::string objective = words(options.weights);
  const std::optional<ConstraintsReport> constraints = run.constraints();
  return input_line(ending.cage, ending.run.cage) + fmt::format("{}", fmt::join(ending.left, "")) +
         fmt::format("minimized {}, cap {}, {}\n", objective, name_of(options.cap), group_words(run.group())) +
         level_table(run.levels()) + limit_line(run.limit()) +
         (options.accuracy ? accuracy_line(run.limit(), *options.accuracy) : "") +
         (ending.certificate ? certificate_line(*ending.certificate, run.group()) : "") +
         result_line(run.levels(), run.result()) + energy_table(run.energies(), objective) +
         (options.second_opinion ? opinion_table(run.second_opinion()) : "") +
         (constraints ? constraints_table(*constraints) : "") + credibility_lines(run.energies());
}

/// A certificate whose report can be read. Returns nothing if the user interrupts.
Result<std::optional<Certificate>> certify(const Run& run, const InterruptWatch& watch) {
  Result<Certificate> certificate = run.certify();
  if (!certificate) return certificate.error();
  while (!certificate->step()) {
    if (watch.interrupted()) return std::optional<Certificate>();
  }
  if (const Result<CertificateReport> report = certificate->report(); !report) return report.error();
  return std::optional(std::move(certificate).value());
}

/// The exit code after one result: a failure has been said.
int told(const std::optional<Error>& error) { return error ? fail(kCannotWrite, error->message) : kEnded; }

int write_limit_mesh(const std::string& path, int density, const Run& run) {
  const Result<LimitMesh> mesh = run.limit_mesh(density);
  if (!mesh) return fail(kBadInput, mesh.error().message);
  return told(write_file(
      path, [&mesh](const TextSink& take) { return write_obj(mesh->positions, mesh->normals, mesh->quads, take); }));
}

/// Writes one result after the other, the report first, from which all others can be had again. One that fails is said
/// and takes no other with it; returns the exit code of the first that fails.
int write_results(const OptimizeArguments& arguments, const Ending& ending) {
  const Run& run = ending.run.run;
  int exit_code = kEnded;
  const auto attempt = [&](const std::string& name, const auto& write) {
    int code = kOutOfMemory;
    try {
      code = write();
    } catch (const std::bad_alloc&) {
      fail(code, fmt::format("cannot write {}: out of memory", name));
    } catch (const std::length_error&) {  // of a container that could not be addressed
      fail(code, fmt::format("cannot write {}: out of memory", name));
    }
    if (exit_code == kEnded) exit_code = code;
  };
  if (const auto& path = arguments.report) {
    attempt(*path, [&] { return told(write_file(*path, json(ending))); });
  }
  if (const auto& path = arguments.output) {
    attempt(*path, [&] { return told(write_file(*path, write_obj(run.control_mesh()))); });
  }
  if (const auto& path = arguments.limit_mesh) {
    attempt(*path, [&] { return write_limit_mesh(*path, arguments.density, run); });
  }
  for (const std::string& path : arguments.outputs()) {
    if (path == "-") return exit_code;  // the table would mix with the result on standard output
  }
  attempt("the table", [&] { return print(table(ending)) ? kEnded : kCannotWrite; });
  return exit_code;
}

/// The problem that the command line describes.
Result<ProblemFile> asked(const OptimizeArguments& arguments) {
  Result<ProblemFile> file = load_problem(arguments.input);
  if (!file) return file.error();
  for (const auto& change : arguments.changes) change(file->problem);
  return file;
}

/// "left 143.7803 (level 3, symmetry Td, order 24): 2 directions lower the energy".
std::string left_line(const Run& run, const CertificateReport& certificate) {
  return fmt::format("left {:.10g} (level {}, {}): {}\n", run.result().energy_reported, run.result().level,
                     group_words(run.group()), descent_words(certificate));
}

/// Minimizes; certifies, if that is asked, and begins again where that leads down. `run` is then the last one, and
/// `ending` tells the rest.
int minimize_and_certify(const OptimizeArguments& arguments, const InterruptWatch& watch, ProblemRun& run,
                         Ending& ending) {
  double energy_before = 0;
  while (true) {
    ending.certificate.reset();
    if (!minimize(run.run, watch, arguments.quiet)) return kInterrupted;
    const bool credible = run.run.energies().credible() && std::isfinite(run.run.result().energy_reported);
    if (!(arguments.certify || arguments.descend) || watch.interrupted()) return credible ? kEnded : kNotCredible;
    const Result<std::optional<Certificate>> certificate = certify(run.run, watch);
    if (!certificate) return fail(kBadInput, certificate.error().message);
    if (!*certificate) return kInterrupted;
    ending.certificate = *(*certificate)->report();
    if (!credible) return kNotCredible;
    if (!arguments.descend || ending.left.size() == kMostDescents) return kEnded;
    Problem lower = run.problem;
    lower.start = (*certificate)->descent();
    const double energy = run.run.result().energy_reported;
    const bool stays = !ending.left.empty() && energy >= (1 - kLeastDescent) * energy_before;
    if (!lower.start || stays) {
      if (ending.certificate->negative > 0)
        ending.left.push_back("no surface that is clearly lower was found along the directions of its certificate\n");
      return kEnded;
    }
    energy_before = energy;
    Result<ProblemRun> next = begin_run(std::move(lower));
    if (!next) return fail(kBadInput, next.error().message);
    ending.left.push_back(left_line(run.run, *ending.certificate));
    run = std::move(next).value();
  }
}

int run(const OptimizeArguments& arguments) {
  use_threads(arguments.threads);
  if (arguments.print_schema) return print(schema_text()) ? kEnded : kCannotWrite;
  if (arguments.input.empty()) return fail(kBadUsage, "INPUT is required");
  const std::vector<std::string> outputs = arguments.outputs();
  if (const auto path = shared_output(outputs))
    return fail(kBadUsage, fmt::format("two results would go to {}", *path));
  const Result<ProblemFile> file = asked(arguments);
  if (!file) return fail(kBadInput, file.error().message);
  if (file->problem.options.weights == Weights{})
    return fail(kBadUsage, "--functional or --weights is required with a cage");
  if (Error error; !in_range(file->problem.options, error)) return fail(kBadUsage, error.message);
  if (arguments.print_problem) return print(problem_text(file->problem)) ? kEnded : kCannotWrite;
  if (!arguments.estimate) {
    for (const std::string& path : outputs) {
      if (const auto error = check_writable(path)) return fail(kCannotWrite, error->message);
    }
  }
  auto run = begin_run(file->problem);
  if (!run) return fail(kBadInput, run.error().message);
  const Estimate estimate = run->run.estimate();
  if (arguments.estimate) return print(estimate_table(estimate) + estimate_warnings(estimate)) ? kEnded : kCannotWrite;
  if (!arguments.quiet) tell(estimate_warnings(estimate));
  const InterruptWatch watch;  // also while the results are written: they are what the run was for
  Ending ending{file->cage, *run};
  const int exit_code = minimize_and_certify(arguments, watch, *run, ending);
  const int written = write_results(arguments, ending);
  return written == kEnded ? exit_code : written;
}

}  // namespace

void add_optimize_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("optimize", "Minimize a functional, level by level, and print or write the result");
  const auto arguments = std::make_shared<OptimizeArguments>();
  command
      ->add_option("INPUT", arguments->input,
                   "A problem, or a report to go on from (JSON); or an OBJ, OFF or PLY file of a\n"
                   "polygon mesh, closed or open; or - for standard input")
      ->type_name("");
  add_problem_options(*command, std::shared_ptr<ProblemChanges>(arguments, &arguments->changes));
  command->add_flag("--estimate", arguments->estimate,
                    "Print how long each level will probably take and how much memory, and exit");
  command->add_flag("--print-problem", arguments->print_problem, "Print the problem that these options ask, and exit");
  command->add_flag("--print-schema", arguments->print_schema,
                    "Print the JSON schema of problems and reports, and exit");
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
  add_output("--report", arguments->report, "OUT.json",
             "Write problem, energies, levels and surface as JSON, to go on from");
  command->add_flag("--certify", arguments->certify,
                    "Tell whether the result is a local minimum among all surfaces, symmetric or not");
  command->add_flag("--descend", arguments->descend,
                    "Where it is none, go on from a lower surface nearby, until there is a local minimum");
  add_threads_option(*command, arguments->threads);
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on standard error");
  command->footer(
      "Options change what the file of a problem says.\n"
      "Where a result goes to - (standard output), no table is printed. Ctrl-C ends the run, keeps the best\n"
      "surface so far and exits with 130; a second Ctrl-C ends the program.\n\n" +
      functional_help());
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace umbilic::cli
