// SPDX-License-Identifier: MIT
/// \file
/// Distinguishes problems from cages, and replaces the path of a cage by the file's text.
#include "cli/problem_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "cage/read.h"
#include "cage/text.h"
#include "cli/files.h"
#include "problem/text.h"

namespace umbilic::cli {

namespace {

namespace fs = std::filesystem;

std::string name_of_file(const std::string& path) { return path == "-" ? "standard input" : path; }

bool is_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '{';
}

/// The file of a cage as text.
Result<CageText> text_of(const std::string& name, std::string_view file) {
  Result<std::string> text = cage_text(file);
  if (!text) return Error{fmt::format("{}: {}", name, text.error().message)};
  return CageText{name, std::move(text).value()};
}

/// Reads the text of the cage; returns its name for messages.
Result<std::string> open_cage(CageInput& input, const fs::path& folder) {
  if (const auto* path = std::get_if<CagePath>(&input)) {
    const std::string file = (folder / path->file).string();
    Result<std::string> text = read_file(file);
    if (!text) return text.error();
    Result<CageText> cage = text_of(file, *text);
    if (!cage) return cage.error();
    input = std::move(cage).value();
  }
  if (const auto* generated = std::get_if<GeneratedCage>(&input)) return generated->generator;
  const std::string& name = std::get<CageText>(input).name;
  return name.empty() ? std::string("its cage") : printable(name);
}

}  // namespace

Result<ProblemFile> load_problem(const std::string& path) {
  const std::string name = name_of_file(path);
  Result<std::string> text = read_file(path);
  if (!text) return text.error();
  if (!is_json(*text)) {
    Result<CageText> cage = text_of(name, *text);
    if (!cage) return cage.error();
    return ProblemFile{{.cage = std::move(cage).value()}, name, false};
  }
  Result<Problem> problem = parse_problem(*text);
  if (!problem) return Error{fmt::format("{}: {}", name, problem.error().message)};
  const Result<std::string> cage = open_cage(problem->cage, path == "-" ? fs::path() : fs::path(path).parent_path());
  if (!cage) return Error{fmt::format("{}: {}", name, cage.error().message)};
  return ProblemFile{std::move(problem).value(), *cage, true};
}

}  // namespace umbilic::cli
