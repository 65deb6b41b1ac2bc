// SPDX-License-Identifier: MIT
/// \file
/// Goes over the members of the structs and describes them.
#include "problem/text.h"

namespace umbilic {
namespace {

class SchemaPrinter {
 public:
  /// A member.
  template <class T>
  void operator()(std::string_view name, T& member, std::string_view words) {
    out_.begin_member(name);
    out_.open('{');
    out_("description", words);
    describe(member);
    out_.close('}');
  }
  template <class T>
  void required(std::string_view name, T& member, std::string_view words) {
    required_.push_back(name);
    (*this)(name, member, words);
  }
  template <class T>
  void pair(std::string_view name, T& first, T&, std::string_view words) {
    out_.begin_member(name);
    out_.open('{');
    out_("description", words);
    out_("type", "array");
    items(first);
    out_("minItems", 2);
    out_("maxItems", 2);
    out_.close('}');
  }

  /// A problem or a report, which begins with what it is.
  template <class T>
  void document(std::string_view kind) {
    out_.begin_element();
    out_.open('{');
    out_("title", kind);
    describe_members(T(), kind);
    out_.close('}');
  }

  JsonPrinter& out() { return out_; }

 private:
  // Each `describe` prints the inside of a type's schema.
  void describe(const bool&) { out_("type", "boolean"); }
  void describe(const int&) { out_("type", "integer"); }
  void describe(const double&) {
    if (unknown_ == Unknown::kRefused) return out_("type", "number");
    out_("type", std::vector<std::string>{"number", "null"});  // a result may be NaN, what is asked may not
  }
  void describe(const std::string&) { out_("type", "string"); }
  void describe(const Points&) {
    out_("type", "array");
    items(double());
  }
  void describe(const Weights&) {
    out_("type", "object");
    out_.begin_member("properties");
    out_.open('{');
    for (const std::string_view name : kFunctionalNames) {
      out_.begin_member(name);
      out_.open('{');
      out_("type", "number");
      out_("minimum", 0);
      out_.close('}');
    }
    out_.close('}');
    out_("additionalProperties", false);
    out_("minProperties", 1);
  }
  template <NamedEnumeration E>
  void describe(const E&) {
    out_("enum", names_of<E>());
  }
  template <class T>
  void describe(const std::optional<T>&) {
    describe(T());
  }
  template <class T>
  void describe(const std::vector<T>&) {
    out_("type", "array");
    items(T());
  }
  template <class T, std::size_t count>
  void describe(const std::array<T, count>&) {
    out_("type", "array");
    items(T());
    out_("minItems", static_cast<int>(count));
    out_("maxItems", static_cast<int>(count));
  }
  template <class... Alternatives>
  void describe(const std::variant<Alternatives...>&) {
    out_.begin_member("oneOf");
    out_.open('[');
    (alternative(Alternatives()), ...);
    out_.close(']');
  }
  template <HasMembers T>
  void describe(const T& value) {
    describe_members(value, "");
  }

  template <class T>
  void alternative(const T& value) {
    out_.begin_element();
    out_.open('{');
    describe(value);
    out_.close('}');
  }

  template <class T>
  void items(const T& element) {
    out_.begin_member("items");
    out_.open('{');
    describe(element);
    out_.close('}');
  }

  template <class T>
  void constant(std::string_view name, const T& value) {
    required_.push_back(name);
    out_.begin_member(name);
    out_.open('{');
    out_("const", value);
    out_.close('}');
  }

  template <class T>
  void describe_members(const T& value, std::string_view kind) {
    const Unknown outside = unknown_;
    if constexpr (requires { T::kUnknown; }) unknown_ = T::kUnknown;
    std::vector<std::string_view> required;
    required.swap(required_);
    out_("type", "object");
    out_.begin_member("properties");
    out_.open('{');
    if (!kind.empty()) {
      constant("umbilic", kind);
      constant("version", kTextVersion);
    }
    T::members(*this, value);
    out_.close('}');
    if (!required_.empty()) out_("required", required_);
    required.swap(required_);
    if (unknown_ == Unknown::kRefused) out_("additionalProperties", false);
    unknown_ = outside;
  }

  JsonPrinter out_{JsonPrinter::Layout::kIndented};
  std::vector<std::string_view> required_;  // of the object that is described
  Unknown unknown_ = Unknown::kRefused;
};

}  // namespace

std::string schema_text() {
  SchemaPrinter schema;
  JsonPrinter& out = schema.out();
  out.open('{');
  out("$schema", "http://json-schema.org/draft-07/schema#");
  out("title", "A problem or a report of umbilic");
  out.begin_member("oneOf");
  out.open('[');
  schema.document<Problem>("problem");
  schema.document<Report>("report");
  out.close(']');
  out.close('}');
  return out.take() + "\n";
}

}  // namespace umbilic
