// SPDX-License-Identifier: MIT
/// \file
/// Prints numbers and strings, and lays out the text.
#include "problem/print.h"

#include <fmt/format.h>

#include <cmath>

#include "base/utf8.h"

namespace umbilic {
namespace {

/// Control characters, all below U+0020, and characters with a meaning in JSON.
void append_escaped(std::string& text, char c) {
  switch (c) {
    case '"': text += "\\\""; break;
    case '\\': text += "\\\\"; break;
    case '\n': text += "\\n"; break;
    case '\r': text += "\\r"; break;
    case '\t': text += "\\t"; break;
    default:
      if (static_cast<unsigned char>(c) < 0x20) {
        text += fmt::format("\\u{:04x}", static_cast<int>(c));
      } else {
        text += c;
      }
  }
}

}  // namespace

void JsonPrinter::print(bool value) { text_ += value ? "true" : "false"; }

void JsonPrinter::print(int value) { text_ += fmt::format("{}", value); }

void JsonPrinter::print(double value) {
  if (!std::isfinite(value)) {
    text_ += "null";
  } else if (value == 0 && std::signbit(value)) {
    text_ += "-0.0";  // a reader that treats integers separately would lose the sign of -0
  } else {
    text_ += fmt::format("{}", value);
  }
}

/// JSON must be UTF-8. Invalid bytes, which a comment in a file may contain, become U+FFFD.
void JsonPrinter::print(std::string_view value) {
  text_ += '"';
  while (!value.empty()) {
    const std::size_t length = utf8_length(value);
    if (length == 1) {
      append_escaped(text_, value[0]);
    } else {
      text_ += length > 0 ? value.substr(0, length) : "\xEF\xBF\xBD";
    }
    value.remove_prefix(length > 0 ? length : 1);
  }
  text_ += '"';
}

void JsonPrinter::print(const Points& points) {
  text_ += '[';
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    if (i > 0) text_ += layout_ == Layout::kIndented ? ", " : ",";
    print(points.data()[i]);
  }
  text_ += ']';
}

void JsonPrinter::print(const Weights& weights) {
  open('{');
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (weights[i] != 0) (*this)(kFunctionalNames[i], weights[i]);
  }
  close('}');
}

void JsonPrinter::open(char bracket) {
  text_ += bracket;
  ++depth_;
  empty_ = true;
}

void JsonPrinter::close(char bracket) {
  --depth_;
  if (!empty_) new_line();
  text_ += bracket;
  empty_ = false;
}

void JsonPrinter::begin_member(std::string_view name) {
  begin_element();
  print(name);
  text_ += layout_ == Layout::kIndented ? ": " : ":";
}

void JsonPrinter::begin_element() {
  if (!empty_) text_ += ',';
  empty_ = false;
  new_line();
}

void JsonPrinter::new_line() {
  if (layout_ == Layout::kIndented) text_.append("\n").append(2 * depth_, ' ');
}

}  // namespace umbilic
