// SPDX-License-Identifier: MIT
/// \file
/// The texts that are kept for each thread.
#include "wasm/guard.h"

#include <pthread.h>

#include <memory>
#include <utility>

namespace umbilic::api {
namespace {

constexpr std::string_view kNoMemory = "no memory";

struct Texts {
  std::string message, answer;
};

/// Frees the texts of threads that end. A `thread_local` object with a destructor would end the process instead where
/// there is no memory to register it, and WebAssembly's module without threads has no memory for any.
pthread_key_t key_of_texts() {
  static const pthread_key_t key = [] {
    pthread_key_t made;
    if (pthread_key_create(&made, [](void* texts) { delete static_cast<Texts*>(texts); }) != 0) throw std::bad_alloc();
    return made;
  }();
  return key;
}

/// The texts of this thread; null if there is no memory for them.
Texts* texts() noexcept {
  try {
    const pthread_key_t key = key_of_texts();
    if (void* kept = pthread_getspecific(key)) return static_cast<Texts*>(kept);
    auto made = std::make_unique<Texts>();
    if (pthread_setspecific(key, made.get()) == 0) return made.release();
  } catch (const std::bad_alloc&) {
  }
  return nullptr;
}

}  // namespace

std::string_view last_message() noexcept {
  const Texts* kept = texts();
  return kept ? std::string_view(kept->message) : kNoMemory;
}

umbilic_status fail(umbilic_status status, std::string_view message) noexcept {
  Texts* kept = texts();
  if (!kept) return status;
  try {
    kept->message = message;
  } catch (const std::bad_alloc&) {
    kept->message = kNoMemory;  // short enough to need no allocation
  }
  return status;
}

umbilic_status answer(std::string text, umbilic_text* out) noexcept {
  Texts* kept = texts();
  if (!kept) return fail(UMBILIC_OUT_OF_MEMORY, kNoMemory);
  kept->answer = std::move(text);
  *out = {kept->answer.c_str(), kept->answer.size()};
  return UMBILIC_OK;
}

}  // namespace umbilic::api
