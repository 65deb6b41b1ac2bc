// SPDX-License-Identifier: MIT
/// \file
/// Fuzzes the readers of cages, validation, and the writer.
#include <cstring>
#include <string>
#include <vector>

#include "cage/read.h"
#include "cage/write.h"
#include "tests/fuzz/targets.h"

namespace umbilic::fuzz {

namespace {

/// Equal to the last bit.
bool is_same(const Cage& a, const Cage& b) {
  const auto size = sizeof(double) * static_cast<std::size_t>(a.vertices.size());
  if (a.vertices.size() != b.vertices.size() || a.faces != b.faces || a.groups.size() != b.groups.size()) return false;
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    if (a.groups[g].name != b.groups[g].name || a.groups[g].faces != b.groups[g].faces) return false;
  }
  return size == 0 || std::memcmp(a.vertices.data(), b.vertices.data(), size) == 0;
}

}  // namespace

void cages(std::string_view file) {
  const Result<CheckedCage> read = read_checked_cage(file);
  const Result<std::string> text = cage_text(file);
  if (!text) require(!read && text.error().message == read.error().message, "both doors refuse a file for one reason");
  if (!read) return require_words(read.error().message);

  const Result<CheckedCage> from_text = read_checked_cage(*text);
  require(from_text && is_same(from_text->cage, read->cage), "a file's text holds its cage");
  const Result<Cage> written = read_cage(write_obj(read->cage));
  require(written && is_same(*written, read->cage), "what is written reads back to the same bits");
  Cage again = read->cage;
  const Result<CageReport> report = validate(again);
  require(report && report->repairs.empty() && is_same(again, read->cage), "a validated cage validates unchanged");
}

}  // namespace umbilic::fuzz
