// SPDX-License-Identifier: MIT
/// \file
/// Limited-memory BFGS with an initial metric. Each call makes one evaluation, so that the caller can stop at any time.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>

#include "solve/line_search.h"
#include "solve/objective.h"
#include "solve/stop_reason.h"

namespace umbilic {

struct LbfgsOptions {
  int memory = 20;            ///< > 0: number of curvature pairs kept
  int max_iterations = 1000;  ///< >= 0
  double tolerance =
      1e-6;          ///< >= 0: converged when the decrease still predicted is at most tolerance * max(value, floor)
  double floor = 0;  ///< >= 0, in units of the objective
  /// >= 0: the quadratic model is believed without the trend if it predicts less than this fraction of the tolerance.
  double model_alone = 1e-3;
  double max_displacement = 1e300;  ///< > 0: largest change of an unknown in the first trial of a step
  int trend = 10;  ///< > 0: length in iterations of each of the two spans whose decreases are extrapolated
};

/// Nocedal & Wright, algorithm 7.4, with H0 = gamma metric^-1 and gamma = s.y / (y . metric^-1 y).
///
/// Converges when the decrease still predicted is within the tolerance. The prediction is the larger of two: that of
/// the quadratic model, g . H g / 2, and that of the trend, which extrapolates the decreases of the last two spans of
/// iterations as a geometric sequence. If the model's prediction is far enough below the tolerance (`model_alone`) and
/// the metric `predicts`, the model alone decides.
class Lbfgs {
 public:
  /// `objective` and `metric` must outlive the optimizer.
  Lbfgs(const Objective& objective, const Metric& metric, Eigen::VectorXd start, LbfgsOptions options);

  /// Evaluates the objective once. Returns whether the optimizer has ended; further calls then do nothing.
  bool step();

  /// Continues, after it has converged or found no way down, with a better metric or a smaller tolerance. Forgets all
  /// curvature pairs.
  void resume(double tolerance);

  /// Continues from the best point with an objective that has changed, whose value there it evaluates.
  void restart(double tolerance, double model_alone);

  bool ended() const { return stop_.has_value(); }
  StopReason stop() const { return *stop_; }
  void cancel() {
    if (!stop_) stop_ = StopReason::kCancelled;
  }

  /// Whether the next `step` begins a new line search, so that the metric may change now.
  bool between_iterations() const { return !search_; }
  /// Whether the last predicted decrease is within the tolerance.
  bool has_nearly_converged() const { return predicted_ <= options_.tolerance * std::max(value_, options_.floor); }
  /// Uses `metric` from the next direction on, and keeps the curvature pairs. `metric` must outlive the optimizer.
  void set_metric(const Metric& metric) { metric_ = &metric; }
  /// Drops the curvature pairs.
  void forget() { pairs_.clear(); }

  const Eigen::VectorXd& best() const { return best_; }
  double best_value() const { return best_value_; }
  double best_gradient_norm() const { return best_gradient_norm_; }
  double predicted_decrease() const { return predicted_; }
  int iterations() const { return iterations_; }
  int evaluations() const { return evaluations_; }
  /// The decrease in the latest iteration, divided by what the quadratic model had predicted; 1 before.
  double latest_gain() const { return latest_gain_; }

 private:
  struct Pair {
    Eigen::VectorXd s, y;
    double rho;
  };

  void evaluate(const Eigen::VectorXd& at);
  double trend() const;
  void begin_iteration();
  void end_iteration();
  void restart_or_stall();
  Eigen::VectorXd direction() const;

  const Objective& objective_;
  const Metric* metric_;
  LbfgsOptions options_;

  Eigen::VectorXd unknowns_, gradient_;
  double value_ = 0;
  Evaluation trial_;
  Eigen::VectorXd trial_unknowns_, direction_;
  std::optional<LineSearch> search_;
  std::deque<Pair> pairs_;
  std::deque<double> recent_values_;

  Eigen::VectorXd best_;
  double best_value_, best_gradient_norm_;
  double predicted_;
  int iterations_ = 0, evaluations_ = 0;
  double model_ = 0, latest_gain_ = 1;
  bool restarted_ = false;
  std::optional<StopReason> stop_;
};

}  // namespace umbilic
