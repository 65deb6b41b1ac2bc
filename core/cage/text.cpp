// SPDX-License-Identifier: MIT
/// \file
/// Line splitting and locale-independent number parsing.
#include "cage/text.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <limits>
#include <system_error>

#include "base/utf8.h"

namespace umbilic {

namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

std::optional<Line> LineReader::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find_first_of("\r\n");
  const std::string_view text = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    const bool crlf = rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(end + (crlf ? 2 : 1));
  }
  return Line{text, ++number_};
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

std::string_view take_word(std::string_view& rest) {
  const std::size_t begin = rest.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return rest = {};
  rest.remove_prefix(begin);
  const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<double> parse_number(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, status] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (status == std::errc::result_out_of_range) return value;  // infinite, or zero for an underflow
  if (status != std::errc()) return std::nullopt;
  return value;
}

std::optional<long long> parse_integer(std::string_view word) {
  word = without_plus(word);
  long long value = 0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (status == std::errc::result_out_of_range) {
    using Limits = std::numeric_limits<long long>;
    return word[0] == '-' ? Limits::min() : Limits::max();
  }
  if (status != std::errc()) return std::nullopt;
  return value;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 32;
  std::string out = "'";
  for (const char c : word.substr(0, kLongest)) out += c >= ' ' && c <= '~' ? c : '?';
  if (word.size() > kLongest) out += "...";
  return out += "'";
}

std::string printable(std::string_view word) {
  std::string out;
  while (!word.empty()) {
    const std::size_t length = utf8_length(word);
    const auto first = static_cast<unsigned char>(word[0]);
    const bool control =  // U+0000 to U+001F and U+007F to U+009F
        first < ' ' || first == 0x7F || (first == 0xC2 && length == 2 && static_cast<unsigned char>(word[1]) < 0xA0);
    if (length == 0 || control) {
      out += '?';
    } else {
      out += word.substr(0, length);
    }
    word.remove_prefix(length > 0 ? length : 1);
  }
  return out;
}

}  // namespace umbilic
