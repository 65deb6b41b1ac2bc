// SPDX-License-Identifier: MIT
/// \file
/// Rules against a fine one, on minimizers.
#include "driver/run.h"
#include "subjects.h"

namespace umbilic {

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

}  // namespace umbilic
