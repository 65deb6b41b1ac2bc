// SPDX-License-Identifier: MIT
/// \file
/// The numbers behind the header of PLY, one after another: as words, or as bytes. Both classes have the same members.
#pragma once

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "cage/formats.h"
#include "cage/ply_header.h"
#include "cage/text.h"

namespace umbilic {

/// Of the format ascii: an element's words are those of one line.
class PlyWords {
 public:
  explicit PlyWords(const PlyHeader& header) : lines_(header.body), header_lines_(header.lines) {}

  /// Goes to the next element; false at the end of the file.
  bool begin() {
    do {
      const auto line = lines_.next();
      if (!line) return false;
      rest_ = line->text;
    } while (is_done());
    return true;
  }

  /// The next number, which is of `property`.
  Result<double> number(PlyType, std::string_view property) {
    const std::string_view word = take_word(rest_);
    if (word.empty()) return Error{fmt::format("the line ends before {}", in_quotes(property))};
    const auto number = parse_number(word);
    if (!number) return Error{fmt::format("{} for {} is not a number", in_quotes(word), in_quotes(property))};
    return *number;
  }

  /// Ends an element; fails if it has more numbers than it should.
  std::optional<Error> end() const {
    std::string_view rest = rest_;
    const std::string_view word = take_word(rest);
    if (word.empty()) return std::nullopt;
    return Error{fmt::format("{} is more than the header announces", in_quotes(word))};
  }

  /// An error in the element: its line.
  Error at(std::string_view /*name*/, long long /*number*/, const std::string& message) const { return here(message); }

  /// An error where the last element ended.
  Error here(const std::string& message) const { return at_line(line(), message); }

  /// Appends the line of the element, for messages of validation.
  void note_line(std::vector<int>& lines) const { lines.push_back(line()); }

 private:
  int line() const { return header_lines_ + lines_.number(); }

  bool is_done() const {
    std::string_view rest = rest_;
    return take_word(rest).empty();
  }

  LineReader lines_;
  int header_lines_;
  std::string_view rest_;
};

/// Of the binary formats.
class PlyBytes {
 public:
  explicit PlyBytes(const PlyHeader& header)
      : rest_(header.body),
        reversed_((header.format == PlyFormat::kBinaryBigEndian) != (std::endian::native == std::endian::big)) {}

  bool begin() const { return !rest_.empty(); }

  Result<double> number(PlyType type, std::string_view property) {
    switch (type) {
      case PlyType::kInt8: return take<std::int8_t>(property);
      case PlyType::kUint8: return take<std::uint8_t>(property);
      case PlyType::kInt16: return take<std::int16_t>(property);
      case PlyType::kUint16: return take<std::uint16_t>(property);
      case PlyType::kInt32: return take<std::int32_t>(property);
      case PlyType::kUint32: return take<std::uint32_t>(property);
      case PlyType::kFloat32: return take<float>(property);
      case PlyType::kFloat64: break;
    }
    return take<double>(property);
  }

  std::optional<Error> end() const { return std::nullopt; }

  Error at(std::string_view name, long long number, const std::string& message) const {
    return Error{fmt::format("{} {}: {}", name, number, message)};
  }

  Error here(const std::string& message) const { return Error{message}; }

  void note_line(std::vector<int>&) const {}

 private:
  template <class T>
  Result<double> take(std::string_view property) {
    std::array<char, sizeof(T)> bytes;
    if (rest_.size() < bytes.size()) return Error{fmt::format("the file ends before {}", in_quotes(property))};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = rest_[reversed_ ? bytes.size() - 1 - i : i];
    rest_.remove_prefix(bytes.size());
    T number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return static_cast<double>(number);
  }

  std::string_view rest_;
  bool reversed_;
};

}  // namespace umbilic
