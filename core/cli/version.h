// SPDX-License-Identifier: MIT
/// \file
/// The program's version.
#pragma once

#include <string_view>

namespace umbilic {

std::string_view version();

}  // namespace umbilic
