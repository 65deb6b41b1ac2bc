// SPDX-License-Identifier: MIT
/// \file
/// The tags of subdivision surfaces that OBJ files hold, as OpenSubdiv and its relatives write them.
#include <fmt/format.h>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {
namespace {

struct TagWords {
  std::string_view tag;
  std::string_view what;     // "ignored 2 <what> tags"
  std::string_view instead;  // what the surface is without them
};

/// The last one is any other.
constexpr std::array<TagWords, 4> kTags{{{"crease", "crease ", "edges stay smooth"},
                                         {"corner", "corner ", "vertices stay smooth"},
                                         {"hole", "hole ", "the faces stay"},
                                         {"", "", "they change nothing"}}};

}  // namespace

void TagCounts::append(std::string_view words, int line) {
  const std::string_view tag = take_word(words);
  std::size_t kind = 0;
  while (kind + 1 < kTags.size() && kTags[kind].tag != tag) ++kind;
  if (kinds_[kind].lines++ == 0) kinds_[kind].first_line = line;
}

std::vector<std::string> TagCounts::notes() const {
  std::vector<std::string> notes;
  for (std::size_t kind = 0; kind < kTags.size(); ++kind) {
    const auto [lines, first_line] = kinds_[kind];
    if (lines == 0) continue;
    const auto& [tag, what, instead] = kTags[kind];
    notes.push_back(fmt::format("ignored {} {}tag{} ({} line {}): {}", lines, what, lines == 1 ? "" : "s",
                                lines == 1 ? "on" : "the first on", first_line, instead));
  }
  return notes;
}

}  // namespace umbilic
