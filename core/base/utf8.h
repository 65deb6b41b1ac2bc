// SPDX-License-Identifier: MIT
/// \file
/// Characters in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace umbilic {

/// Length in bytes of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace umbilic
