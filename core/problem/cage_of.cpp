// SPDX-License-Identifier: MIT
/// \file
/// Generates or reads, and validates.
#include "problem/cage_of.h"

#include <fmt/format.h>

#include "cage/read.h"
#include "cage/text.h"

namespace umbilic {
namespace {

Result<CheckedCage> made(const GeneratedCage& input) {
  Result<Cage> cage = generate_cage(input.generator, input.options);
  if (!cage) return cage.error();
  const Result<CageReport> report = validate(*cage);
  if (!report) return report.error();
  return CheckedCage{std::move(cage).value(), *report};
}

Result<CheckedCage> made(const CageText& input) { return read_checked_cage(input.text); }

Result<CheckedCage> made(const CagePath& input) {
  return Error{fmt::format("cage.file: {} is not read here; only the command line opens files", input.file)};
}

}  // namespace

Result<CheckedCage> cage_of(const CageInput& input) {
  Result<CheckedCage> cage = std::visit([](const auto& alternative) { return made(alternative); }, input);
  if (!cage) return named(input, cage.error());
  return cage;
}

Error named(const CageInput& input, Error error) {
  const auto* text = std::get_if<CageText>(&input);
  if (text && !text->name.empty()) error.message = fmt::format("{}: {}", printable(text->name), error.message);
  return error;
}

}  // namespace umbilic
