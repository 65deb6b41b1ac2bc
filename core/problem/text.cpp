// SPDX-License-Identifier: MIT
/// \file
/// What stands at the top of a text, and what it is.
#include "problem/text.h"

#include <fmt/format.h>

#include "problem/read.h"

namespace umbilic {
namespace {

constexpr std::string_view kProblem = "problem", kReport = "report";

/// An object that says of itself what it is.
class Document {
 public:
  explicit Document(const JsonNode& root) : members_(reader_, object(root)) {
    int version = 0;
    members_.required("umbilic", kind_);
    members_.required("version", version);
    if (reader_.ok() && (version < 1 || version > kTextVersion)) {
      reader_.fail(fmt::format("version: {} is not known to this program, which reads versions up to {}", version,
                               kTextVersion));
    }
  }

  std::string_view kind() const { return kind_; }

  template <class T>
  Result<T> take() {
    T value;
    if (reader_.ok()) reader_.read_members(members_, value);
    if (!reader_.ok()) return reader_.error();
    return value;
  }

  Error refused(std::string_view expected) {
    reader_.fail(fmt::format("umbilic: expected {}", expected));
    return reader_.error();
  }

 private:
  const JsonNode::Object& object(const JsonNode& root) {
    static const JsonNode::Object none;
    const auto* object = root.get_if<JsonNode::Object>();
    if (!object) reader_.fail("expected an object, {\"umbilic\": \"problem\", …}");
    return object ? *object : none;
  }

  JsonReader reader_;
  ObjectReader members_;
  std::string kind_;
};

template <class T>
Result<T> parse_value(std::string_view text) {
  const Result<JsonNode> root = parse_json(text);
  if (!root) return root.error();
  JsonReader reader;
  Result<T> value{T()};
  reader.read(*root, value.value());
  if (!reader.ok()) return reader.error();
  return value;
}

}  // namespace

std::string problem_text(const Problem& problem, JsonPrinter::Layout layout) {
  return document_text(kProblem, problem, layout);
}

std::string report_text(const Report& report, JsonPrinter::Layout layout) {
  return document_text(kReport, report, layout);
}

Result<Problem> parse_problem(std::string_view text) {
  const Result<JsonNode> root = parse_json(text);
  if (!root) return root.error();
  Document document(*root);
  if (document.kind() != kReport) {
    if (document.kind() != kProblem) return document.refused("\"problem\" or \"report\"");
    return document.take<Problem>();
  }
  Result<Report> report = document.take<Report>();
  if (!report) return report.error();
  if (report->surface) report->problem.start = std::move(report->surface);
  return std::move(report->problem);
}

Result<Report> parse_report(std::string_view text) {
  const Result<JsonNode> root = parse_json(text);
  if (!root) return root.error();
  Document document(*root);
  if (document.kind() != kReport) return document.refused("\"report\"");
  return document.take<Report>();
}

Result<CageInput> parse_cage(std::string_view text) { return parse_value<CageInput>(text); }
Result<Weights> parse_terms(std::string_view text) { return parse_value<Weights>(text); }
Result<Targets> parse_targets(std::string_view text) { return parse_value<Targets>(text); }

}  // namespace umbilic
