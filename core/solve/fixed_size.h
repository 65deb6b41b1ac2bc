// SPDX-License-Identifier: MIT
/// \file
/// Keeps the directions that a metric answers with to those that leave the surface's size alone.
///
/// Energies have degree 0 in the control points: a gradient has no part along a change of scale, but a metric that is
/// not invariant turns it into one, and the surface grows from step to step without gaining anything.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace umbilic {

/// The projection of M^-1 g on the directions d with a . d = 0 that is orthogonal in the metric M.
class FixedSize {
 public:
  /// `a` is the gradient of a measure of size, `solved` is M^-1 a.
  void set(Eigen::VectorXd a, Eigen::VectorXd solved) {
    a_ = std::move(a);
    solved_ = std::move(solved);
  }
  Eigen::VectorXd project(const Eigen::VectorXd& direction) const {
    return direction - (a_.dot(direction) / a_.dot(solved_)) * solved_;
  }

 private:
  Eigen::VectorXd a_, solved_;
};

}  // namespace umbilic
