// SPDX-License-Identifier: MIT
/// \file
/// What is fuzzed: functions that take any bytes, and end the program where a promise is broken. `npm run fuzz` runs
/// them with bytes that libFuzzer invents, the tests with the files in corpus/, a folder for each.
#pragma once

#include <array>
#include <string_view>

namespace umbilic::fuzz {

/// The file of a cage: it is read or refused with words; what is read is valid, and reads back from its text and from
/// what is written of it.
void cages(std::string_view file);

/// The text of a problem, a report or a part of them: it is read or refused with words; what is read prints to a text
/// that reads back to the same.
void problems(std::string_view text);

/// Choices of calls of the C contract on runs of small cages: each answers with a status that the caller or the user is
/// to blame for, if anyone; leaves outputs as they were where it fails; and hands out what the contract says.
void contract(std::string_view choices);

struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

inline constexpr std::array<Target, 3> kTargets{{{"cages", cages}, {"problems", problems}, {"contract", contract}}};

/// Of the processor that an input takes with sanitizers, on any machine: the time by the clock depends on what else
/// runs.
inline constexpr double kMostSeconds = 10;

/// Ends the program with these words unless the promise is kept, in all builds.
void require(bool kept, std::string_view words);

/// Requires that a message has words, in one line that can be printed.
void require_words(std::string_view message);

}  // namespace umbilic::fuzz
