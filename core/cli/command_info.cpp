// SPDX-License-Identifier: MIT
/// \file
/// `umbilic info`: describes a cage, or that of a problem.
#include <fmt/format.h>

#include <memory>

#include "cli/arguments.h"
#include "cli/cage_shape.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/documents.h"
#include "cli/exit_code.h"
#include "cli/files.h"
#include "cli/problem_file.h"
#include "cli/tables.h"
#include "cli/version.h"
#include "problem/run_cage.h"

namespace umbilic::cli {

namespace {

struct InfoArguments {
  std::string cage;
  bool json = false;
};

std::string histogram_line(std::string_view what, const std::map<int, int>& histogram) {
  std::string text = fmt::format("  {:<12}", what);
  for (const auto& [size, count] : histogram) text += fmt::format(" {} x {}", count, size).append(",");
  text.back() = '\n';
  return text;
}

std::string boundary_lines(const CageReport& report) {
  std::string text;
  for (const CageBoundary& boundary : report.boundaries) {
    text += fmt::format("  boundary {}: {} vertices, from vertex {}", boundary.number, boundary.vertices,
                        boundary.first_vertex);
    text += report.components.size() > 1 ? fmt::format(", of component {}\n", boundary.component) : "\n";
  }
  return text;
}

std::string group_lines(const CageReport& report) {
  std::string text;
  for (const CageGroup& group : report.groups) {
    text += fmt::format("  group {}: {} {}\n", group.name, group.faces, group.faces == 1 ? "face" : "faces");
  }
  return text;
}

std::string table(const CageFile& input) {
  const CageShape shape = shape_of(input.cage);
  std::string text = input_line(input.name, input.report);
  if (input.report.components.size() > 1) {
    for (std::size_t i = 0; i < input.report.components.size(); ++i) {
      const CageComponent& c = input.report.components[i];
      text += fmt::format("  component {}: {} vertices, {} edges, {} faces, genus {}", i + 1, c.vertices, c.edges,
                          c.faces, c.genus);
      text += c.boundaries > 0 ? fmt::format(", boundaries: {}\n", c.boundaries) : "\n";
    }
  }
  text += boundary_lines(input.report) + group_lines(input.report);
  text += histogram_line("valences", shape.valences);
  text += histogram_line("face sizes", shape.face_sizes);
  return text + (shape.first_level ? fmt::format("  first level that can be evaluated: {}\n", *shape.first_level)
                                   : fmt::format("  its surface cannot be evaluated: {}\n", shape.obstacle));
}

std::string json(const CageFile& input) {
  const CageDocument document{std::string(version()), input.report, shape_of(input.cage)};
  return document_text("cage", document, JsonPrinter::Layout::kIndented);
}

/// The cage of the problem at `path`, with its holes but not filled, or the file's own cage.
Result<CageFile> load_described_cage(const std::string& path) {
  const Result<ProblemFile> file = load_problem(path);
  if (!file) return file.error();
  Result<CheckedCage> checked = cage_with_holes(file->problem);
  if (!checked) return checked.error();
  return CageFile{file->cage, std::move(checked->cage), std::move(checked->report)};
}

int run(const InfoArguments& arguments) {
  const auto input = load_described_cage(arguments.cage);
  if (!input) return fail(kBadInput, input.error().message);
  return print(arguments.json ? json(*input) : table(*input)) ? kEnded : kCannotWrite;
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("info", "Check a cage and count its parts, components and genus");
  const auto arguments = std::make_shared<InfoArguments>();
  command
      ->add_option("CAGE", arguments->cage,
                   "OBJ, OFF or PLY file of a polygon mesh; or a problem or report (JSON), whose cage is\n"
                   "described with its holes; or - for standard input")
      ->required()
      ->type_name("");
  add_json_flag(*command, arguments->json);
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace umbilic::cli
