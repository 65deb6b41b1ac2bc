// SPDX-License-Identifier: MIT
/// \file
/// Lets Ctrl-C end a run early.
#pragma once

namespace umbilic::cli {

/// While this exists, the first SIGINT or SIGTERM is only remembered; the second ends the program as usual.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;
};

}  // namespace umbilic::cli
