// SPDX-License-Identifier: MIT
/// \file
/// Compares targets with what the problem holds.
#include "problem/targets.h"

#include <fmt/format.h>

#include <cmath>

namespace umbilic {
namespace {

bool is_free(const Pin& pin, int coordinate) { return pin.at && std::isnan((*pin.at)[coordinate]); }

/// Begins with the member that does not fit; empty if all do.
std::string mismatch(const PinTarget& target, const Pin& pin) {
  if (target.at && !pin.position) return "at: the pin holds only the normal";
  for (int c = 0; target.at && c < 3; ++c) {
    const double at = (*target.at)[c];
    if (std::isnan(at) == is_free(pin, c)) continue;
    return fmt::format("at[{}]: {}", c,
                       is_free(pin, c) ? "the pin leaves this coordinate free: expected null"
                                       : "null, but the pin holds this coordinate");
  }
  if (target.normal && !pin.holds_normal()) return "normal: the pin holds only the position";
  return "";
}

void set(const PinTarget& target, Pin& pin) {
  if (target.at) pin.at = target.at;
  if (target.normal) pin.normal = *target.normal;
}

}  // namespace

std::optional<Error> set_targets(const Targets& targets, RunOptions& options, Constraints& constraints) {
  if (Error error; targets.terms && !usable(*targets.terms, error)) return Error{"terms: " + error.message};
  if (!targets.pins.empty() && targets.pins.size() != constraints.pins.size()) {
    return Error{fmt::format("pins: {} for the problem's {}", targets.pins.size(), constraints.pins.size())};
  }
  std::vector<Pin> pins = constraints.pins;
  for (std::size_t i = 0; i < targets.pins.size(); ++i) {
    if (const std::string words = mismatch(targets.pins[i], pins[i]); !words.empty()) {
      return Error{fmt::format("pins[{}].{}", i, words)};
    }
    set(targets.pins[i], pins[i]);
    if (Error error; !in_range(pins[i], error)) return Error{fmt::format("pins[{}].{}", i, error.message)};
  }
  if (targets.closeness) {
    if (!constraints.closeness || !constraints.closeness->weight) {
      return Error{"closeness: the problem has no constraints.closeness.weight"};
    }
    const Closeness closeness{targets.closeness, {}};
    if (Error error; !in_range(closeness, error)) return Error{"closeness: " + error.message};
    constraints.closeness = closeness;
  }
  if (targets.terms) options.weights = *targets.terms;
  constraints.pins = std::move(pins);
  return std::nullopt;
}

}  // namespace umbilic
