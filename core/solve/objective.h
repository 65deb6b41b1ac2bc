// SPDX-License-Identifier: MIT
/// \file
/// The interfaces of the optimizer: the function to minimize, and the metric in which directions are computed.
#pragma once

#include <Eigen/Core>

namespace umbilic {

struct Evaluation {
  double value = 0;          ///< may be infinite or NaN
  Eigen::VectorXd gradient;  ///< by the unknowns
  bool degenerate = false;   ///< the value is finite, but about to become meaningless
};

/// A function of the unknowns with its gradient.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const = 0;
};

/// A symmetric positive definite approximation of the Hessian, up to a constant factor, which L-BFGS estimates.
class Metric {
 public:
  virtual ~Metric() = default;
  /// The solution of metric * direction = gradient.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const = 0;
  /// Whether the decrease that it predicts from a single gradient can be trusted.
  virtual bool predicts() const { return true; }
};

}  // namespace umbilic
