// SPDX-License-Identifier: MIT
/// \file
/// What L-BFGS itself costs beside the evaluations and the metric, on a quadratic in the identity.
#include <algorithm>
#include <chrono>

#include "solve/lbfgs.h"
#include "subjects.h"

namespace umbilic {
namespace {

/// Adds up the seconds between its construction and its end.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  double& total_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// sum of d_i x_i^2 / 2, so badly conditioned that it does not end.
class Quadratic : public Objective {
 public:
  explicit Quadratic(int n) : diagonal_(Eigen::ArrayXd::LinSpaced(n, 0, 14).exp()) {}
  void evaluate(const Eigen::VectorXd& x, Evaluation& result) const override {
    const Stopwatch watch(seconds);
    result.gradient = (diagonal_ * x.array()).matrix();
    result.value = x.dot(result.gradient) / 2;
  }
  mutable double seconds = 0;

 private:
  Eigen::ArrayXd diagonal_;
};

class TimedIdentity : public Metric {
 public:
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override {
    const Stopwatch watch(seconds);
    return gradient;
  }
  mutable double seconds = 0;
};

/// Seconds of an iteration with full memory, the best of several rounds.
double iteration_seconds(int n, int memory) {
  constexpr int kRounds = 8, kIterations = 20;
  const Quadratic objective(n);
  const TimedIdentity metric;
  LbfgsOptions options;
  options.memory = memory;
  options.max_iterations = memory + kRounds * kIterations;
  options.tolerance = 0;
  Lbfgs lbfgs(objective, metric, Eigen::VectorXd::Ones(n), options);
  while (lbfgs.iterations() < memory && !lbfgs.step()) {
  }
  double best = 1e300;
  for (int round = 0; round < kRounds && !lbfgs.ended(); ++round) {
    objective.seconds = metric.seconds = 0;
    double all = 0;
    const int before = lbfgs.iterations();
    {
      const Stopwatch watch(all);
      while (lbfgs.iterations() < before + kIterations && !lbfgs.step()) {
      }
    }
    if (lbfgs.iterations() < before + kIterations) break;
    best = std::min(best, (all - objective.seconds - metric.seconds) / kIterations);
  }
  return best;
}

}  // namespace

std::string overhead() {
  constexpr int kMemory = 20;
  std::vector<std::string> rows;
  for (const int n : {300, 1000, 3000, 10'000, 30'000, 100'000, 300'000}) {
    const double seconds = iteration_seconds(n, kMemory);
    rows.push_back(fmt::format(R"({{"unknowns":{},"memory":{},"secondsPerIteration":{:.5g}}})", n, kMemory, seconds));
  }
  return joined(rows);
}

}  // namespace umbilic
