// SPDX-License-Identifier: MIT
/// \file
/// Lines, words and numbers of a mesh file, whatever its line ends and whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace umbilic {

struct Line {
  std::string_view text;
  int number = 0;  ///< one-based
};

/// Walks over lines that end with LF, CRLF or CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line without its end, or nothing at the end of the text. A line end that closes the text opens no further
  /// line.
  std::optional<Line> next();

  /// Number of the line that `next` returned last; 0 before the first.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// `line` up to its first '#'.
std::string_view without_comment(std::string_view line);

/// Takes the first blank-separated word off the front of `rest`; empty when only blanks are left.
std::string_view take_word(std::string_view& rest);

/// The number that is the whole of `word`; infinite when its digits overflow a double or spell an infinity.
std::optional<double> parse_number(std::string_view word);

/// The integer that is the whole of `word`. Integers too large for 64 bits are clamped to the nearest that fits.
std::optional<long long> parse_integer(std::string_view word);

/// `word` between quotes, safe to print: cut when it is long, with anything but printable ASCII replaced.
std::string in_quotes(std::string_view word);

}  // namespace umbilic
