// SPDX-License-Identifier: MIT
/// \file
/// Runs and certificates in turn.
#include "catalog/descent.h"

#include "driver/certificate.h"

namespace umbilic::catalog {

bool descend(Problem problem, double energy, const Watch& watch, std::optional<LowerMinimizer>& lower) {
  for (std::size_t descent = 0; descent < kMostDescents && problem.start; ++descent) {
    Run run = begin_run(problem).value().run;
    while (!run.step(1)) {
      if (!watch(run)) return false;
    }
    const double reached = run.result().energy_reported;
    if (!(reached < (1 - kLeastDescent) * energy)) return true;
    energy = reached;
    lower = LowerMinimizer{run.group(), run.result(), run.energies(), {}, run.orbit_points()};
    Result<Certificate> certificate = run.certify();
    if (!certificate) return true;
    while (!certificate->step()) {
      if (!watch(run)) return false;
    }
    if (const Result<CertificateReport> report = certificate->report()) lower->certificate = *report;
    problem.start = certificate->descent();
  }
  return true;
}

}  // namespace umbilic::catalog
