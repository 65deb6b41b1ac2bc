// SPDX-License-Identifier: MIT
/// \file
/// Stored entries beside recomputed ones: by the same kernels, and by those of another instruction set.
#include "catalog/comparison.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/each_instruction_set.h"

namespace umbilic::catalog {
namespace {

/// A made-up entry whose limit is 100 +- 0.05, with three converged levels.
Json converged() {
  Json entry{{"status", "converged"}, {"energy", 100.0}, {"error", 0.05}, {"group", {{"name", "D3h"}, {"order", 12}}}};
  entry["levels"] = Json::array();
  for (const double energy : {104.0, 100.4, 100.04}) {
    entry["levels"].push_back({{"evaluable", true}, {"stop", "converged"}, {"energy_reported", energy}});
  }
  entry["second_opinion"] = {{"energy", 100.04}, {"difference", 2e-9}};
  return entry;
}

/// The same levels, which determine no limit.
Json bound(double energy = 100.04) {
  Json entry = converged();
  entry["status"] = "upper_bound";
  entry["energy"] = energy;
  entry["error"] = nullptr;
  return entry;
}

/// With all energies `factor` times as large.
Json scaled(Json entry, double factor) {
  entry["energy"] = factor * entry["energy"].get<double>();
  for (Json& level : entry["levels"]) level["energy_reported"] = factor * level["energy_reported"].get<double>();
  entry["second_opinion"]["energy"] = factor * entry["second_opinion"]["energy"].get<double>();
  return entry;
}

TEST(CatalogComparison, knows_the_kernels_in_use_by_the_name_of_their_instruction_set) {
  test::with_each_instruction_set([](InstructionSet set) {
    for (const std::string_view name : kInstructionSetNames) {
      EXPECT_EQ(kernels_of(name), name == name_of(set) ? Kernels::kSame : Kernels::kOther) << name;
    }
    EXPECT_EQ(kernels_of(""), Kernels::kSame) << "a report that names none";
  });
}

TEST(CatalogComparison, of_the_same_kernels_allows_1e_5_of_the_last_level) {
  EXPECT_EQ(difference(converged(), scaled(converged(), 1 + 9e-6), Kernels::kSame), "");
  EXPECT_NE(difference(converged(), scaled(converged(), 1 + 2e-5), Kernels::kSame).find("more than 1e-05"),
            std::string::npos);
  EXPECT_EQ(difference(bound(), converged(), Kernels::kSame), "was upper_bound, is converged");
}

TEST(CatalogComparison, of_other_kernels_allows_the_error_bar) {
  EXPECT_EQ(difference(converged(), scaled(converged(), 1 + 4e-4), Kernels::kOther), "");
  EXPECT_EQ(difference(converged(), scaled(converged(), 1 - 4e-4), Kernels::kOther), "");
  EXPECT_NE(difference(converged(), scaled(converged(), 1 + 6e-4), Kernels::kOther), "");
  Json again = converged();
  again["levels"][1]["energy_reported"] = 100.6;
  EXPECT_NE(difference(converged(), again, Kernels::kOther).find("level 1: 100.6 was 100.4"), std::string::npos);
  again = converged();
  again["energy"] = 100.06;
  EXPECT_NE(difference(converged(), again, Kernels::kOther), "") << "the limit is another one";
}

TEST(CatalogComparison, of_other_kernels_allows_1e_3_where_there_is_no_error_bar) {
  EXPECT_EQ(difference(bound(), scaled(bound(), 1 + 9e-4), Kernels::kOther), "");
  EXPECT_NE(difference(bound(), scaled(bound(), 1 + 2e-3), Kernels::kOther), "");
}

TEST(CatalogComparison, of_other_kernels_is_no_closer_than_that_of_the_same) {
  Json narrow = converged();
  narrow["error"] = 1e-5;
  EXPECT_EQ(difference(narrow, scaled(narrow, 1 + 9e-6), Kernels::kOther), "");
  Json unsettled = bound();
  unsettled["levels"][2]["stop"] = "max_iterations";
  for (const Kernels kernels : {Kernels::kSame, Kernels::kOther}) {
    EXPECT_EQ(difference(unsettled, scaled(unsettled, 1.09), kernels), "");
    EXPECT_NE(difference(unsettled, scaled(unsettled, 1.11), kernels), "");
  }
}

TEST(CatalogComparison, of_other_kernels_lets_a_limit_be_an_upper_bound_that_is_not_below_its_bar) {
  EXPECT_EQ(difference(bound(), converged(), Kernels::kOther), "");
  EXPECT_EQ(difference(converged(), bound(99.96), Kernels::kOther), "");
  EXPECT_EQ(difference(converged(), bound(99.94), Kernels::kOther), "was converged, is upper_bound");
  EXPECT_EQ(difference(bound(99.94), converged(), Kernels::kOther), "was upper_bound, is converged");
  Json none = bound();
  none["status"] = "none_found";
  EXPECT_EQ(difference(converged(), none, Kernels::kOther), "was converged, is none_found");
  Json other = bound();
  other["levels"][2]["energy_reported"] = 100.2;
  EXPECT_NE(difference(converged(), other, Kernels::kOther).find("level 2"), std::string::npos);
}

TEST(CatalogComparison, is_of_second_opinions_where_both_have_one) {
  Json other = converged();
  other["second_opinion"]["energy"] = 100.07;
  EXPECT_EQ(difference(converged(), other, Kernels::kSame),
            "second opinion: 100.07 was 100.04, 3.0e-04 off, more than 1e-05");
  EXPECT_EQ(difference(converged(), other, Kernels::kOther), "");
  other["second_opinion"]["energy"] = 100.2;
  EXPECT_NE(difference(converged(), other, Kernels::kOther).find("second opinion: "), std::string::npos);
  other["second_opinion"]["energy"] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(difference(converged(), other, Kernels::kSame), "");
  Json before = other;
  before["second_opinion"]["energy"] = nullptr;
  EXPECT_EQ(difference(before, other, Kernels::kSame), "") << "null is how NaN is written";
  other.erase("second_opinion");
  EXPECT_EQ(difference(converged(), other, Kernels::kSame), "");
  EXPECT_EQ(difference(other, converged(), Kernels::kSame), "") << "an earlier version stored none";
}

TEST(CatalogComparison, of_starts_allows_1e_5_or_1e_3_once_they_have_converged) {
  const auto start = [](double energy, const char* stop) {
    return Json{{"level", 3}, {"energy", energy}, {"stop", stop}};
  };
  const Json stored = start(100, "converged");
  EXPECT_NE(start_difference(stored, start(100.05, "converged"), Kernels::kSame), "");
  EXPECT_EQ(start_difference(stored, start(100.05, "converged"), Kernels::kOther), "");
  EXPECT_NE(start_difference(stored, start(100.2, "converged"), Kernels::kOther), "");
  EXPECT_EQ(start_difference(stored, start(105, "max_iterations"), Kernels::kSame), "");
}

}  // namespace
}  // namespace umbilic::catalog
