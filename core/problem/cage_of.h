// SPDX-License-Identifier: MIT
/// \file
/// Makes the cage of a problem.
#pragma once

#include "cage/read.h"
#include "problem/problem.h"

namespace umbilic {

/// Errors begin with the cage's name, if it has one. A path is an error, because no layer below the command line opens
/// files.
Result<CheckedCage> cage_of(const CageInput& input);

/// The error, preceded by the cage's name if it has one, with '?' for what of it cannot be printed.
Error named(const CageInput& input, Error error);

}  // namespace umbilic
