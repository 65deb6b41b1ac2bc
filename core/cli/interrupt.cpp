// SPDX-License-Identifier: MIT
/// \file
/// Handles signals.
#include "cli/interrupt.h"

#include <csignal>

namespace umbilic::cli {

namespace {

volatile std::sig_atomic_t g_interrupted = 0;

}  // namespace

extern "C" {
static void umbilic_remember_interrupt(int) {
  g_interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}
}

InterruptWatch::InterruptWatch() {
  g_interrupted = 0;
  std::signal(SIGINT, umbilic_remember_interrupt);
  std::signal(SIGTERM, umbilic_remember_interrupt);
  if (std::signal(SIGHUP, umbilic_remember_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (std::signal(SIGHUP, SIG_DFL) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool InterruptWatch::interrupted() const { return g_interrupted != 0; }

}  // namespace umbilic::cli
