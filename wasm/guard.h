// SPDX-License-Identifier: MIT
/// \file
/// The wrapper of every function of the contract: turns exceptions into statuses and keeps the message of a failure.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/result.h"
#include "wasm/api.h"

namespace umbilic::api {

/// The message of the last failure on this thread.
std::string_view last_message() noexcept;

/// Keeps the message and returns the status.
umbilic_status fail(umbilic_status status, std::string_view message) noexcept;

inline umbilic_status fail(const Error& error) noexcept { return fail(UMBILIC_BAD_INPUT, error.message); }

/// Whether none of the caller's pointers is null; otherwise keeps a message.
template <class... Pointers>
bool all_given(const Pointers*... pointers) noexcept {
  const bool given = (... && (pointers != nullptr));
  if (!given) fail(UMBILIC_BAD_ARGUMENT, "a null pointer");
  return given;
}

/// Runs `body`, which returns a status.
template <class Body>
umbilic_status guarded(const Body& body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return fail(UMBILIC_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error&) {
    return fail(UMBILIC_OUT_OF_MEMORY, "more than memory can hold");
  } catch (const std::exception& error) {
    return fail(UMBILIC_INTERNAL, error.what());
  } catch (...) {
    return fail(UMBILIC_INTERNAL, "unknown failure");
  }
}

/// Returns a text to the caller, valid until the next one on this thread.
umbilic_status answer(std::string text, umbilic_text* out) noexcept;

}  // namespace umbilic::api
