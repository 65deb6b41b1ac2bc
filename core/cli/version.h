// SPDX-License-Identifier: MIT
/// \file
/// The program's version.
#pragma once

#include <string_view>

namespace umbilic::cli {

std::string_view version();

}  // namespace umbilic::cli
