// SPDX-License-Identifier: MIT
/// \file
/// Minimizes bending of a generated cage with the installed C++ library, and prints the energy.
#include <umbilic/driver/problem_run.h>
#include <umbilic/problem/text.h>

#include <cstdio>

int main() {
  const umbilic::Result<umbilic::Problem> problem = umbilic::parse_problem(
      R"({"umbilic": "problem", "version": 1, "cage": {"generator": "two-3"},
          "terms": {"bending": 1}, "options": {"levels": [0, 1]}})");
  if (!problem) return std::puts(problem.error().message.c_str()), 1;
  umbilic::Result<umbilic::ProblemRun> run = umbilic::begin_run(*problem);
  if (!run) return std::puts(run.error().message.c_str()), 1;
  while (!run->run.step(10)) continue;
  const umbilic::Cage mesh = run->run.control_mesh();
  std::printf("%.17g %d\n", run->run.result().energy_reported, static_cast<int>(mesh.vertices.rows()));
}
