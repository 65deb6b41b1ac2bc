// SPDX-License-Identifier: MIT
/// \file
/// Moré & Thuente's line search for the strong Wolfe conditions. The caller evaluates the function: one value per call.
#pragma once

namespace umbilic {

struct LineSearchOptions {
  double decrease = 1e-4;    ///< in (0, 1/2): phi(t) <= phi(0) + decrease t phi'(0)
  double curvature = 0.9;    ///< in (decrease, 1): |phi'(t)| <= curvature |phi'(0)|
  double width = 1e-12;      ///< > 0: relative width of the bracket at which the search gives up
  double max_step = 1e10;    ///< > 0
  int max_evaluations = 30;  ///< > 0
};

/// Finds a step t along a descent direction. Moré & Thuente 1994, ACM TOMS 20(3), 286-307. A value that is not finite
/// moves the next trial back towards the best known step.
class LineSearch {
 public:
  enum class Status { kEvaluate, kDone, kFailed };

  /// `value` = phi(0), `slope` = phi'(0) < 0; the first step must be > 0.
  LineSearch(double value, double slope, double step, LineSearchOptions options);

  /// The step to evaluate next, or the accepted one.
  double step() const { return step_; }
  /// Takes phi and phi' at `step()`.
  Status update(double value, double slope);

 private:
  /// A step with phi and phi' there.
  struct Point {
    double step, value, slope;
  };

  Status reject_not_finite();
  void choose_step(Point trial);
  double trial_step(const Point& best, const Point& other, const Point& trial) const;

  LineSearchOptions options_;
  double start_value_, start_slope_;
  double step_;
  Point best_, other_;
  bool bracketed_ = false;
  bool first_stage_ = true;
  double lower_, upper_;
  double width_, previous_width_;
  double largest_;  // smallest step whose value was not finite, or the maximum
  int evaluations_ = 0;
};

}  // namespace umbilic
