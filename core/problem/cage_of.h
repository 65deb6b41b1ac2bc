// SPDX-License-Identifier: MIT
/// \file
/// Makes the cage that a problem names.
#pragma once

#include "cage/read.h"
#include "problem/problem.h"

namespace umbilic {

/// Errors begin with the cage's name, where it has one. A path is an error: no layer below the command line opens
/// files.
Result<CheckedCage> cage_of(const CageInput& input);

/// The error with the cage's name before it, where it has one.
Error named(const CageInput& input, Error error);

}  // namespace umbilic
