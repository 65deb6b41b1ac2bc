// SPDX-License-Identifier: MIT
/// \file
/// `umbilic cage`: writes a generated cage.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cage/generate.h"
#include "cage/text.h"
#include "cage/write.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/files.h"

namespace umbilic::cli {

namespace {

struct CageArguments {
  std::string name;
  std::string output = "-";
  CageOptions options;
  bool list = false;
};

std::string list_of_cages() {
  std::string text;
  for (const CageName& cage : cage_names()) text += fmt::format("{:<28} {}\n", cage.name, cage.description);
  return text;
}

struct Segments {
  int major;
  int minor;
};

/// Parses "MxN": quads around the axis and the tube, or around the boundary and across. generate_cage checks the range.
Result<Segments> parse_segments(std::string_view text) {
  constexpr int kMost = 1'000'000;
  const std::size_t cross = text.find('x');
  const Result<int> major = parse_count(text.substr(0, cross), 1, kMost);
  const Result<int> minor = parse_count(cross == std::string_view::npos ? "" : text.substr(cross + 1), 1, kMost);
  if (major && minor) return Segments{*major, *minor};
  return Error{fmt::format("{} is not MxN, two numbers of segments", in_quotes(text))};
}

/// generate_cage checks the range.
Result<int> parse_sides(std::string_view text) { return parse_count(text, 1, 1'000'000); }

Result<FrameFamily> family_called(const std::string& name) {
  if (name == "hub") return FrameFamily::kHub;
  if (name == "flag") return FrameFamily::kFlag;
  return Error{fmt::format("{} is not hub or flag", in_quotes(name))};
}

/// An option that the cage does not have, which would silently be ignored.
std::optional<std::string> misplaced_option(const CLI::App& command, const CageName& cage) {
  const CageParameters has_the = parameters_of(cage.kind);
  const std::initializer_list<std::pair<const char*, bool>> applies{{"--family", has_the.family},
                                                                    {"--thickness", has_the.thickness},
                                                                    {"--spread", has_the.spread},
                                                                    {"--ratio", has_the.ratio},
                                                                    {"--segments", has_the.segments},
                                                                    {"--radius", has_the.radius},
                                                                    {"--half-angle", has_the.half_angle},
                                                                    {"--height", has_the.height},
                                                                    {"--waist", has_the.waist},
                                                                    {"--sides", has_the.sides},
                                                                    {"--rise", has_the.rise}};
  for (const auto& [option, has] : applies) {
    if (!has && command.count(option) > 0) return fmt::format("cage {} has no {}", cage.name, option);
  }
  return std::nullopt;
}

int run(const CLI::App& command, const CageArguments& arguments) {
  if (arguments.list) return print(list_of_cages()) ? kEnded : kCannotWrite;
  if (arguments.name.empty()) return fail(kBadUsage, "cage needs a NAME, or --list");
  const auto cage = generate_cage(arguments.name, arguments.options);
  if (!cage) return fail(kBadUsage, cage.error().message);
  const auto known = std::find_if(cage_names().begin(), cage_names().end(),
                                  [&](const CageName& candidate) { return candidate.name == arguments.name; });
  if (const auto problem = misplaced_option(command, *known)) return fail(kBadUsage, *problem);
  if (const auto error = write_file(arguments.output, write_obj(*cage))) return fail(kCannotWrite, error->message);
  return kEnded;
}

}  // namespace

void add_cage_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("cage", "Write a generated cage as OBJ: cube, torus, frames, open cages");
  const auto arguments = std::make_shared<CageArguments>();
  CageOptions& options = arguments->options;
  command->add_option("NAME", arguments->name, "Which cage; see --list")->type_name("");
  command->add_flag("--list", arguments->list, "Print the names of all cages, with their genus");
  command
      ->add_option_function<std::string>(
          "--family", [&options](const std::string& name) { options.family = family_called(name).value(); },
          "Frames: hub (junctions are prisms) or flag (quads only, extraordinary\nvertices on the axes only) [flag]")
      ->type_name("hub|flag")
      ->check(checked(family_called));
  const auto add_real = [&](const char* name, double& value, const char* letter, const char* description) {
    command
        ->add_option_function<std::string>(
            name, [&value](const std::string& text) { value = parse_real(text).value(); }, description)
        ->type_name(letter)
        ->check(checked(parse_real));
  };
  add_real("--thickness", options.thickness, "T",
           "Frames, torus: width of the arms or the tube, relative to the default [1]");
  add_real("--spread", options.spread, "S",
           "Frames two-N: distance of the arms from the axis; the junctions are at 1 [1]");
  add_real("--ratio", options.ratio, "R", "Torus: minor radius / major radius of the control net [0.5]");
  command
      ->add_option_function<std::string>(
          "--segments",
          [&options](const std::string& text) {
            const Segments segments = parse_segments(text).value();
            options.major_segments = segments.major;
            options.minor_segments = segments.minor;
          },
          "Torus: quads around the axis x quads around the tube [6x8];\nopen cages: around the boundary x across [32x, "
          "about square]")
      ->type_name("MxN")
      ->check(checked(parse_segments));
  add_real("--radius", options.radius, "R", "Disk, cylinder, spherical-cap, n-sided: radius [1]");
  add_real("--half-angle", options.half_angle, "A", "Spherical-cap: degrees from the pole to the boundary [90]");
  add_real("--height", options.height, "H", "Cylinder, catenoid: from boundary to boundary [2]");
  add_real("--waist", options.waist, "W", "Catenoid: smallest radius [1]");
  command
      ->add_option_function<std::string>(
          "--sides", [&options](const std::string& text) { options.sides = parse_sides(text).value(); },
          "N-sided: how many [5]")
      ->type_name("N")
      ->check(checked(parse_sides));
  add_real("--rise", options.rise, "Z", "N-sided: height of the corners, to which a saddle is lifted [0, flat]");
  command->add_option("-o,--output", arguments->output, "Write to this file instead of standard output")
      ->type_name("OUT.obj");
  command->callback([arguments, command, &exit_code] { exit_code = run(*command, *arguments); });
}

}  // namespace umbilic::cli
