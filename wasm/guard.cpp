// SPDX-License-Identifier: MIT
/// \file
/// The texts that are kept for each thread.
#include "wasm/guard.h"

namespace umbilic::api {
namespace {

thread_local std::string g_message;
thread_local std::string g_answer;

}  // namespace

const std::string& last_message() noexcept { return g_message; }

umbilic_status fail(umbilic_status status, std::string_view message) noexcept {
  try {
    g_message = message;
  } catch (const std::bad_alloc&) {
    g_message = "no memory";  // short enough to need no allocation
  }
  return status;
}

umbilic_status answer(std::string text, umbilic_text* out) noexcept {
  g_answer = std::move(text);
  *out = {g_answer.c_str(), g_answer.size()};
  return UMBILIC_OK;
}

}  // namespace umbilic::api
