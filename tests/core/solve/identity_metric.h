// SPDX-License-Identifier: MIT
/// \file
/// The metric that changes nothing.
#pragma once

#include "solve/objective.h"

namespace umbilic::test {

class Identity : public Metric {
 public:
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override { return gradient; }
};

}  // namespace umbilic::test
