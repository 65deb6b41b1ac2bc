// SPDX-License-Identifier: MIT
/// \file
/// How fast this machine computes, beside the one on which the rates of driver/level_work.cpp were measured.
#pragma once

namespace umbilic {

/// Seconds of this machine for work that took that one a second on one thread. Threads share it, and where it is not
/// `large` they gain nothing. Measured on the first call, and again when threads or kernels change, in a few
/// milliseconds, by the energy of a torus; with the best of several rounds, so when nothing else disturbs the machine.
double machine_slowness(bool large);

}  // namespace umbilic
