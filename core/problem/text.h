// SPDX-License-Identifier: MIT
/// \file
/// The one text form of problems and reports, for every door: JSON that says what it is and in which version of the
/// form.
///
///     {"umbilic": "problem", "version": 1, "cage": {…}, "terms": {…}, "options": {…}}
///     {"umbilic": "report", "version": 1, "program": "0.2.0", "problem": {…}, "levels": […], …}
///
/// Numbers read back as they were; those that are not finite are null, and null is read as NaN. Members that are left
/// out have their defaults. Unknown members of a problem are refused, those of a report ignored. The version rises when
/// a member changes its meaning or goes away, not when one is added. `schema_text` describes all members.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "problem/print.h"
#include "problem/report.h"
#include "problem/targets.h"

namespace umbilic {

inline constexpr int kTextVersion = 1;

/// {"umbilic": `kind`, "version": 1, …} with the members of `content`.
template <HasMembers T>
std::string document_text(std::string_view kind, const T& content, JsonPrinter::Layout layout) {
  JsonPrinter printer(layout);
  printer.open('{');
  printer("umbilic", kind);
  printer("version", kTextVersion);
  T::members(printer, content);
  printer.close('}');
  return printer.take() + "\n";
}

std::string problem_text(const Problem& problem, JsonPrinter::Layout layout = JsonPrinter::Layout::kIndented);
std::string report_text(const Report& report, JsonPrinter::Layout layout = JsonPrinter::Layout::kIndented);

/// The problem of a problem's text; of a report's, the problem that goes on where the report ends. Errors name the line
/// of what is no JSON, or the member: "options.levels[1]: 1 is below levels[0], 2". At most kLongestJson bytes.
Result<Problem> parse_problem(std::string_view text);
/// Errors as above.
Result<Report> parse_report(std::string_view text);
/// A cage alone, as it stands in a problem.
Result<CageInput> parse_cage(std::string_view text);
/// Terms alone, as they stand in a problem.
Result<Weights> parse_terms(std::string_view text);
/// New values for a run, see problem/targets.h.
Result<Targets> parse_targets(std::string_view text);

/// JSON Schema (draft 7) of both forms, with words for each member.
std::string schema_text();

}  // namespace umbilic
