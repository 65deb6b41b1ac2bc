// SPDX-License-Identifier: MIT
/// \file
/// Parts of reports as JSON objects, with the names and digits of their text form (problem/text.h), so that they can be
/// combined and compared.
#pragma once

#include <nlohmann/json.hpp>

#include "problem/print.h"

namespace umbilic::catalog {

/// Keeps its keys in the order in which they were added.
using Json = nlohmann::ordered_json;

template <class T>
Json part_json(const T& part) {
  return Json::parse(json_text(part));
}

}  // namespace umbilic::catalog
