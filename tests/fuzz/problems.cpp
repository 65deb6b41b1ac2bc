// SPDX-License-Identifier: MIT
/// \file
/// Fuzzes the text form of problems, reports and their parts, with the cages that they hold as text.
#include <string>
#include <variant>

#include "problem/cage_of.h"
#include "problem/text.h"
#include "tests/fuzz/targets.h"

namespace umbilic::fuzz {

namespace {

template <class T>
bool is_read(const Result<T>& result) {
  if (!result) require_words(result.error().message);
  return result.ok();
}

/// Requires that what is printed of `value` reads back to the same, and that both layouts say the same.
template <class T, class Parse, class Print>
void require_fixed_point(const T& value, const Parse& parse, const Print& print) {
  const std::string text = print(value, JsonPrinter::Layout::kIndented);
  for (const JsonPrinter::Layout layout : {JsonPrinter::Layout::kIndented, JsonPrinter::Layout::kCompact}) {
    const Result<T> again = parse(print(value, layout));
    require(again.ok(), "what is printed can be read");
    require(print(*again, JsonPrinter::Layout::kIndented) == text, "what is printed reads back to the same");
  }
}

}  // namespace

void problems(std::string_view text) {
  if (const Result<Problem> problem = parse_problem(text); is_read(problem)) {
    require_fixed_point(*problem, parse_problem, problem_text);
    if (std::holds_alternative<CageText>(problem->cage)) is_read(cage_of(problem->cage));
  }
  if (const Result<Report> report = parse_report(text); is_read(report)) {
    require_fixed_point(*report, parse_report, report_text);
  }
  is_read(parse_cage(text));
  is_read(parse_terms(text));
  is_read(parse_targets(text));
}

}  // namespace umbilic::fuzz
