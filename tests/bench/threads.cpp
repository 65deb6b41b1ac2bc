// SPDX-License-Identifier: MIT
/// \file
/// What several threads do together beside what they do each for itself: the same work by as many threads that share
/// nothing, like independent processes.
#include "base/threads.h"

#include <barrier>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "cages.h"
#include "driver/run.h"
#include "optimize/hessian_metric.h"
#include "subjects.h"

namespace umbilic {

namespace {

constexpr double kSeconds = 1;
constexpr int kIterations = 30;  // of a whole run

/// Some work, which can be done again and again, and nothing of which is shared with another one's.
using Work = std::function<void()>;
using MakeWork = std::function<Work()>;

/// How often per second the work is done by each of so many threads at the same time, all together.
double rate(int workers, const MakeWork& make) {
  std::barrier start(workers);
  std::vector<double> rates(workers);
  const auto measure = [&](int worker) {
    using Clock = std::chrono::steady_clock;
    const Work work = make();
    work();
    start.arrive_and_wait();
    const auto begin = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    int count = 0;
    for (; count < 2 || seconds() < kSeconds; ++count) work();
    rates[worker] = count / seconds();
  };
  std::vector<std::thread> others;
  for (int worker = 1; worker < workers; ++worker) others.emplace_back([&, worker] { measure(worker); });
  measure(0);
  for (std::thread& other : others) other.join();
  double sum = 0;
  for (const double one : rates) sum += one;
  return sum;
}

/// A surface, and what a level computes on it.
struct Measured {
  explicit Measured(const RefinedCage& cage)
      : surface(cage, CapKind::kSmooth, only(kMvsCross)),
        unknowns(Coordinates(cage.mesh.vertex_count())),
        assembly(surface.layout(), unknowns, only(kMvsCross), hessian_rule(CapKind::kSmooth, only(kMvsCross)),
                 kUmbilicEta) {}

  void evaluate() { surface.energy().evaluate(surface.start(), &gradient); }
  void assemble() {
    assembly.begin(surface.start());
    while (!assembly.advance()) {
    }
  }
  void factor() { cholesky.factor(assembly.combine(0, 1)); }
  void solve() { solution = cholesky.solve(Eigen::VectorXd(Eigen::VectorXd::Ones(unknowns.count()))); }

  Surface surface;
  Unknowns unknowns;
  HessianAssembly assembly;
  SparseCholesky cholesky{SparseCholesky::Pivots::kPositive};
  Points gradient;
  Eigen::VectorXd solution;
};

Work prepared(const RefinedCage& cage, void (Measured::*step)()) {
  const auto measured = std::make_shared<Measured>(cage);
  measured->evaluate();
  measured->assemble();
  measured->factor();
  return [=] { ((*measured).*step)(); };
}

Work whole_run_of(const Cage& cage, int level) {
  return [=] {
    RunOptions options;
    options.weights = only(kMvsCross);
    options.first_level = options.last_level = level;
    options.max_iterations = kIterations;
    Run run = *Run::create(cage, options);
    while (!run.step(1)) {
    }
  };
}

}  // namespace

std::string threads() {
  const int all = hardware_threads();
  const Cage cage = *bench_cage("moved-two-3");
  std::vector<std::string> rows;
  for (const int level : {2, 3}) {
    const RefinedCage refined = *refine_to_evaluable(cage, level, false);
    const auto add = [&](const char* name, const MakeWork& make) {
      const double alone = rate(1, make), apart = rate(all, make);
      use_threads(all);
      const double together = rate(1, make);
      use_threads(1);
      rows.push_back(
          fmt::format(R"({{"work":"{}","patches":{},"threads":{},"alone":{:.6g},"apart":{:.6g},"together":{:.6g}}})",
                      name, refined.mesh.face_count(), all, alone, apart, together));
    };
    add("energy and gradient", [&] { return prepared(refined, &Measured::evaluate); });
    add("second derivatives", [&] { return prepared(refined, &Measured::assemble); });
    add("factorization", [&] { return prepared(refined, &Measured::factor); });
    add("solution", [&] { return prepared(refined, &Measured::solve); });
    add("a run of 30 iterations", [&] { return whole_run_of(cage, level); });
  }
  return joined(rows);
}

}  // namespace umbilic
