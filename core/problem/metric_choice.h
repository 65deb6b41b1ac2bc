// SPDX-License-Identifier: MIT
/// \file
/// The metrics that a run may use.
#pragma once

#include <string_view>

namespace umbilic {

enum class MetricChoice { kAutomatic, kIdentity, kSobolev, kHessian, kNewton };
inline constexpr int kMetricChoiceCount = 5;
inline constexpr std::string_view kMetricChoiceNames[kMetricChoiceCount] = {"auto", "identity", "sobolev", "hessian",
                                                                            "newton"};

/// "auto", "identity", "sobolev", "hessian", "newton"; empty where there is no such metric.
constexpr std::string_view name_of(MetricChoice metric) {
  const int index = static_cast<int>(metric);
  return index >= 0 && index < kMetricChoiceCount ? kMetricChoiceNames[index] : std::string_view();
}

}  // namespace umbilic
