// SPDX-License-Identifier: MIT
/// \file
/// How fast this machine computes, beside the one on which the rates of driver/level_work.cpp were measured.
#pragma once

namespace umbilic {

/// Seconds that take this machine as long as one second took that one, for work that all threads of the process share
/// where it is `large`. Measured on the first call, in a few milliseconds, by the energy of a torus with the kernels in
/// use; as what the machine does when nothing disturbs it.
double machine_slowness(bool large);

}  // namespace umbilic
