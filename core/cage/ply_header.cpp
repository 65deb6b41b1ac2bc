// SPDX-License-Identifier: MIT
/// \file
/// Reads the header of PLY.
#include "cage/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {

namespace {

constexpr std::string_view kPly = "ply";

constexpr std::array<std::pair<std::string_view, PlyFormat>, 3> kPlyFormats{
    {{"ascii", PlyFormat::kAscii},
     {"binary_little_endian", PlyFormat::kBinaryLittleEndian},
     {"binary_big_endian", PlyFormat::kBinaryBigEndian}}};

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kPlyTypes{{{"char", PlyType::kInt8},
                                                                          {"int8", PlyType::kInt8},
                                                                          {"uchar", PlyType::kUint8},
                                                                          {"uint8", PlyType::kUint8},
                                                                          {"short", PlyType::kInt16},
                                                                          {"int16", PlyType::kInt16},
                                                                          {"ushort", PlyType::kUint16},
                                                                          {"uint16", PlyType::kUint16},
                                                                          {"int", PlyType::kInt32},
                                                                          {"int32", PlyType::kInt32},
                                                                          {"uint", PlyType::kUint32},
                                                                          {"uint32", PlyType::kUint32},
                                                                          {"float", PlyType::kFloat32},
                                                                          {"float32", PlyType::kFloat32},
                                                                          {"double", PlyType::kFloat64},
                                                                          {"float64", PlyType::kFloat64}}};

template <class Table>
auto called(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.first == name; });
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

/// The lines of a header. All end as the first one does: bytes may follow that look like the rest of a line's end.
class PlyHeaderLines {
 public:
  explicit PlyHeaderLines(std::string_view file) : rest_(file) {
    const std::size_t end = file.find_first_of("\r\n");
    if (end != std::string_view::npos && file[end] == '\r' && file.substr(end + 1, 1) != "\n") end_ = '\r';
  }

  /// The next line without its end; nothing where no further line ends.
  std::optional<std::string_view> next() {
    const std::size_t end = rest_.find(end_);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    ++number_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  std::string_view rest() const { return rest_; }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  char end_ = '\n';
  int number_ = 0;
};

/// Collects what the lines of a header say. Errors name no line.
class PlyHeaderParser {
 public:
  explicit PlyHeaderParser(std::string_view file) : lines_(file) { lines_.next(); }

  Result<PlyHeader> parse() {
    for (auto line = lines_.next(); line; line = lines_.next()) {
      std::string_view words = *line;
      const std::string_view keyword = take_word(words);
      if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
      auto error = keyword == "end_header" ? std::nullopt : parse_line(keyword, words);
      if (!error && !has_format_) error = Error{"the line of the format must come first"};
      if (!error && !take_word(words).empty())
        error = Error{fmt::format("more words than {} takes", in_quotes(keyword))};
      if (error) return at_line(lines_.number(), error->message);
      if (keyword == "end_header") return finished();
    }
    return at_line(lines_.number() + 1, "the file ends before the line end_header");
  }

 private:
  std::optional<Error> parse_line(std::string_view keyword, std::string_view& words) {
    if (keyword == "format") return parse_format(words);
    if (keyword == "element") return parse_element(words);
    if (keyword == "property") return parse_property(words);
    return Error{fmt::format("expected element, property, comment or end_header, found {}", in_quotes(keyword))};
  }

  std::optional<Error> parse_format(std::string_view& words) {
    const std::string_view name = take_word(words);
    const std::string_view version = take_word(words);
    const auto format = called(kPlyFormats, name);
    if (!format) {
      return Error{fmt::format("format {} is none of ascii, binary_little_endian, binary_big_endian", in_quotes(name))};
    }
    if (version != "1.0") return Error{fmt::format("version {} of the format is not 1.0", in_quotes(version))};
    if (std::exchange(has_format_, true)) return Error{"a second line of the format"};
    header_.format = *format;
    return std::nullopt;
  }

  std::optional<Error> parse_element(std::string_view& words) {
    const std::string_view name = take_word(words);
    const std::string_view word = take_word(words);
    const auto count = parse_integer(word);
    if (name.empty() || !count || *count < 0) {
      return Error{fmt::format("expected the name of an element and how many there are, found {} and {}",
                               in_quotes(name), in_quotes(word))};
    }
    header_.elements.push_back({name, *count, lines_.number()});
    return std::nullopt;
  }

  std::optional<Error> parse_property(std::string_view& words) {
    if (header_.elements.empty()) return Error{"a property before the first element"};
    PlyProperty property;
    std::string_view word = take_word(words);
    if (word == "list") {
      word = take_word(words);
      property.length_type = called(kPlyTypes, word);
      if (!property.length_type) return no_type(word);
      word = take_word(words);
    }
    const auto type = called(kPlyTypes, word);
    if (!type) return no_type(word);
    property.type = *type;
    property.name = take_word(words);
    if (property.name.empty()) return Error{"the property has no name"};
    header_.elements.back().properties.push_back(property);
    return std::nullopt;
  }

  static Error no_type(std::string_view word) {
    return Error{fmt::format("{} is no type of a property (as uchar, int, float or double are)", in_quotes(word))};
  }

  PlyHeader finished() {
    header_.body = lines_.rest();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  PlyHeaderLines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

const PlyElement* PlyHeader::find(std::string_view name) const {
  const auto found = std::find_if(elements.begin(), elements.end(), [&](const auto& e) { return e.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

bool is_ply(std::string_view file) {
  std::string_view line = file.substr(0, file.find_first_of("\r\n"));
  return take_word(line) == kPly && file.starts_with(kPly) && take_word(line).empty();
}

Result<PlyHeader> parse_ply_header(std::string_view file) { return PlyHeaderParser(file).parse(); }

}  // namespace umbilic
