// SPDX-License-Identifier: MIT
/// \file
/// Problems and reports in their text form: what is printed reads back as the same bytes, and what cannot be read is
/// refused with the name of the member.
#include "problem/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace umbilic {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Problem blend_of_a_frame() {
  GeneratedCage cage{"two-3", {.family = FrameFamily::kHub, .thickness = 0.1, .spread = 2}};
  Problem problem{.cage = cage};
  problem.options.weights = {0.95, 0, 0, 0.05, 0, 0};
  problem.options.cap = CapKind::kFlat;
  problem.options.first_level = 1;
  problem.options.last_level = 3;
  problem.options.max_iterations = 7;
  problem.options.tolerance = 1e-300;
  problem.options.symmetry = false;
  problem.options.metric = MetricChoice::kSobolev;
  return problem;
}

/// Every member differs from its default.
Report full_report() {
  Report report;
  report.program = "1.2.3";
  report.instruction_set = "portable";
  report.problem = blend_of_a_frame();
  report.cage = {.vertices = 22,
                 .edges = 48,
                 .faces = 24,
                 .genus = 2,
                 .components = {{22, 48, 24, 2, 1}},
                 .boundaries = {{1, 4, 7, 1}},
                 .groups = {{"head", 3}},
                 .repairs = {"1 unused vertex was dropped"},
                 .notes = {"crease tags were ignored"}};
  report.group = {.name = "D3h", .order = 12, .incomplete = "the search was given up"};
  report.levels = {{.level = 0,
                    .patches = 24,
                    .unknowns = 22,
                    .energy = 1.5,
                    .energy_reported = 1.25,
                    .iterations = 3,
                    .evaluations = 4,
                    .seconds = 0.125,
                    .stop = StopReason::kRoundOff,
                    .metric = MetricChoice::kHessian,
                    .metrics = 2,
                    .factorizations = 3,
                    .quadrature = 1,
                    .credible = false,
                    .thickened = true,
                    .evaluable = false,
                    .narrower_caps_energy = 1.375,
                    .narrower_caps_evaluations = 5,
                    .predicted_decrease = 0.0625}};
  report.limit = {.status = LimitStatus::kNotConverging, .energy = 113, .order = kNan, .error = kNan, .lower = kNan};
  report.energies.functionals = {1, 2, 3, 4, kNan, 6, 7, 8};
  report.energies.area = 7;
  report.energies.gaussian = -8;
  report.energies.quadrature_error = 1e-17;
  report.energies.input_rounding = FunctionalValues{{1e-9, 2e-9, kNan, 0, 3e-9, 4e-9}};
  report.energies.invariants = {{-1, 2.5, kNan}};
  report.energies.resolved = false;
  report.energies.below_bound = true;
  report.energies.embedded = true;
  report.certificate = CertificateReport{1, 66, 10, 1e-3, 4};
  Points points(3, 3);
  points << 1.0 / 3, -0.1, 1e-300, 5e-324, 1.7976931348623157e308, -0.0, 2, 1e21, 123456789.125;
  report.surface = SurfaceState{2, points};
  return report;
}

std::string message(std::string_view text) {
  const Result<Problem> problem = parse_problem(text);
  return problem ? "" : problem.error().message;
}

/// A problem's text with other members in place of "options".
std::string with(std::string_view members) {
  return R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {"bending": 1}, )" +
         std::string(members) + "}";
}

TEST(Text, of_a_problem_reads_back_as_the_same_problem) {
  for (const auto layout : {JsonPrinter::Layout::kCompact, JsonPrinter::Layout::kIndented}) {
    const std::string text = problem_text(blend_of_a_frame(), layout);
    const Result<Problem> again = parse_problem(text);
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(problem_text(*again, layout), text);
    const auto& cage = std::get<GeneratedCage>(again->cage);
    EXPECT_EQ(cage.generator, "two-3");
    EXPECT_EQ(cage.options.family, FrameFamily::kHub);
    EXPECT_EQ(cage.options.thickness, 0.1);
    EXPECT_EQ(again->options.weights, blend_of_a_frame().options.weights);
    EXPECT_EQ(again->options.tolerance, 1e-300);
    EXPECT_EQ(again->options.metric, MetricChoice::kSobolev);
    EXPECT_FALSE(again->options.symmetry);
  }
}

TEST(Text, of_a_generated_cage_shows_what_applies_to_it_with_the_segments_that_it_takes) {
  const auto text = [](const GeneratedCage& cage) {
    return problem_text(Problem{.cage = cage}, JsonPrinter::Layout::kCompact);
  };
  const auto shows = [&](const GeneratedCage& cage, std::string_view members) {
    return text(cage).find(members) != std::string::npos;
  };
  EXPECT_TRUE(shows({"torus", {}}, R"({"generator":"torus","thickness":1,"ratio":0.5,"segments":[6,8]})"));
  EXPECT_TRUE(shows({"disk", {}}, R"({"generator":"disk","segments":[32,3],"radius":1})"));
  EXPECT_TRUE(shows({"cylinder", {}}, R"({"generator":"cylinder","segments":[32,10],"radius":1,"height":2})"));
  EXPECT_TRUE(shows({"catenoid", {}}, R"({"generator":"catenoid","segments":[32,8],"height":2,"waist":1})"));
  EXPECT_TRUE(shows({"spherical-cap", {.half_angle = 150}},
                    R"({"generator":"spherical-cap","segments":[32,9],"radius":1,"half_angle":150})"));
  EXPECT_TRUE(shows({"n-sided", {.sides = 7, .rise = 0.5}},
                    R"({"generator":"n-sided","segments":[8,4],"radius":1,"sides":7,"rise":0.5})"));
  EXPECT_FALSE(shows({"cube", {}}, "segments"));
}

TEST(Text, of_a_report_reads_back_as_the_same_report) {
  const std::string text = report_text(full_report());
  const Result<Report> again = parse_report(text);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(report_text(*again), text);
  EXPECT_TRUE(std::isnan(again->limit.error));
  EXPECT_TRUE(std::isnan(again->energies.functionals[kMehlumTarrou]));
  EXPECT_EQ(again->levels[0].stop, StopReason::kRoundOff);
  EXPECT_EQ(again->surface->points, full_report().surface->points) << "to the last bit";
}

TEST(Text, of_a_report_that_is_older_than_a_functional_leaves_its_energy_open) {
  std::string text = report_text(full_report(), JsonPrinter::Layout::kCompact);
  const auto take_out = [&](const std::string& member) {
    const std::size_t at = text.find(member);
    ASSERT_NE(at, std::string::npos) << member;
    text.erase(at, member.size());
  };
  take_out("\"mean_curvature_variation\":7,");
  take_out("\"curvedness_variation\":8,");
  take_out("\"invariants\":{\"gradient_form\":-1,\"variation_form\":2.5,\"triple_form\":null},");
  const Result<Report> old = parse_report(text);
  ASSERT_TRUE(old.ok()) << old.error().message;
  EXPECT_EQ(old->energies.functionals[kSecondFormVariation], 6);
  EXPECT_TRUE(std::isnan(old->energies.functionals[kMeanCurvatureVariation]));
  EXPECT_TRUE(std::isnan(old->energies.functionals[kCurvednessVariation]));
  EXPECT_FALSE(old->energies.invariants);
}

TEST(Text, keeps_every_bit_of_a_number) {
  std::mt19937_64 random(1);
  SurfaceState state{0, Points(1000, 3)};
  for (Eigen::Index i = 0; i < state.points.size(); ++i) {
    double x = std::bit_cast<double>(random());
    if (!std::isfinite(x)) x = -0.0;
    state.points.data()[i] = x;
  }
  Problem problem = blend_of_a_frame();
  problem.start = state;
  const Problem again = parse_problem(problem_text(problem, JsonPrinter::Layout::kCompact)).value();
  for (Eigen::Index i = 0; i < state.points.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(again.start->points.data()[i]),
              std::bit_cast<std::uint64_t>(state.points.data()[i]));
  }
}

TEST(Text, of_a_cage_keeps_its_lines_and_replaces_what_is_not_utf_8) {
  Problem problem = blend_of_a_frame();
  problem.cage = CageText{"a \"cage\".obj", "# caf\xE9 \xC3\xA9 \xF0\x9F\x98\x80 \xED\xA0\x80\t\\\x01\nv 0 0 0\r\n"};
  const Problem again = parse_problem(problem_text(problem)).value();
  const auto& cage = std::get<CageText>(again.cage);
  EXPECT_EQ(cage.name, "a \"cage\".obj");
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(cage.text, "# caf" + bad + " \xC3\xA9 \xF0\x9F\x98\x80 " + bad + bad + bad + "\t\\\x01\nv 0 0 0\r\n");
}

TEST(Text, of_a_report_is_the_problem_that_goes_on_where_it_ended) {
  const Problem problem = parse_problem(report_text(full_report())).value();
  EXPECT_EQ(problem.start->level, 2);
  EXPECT_EQ(problem.start->points, full_report().surface->points);
  EXPECT_EQ(problem.options.last_level, 3);
}

TEST(Text, says_only_what_applies_to_a_generated_cage) {
  Problem problem = blend_of_a_frame();
  problem.cage = GeneratedCage{"cube", {}};
  EXPECT_NE(problem_text(problem).find("\"generator\": \"cube\"\n"), std::string::npos) << problem_text(problem);
  EXPECT_EQ(message(R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube", "ratio": 0.5},
                        "terms": {"bending": 1}})"),
            "");
}

TEST(Text, left_out_members_have_their_defaults) {
  const Problem problem = parse_problem(with(R"("options": {})")).value();
  EXPECT_EQ(problem.options.cap, CapKind::kSmooth);
  EXPECT_EQ(problem.options.last_level, 2);
  EXPECT_EQ(problem.options.max_iterations, 1000);
  EXPECT_FALSE(problem.start);
}

TEST(Text, errors_name_the_member) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "line 1, column 1: the text ends too early, it is no JSON"},
      {"{\"umbilic\": \"problem\",\n \"version\": 1e400}", "line 2, column 17: the number '1e400' is too large"},
      {"{\n  \"umbilic\": }", "line 2, column 14: this is no JSON, at '\"umbilic\": }'"},
      {"[1]", "expected an object, {\"umbilic\": \"problem\", …}"},
      {"{}", "umbilic: missing"},
      {R"({"umbilic": "problem"})", "version: missing"},
      {R"({"umbilic": "song", "version": 1})", "umbilic: expected \"problem\" or \"report\""},
      {R"({"umbilic": "problem", "version": 2})",
       "version: 2 is not known to this program, which reads versions up to 1"},
      {R"({"umbilic": "problem", "version": 1.5})", "version: expected a whole number"},
      {R"({"umbilic": "problem", "version": 1, "version": 1})", "version: stands there twice"},
      {R"({"umbilic": "problem", "version": 1})", "cage: missing"},
      {R"({"umbilic": "problem", "version": 1, "cage": "cube"})", "cage: expected an object"},
      {R"({"umbilic": "problem", "version": 1, "cage": {}})",
       "cage: expected one of the members generator, text, file"},
      {R"({"umbilic": "problem", "version": 1, "cage": {"text": "", "file": ""}})",
       "cage: expected one of the members generator, text, file"},
      {R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}})", "terms: missing"},
      {R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {"bend": 1}})",
       "terms.'bend': no functional; known are bending, willmore, mvs, mvs_cross, mehlum_tarrou, "
       "second_form_variation, mean_curvature_variation, curvedness_variation"},
      {R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {}})",
       "terms: all weights are zero"},
      {R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {"bending": -1}})",
       "terms: weight of bending is not a finite number >= 0"},
      {with(R"("options": {"levels": [2, 1]})"), "options.levels[1]: 1 is below levels[0], 2"},
      {with(R"("options": {"levels": [-1, 1]})"), "options.levels[0]: -1 is negative"},
      {with(R"("options": {"levels": [0, 1.5]})"), "options.levels[1]: expected a whole number"},
      {with(R"("options": {"levels": [0, 3e9]})"), "options.levels[1]: 3000000000 is too large"},
      {with(R"("options": {"levels": 2})"), "options.levels: expected two numbers, [first, second]"},
      {with(R"("options": {"tolerance": null})"), "options.tolerance: nan is not a finite number >= 0"},
      {with(R"("options": {"tolerance": "small"})"), "options.tolerance: expected a number"},
      {with(R"("options": {"symmetry": 1})"), "options.symmetry: expected true or false"},
      {with(R"("options": {"cap": "flatt"})"), "options.cap: 'flatt' is unknown, expected one of none, flat, smooth"},
      {with(R"("options": {"cap_rings": 3})"), "options.cap_rings: 3 is none of 1, 2, 4, 8, 16"},
      {with(R"("options": {"cap": 2})"), "options.cap: expected one of none, flat, smooth"},
      {with(R"("options": {"levles": [0, 1]})"),
       "options.'levles': unknown; known are cap, cap_rings, levels, max_iterations, tolerance, symmetry, metric, "
       "second_opinion, accuracy"},
      {with(R"("constraints": {"volume": 1})"),
       "constraints.'volume': unknown; known are hold, free, pins, symmetric, closeness, boundary, holes"},
      {with(R"("start": {"level": -1, "points": []})"), "start.level: -1 is negative"},
      {with(R"("start": {"level": 0, "points": [1, 2]})"), "start.points: 2 numbers, not three for each point"},
      {with(R"("start": {"level": 0, "points": [1, 2, "x"]})"), "start.points[2]: expected a number"},
      {with(R"("start": {"level": 0})"), "start.points: missing"},
      {with(R"("options": [)" + std::string(40, '[')), "nested more than 32 deep"},
  };
  for (const auto& [text, words] : cases) EXPECT_EQ(message(text), words) << text;
}

TEST(Text, of_a_report_may_have_members_that_this_program_does_not_know_but_its_problem_may_not) {
  std::string text = report_text(full_report(), JsonPrinter::Layout::kCompact);
  const auto insert = [&](std::string_view after, std::string_view what) {
    std::string longer = text;
    return longer.insert(longer.find(after) + after.size(), what);
  };
  EXPECT_TRUE(parse_report(insert("\"limit\":{", "\"news\":1,")).ok());
  EXPECT_TRUE(parse_report(insert("\"version\":1,", "\"news\":{\"a\":[]},")).ok());
  const Result<Report> refused = parse_report(insert("\"problem\":{", "\"news\":1,"));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message.substr(0, 15), "problem.'news':");
}

TEST(Text, cut_or_changed_at_any_byte_is_read_or_refused_in_words) {
  const std::string text = report_text(full_report(), JsonPrinter::Layout::kCompact);
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    EXPECT_NE(message(text.substr(0, length)), "") << length;
  }
  std::mt19937 random(2);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string changed = text;
    for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random() % 256);
    const Result<Problem> problem = parse_problem(changed);
    if (problem) continue;
    ++refused;
    EXPECT_NE(problem.error().message, "");
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace umbilic
