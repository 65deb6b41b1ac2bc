// SPDX-License-Identifier: MIT
/// \file
/// Splits a mesh file into lines, words and numbers, for any line ends and independently of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace umbilic {

struct Line {
  std::string_view text;
  int number = 0;  ///< one-based
};

/// Iterates over lines that end with LF, CRLF or CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line without its end, or nothing at the end of the text. A line end at the end of the text does not begin
  /// another line.
  std::optional<Line> next();

  /// Number of the line that `next` returned last; 0 before the first.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// `line` up to its first '#'.
std::string_view without_comment(std::string_view line);

/// Removes the first blank-separated word from the front of `rest`; empty if only blanks are left.
std::string_view take_word(std::string_view& rest);

/// The number that `word` consists of; infinite if its digits overflow a double or spell an infinity.
std::optional<double> parse_number(std::string_view word);

/// The integer that `word` consists of. Integers too large for 64 bits become the nearest one that fits.
std::optional<long long> parse_integer(std::string_view word);

/// `word` in quotes, safe to print: shortened if it is long, and with everything but printable ASCII replaced.
std::string in_quotes(std::string_view word);

/// `word` with '?' for all that cannot be printed: control characters, and bytes that are no UTF-8.
std::string printable(std::string_view word);

}  // namespace umbilic
