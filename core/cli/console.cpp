// SPDX-License-Identifier: MIT
/// \file
/// Writing to the terminal.
#include "cli/console.h"

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "cage/text.h"
#include "cli/estimates.h"

namespace umbilic::cli {

namespace {

void write_error(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

std::string describe(const Progress& progress) {
  std::string text = fmt::format("level {}", progress.level);
  if (progress.phase == Phase::kPrepare) return text + ": preparing";
  text += progress.phase == Phase::kCompareCaps ? std::string(": comparing with narrower caps")
                                                : fmt::format(": {} evaluations", progress.evaluations);
  if (std::isfinite(progress.energy)) text += fmt::format(", energy {:.10g}", progress.energy);
  if (std::isfinite(progress.predicted_decrease)) text += fmt::format(", to gain {:.1e}", progress.predicted_decrease);
  return text + fmt::format(", {:.0f} % done, {} left", std::floor(100 * progress.share_done),
                            rough_duration(progress.seconds_left));
}

}  // namespace

std::string printable_lines(std::string_view text) {
  std::string out;
  for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
    out.append(printable(text.substr(0, end))).append("\n");
  }
  return out.append(printable(text));
}

int fail(int exit_code, std::string_view message) {
  write_error(fmt::format("umbilic: {}\n", printable_lines(message)));
  return exit_code;
}

void tell(std::string_view text) { write_error(text); }

bool print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) write_error(fmt::format("umbilic: cannot write to standard output: {}\n", std::strerror(errno)));
  return written;
}

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (shown_) write_error("\r\x1b[K");
  shown_ = false;
}

CatalogBar::CatalogBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

CatalogBar::~CatalogBar() {
  if (shown_) write_error("\r\x1b[K");
}

void CatalogBar::update(const catalog::CatalogProgress& progress) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  if (terminal_ ? now < next_update_ : progress.done == told_) return;
  constexpr auto kPause = std::chrono::milliseconds(200);
  next_update_ = now + kPause;
  told_ = progress.done;
  if (!terminal_) return write_error(fmt::format("{} of {} entries\n", progress.done, progress.count));
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = progress.count > 0 ? kWidth * progress.done / progress.count : 0;
  write_error(fmt::format("\r[{:=<{}}{: <{}}] {} of {} entries, {} level {}\x1b[K", "", filled, "", kWidth - filled,
                          progress.done, progress.count, progress.task, progress.level));
  shown_ = true;
}

void ProgressLine::update(const Run& run) {
  if (quiet_) return;
  for (; levels_told_ < run.levels().size(); ++levels_told_) {
    const LevelReport& level = run.levels()[levels_told_];
    clear();
    write_error(fmt::format("level {}: {} patches, {} evaluations, energy {:.10g}, {} after {:.1f} s\n", level.level,
                            level.patches, level.evaluations, level.energy, name_of(level.stop), level.seconds));
  }
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now < next_update_ || run.progress().phase == Phase::kDone) return;
  constexpr auto kPause = std::chrono::milliseconds(100);
  next_update_ = now + kPause;
  write_error(fmt::format("\r{}\x1b[K", describe(run.progress())));
  shown_ = true;
}

}  // namespace umbilic::cli
