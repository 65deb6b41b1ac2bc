// SPDX-License-Identifier: MIT
/// \file
/// What the width of smooth caps does to third-order energies: MVS_cross of minimizers, level by level, with caps of at
/// most 1, 2, 4, 8 and 16 rings; and the torus of least bending + MVS_cross, which needs no caps.
#include <string_view>

#include "driver/run.h"
#include "subjects.h"

namespace umbilic {
namespace {

struct Shape {
  std::string_view cage;
  int last_level;
  Weights weights;
  std::string truth;  ///< as JSON
};

std::vector<Shape> shapes() {
  Weights blend = only(kMvsCross);
  blend[kBending] = 1;
  return {{"cube", 5, only(kMvsCross), "0"},
          {"torus", 4, blend, "1020.67048"},  // tests/run/bench/profiles.js: its tube is not quite round
          {"two-3", 4, only(kMvsCross), "null"},
          {"tetrahedron-frame", 4, only(kMvsCross), "null"},
          {"octahedron-frame", 4, only(kMvsCross), "null"}};
}

std::string levels_of(const Run& run) {
  std::vector<std::string> levels;
  for (const LevelReport& level : run.levels()) {
    levels.push_back(fmt::format(
        R"({{"level":{},"rings":{},"energy":{:.10g},"evaluations":{},"seconds":{:.3g},"stop":"{}"}})", level.level,
        level.cap_rings, level.energy_reported, level.evaluations, level.seconds, name_of(level.stop)));
  }
  return joined(levels);
}

}  // namespace

std::string caps() {
  std::vector<std::string> rows;
  for (const Shape& shape : shapes()) {
    for (int rings = 1; rings <= kMostCapRings; rings *= 2) {
      RunOptions options;
      options.weights = shape.weights;
      options.cap_rings = rings;
      options.last_level = shape.last_level;
      Run run = *Run::create(*generate_cage(std::string(shape.cage)), options);
      while (!run.step(100)) {
      }
      const LimitReport limit = run.limit();
      const bool converging = limit.status == LimitStatus::kConverging;
      rows.push_back(fmt::format(
          R"({{"shape":"{}","truth":{},"rings":{},"levels":{},"limit":{},"error":{},"capsIncluded":{}}})", shape.cage,
          shape.truth, rings, levels_of(run), converging ? fmt::format("{:.10g}", limit.energy) : "null",
          converging ? fmt::format("{:.3g}", limit.error) : "null", limit.caps_included));
      if (run.levels().back().cap_rings == 0) break;
    }
  }
  return joined(rows);
}

}  // namespace umbilic
