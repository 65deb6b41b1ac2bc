// SPDX-License-Identifier: MIT
/// \file
/// Lets Ctrl-C, and what else asks a program to end, end a run early.
#pragma once

namespace umbilic::cli {

/// While this exists, the first SIGINT, SIGTERM or SIGHUP is only remembered. A second SIGINT or SIGTERM ends the
/// program as usual. A second SIGHUP does not: when a terminal closes, both the shell and the system send one. A
/// SIGHUP that was ignored before, as by nohup, stays so.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;
};

}  // namespace umbilic::cli
