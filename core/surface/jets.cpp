// SPDX-License-Identifier: MIT
/// \file
/// Evaluates the jets of each range of patches, and pulls back the adjoints that the visitor returns.
#include "surface/jets.h"

#include <cassert>

#include "base/threads.h"

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
  reserve_memory(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) patches_.clear(sums_[i]);

  in_order(
      block_count(), slot_count(),
      [&](int block, int slot, int member) {
        evaluate_block(block, derivatives, channels, visit, memories_[member], pulled_back_[slot]);
      },
      [&](int block, int slot) {
        for (std::size_t i = 0; i < channels.size(); ++i) {
          patches_.add(patches_.ranges()[block], pulled_back_[slot][i], sums_[i]);
        }
      });

  gradients.resize(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) patches_.finish(sums_[i], gradients[i]);
}

void JetEvaluator::reserve_memory(std::size_t channels) const {
  const auto grow = [](auto& list, std::size_t size) {
    if (list.size() < size) list.resize(size);
  };
  grow(memories_, thread_count());
  grow(pulled_back_, slot_count());
  grow(sums_, channels);
  for (Memory& memory : memories_) {
    grow(memory.adjoints, channels);
    grow(memory.starts, channels);
  }
  for (std::vector<RangeAdjoint>& of_channels : pulled_back_) grow(of_channels, channels);
}

void JetEvaluator::evaluate_block(int number, int derivatives, std::span<const AdjointChannel> channels,
                                  const JetVisitor& visit, Memory& memory,
                                  std::vector<RangeAdjoint>& pulled_back) const {
  const PatchRange range = patches_.ranges()[number];
  const PatchBasis& basis = patches_.basis(range.set);
  const std::size_t samples = static_cast<std::size_t>(basis.samples()) * range.count;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    memory.starts[i] = reserve(memory.adjoints[i], 3 * samples * channels[i].derivatives);
  }
  const double* jets = patches_.jets(range, derivatives, memory.patches);
  visit(number, {range.count, basis.samples(), derivatives, basis.weights().data(),
                 &layout().sets()[range.set].multiplicities[range.first], jets,
                 channels.empty() ? nullptr : memory.starts.data()});
  for (std::size_t i = 0; i < channels.size(); ++i) {
    patches_.pull_back(memory.starts[i], channels[i].derivatives, memory.patches, pulled_back[i]);
  }
}

}  // namespace umbilic
