// SPDX-License-Identifier: MIT
/// \file
/// Rounds durations as plainly as they are known.
#include "cli/estimates.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace umbilic::cli {
namespace {

constexpr double kMinute = 60, kHour = 60 * kMinute, kDay = 24 * kHour;
/// Seconds that try a user's patience.
constexpr double kLong = 2 * kMinute;

std::string memory_words(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", std::max(1., std::round(bytes / 1e6)))
                     : fmt::format("{:.1f} GB", bytes / 1e9);
}

}  // namespace

std::string rough_duration(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  const auto about = [&](double unit, double step, const char* name) {
    return fmt::format("about {:.0f} {}", step * std::max(1., std::round(seconds / (unit * step))), name);
  };
  if (seconds < 1.5) return "a second";
  if (seconds < 9.5) return about(1, 1, "s");
  if (seconds < 57.5) return about(1, 5, "s");
  if (seconds < 1.5 * kMinute) return "about a minute";
  if (seconds < 9.5 * kMinute) return about(kMinute, 1, "min");
  if (seconds < 57.5 * kMinute) return about(kMinute, 5, "min");
  if (seconds < 1.5 * kHour) return "about an hour";
  return seconds < 1.5 * kDay ? about(kHour, 1, "h") : about(kDay, 1, "days");
}

std::string estimate_table(const Estimate& estimate) {
  std::string table = "  level    patches   unknowns evaluations      memory   time\n";
  for (const LevelEstimate& level : estimate.levels) {
    table += fmt::format("{:7} {:10.0f} {:10.0f} {:11.0f} {:>11}   {}\n", level.level, level.patches, level.unknowns,
                         level.evaluations, memory_words(level.bytes), rough_duration(level.seconds));
  }
  return table + fmt::format("in all {}, {}; half or twice as long is usual\n", rough_duration(estimate.seconds),
                             memory_words(estimate.bytes));
}

std::string estimate_warnings(const Estimate& estimate, double memory) {
  std::string warnings;
  const auto longest =
      std::max_element(estimate.levels.begin(), estimate.levels.end(),
                       [](const LevelEstimate& a, const LevelEstimate& b) { return a.seconds < b.seconds; });
  if (longest == estimate.levels.end()) return warnings;
  if (estimate.seconds > kLong) {
    warnings += fmt::format("note: this will take {}", rough_duration(estimate.seconds));
    warnings += estimate.levels.size() > 1
                    ? fmt::format(", of which level {} takes {}\n", longest->level, rough_duration(longest->seconds))
                    : "\n";
  }
  if (memory > 0 && estimate.bytes > memory) {
    warnings += fmt::format("note: this will take {} of memory; the machine has {}\n", memory_words(estimate.bytes),
                            memory_words(memory));
  }
  return warnings;
}

std::string estimate_warnings(const Estimate& estimate) {
  return estimate_warnings(estimate,
                           static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

}  // namespace umbilic::cli
