// SPDX-License-Identifier: MIT
/// \file
/// The benchmark: throughput of energy and gradient, seconds per phase of a level, and the errors of quadrature rules,
/// as JSON on standard output. `npm run bench` runs it natively and as WebAssembly and prints the tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/instruction_set.h"
#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "driver/tessellate.h"
#include "measure.h"
#include "mesh/hierarchy.h"
#include "optimize/lbfgs.h"
#include "optimize/sobolev.h"

using namespace umbilic;

namespace {

constexpr int kThroughputLevel = 3;

RefinedCage genus_two(int level) { return *refine_to_evaluable(*generate_cage("two-3"), level, false); }

Weights only(int functional) {
  Weights weights{};
  weights[functional] = 1;
  return weights;
}

std::string joined(const std::vector<std::string>& parts) { return fmt::format("[{}]", fmt::join(parts, ",")); }

/// Samples per second of energy and gradient, capped patches included, on the genus-2 flag frame.
std::string throughput() {
  std::vector<std::string> rows;
  for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) {
    for (int f = 0; f < kFunctionalCount; ++f) {
      RefinedCage cage = genus_two(kThroughputLevel);
      const Points control = cage.control;
      const Surface surface(std::move(cage), cap, only(f));
      Points gradient;
      const double seconds = best_seconds([&] { surface.energy().evaluate(control, &gradient); });
      rows.push_back(fmt::format(
          R"({{"functional":"{}","cap":"{}","patches":{},"samples":{},"samplesPerSecond":{:.6g},"tableBytes":{}}})",
          kFunctionalNames[f], cap == CapKind::kSmooth ? "smooth" : "flat", surface.mesh().face_count(),
          surface.jets().sample_count(), static_cast<double>(surface.jets().sample_count()) / seconds,
          surface.jets().table_bytes()));
    }
  }
  return joined(rows);
}

/// Seconds of each thing that a level does once, beside one evaluation.
std::string phases() {
  const Weights weights = only(kMvsCross);
  const Cage cage = *generate_cage("two-3");
  const RefinedCage refined = genus_two(kThroughputLevel);
  std::vector<std::string> rows;
  const auto add = [&](const char* name, double seconds) {
    rows.push_back(fmt::format(R"({{"phase":"{}","seconds":{:.6g}}})", name, seconds));
  };
  const Surface surface(refined, CapKind::kSmooth, weights);
  const Unknowns unknowns{Coordinates(refined.mesh.vertex_count())};
  Points gradient;
  SobolevMetric metric(surface.energy(), unknowns);
  const double metric_seconds = best_seconds(
      [&] {
        SobolevMetric fresh(surface.energy(), unknowns);
        fresh.begin(refined.control);
        while (!fresh.advance()) {
        }
      },
      0.5, 1);
  metric.begin(refined.control);
  while (!metric.advance()) {
  }
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(refined.control.size());
  add("refine the cage", best_seconds([&] { (void)refine_to_evaluable(cage, kThroughputLevel, false); }));
  add("layout and tables", best_seconds([&] { Surface(refined, CapKind::kSmooth, weights); }));
  add("Sobolev metric, assembled and factored", metric_seconds);
  add("metric solve", best_seconds([&] { (void)metric.solve(right); }));
  add("energy and gradient", best_seconds([&] { surface.energy().evaluate(refined.control, &gradient); }));
  add("energy alone", best_seconds([&] { surface.energy().evaluate(refined.control, nullptr); }));
  (void)surface.report(refined.control);
  add("all energies by the reporting rule", best_seconds([&] { (void)surface.report(refined.control); }));
  add("limit mesh, 4 x 4 quads per patch",
      best_seconds([&] { (void)tessellate(surface.mesh(), surface.layout(), refined.control, 4); }));
  return joined(rows);
}

/// Errors of rules on surfaces that were minimized by the rule in use, which exploits its errors.
std::string quadrature() {
  std::vector<std::string> rows;
  for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) {
    for (const int functional : {int(kBending), int(kMvsCross)}) {
      RunOptions options;
      options.weights = only(functional);
      options.cap = cap;
      options.last_level = 2;
      options.max_iterations = 60;
      Run run = *Run::create(*generate_cage("two-3"), options);
      while (!run.step(100)) {
      }
      const Cage control = run.control_mesh();
      const PolygonMesh mesh(control);
      const PatchLayout layout(mesh, cap);
      const auto energy = [&](const QuadratureRule& rule, long* samples) {
        const JetEvaluator jets(layout, rule);
        if (samples) *samples = jets.sample_count();
        return surface_integrals(jets, control.vertices).functionals[functional];
      };
      const double exact = energy({10, cap == CapKind::kFlat ? 48 : 14, cap == CapKind::kFlat ? 3 : 8}, nullptr);
      for (const int regular : {3, 4, 5}) {
        for (const int capped : cap == CapKind::kFlat ? std::vector{8, 12, 16, 24, 32} : std::vector{4, 5, 6, 7, 10}) {
          for (const int grading : {0, 1, 2, 4}) {
            long samples = 0;
            const double error = energy({regular, capped, grading}, &samples) / exact - 1;
            rows.push_back(fmt::format(
                R"({{"functional":"{}","cap":"{}","regular":{},"capped":{},"grading":{},"samples":{},"error":{:.3g}}})",
                kFunctionalNames[functional], cap == CapKind::kSmooth ? "smooth" : "flat", regular, capped, grading,
                samples, error));
          }
        }
      }
    }
  }
  return joined(rows);
}

}  // namespace

int main(int argc, char** argv) {
  const bool rules = argc > 1 && std::strcmp(argv[1], "quadrature") == 0;
  const std::string text =
      rules ? fmt::format(R"({{"quadrature":{}}})", quadrature())
            : fmt::format(R"({{"instructionSet":"{}","throughput":{},"phases":{}}})",
                          kInstructionSetNames[static_cast<int>(instruction_set())], throughput(), phases());
  std::puts(text.c_str());
}
