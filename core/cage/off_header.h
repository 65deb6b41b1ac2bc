// SPDX-License-Identifier: MIT
/// \file
/// How an OFF text begins, and its words with and without regard to lines; see read_off.cpp.
#pragma once

#include <string_view>

#include "base/result.h"
#include "cage/text.h"

namespace umbilic {

/// What the prefixes of a keyword say.
struct OffKeyword {
  std::size_t length = 0;  ///< with prefixes
  bool normals = false;
  bool colours = false;
  bool texture = false;
  bool other_dimension = false;

  /// Numbers behind a vertex's coordinates.
  int numbers() const { return (normals ? 3 : 0) + (colours ? 4 : 0) + (texture ? 2 : 0); }
};

/// The text without its comments, as lines or as words that may be anywhere.
class OffWords {
 public:
  OffWords(std::string_view text, bool by_lines) : lines_(text), by_lines_(by_lines) {}

  bool by_lines() const { return by_lines_; }

  /// Goes to the next element, by lines to the next line that has one; false at the end.
  bool begin() {
    if (!by_lines_ && has_word()) return true;
    do {
      const auto line = lines_.next();
      if (!line) return false;
      rest_ = without_comment(line->text);
    } while (!has_word());
    return true;
  }

  /// The next word; empty where the element, or the text, ends before.
  std::string_view word() {
    const std::string_view word = take_word(rest_);
    return !word.empty() || by_lines_ || !begin() ? word : take_word(rest_);
  }

  /// What is left of the line.
  std::string_view& rest() { return rest_; }

  /// Number of the line that was looked at last.
  int line() const { return lines_.number(); }

 private:
  bool has_word() const {
    std::string_view words = rest_;
    return !take_word(words).empty();
  }

  LineReader lines_;
  bool by_lines_;
  std::string_view rest_;
};

struct OffHeader {
  OffKeyword keyword;
  int keyword_line = 0;
  std::string_view keyword_text;
  long long vertices = 0;
  long long faces = 0;
  int line = 0;  ///< of the counts
};

/// Reads the keyword, unless it was left out, and the counts, which may follow on the same line.
Result<OffHeader> parse_off_header(OffWords& words);

}  // namespace umbilic
