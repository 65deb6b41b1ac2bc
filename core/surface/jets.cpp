// SPDX-License-Identifier: MIT
/// \file
/// Evaluates the jets of one range of patches after the other, and pulls back the adjoints that the visitor returns.
#include "surface/jets.h"

#include <cassert>

namespace umbilic {

JetEvaluator::JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule)
    : patches_(layout, [&](const PatchKind& kind) { return PatchBasis(kind, rule); }) {}

long JetEvaluator::sample_count() const {
  long count = 0;
  for (int set = 0; set < patches_.set_count(); ++set) {
    count += (patches_.basis(set).weights().array() > 0).count() * layout().sets()[set].count();
  }
  return count;
}

std::size_t JetEvaluator::table_bytes() const {
  std::size_t bytes = 0;
  for (int set = 0; set < patches_.set_count(); ++set) bytes += patches_.basis(set).bytes();
  return bytes;
}

void JetEvaluator::evaluate(const Points& control, int derivatives, std::span<const AdjointChannel> channels,
                            const JetVisitor& visit, std::vector<Points>& gradients) const {
  assert(derivatives == kSecondOrderCount || derivatives == kThirdOrderCount);
  patches_.move_to(control);
  if (channels_.size() < channels.size()) channels_.resize(channels.size());
  adjoints_.resize(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) patches_.clear(channels_[i].sum);

  patches_.for_each_range([&](PatchRange range) {
    const PatchBasis& basis = patches_.basis(range.set);
    const std::size_t samples = static_cast<std::size_t>(basis.samples()) * range.count;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      adjoints_[i] = reserve(channels_[i].adjoint, 3 * samples * channels[i].derivatives);
    }
    const double* jets = patches_.jets(range, derivatives);
    visit({range.count, basis.samples(), derivatives, basis.weights().data(),
           &layout().sets()[range.set].multiplicities[range.first], jets,
           channels.empty() ? nullptr : adjoints_.data()});
    for (std::size_t i = 0; i < channels.size(); ++i) {
      patches_.pull_back(adjoints_[i], channels[i].derivatives, channels_[i].sum);
    }
  });

  gradients.resize(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) patches_.finish(channels_[i].sum, gradients[i]);
}

}  // namespace umbilic
