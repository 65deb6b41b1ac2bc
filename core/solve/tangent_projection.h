// SPDX-License-Identifier: MIT
/// \file
/// Projects the directions that a metric gives to the tangent space of a level set of a function of the unknowns.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace umbilic {

/// The projection of M^-1 g to the directions d with a . d = 0, orthogonal in the metric M: the solution of M d +
/// lambda a = g, a . d = 0. M^-1 g itself until `set` is called.
class TangentProjection {
 public:
  /// `a` is the gradient of the function, `solved` is M^-1 a.
  void set(Eigen::VectorXd a, Eigen::VectorXd solved) {
    a_ = std::move(a);
    solved_ = std::move(solved);
  }
  /// Projects `direction` = M^-1 g.
  Eigen::VectorXd project(const Eigen::VectorXd& direction) const {
    if (a_.size() == 0) return direction;
    return direction - (a_.dot(direction) / a_.dot(solved_)) * solved_;
  }

 private:
  Eigen::VectorXd a_, solved_;
};

}  // namespace umbilic
