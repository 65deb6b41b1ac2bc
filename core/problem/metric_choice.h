// SPDX-License-Identifier: MIT
/// \file
/// The metrics that a run may use.
#pragma once

#include <string_view>

namespace umbilic {

enum class MetricChoice { kAutomatic, kIdentity, kSobolev, kHessian };
inline constexpr int kMetricChoiceCount = 4;
inline constexpr std::string_view kMetricChoiceNames[kMetricChoiceCount] = {"auto", "identity", "sobolev", "hessian"};

}  // namespace umbilic
