// SPDX-License-Identifier: MIT
/// \file
/// Energy and gradient, with the kernels of every instruction set that the machine has.
#include <utility>

#include "base/instruction_set.h"
#include "flops.h"
#include "measure.h"
#include "peak.h"
#include "subjects.h"

namespace umbilic {
namespace {

/// Calls `body` with the name of each available set, whose kernels then run.
template <class Body>
void for_each_instruction_set(const Body& body) {
  const InstructionSet before = instruction_set();
  for (int i = 0; i < kInstructionSetCount; ++i) {
    if (!available(static_cast<InstructionSet>(i))) continue;
    use_instruction_set(static_cast<InstructionSet>(i));
    body(kInstructionSetNames[i]);
  }
  use_instruction_set(before);
}

}  // namespace

std::string peaks() {
  std::vector<std::string> rows;
  for_each_instruction_set([&](std::string_view name) {
    rows.push_back(fmt::format(R"({{"instructionSet":"{}","flopsPerSecond":{:.6g}}})", name, peak_flops_per_second()));
  });
  return joined(rows);
}

std::string throughput() {
  std::vector<std::string> rows;
  for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) {
    for (int f = 0; f < kFunctionalCount; ++f) {
      RefinedCage cage = genus_two(kThroughputLevel);
      const Points control = cage.control;
      const Surface surface(std::move(cage), cap, only(f));
      const long samples = surface.jets().sample_count();
      const double flops = evaluation_flops(surface.layout(), minimizing_rule(cap, only(f)), only(f));
      for_each_instruction_set([&](std::string_view name) {
        Points gradient;
        const double seconds = best_seconds([&] { surface.energy().evaluate(control, &gradient); }, 0.25);
        rows.push_back(fmt::format(
            R"({{"instructionSet":"{}","functional":"{}","cap":"{}","patches":{},"samples":{},"samplesPerSecond":{:.6g},)"
            R"("flopsPerSample":{:.4g},"tableBytes":{}}})",
            name, kFunctionalNames[f], cap == CapKind::kSmooth ? "smooth" : "flat", surface.mesh().face_count(),
            samples, static_cast<double>(samples) / seconds, flops / static_cast<double>(samples),
            surface.jets().table_bytes()));
      });
    }
  }
  return joined(rows);
}

}  // namespace umbilic
