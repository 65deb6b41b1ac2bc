// SPDX-License-Identifier: MIT
/// \file
/// Reads the keyword and the counts of OFF.
#include "cage/off_header.h"

#include <fmt/format.h>

#include <optional>

#include "cage/formats.h"

namespace umbilic {

namespace {

constexpr std::string_view kOff = "OFF";

/// The keyword with which a word begins. Its prefixes stand in any order. Files in which the counts follow without a
/// blank ("OFF490 518 0") are common.
std::optional<OffKeyword> keyword_of(std::string_view word) {
  OffKeyword keyword;
  const auto skip = [&](std::string_view prefix, bool& found) {
    if (found || !word.substr(keyword.length).starts_with(prefix)) return false;
    keyword.length += prefix.size();
    return found = true;
  };
  bool four = false, any = false;
  while (skip("ST", keyword.texture) || skip("C", keyword.colours) || skip("N", keyword.normals) || skip("4", four) ||
         skip("n", any)) {
  }
  if (!word.substr(keyword.length).starts_with(kOff)) return std::nullopt;
  keyword.length += kOff.size();
  if (word.find_first_not_of("0123456789", keyword.length) != std::string_view::npos) return std::nullopt;
  keyword.other_dimension = four || any;
  return keyword;
}

/// Whether a line can begin a file without a keyword: the numbers of vertices and faces, and other numbers behind them.
/// In OBJ no line begins with a number.
bool is_counts(std::string_view line) {
  for (int count = 0; count < 2; ++count) {
    const std::string_view word = take_word(line);
    if (word.empty() || word.find_first_not_of("0123456789") != std::string_view::npos) return false;
  }
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    if (!parse_number(word)) return false;
  }
  return true;
}

std::optional<Error> parse_counts(OffWords& words, OffHeader& header) {
  header.line = words.line();
  for (long long* count : {&header.vertices, &header.faces}) {
    const std::string_view word = words.word();
    const auto number = parse_integer(word);
    if (!number || *number < 0) {
      return at_line(header.line, fmt::format("expected the numbers of vertices and faces, found {}", in_quotes(word)));
    }
    *count = *number;
  }
  if (!words.by_lines()) {
    const std::string_view edges = words.word();
    if (!parse_integer(edges)) {
      return at_line(header.line, fmt::format("expected the number of edges, found {}", in_quotes(edges)));
    }
  }
  return std::nullopt;
}

}  // namespace

Result<OffHeader> parse_off_header(OffWords& words) {
  OffHeader header;
  bool found = words.begin();
  std::string_view peek = words.rest();
  const std::string_view first = take_word(peek);
  if (const auto keyword = keyword_of(first)) {
    header.keyword = *keyword;
    header.keyword_line = words.line();
    header.keyword_text = first.substr(0, keyword->length);
    if (keyword->other_dimension) {
      return at_line(words.line(), fmt::format("{} has vertices of another dimension than 3", header.keyword_text));
    }
    if (take_word(peek) == "BINARY") return at_line(words.line(), "binary OFF is not read; save it as text");
    std::string_view& rest = words.rest();
    rest.remove_prefix(static_cast<std::size_t>(first.data() - rest.data()) + keyword->length);
    peek = rest;
    if (take_word(peek).empty()) found = words.begin();
  }
  if (!found) return at_line(words.line(), "the file ends before the numbers of vertices and faces");
  if (auto error = parse_counts(words, header)) return *error;
  return header;
}

bool is_off(std::string_view text) {
  OffWords words(text, true);
  words.begin();
  std::string_view line = words.rest();
  return is_counts(line) || keyword_of(take_word(line));
}

}  // namespace umbilic
