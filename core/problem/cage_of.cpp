// SPDX-License-Identifier: MIT
/// \file
/// Generates or reads, and validates.
#include "problem/cage_of.h"

#include <fmt/format.h>

#include "cage/read.h"

namespace umbilic {
namespace {

Result<Cage> made(const GeneratedCage& input) { return generate_cage(input.generator, input.options); }

Result<Cage> made(const CageText& input) { return read_cage(input.text); }

Result<Cage> made(const CagePath& input) {
  return Error{fmt::format("cage.file: {} is not read here; only the command line opens files", input.file)};
}

}  // namespace

Result<CheckedCage> cage_of(const CageInput& input) {
  Result<Cage> cage = std::visit([](const auto& alternative) { return made(alternative); }, input);
  if (!cage) return named(input, cage.error());
  const Result<CageReport> report = validate(*cage);
  if (!report) return named(input, report.error());
  return CheckedCage{std::move(cage).value(), *report};
}

Error named(const CageInput& input, Error error) {
  const auto* text = std::get_if<CageText>(&input);
  if (text && !text->name.empty()) error.message = fmt::format("{}: {}", text->name, error.message);
  return error;
}

}  // namespace umbilic
