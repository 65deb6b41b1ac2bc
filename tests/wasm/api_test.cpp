// SPDX-License-Identifier: MIT
/// \file
/// The C contract as a C program would use it: what each function answers.
#include "wasm/api.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "cage/generate.h"
#include "cage/ply_writer.h"
#include "cage/write.h"
#include "tests/wasm/runs.h"

namespace umbilic::test {
namespace {

TEST(Api, has_the_version_of_its_header) { EXPECT_EQ(umbilic_api_version(), UMBILIC_API_VERSION); }

TEST(Api, runs_the_example_in_its_header) {
  umbilic_run* run;
  const char problem[] =
      "{\"umbilic\": \"problem\", \"version\": 1, \"cage\": {\"generator\": \"two-3\"},"
      " \"terms\": {\"bending\": 1}}";
  ASSERT_EQ(umbilic_run_create(problem, strlen(problem), NULL, 0, &run), UMBILIC_OK) << message();
  int32_t done = 0;
  while (!done && umbilic_run_step(run, 10, &done) == UMBILIC_OK) {
  }
  const Report report = report_of(run);
  EXPECT_EQ(report.program, umbilic_version());
  EXPECT_EQ(report.levels.size(), 3u);
  EXPECT_EQ(report.cage.genus, 2);
}

TEST(Api, names_the_symmetry_that_a_run_keeps_before_its_first_step) {
  for (const bool symmetry : {true, false}) {
    Problem problem = bending_of("two-3");
    problem.options.symmetry = symmetry;
    umbilic_run* run = begun(problem);
    EXPECT_EQ(part(run, UMBILIC_PART_GROUP), symmetry ? R"({"name":"D3h","order":12})" : R"({"name":"C1","order":1})");
    umbilic_run_destroy(run);
  }
}

TEST(Api, minimizes_in_the_metric_that_is_asked_for) {
  const MetricChoice used[] = {MetricChoice::kHessian, MetricChoice::kIdentity, MetricChoice::kSobolev,
                               MetricChoice::kHessian, MetricChoice::kNewton};
  for (int metric = 0; metric < kMetricChoiceCount; ++metric) {
    Problem problem = bending_of("cube");
    problem.options.metric = static_cast<MetricChoice>(metric);
    problem.options.max_iterations = 3;
    const Report report = report_of(finished(problem));
    ASSERT_EQ(report.levels.size(), 1u);
    EXPECT_EQ(report.levels[0].metric, used[metric]);
    EXPECT_EQ(report.levels[0].metrics > 0, metric != 1) << "how often it was built";
  }
}

TEST(Api, gives_the_same_surface_with_any_number_of_threads) {
  std::vector<SurfaceState> surfaces;
  for (const int32_t threads : {1, 3, 2}) {
    ASSERT_EQ(umbilic_use_threads(threads), UMBILIC_OK);
    surfaces.push_back(report_of(finished(bending_of("two-3", 1, 1))).surface.value());
    EXPECT_EQ(surfaces.back().points, surfaces.front().points);
  }
  for (const int32_t none : {0, -1, 257}) EXPECT_EQ(umbilic_use_threads(none), UMBILIC_BAD_ARGUMENT);
  EXPECT_EQ(message(), "threads: 257 is not from 1 to 256");
  EXPECT_EQ(umbilic_use_threads(1), UMBILIC_OK);
}

TEST(Api, tells_which_levels_only_prepare_the_first_evaluable_one) {
  const Report report = report_of(finished(bending_of("cube", 0, 1)));
  ASSERT_EQ(report.levels.size(), 2u);
  EXPECT_EQ(report.levels[0].level, 0);
  EXPECT_EQ(report.levels[0].patches, 24) << "evaluated on the faces of level 1";
  EXPECT_FALSE(report.levels[0].evaluable);
  EXPECT_EQ(report.levels[1].level, 1);
  EXPECT_EQ(report.levels[1].stop, StopReason::kConverged);
  EXPECT_TRUE(report.levels[1].evaluable);
}

TEST(Api, extrapolates_from_three_evaluable_levels) {
  const LimitReport two = report_of(finished(bending_of("cube", 1, 2))).limit;
  const LimitReport three = report_of(finished(bending_of("cube", 1, 3))).limit;
  EXPECT_EQ(two.status, LimitStatus::kTooFewLevels);
  EXPECT_TRUE(std::isfinite(two.energy));
  EXPECT_TRUE(std::isnan(two.error));
  EXPECT_EQ(three.status, LimitStatus::kConverging);
  EXPECT_LE(std::abs(three.energy - 8 * M_PI), three.error) << "the sphere's energy";
}

TEST(Api, has_a_second_opinion_in_the_report_where_the_problem_asks_for_it) {
  Problem problem = bending_of("cube");
  EXPECT_FALSE(report_of(finished(problem)).second_opinion.has_value());
  problem.options.second_opinion = true;
  const Report report = report_of(finished(problem));
  ASSERT_TRUE(report.second_opinion.has_value());
  EXPECT_TRUE(report.problem.options.second_opinion);
  const double bending = report.second_opinion->values.functionals[kBending];
  EXPECT_NEAR(bending, report.energies.functionals[kBending], 1e-5 * bending);
  EXPECT_NEAR(report.second_opinion->differences.functionals[kBending], 0, 1e-5 * bending);
}

TEST(Api, counts_the_levels_and_evaluations_of_a_run_as_it_goes) {
  umbilic_run* run = begun(bending_of("cube", 1, 2));
  EXPECT_NE(part(run, UMBILIC_PART_PROGRESS).find(R"("phase":"prepare","level":1,"ended_levels":0)"),
            std::string::npos);
  EXPECT_EQ(part(run, UMBILIC_PART_ESTIMATE).find(R"({"levels":[{"level":1,"patches":24,)"), 0U);
  EXPECT_EQ(part(run, UMBILIC_PART_LEVELS), "[]");
  ASSERT_EQ(umbilic_run_cancel(run), UMBILIC_OK);
  int32_t done = 0;
  ASSERT_EQ(umbilic_run_step(run, 1, &done), UMBILIC_OK);
  EXPECT_EQ(done, 1);
  EXPECT_NE(part(run, UMBILIC_PART_PROGRESS).find(R"("phase":"done","level":1,"ended_levels":1)"), std::string::npos);
  EXPECT_NE(part(run, UMBILIC_PART_LEVELS).find(R"("stop":"cancelled")"), std::string::npos);
  EXPECT_NE(part(run, UMBILIC_PART_LIMIT).find(R"("status":"too_few_levels")"), std::string::npos);
  EXPECT_NE(part(run, UMBILIC_PART_CAGE).find(R"({"vertices":8,"edges":12,"faces":6,"genus":0,)"), std::string::npos);
  umbilic_run_destroy(run);
}

TEST(Api, goes_on_with_other_targets_which_its_problem_then_has) {
  umbilic_run* run = finished(bending_of("cube", 1, 2));
  const auto retarget = [&](const std::string& text) { return umbilic_run_retarget(run, text.data(), text.size()); };
  EXPECT_EQ(retarget(R"({"terms": {"bending": -1}})"), UMBILIC_BAD_INPUT);
  EXPECT_EQ(retarget(R"({"cage": {"generator": "two-3"}})"), UMBILIC_BAD_INPUT);
  EXPECT_EQ(message().substr(0, 15), "'cage': unknown");
  EXPECT_NE(part(run, UMBILIC_PART_PROGRESS).find(R"("phase":"done")"), std::string::npos);
  EXPECT_EQ(retarget(R"({"terms": {"willmore": 2}})"), UMBILIC_OK);
  EXPECT_EQ(part(run, UMBILIC_PART_LEVELS), "[]");
  EXPECT_NE(part(run, UMBILIC_PART_PROBLEM).find(R"("terms":{"willmore":2})"), std::string::npos);
  int32_t done = 0;
  while (!done) ASSERT_EQ(umbilic_run_step(run, 10, &done), UMBILIC_OK);
  EXPECT_NEAR(report_of(run).levels.back().energy, 2 * 4 * M_PI, 1e-2);
}

TEST(Api, certifies_a_sphere_as_a_local_minimum_after_its_run_is_gone) {
  umbilic_run* run = finished(bending_of("cube", 1, 2));
  umbilic_certificate* certificate = nullptr;
  ASSERT_EQ(umbilic_run_certify(run, &certificate), UMBILIC_OK);
  umbilic_text text{};
  EXPECT_EQ(umbilic_run_report(run, certificate, &text), UMBILIC_BAD_ARGUMENT) << "it is not ready";
  EXPECT_EQ(umbilic_certificate_report(certificate, &text), UMBILIC_BAD_ARGUMENT);
  double progress = -1, before = 0;
  ASSERT_EQ(umbilic_certificate_progress(certificate, &progress), UMBILIC_OK);
  EXPECT_EQ(progress, 0);
  for (int32_t done = 0; !done;) {
    ASSERT_EQ(umbilic_certificate_step(certificate, 1, &done), UMBILIC_OK);
    ASSERT_EQ(umbilic_certificate_progress(certificate, &progress), UMBILIC_OK);
    EXPECT_GE(progress, before);
    before = progress;
  }
  EXPECT_EQ(progress, 1);
  ASSERT_EQ(umbilic_run_report(run, certificate, &text), UMBILIC_OK);
  const Report report = parse_report({text.data, text.length}).value();
  ASSERT_TRUE(report.certificate);
  EXPECT_EQ(report.certificate->negative, 0);
  umbilic_run_destroy(run);
  ASSERT_EQ(umbilic_certificate_report(certificate, &text), UMBILIC_OK);
  EXPECT_EQ(std::string(text.data, text.length), R"({"level":2,"unknowns":294,"gauge":10,"tau":0.001,"negative":0})");
  umbilic_certificate_destroy(certificate);
}

TEST(Api, refuses_to_certify_flat_caps_and_leaves_the_handle_untouched) {
  Problem problem = bending_of("cube");
  problem.options.cap = CapKind::kFlat;
  umbilic_run* run = begun(problem);
  umbilic_certificate* certificate = nullptr;
  EXPECT_EQ(umbilic_run_certify(run, &certificate), UMBILIC_BAD_INPUT);
  EXPECT_EQ(certificate, nullptr);
  EXPECT_NE(message().find("flat"), std::string::npos) << message();
  umbilic_run_destroy(run);
}

/// Whether the surface of `again` is the one that `run` ended with, to rounding.
void expect_the_same_surface(const EnergyReport& before, const EnergyReport& after) {
  for (int f = 0; f < kFunctionalCount; ++f) {
    EXPECT_NEAR(after.functionals[f], before.functionals[f], 1e-12 * std::max(1.0, before.functionals[f]));
  }
}

TEST(Api, goes_on_from_a_report_and_from_points_with_the_surface_and_the_level_that_were_there) {
  for (const bool symmetry : {true, false}) {
    Problem problem = bending_of("two-3", 0, 1);
    problem.options.symmetry = symmetry;
    problem.options.max_iterations = 4;
    umbilic_run* run = finished(problem);
    int32_t level = 0;
    const double* points = nullptr;
    size_t count = 0;
    ASSERT_EQ(umbilic_run_state(run, &level, &points, &count), UMBILIC_OK);
    EXPECT_EQ(level, 1);

    Problem from_points = problem;
    from_points.start = SurfaceState{level, {}};
    const std::string text = problem_text(from_points);
    umbilic_run* again = nullptr;
    ASSERT_EQ(umbilic_run_create(text.data(), text.size(), points, count, &again), UMBILIC_OK) << message();
    const Report report = report_of(run);
    EXPECT_EQ(report.surface->points.rows(), static_cast<Eigen::Index>(count));
    const Report first = report_of(again);
    expect_the_same_surface(report.energies, first.energies);
    EXPECT_EQ(first.surface->level, 1) << "level 0 is behind it";
    EXPECT_EQ(first.group.order, symmetry ? 12 : 1);

    const std::string kept = report_text(report);
    ASSERT_EQ(umbilic_run_create(kept.data(), kept.size(), nullptr, 0, &again), UMBILIC_OK) << message();
    expect_the_same_surface(report.energies, report_of(again).energies);
  }
}

TEST(Api, goes_on_without_the_symmetry_that_the_surface_was_minimized_in_and_the_other_way_round) {
  const Report report = report_of(finished(bending_of("two-3", 0, 1)));
  Problem problem = report.problem;
  problem.start = report.surface;
  problem.options.symmetry = false;
  const Report free = report_of(begun(problem));
  EXPECT_EQ(free.group.order, 1);
  expect_the_same_surface(report.energies, free.energies);
  problem.start = free.surface;
  problem.options.symmetry = true;
  const Report symmetric = report_of(begun(problem));
  EXPECT_EQ(symmetric.group.name, "D3h") << "found again from all vertices";
  expect_the_same_surface(report.energies, symmetric.energies);
}

TEST(Api, gives_a_control_mesh_its_edges_once_and_a_limit_mesh_its_curvatures) {
  umbilic_run* run = begun(bending_of("cube", 2, 2));
  umbilic_mesh *control = nullptr, *limit = nullptr;
  ASSERT_EQ(umbilic_run_control_mesh(run, &control), UMBILIC_OK);
  ASSERT_EQ(umbilic_run_limit_mesh(run, 3, &limit), UMBILIC_OK);
  umbilic_mesh_arrays arrays{};
  ASSERT_EQ(umbilic_mesh_view(control, &arrays), UMBILIC_OK);
  EXPECT_EQ(arrays.vertex_count, 98u);
  EXPECT_EQ(arrays.triangle_count, 2 * 96u);
  EXPECT_EQ(arrays.edge_count, 192u);
  EXPECT_EQ(arrays.normals, nullptr);
  EXPECT_EQ(arrays.curvatures, nullptr);
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (size_t i = 0; i < arrays.edge_count; ++i)
    edges.insert(std::minmax(arrays.edges[2 * i], arrays.edges[2 * i + 1]));
  EXPECT_EQ(edges.size(), 192u);
  EXPECT_EQ(arrays.faces[0], 0u);
  EXPECT_EQ(arrays.faces[2 * 96 - 1], 5u) << "the cube's last face";
  ASSERT_EQ(umbilic_mesh_view(limit, &arrays), UMBILIC_OK);
  EXPECT_EQ(arrays.triangle_count, 2 * 96u * 9);
  for (size_t f = 0; f < 6; ++f)
    EXPECT_EQ(std::count(arrays.faces, arrays.faces + arrays.triangle_count, f), 2 * 16 * 9);
  EXPECT_EQ(arrays.edges, nullptr);
  EXPECT_GE(arrays.curvatures[0], arrays.curvatures[1]);
  EXPECT_NEAR(std::hypot(arrays.normals[0], arrays.normals[1], arrays.normals[2]), 1, 1e-6);
  umbilic_text obj{};
  for (const umbilic_mesh* mesh : {control, limit}) {
    ASSERT_EQ(umbilic_mesh_obj(mesh, &obj), UMBILIC_OK);
    EXPECT_EQ(obj.data[obj.length], '\0');
    EXPECT_EQ(std::string(obj.data, 2), "v ");
  }
  for (umbilic_mesh* mesh : {control, limit}) umbilic_mesh_destroy(mesh);
  umbilic_run_destroy(run);
}

TEST(Api, gives_a_limit_mesh_the_density_of_its_energy_if_it_is_asked_for) {
  umbilic_run* run = begun(bending_of("cube", 2, 2));
  umbilic_mesh *without = nullptr, *with = nullptr;
  const std::string terms = R"({"bending": 1})", unknown = R"({"bendin": 1})";
  ASSERT_EQ(umbilic_run_limit_mesh_with_densities(run, 3, unknown.data(), unknown.size(), &with), UMBILIC_BAD_INPUT);
  EXPECT_NE(message().find("bendin"), std::string::npos);
  ASSERT_EQ(umbilic_run_limit_mesh(run, 3, &without), UMBILIC_OK);
  ASSERT_EQ(umbilic_run_limit_mesh_with_densities(run, 3, terms.data(), terms.size(), &with), UMBILIC_OK);
  const float* densities = nullptr;
  size_t count = 77;
  ASSERT_EQ(umbilic_mesh_densities(without, &densities, &count), UMBILIC_OK);
  EXPECT_EQ(densities, nullptr);
  EXPECT_EQ(count, 0u);
  umbilic_mesh_arrays arrays{};
  ASSERT_EQ(umbilic_mesh_view(with, &arrays), UMBILIC_OK);
  ASSERT_EQ(umbilic_mesh_densities(with, &densities, &count), UMBILIC_OK);
  ASSERT_EQ(count, arrays.vertex_count);
  // Away from extraordinary vertices, where neighbouring patches have the same curvatures, it is that of the mean ones.
  size_t agree = 0;
  for (size_t v = 0; v < count; ++v) {
    const double bending =
        std::pow(double{arrays.curvatures[2 * v]}, 2) + std::pow(double{arrays.curvatures[2 * v + 1]}, 2);
    agree += std::abs(double{densities[v]} - bending) < 1e-4 * bending;
  }
  EXPECT_GT(agree, count * 9 / 10);
  for (umbilic_mesh* mesh : {without, with}) umbilic_mesh_destroy(mesh);
  umbilic_run_destroy(run);
}

TEST(Api, cuts_a_message_to_the_buffer_and_tells_its_full_length) {
  const std::string name(500, 'x');
  const std::string text = "{\"generator\": \"" + name + "\"}";
  umbilic_cage* cage = nullptr;
  ASSERT_EQ(umbilic_cage_create(text.data(), text.size(), &cage), UMBILIC_BAD_INPUT);
  EXPECT_EQ(cage, nullptr);
  EXPECT_NE(message().find(name), std::string::npos);
  char buffer[8] = "unmoved";
  EXPECT_GT(umbilic_copy_message(buffer, 0), 500u);
  EXPECT_STREQ(buffer, "unmoved");
  EXPECT_GT(umbilic_copy_message(buffer, sizeof buffer), 500u);
  EXPECT_STREQ(buffer, message().substr(0, 7).c_str());
}

TEST(Api, counts_an_open_cage_and_draws_it) {
  const std::string text = R"({"text": "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng a\nf 1 2 3 4\n"})";
  umbilic_cage* cage = nullptr;
  ASSERT_EQ(umbilic_cage_create(text.data(), text.size(), &cage), UMBILIC_OK);
  umbilic_text counts{};
  ASSERT_EQ(umbilic_cage_counts(cage, &counts), UMBILIC_OK);
  const std::string json(counts.data, counts.length);
  EXPECT_NE(json.find(R"("boundaries":[{"number":1,"vertices":4,"first_vertex":1,"component":1}])"), std::string::npos)
      << json;
  EXPECT_NE(json.find(R"("groups":[{"name":"a","faces":1}])"), std::string::npos) << json;
  umbilic_mesh* mesh = nullptr;
  ASSERT_EQ(umbilic_cage_mesh(cage, &mesh), UMBILIC_OK);
  umbilic_mesh_arrays arrays{};
  ASSERT_EQ(umbilic_mesh_view(mesh, &arrays), UMBILIC_OK);
  EXPECT_EQ(arrays.triangle_count, 2u);
  EXPECT_EQ(arrays.edge_count, 4u);
  umbilic_mesh_destroy(mesh);
  umbilic_cage_destroy(cage);
}

TEST(Api, makes_text_of_the_bytes_of_a_file) {
  const Cage cube = generate_cage("cube").value();
  const std::string ply = write_ply(cube, "binary_big_endian");
  umbilic_text text{"before", 6};
  ASSERT_EQ(umbilic_cage_text(ply.data(), ply.size(), &text), UMBILIC_OK);
  EXPECT_EQ(std::string(text.data, text.length), write_obj(cube));
  ASSERT_EQ(umbilic_cage_text("v 1 2 3\r\nx", 10, &text), UMBILIC_OK);
  EXPECT_EQ(std::string(text.data, text.length), "v 1 2 3\r\nx");
  EXPECT_EQ(umbilic_cage_text(ply.data(), ply.size() - 1, &text), UMBILIC_BAD_INPUT);
  EXPECT_EQ(message(), "'face' 6: the file ends before 'vertex_indices'");
  EXPECT_EQ(std::string(text.data, text.length), "v 1 2 3\r\nx");
}

TEST(Api, knows_tori_in_closed_form) {
  umbilic_text text{};
  ASSERT_EQ(umbilic_torus_energies(std::sqrt(0.5), &text), UMBILIC_OK);
  EXPECT_EQ(std::string(text.data, text.length).substr(0, 20), "{\"bending\":78.956835");
  const std::string terms = R"({"mvs_cross": 1})";
  ASSERT_EQ(umbilic_torus_minimizer(terms.data(), terms.size(), &text), UMBILIC_OK);
  EXPECT_EQ(std::string(text.data, text.length).substr(0, 11), "{\"ratio\":0,");
  EXPECT_EQ(umbilic_torus_energies(1, &text), UMBILIC_BAD_INPUT);
}

}  // namespace
}  // namespace umbilic::test
