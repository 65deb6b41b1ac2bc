// SPDX-License-Identifier: MIT
/// \file
/// What the optimizer minimizes, and the inner product in which it looks for a direction.
#pragma once

#include <Eigen/Core>

namespace umbilic {

struct Evaluation {
  double value = 0;          ///< may be infinite or NaN
  Eigen::VectorXd gradient;  ///< by the unknowns
  bool degenerate = false;   ///< the value is finite, but here it is about to lose its meaning
};

/// A function of the unknowns with its gradient.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const = 0;
};

/// A symmetric positive definite approximation of the Hessian, up to a factor that L-BFGS finds by itself.
class Metric {
 public:
  virtual ~Metric() = default;
  /// The solution of metric * direction = gradient.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const = 0;
  /// Whether the decrease that it predicts from one gradient alone may be believed.
  virtual bool predicts() const { return true; }
};

}  // namespace umbilic
