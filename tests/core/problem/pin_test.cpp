// SPDX-License-Identifier: MIT
/// \file
/// Pins in their text form, and which of them make no sense.
#include "problem/pin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problem/text.h"

namespace umbilic {
namespace {

Result<Problem> problem_with(const std::string& pins) {
  return parse_problem(R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {"bending": 1},
                          "constraints": {"pins": )" +
                       pins + "}}");
}

std::string pin_error(const std::string& pins) {
  const Result<Problem> problem = problem_with(pins);
  return problem ? "" : problem.error().message;
}

TEST(Pin, reads_back_as_it_was_printed) {
  const Result<Problem> problem = problem_with(R"([
      {"vertex": 3},
      {"face": 2, "uv": [0.5, 0], "at": [1, null, -0.25], "normal": true},
      {"face": 1, "corner": 3, "uv": [0, 1], "position": false, "normal": [0, 0, 2]}])");
  ASSERT_TRUE(problem.ok()) << problem.error().message;
  const std::vector<Pin>& pins = problem->constraints.pins;
  ASSERT_EQ(pins.size(), 3u);
  EXPECT_EQ(pins[0].vertex, 3);
  EXPECT_TRUE(pins[0].position);
  EXPECT_FALSE(pins[0].at);
  EXPECT_FALSE(pins[0].holds_normal());
  EXPECT_EQ((*pins[1].uv)[0], 0.5);
  EXPECT_TRUE(std::isnan((*pins[1].at)[1])) << "null leaves the coordinate free";
  EXPECT_EQ((*pins[1].at)[2], -0.25);
  EXPECT_EQ(std::get<bool>(*pins[1].normal), true);
  EXPECT_EQ(std::get<Coordinates3>(*pins[2].normal)[2], 2);
  EXPECT_EQ(pins[2].corner, 3);
  EXPECT_FALSE(pins[2].position);
  for (const auto layout : {JsonPrinter::Layout::kCompact, JsonPrinter::Layout::kIndented}) {
    const std::string text = problem_text(*problem, layout);
    const Result<Problem> again = parse_problem(text);
    ASSERT_TRUE(again.ok()) << again.error().message << text;
    EXPECT_EQ(problem_text(*again, layout), text);
  }
}

TEST(Pin, errors_name_the_member) {
  const std::pair<std::string, std::string> cases[] = {
      {R"([{}])", "constraints.pins[0].vertex: expected either vertex, or face and uv"},
      {R"([{"vertex": 1}, {"vertex": 1, "face": 1}])",
       "constraints.pins[1].vertex: expected either vertex, or face and uv"},
      {R"([{"vertex": 0}])", "constraints.pins[0].vertex: 0 is below 1"},
      {R"([{"vertex": 1.5}])", "constraints.pins[0].vertex: expected a whole number"},
      {R"([{"face": 0, "uv": [0, 0]}])", "constraints.pins[0].face: 0 is below 1"},
      {R"([{"face": 1}])", "constraints.pins[0].uv: missing"},
      {R"([{"face": 1, "uv": [0.5]}])", "constraints.pins[0].uv: expected an array of 2"},
      {R"([{"face": 1, "uv": [0.5, 1.5]}])", "constraints.pins[0].uv[1]: 1.5 is not between 0 and 1"},
      {R"([{"face": 1, "uv": [null, 0.5]}])", "constraints.pins[0].uv[0]: nan is not between 0 and 1"},
      {R"([{"face": 1, "uv": [0, 0], "corner": 0}])", "constraints.pins[0].corner: 0 is below 1"},
      {R"([{"vertex": 1, "uv": [0, 0]}])", "constraints.pins[0].uv: stands beside a vertex, which has none"},
      {R"([{"vertex": 1, "corner": 1}])", "constraints.pins[0].corner: stands beside a vertex, which has none"},
      {R"([{"vertex": 1, "at": [1, 2]}])", "constraints.pins[0].at: expected an array of 3"},
      {R"([{"vertex": 1, "at": [1, 2, "x"]}])", "constraints.pins[0].at[2]: expected a number"},
      {R"([{"vertex": 1, "at": [null, null, null]}])",
       "constraints.pins[0].at: every coordinate is null; leave it out to hold the point where it is"},
      {R"([{"vertex": 1, "at": [1, 2, 3], "position": false, "normal": true}])",
       "constraints.pins[0].at: stands beside position false"},
      {R"([{"vertex": 1, "position": false}])",
       "constraints.pins[0].position: false, without a normal nothing is held"},
      {R"([{"vertex": 1, "position": false, "normal": false}])",
       "constraints.pins[0].position: false, without a normal nothing is held"},
      {R"([{"vertex": 1, "normal": [0, 0, 0]}])",
       "constraints.pins[0].normal: has no direction, all coordinates are 0"},
      {R"([{"vertex": 1, "normal": [0, null, 0]}])", "constraints.pins[0].normal[1]: nan is not finite"},
      {R"([{"vertex": 1, "normal": "up"}])", "constraints.pins[0].normal: expected an array of 3"},
      {R"([{"vertx": 1}])",
       "constraints.pins[0].'vertx': unknown; known are vertex, face, corner, uv, at, position, normal"},
      {R"({})", "constraints.pins: expected an array"},
  };
  for (const auto& [pins, words] : cases) EXPECT_EQ(pin_error(pins), words) << pins;
}

}  // namespace
}  // namespace umbilic
