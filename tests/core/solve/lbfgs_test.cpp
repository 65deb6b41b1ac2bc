// SPDX-License-Identifier: MIT
/// \file
/// L-BFGS on functions whose minima are known, and every reason to stop.
#include "solve/lbfgs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "solve/identity_metric.h"

namespace umbilic::test {
namespace {

class Diagonal : public Metric {
 public:
  explicit Diagonal(Eigen::VectorXd entries) : entries_(std::move(entries)) {}
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override { return gradient.cwiseQuotient(entries_); }

 private:
  Eigen::VectorXd entries_;
};

class Function : public Objective {
 public:
  using Body = std::function<double(const Eigen::VectorXd&, Eigen::VectorXd&)>;
  explicit Function(Body body) : body_(std::move(body)) {}
  void evaluate(const Eigen::VectorXd& x, Evaluation& result) const override {
    result.gradient = Eigen::VectorXd::Zero(x.size());
    result.value = body_(x, result.gradient);
    result.degenerate = degenerate_below && x.norm() < *degenerate_below;
  }
  std::optional<double> degenerate_below;

 private:
  Body body_;
};

/// Curvatures from 1 to 1e4 around the point (1, ..., 1), with value 1 at the minimum.
Eigen::VectorXd curvatures() {
  return Eigen::VectorXd::LinSpaced(40, 0, 4).unaryExpr([](double e) { return std::pow(10, e); });
}

double quadratic(const Eigen::VectorXd& x, Eigen::VectorXd& g) {
  const Eigen::VectorXd d = x - Eigen::VectorXd::Ones(x.size());
  g = curvatures().cwiseProduct(d);
  return 1 + 0.5 * d.dot(g);
}

double rosenbrock(const Eigen::VectorXd& x, Eigen::VectorXd& g) {
  const double a = 1 - x[0], b = x[1] - x[0] * x[0];
  g[0] = -2 * a - 400 * x[0] * b;
  g[1] = 200 * b;
  return a * a + 100 * b * b;
}

int run(Lbfgs& lbfgs, int most = 100000) {
  int steps = 0;
  while (steps < most && !lbfgs.step()) ++steps;
  return steps;
}

TEST(Lbfgs, the_hessian_as_metric_solves_a_quadratic_in_one_iteration) {
  const Function f(quadratic);
  const Diagonal hessian(curvatures());
  Lbfgs lbfgs(f, hessian, Eigen::VectorXd::Zero(40), {});
  for (int i = 0; i < 2; ++i) lbfgs.step();  // the start and one full step
  EXPECT_NEAR(lbfgs.best_value(), 1, 1e-9);
  run(lbfgs);
  EXPECT_LE(lbfgs.iterations(), 3);
  EXPECT_TRUE(lbfgs.stop() == StopReason::kConverged || lbfgs.stop() == StopReason::kRoundOff);
}

TEST(Lbfgs, a_metric_close_to_the_hessian_needs_fewer_evaluations_than_the_identity) {
  const Function f(quadratic);
  const Identity identity;
  const Diagonal close(curvatures().cwiseProduct(Eigen::VectorXd::LinSpaced(40, 0.5, 2)));
  LbfgsOptions options;
  options.tolerance = 1e-10;
  Lbfgs plain(f, identity, Eigen::VectorXd::Zero(40), options), guided(f, close, Eigen::VectorXd::Zero(40), options);
  run(plain);
  run(guided);
  EXPECT_NEAR(plain.best_value(), 1, 1e-7);
  EXPECT_NEAR(guided.best_value(), 1, 1e-9);
  EXPECT_LT(2 * guided.evaluations(), plain.evaluations());
}

TEST(Lbfgs, finds_the_minimum_of_rosenbrocks_valley) {
  const Function f(rosenbrock);
  const Identity identity;
  LbfgsOptions options;
  options.floor = 1e-9;
  Lbfgs lbfgs(f, identity, Eigen::Vector2d(-1.2, 1), options);
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kConverged);
  EXPECT_LT((lbfgs.best() - Eigen::Vector2d(1, 1)).norm(), 1e-6);
  EXPECT_LE(lbfgs.evaluations(), 80);
}

TEST(Lbfgs, resumes_to_a_smaller_tolerance) {
  const Function f(quadratic);
  const Identity identity;
  LbfgsOptions options;
  options.tolerance = 1e-1;
  Lbfgs lbfgs(f, identity, Eigen::VectorXd::Zero(40), options);
  run(lbfgs);
  ASSERT_EQ(lbfgs.stop(), StopReason::kConverged);
  const double before = lbfgs.best_value() - 1;
  lbfgs.resume(1e-9);
  EXPECT_FALSE(lbfgs.ended());
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kConverged);
  EXPECT_LT(lbfgs.best_value() - 1, 1e-4 * before);
}

TEST(Lbfgs, does_not_end_by_the_model_of_a_metric_that_predicts_nothing) {
  class Blind : public Diagonal {
   public:
    Blind(const Eigen::VectorXd& entries, bool predicts) : Diagonal(entries), predicts_(predicts) {}
    bool predicts() const override { return predicts_; }

   private:
    bool predicts_;
  };
  const Function f(quadratic);
  const Blind believed(1e10 * curvatures(), true), blind(1e10 * curvatures(), false);
  LbfgsOptions options;
  options.tolerance = 1e-5;
  Lbfgs early(f, believed, Eigen::VectorXd::Zero(40), options), late(f, blind, Eigen::VectorXd::Zero(40), options);
  run(early);
  run(late);
  EXPECT_EQ(early.stop(), StopReason::kConverged);
  EXPECT_GT(early.best_value(), 1e4) << "a model that is 1e10 times too steep sees nothing to gain at the start";
  EXPECT_NEAR(late.best_value(), 1, 1e-5);
}

TEST(Lbfgs, each_step_costs_one_evaluation) {
  int calls = 0;
  const Function f([&](const Eigen::VectorXd& x, Eigen::VectorXd& g) { return ++calls, rosenbrock(x, g); });
  const Identity identity;
  Lbfgs lbfgs(f, identity, Eigen::Vector2d(-1.2, 1), {});
  for (int i = 1; i <= 20; ++i) {
    lbfgs.step();
    EXPECT_EQ(calls, i);
    EXPECT_EQ(lbfgs.evaluations(), i);
  }
}

TEST(Lbfgs, a_tolerance_bounds_what_is_left_to_gain) {
  const Function f(quadratic);
  const Identity identity;
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    LbfgsOptions options;
    options.tolerance = tolerance;
    Lbfgs lbfgs(f, identity, Eigen::VectorXd::Zero(40), options);
    run(lbfgs);
    EXPECT_EQ(lbfgs.stop(), StopReason::kConverged);
    EXPECT_LE(lbfgs.best_value() - 1, 10 * tolerance);
  }
}

TEST(Lbfgs, stops_where_the_start_is_not_finite_and_keeps_it) {
  const Function f([](const Eigen::VectorXd&, Eigen::VectorXd&) { return std::nan(""); });
  const Identity identity;
  Lbfgs lbfgs(f, identity, Eigen::Vector2d(2, 3), {});
  EXPECT_TRUE(lbfgs.step());
  EXPECT_EQ(lbfgs.stop(), StopReason::kNotFinite);
  EXPECT_EQ(lbfgs.best(), Eigen::VectorXd(Eigen::Vector2d(2, 3)));
}

TEST(Lbfgs, stops_after_the_iterations_allowed) {
  const Function f(rosenbrock);
  const Identity identity;
  for (const int most : {0, 1, 7}) {
    LbfgsOptions options;
    options.max_iterations = most;
    Lbfgs lbfgs(f, identity, Eigen::Vector2d(-1.2, 1), options);
    run(lbfgs);
    EXPECT_EQ(lbfgs.stop(), StopReason::kMaxIterations);
    EXPECT_EQ(lbfgs.iterations(), most);
  }
}

TEST(Lbfgs, ends_as_stalled_when_the_gradient_is_wrong) {
  const Function f([](const Eigen::VectorXd& x, Eigen::VectorXd& g) {
    const double value = rosenbrock(x, g);
    g = -g;
    return value;
  });
  const Identity identity;
  Lbfgs lbfgs(f, identity, Eigen::Vector2d(-1.2, 1), {});
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kLineSearchStalled);
}

TEST(Lbfgs, ends_at_round_off_when_no_tolerance_is_asked_for) {
  const Function f(quadratic);
  const Identity identity;
  LbfgsOptions options;
  options.tolerance = 0;
  Lbfgs lbfgs(f, identity, Eigen::VectorXd::Zero(40), options);
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kRoundOff);
  EXPECT_NEAR(lbfgs.best_value(), 1, 1e-11);
}

TEST(Lbfgs, ends_where_the_objective_says_that_the_surface_collapses) {
  Function f([](const Eigen::VectorXd& x, Eigen::VectorXd& g) { return g = 2 * x, x.squaredNorm(); });
  f.degenerate_below = 1;
  const Identity identity;
  Lbfgs lbfgs(f, identity, Eigen::Vector2d(30, 40), {});
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kDegenerate);
}

TEST(Lbfgs, can_be_cancelled_between_any_two_evaluations_without_losing_the_best_point) {
  const Function f(rosenbrock);
  const Identity identity;
  for (int steps = 0; steps < 30; ++steps) {
    Lbfgs lbfgs(f, identity, Eigen::Vector2d(-1.2, 1), {});
    double lowest = std::numeric_limits<double>::infinity();
    Eigen::VectorXd g(2);
    for (int i = 0; i < steps; ++i) {
      lbfgs.step();
      lowest = std::min(lowest, lbfgs.best_value());
    }
    lbfgs.cancel();
    EXPECT_TRUE(lbfgs.step());
    EXPECT_EQ(lbfgs.stop(), StopReason::kCancelled);
    EXPECT_EQ(lbfgs.evaluations(), steps);
    if (steps > 0) {
      EXPECT_EQ(rosenbrock(lbfgs.best(), g), lowest);
    }
  }
}

TEST(Lbfgs, steps_over_regions_that_are_not_finite) {
  const Function f([](const Eigen::VectorXd& x, Eigen::VectorXd& g) {
    if (x[0] <= 0) return std::numeric_limits<double>::infinity();
    g[0] = 1 - 1 / x[0];
    return x[0] - std::log(x[0]);
  });
  const Identity identity;
  Lbfgs lbfgs(f, identity, Eigen::VectorXd::Constant(1, 1e-3), {});
  run(lbfgs);
  EXPECT_EQ(lbfgs.stop(), StopReason::kConverged);
  EXPECT_NEAR(lbfgs.best()[0], 1, 1e-2);
}

}  // namespace
}  // namespace umbilic::test
