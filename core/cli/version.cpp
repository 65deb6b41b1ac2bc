// SPDX-License-Identifier: MIT
/// \file
/// The version that the build was given.
#include "cli/version.h"

namespace umbilic::cli {

std::string_view version() { return UMBILIC_VERSION; }

}  // namespace umbilic::cli
