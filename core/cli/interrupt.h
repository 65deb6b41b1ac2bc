// SPDX-License-Identifier: MIT
/// \file
/// Ctrl-C as a wish to end the run.
#pragma once

namespace umbilic::cli {

/// While this exists, the first SIGINT or SIGTERM is only remembered; the second ends the program as it would without
/// this.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const;
};

}  // namespace umbilic::cli
