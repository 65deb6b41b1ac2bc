// SPDX-License-Identifier: MIT
/// \file
/// Entries: their status, and how they are stored and compared.
#include "catalog/entry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/each_instruction_set.h"
#include "catalog/catalog_json.h"
#include "catalog/comparison.h"
#include "problem/text.h"

namespace umbilic::catalog {
namespace {

using std::numbers::pi;

Entry entry(const char* shape, const char* functional, int last_level) {
  const CatalogShape& row = shape_called(shape);
  const CatalogFunctional& column = functional_called(functional);
  return *compute_entry(row, column, entry_settings(row, column, last_level), [](const umbilic::Run&) { return true; });
}

TEST(CatalogEntrySlow, of_the_spheres_bending_converges_to_8_pi) {
  const Entry sphere = entry("sphere", "bending", 3);
  EXPECT_EQ(sphere.status, EntryStatus::kConverged);
  EXPECT_NEAR(sphere.energy, 8 * pi, *sphere.error);
  EXPECT_LT(*sphere.error, 1e-3 * sphere.energy);
  EXPECT_EQ(sphere.exact->energy, 8 * pi);
  EXPECT_TRUE(sphere.reason.empty());
  EXPECT_EQ(sphere.certificate->negative, 0);
}

TEST(CatalogEntry, of_an_infimum_that_is_known_has_no_error_but_a_reason) {
  const Entry sphere = entry("sphere", "mvs_cross", 1);
  EXPECT_EQ(sphere.status, EntryStatus::kZeroAttained);
  EXPECT_EQ(sphere.energy, 0);
  const Entry torus = entry("torus", "mvs_cross", 1);
  EXPECT_EQ(torus.status, EntryStatus::kInfimumNotAttained);
  EXPECT_NEAR(torus.energy, 8 * std::pow(pi, 4), 1e-9);
  EXPECT_GT(torus.levels.back().energy_reported, torus.energy);
  for (const Entry& e : {sphere, torus}) {
    EXPECT_FALSE(e.error);
    EXPECT_FALSE(e.reason.empty());
    EXPECT_FALSE(e.certificate) << "there is no minimum near it";
  }
}

TEST(CatalogEntrySlow, of_too_few_levels_is_an_upper_bound) {
  const Entry frame = entry("two-3", "bending", 1);
  EXPECT_EQ(frame.status, EntryStatus::kUpperBound);
  EXPECT_EQ(frame.energy, frame.levels.back().energy_reported);
  EXPECT_GT(frame.energy, frame.exact->energy);
  EXPECT_EQ(frame.group.name, "D3h");
  EXPECT_EQ(frame.second->family, FrameFamily::kHub);
  EXPECT_EQ(frame.second->levels.size(), 2u);
}

TEST(CatalogEntrySlow, tells_what_a_minimizer_with_directions_of_descent_descends_to) {
  const Entry frame = entry("tetrahedron-frame", "bending", 2);
  ASSERT_EQ(frame.certificate->negative, 2);
  ASSERT_TRUE(frame.below);
  EXPECT_EQ(frame.below->group.name, "D2");
  EXPECT_EQ(frame.below->certificate->negative, 0);
  const double lawson = exact_energy(shape_called("two-4"), functional_called("bending"))->energy;
  EXPECT_NEAR(frame.below->result.energy_reported, lawson, 1e-4 * lawson);
  EXPECT_LT(frame.below->result.energy_reported, 0.99 * frame.energies.functionals[kBending]);

  const Json stored = json_of(frame);
  EXPECT_EQ(stored.at("below").at("energy"), frame.below->result.energy_reported);
  EXPECT_EQ(difference(stored, stored, Kernels::kSame), "");
  Json other = stored;
  other.erase("below");
  EXPECT_NE(difference(stored, other, Kernels::kSame), "");
  other = stored;
  other["below"]["energy"] = 1.001 * frame.below->result.energy_reported;
  EXPECT_NE(difference(stored, other, Kernels::kSame), "");
  Json described{{"energies", part_json(frame.below->energies)}};
  EXPECT_EQ(misfit(described, *below_text(frame, "1.2.3")), "") << "the file holds this surface";
}

TEST(CatalogEntry, of_one_level_descends_from_that) {
  const Entry torus = entry("torus", "bending", 0);
  ASSERT_GT(torus.certificate->negative, 0) << "directions that only so coarse a mesh has";
  ASSERT_TRUE(torus.below);
  EXPECT_LT(torus.below->result.energy_reported, torus.result.energy_reported);
}

TEST(CatalogEntry, has_nothing_below_a_certified_minimum) {
  const Entry frame = entry("two-3", "bending", 2);
  ASSERT_EQ(frame.certificate->negative, 0);
  EXPECT_FALSE(frame.below);
  EXPECT_FALSE(json_of(frame).contains("below"));
  EXPECT_FALSE(below_text(frame, "1.2.3"));
}

TEST(CatalogEntrySlow, is_computed_to_the_same_digits_again_and_its_file_holds_its_surface) {
  for (const char* functional : {"bending", "mvs"}) {
    const Entry first = entry("two-3", functional, 1);
    const Json stored = json_of(first);
    const std::string minimizer = minimizer_text(first, "1.2.3");
    const Entry second = entry("two-3", functional, 1);
    EXPECT_EQ(json_of(second).dump(), stored.dump());
    EXPECT_EQ(minimizer_text(second, "1.2.3"), minimizer);
    EXPECT_EQ(difference(stored, json_of(second), Kernels::kSame), "");
    EXPECT_EQ(misfit(Json::parse(stored.dump()), minimizer), "");
  }
}

TEST(CatalogEntrySlow, agrees_on_every_instruction_set_within_what_is_reproducible) {
  for (const char* functional : {"bending", "mvs", "mvs_cross", "bending_mvs_cross"}) {
    const Json stored = json_of(entry("two-3", functional, 1));
    test::with_each_instruction_set([&](InstructionSet) {
      EXPECT_EQ(difference(stored, json_of(entry("two-3", functional, 1)), Kernels::kSame), "");
    });
  }
}

TEST(CatalogEntry, differs_from_one_that_is_off_by_more_than_rounding_explains) {
  const Entry sphere = entry("sphere", "bending", 1);
  const Json right = json_of(sphere);
  Json wrong = right;
  wrong["levels"][1]["energy_reported"] = 1.0001 * sphere.levels[1].energy_reported;
  EXPECT_NE(difference(wrong, right, Kernels::kSame).find("1.0e-04 off"), std::string::npos)
      << difference(wrong, right, Kernels::kSame);
  wrong = right;
  wrong["status"] = "none_found";
  EXPECT_EQ(difference(wrong, right, Kernels::kSame), "was none_found, is upper_bound");

  Json minimizer = Json::parse(minimizer_text(sphere, "1.2.3"));
  Json& points = minimizer["surface"]["points"];
  points[5] = points[5].get<double>() + 1e-3;
  EXPECT_NE(misfit(right, minimizer.dump()).find("of the stored surface"), std::string::npos);
  points.erase(0);
  EXPECT_NE(misfit(right, minimizer.dump()).find("not three for each point"), std::string::npos);
  minimizer.erase("surface");
  EXPECT_EQ(misfit(right, minimizer.dump()), "it holds no surface");
}

/// The second opinion of an entry is about the surface whose energies it has.
void expect_same_surface(const Entry& entry) {
  const OpinionReport& opinion = entry.second_opinion;
  EXPECT_NEAR(opinion.values.area, entry.energies.area, 1e-6 * entry.energies.area);
  EXPECT_NEAR(opinion.values.gaussian, entry.energies.gaussian, 1e-4);
  for (const int i : {kBending, kMehlumTarrou}) {
    const double energy = entry.energies.functionals[i];
    EXPECT_NEAR(opinion.values.functionals[i], energy, 1e-3 * energy);
    EXPECT_DOUBLE_EQ(opinion.differences.functionals[i], energy - opinion.values.functionals[i]);
  }
}

TEST(CatalogEntry, has_a_second_opinion_of_all_integrals_in_its_file_and_of_the_minimized_one_in_the_list) {
  const Entry torus = entry("torus", "bending_mvs_cross", 1);
  expect_same_surface(torus);
  const Report report = *parse_report(minimizer_text(torus, "1.2.3"));
  ASSERT_TRUE(report.second_opinion);
  EXPECT_EQ(report.second_opinion->values.area, torus.second_opinion.values.area);
  EXPECT_FALSE(report.problem.options.second_opinion) << "who goes on from the file has not asked for one";

  const Json listed = json_of(torus).at("second_opinion");
  const auto& values = torus.second_opinion.values.functionals;
  EXPECT_DOUBLE_EQ(listed.at("energy"), values[kBending] + values[kMvsCross]);
  EXPECT_NEAR(listed.at("difference"), torus.result.energy_reported / listed.at("energy").get<double>() - 1, 1e-14);
  EXPECT_LT(std::abs(listed.at("difference").get<double>()), 1e-4);
}

TEST(CatalogEntry, has_the_second_opinion_of_the_level_that_it_shows) {
  const CatalogShape& shape = shape_called("torus");
  const CatalogFunctional& functional = functional_called("bending");
  EntrySettings settings = entry_settings(shape, functional, 1);
  settings.certified_faces.reset();
  settings.shown_level = 0;
  const Entry shown = *compute_entry(shape, functional, settings, [](const umbilic::Run&) { return true; });
  ASSERT_EQ(shown.result.level, 0);
  ASSERT_EQ(shown.levels.size(), 2u);
  EXPECT_NEAR(shown.second_opinion.values.functionals[kBending], shown.levels[0].energy_reported, 1e-6);
  EXPECT_GT(shown.levels[0].energy_reported - shown.levels[1].energy_reported, 1e-5);
}

TEST(CatalogEntry, ends_where_it_is_asked_to) {
  const CatalogShape& shape = shape_called("two-3");
  const CatalogFunctional& functional = functional_called("mvs_cross");
  int units = 0;
  EXPECT_FALSE(compute_entry(shape, functional, entry_settings(shape, functional, 2),
                             [&](const umbilic::Run&) { return ++units < 30; }));
  EXPECT_EQ(units, 30);
}

TEST(CatalogEntry, of_two_families_agree_where_their_error_bars_overlap) {
  const LimitReport a{LimitStatus::kConverging, 10, 2, 1}, near{LimitStatus::kConverging, 11.5, 2, 0.6},
      far{LimitStatus::kConverging, 11.7, 2, 0.6}, none{LimitStatus::kNotConverging, 10, 2, NAN};
  EXPECT_EQ(agree(a, near), true);
  EXPECT_EQ(agree(far, a), false);
  EXPECT_EQ(agree(a, none), std::nullopt);
}

}  // namespace
}  // namespace umbilic::catalog
