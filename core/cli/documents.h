// SPDX-License-Identifier: MIT
/// \file
/// The JSON output of the commands other than `optimize`: documents as in problem/text.h, with the same parts as a
/// report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/cage_shape.h"
#include "energy/torus.h"
#include "problem/text.h"

namespace umbilic::cli {

/// {"umbilic": "cage", …}
struct CageDocument {
  std::string program;
  CageReport cage;
  CageShape shape;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("program", self.program);
    visit("cage", self.cage);
    visit("valences", self.shape.valences);
    visit("face_sizes", self.shape.face_sizes);
    visit("first_level", self.shape.first_level);
  }
};

/// {"umbilic": "evaluation", …}
struct EvaluationDocument {
  std::string program;
  std::string instruction_set;
  CageReport cage;
  CapKind cap;
  int cap_rings;
  EvaluationReport evaluation;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("program", self.program);
    visit("instruction_set", self.instruction_set);
    visit("cage", self.cage);
    visit("cap", self.cap);
    visit("cap_rings", self.cap_rings);
    EvaluationReport::members(visit, self.evaluation);
  }
};

/// {"umbilic": "gradient", …}
struct GradientDocument {
  std::string program;
  CageReport cage;
  Weights terms;
  CapKind cap;
  int cap_rings;
  GradientReport gradient;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("program", self.program);
    visit("cage", self.cage);
    visit("terms", self.terms);
    visit("cap", self.cap);
    visit("cap_rings", self.cap_rings);
    GradientReport::members(visit, self.gradient);
  }
};

/// Energies of one torus of revolution.
struct TorusRow {
  double ratio;
  FunctionalValues energies;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("ratio", self.ratio);
    visit("energies", self.energies);
  }
};

/// {"umbilic": "tori", …}
struct ToriDocument {
  std::string program;
  std::vector<TorusRow> tori{};
  std::optional<Weights> terms{};  ///< the functional that the minimizer is for
  std::optional<TorusMinimizer> minimizer{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("program", self.program);
    visit("tori", self.tori);
    visit("terms", self.terms);
    visit("minimizer", self.minimizer);
  }
};

}  // namespace umbilic::cli
