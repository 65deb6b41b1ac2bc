// SPDX-License-Identifier: MIT
/// \file
/// The groups of a layout, passed one after the other.
#include "surface/jets.h"

#include <cassert>

#include "surface/jet_pass.h"

namespace umbilic {

JetEvaluator::JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule)
    : layout_(layout), pass_(std::make_unique<JetPass>(layout)) {
  for (const PatchSet& set : layout.sets()) groups_.push_back(std::make_unique<JetGroup>(set, rule));
}

JetEvaluator::~JetEvaluator() = default;

long JetEvaluator::sample_count() const {
  long count = 0;
  for (const auto& group : groups_) count += group->sample_count();
  return count;
}

std::size_t JetEvaluator::table_bytes() const {
  std::size_t bytes = 0;
  for (const auto& group : groups_) bytes += group->bytes();
  return bytes;
}

void JetEvaluator::evaluate(const Points& control, int derivatives, std::span<const AdjointChannel> channels,
                            const JetVisitor& visit, std::vector<Points>& gradients) const {
  assert(derivatives == kSecondOrderCount || derivatives == kThirdOrderCount);
  pass_->begin(control, derivatives, channels);
  for (const auto& group : groups_) pass_->run(*group, visit);
  pass_->finish(gradients);
}

}  // namespace umbilic
