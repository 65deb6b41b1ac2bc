// SPDX-License-Identifier: MIT
/// \file
/// Pads and aligns basis tables.
#include "surface/kernel_table.h"

#include <utility>

#include "base/lanes.h"
#include "base/shared_cache.h"

namespace umbilic {
namespace {

constexpr int round_up(int count, int multiple) { return (count + multiple - 1) / multiple * multiple; }

KernelTable make_table(const PatchKind& kind, const QuadratureRule& rule) {
  std::vector<Sample> samples = samples_of(kind, rule);
  pad_samples(samples, kSampleMultiple);
  KernelTable table;
  table.samples = static_cast<int>(samples.size());
  table.columns = round_up(patch_columns(kind).count(), kColumnMultiple);
  table.stride = round_up(table.rows(), kCacheLine / sizeof(double));
  table.weights.resize(table.samples);
  for (int s = 0; s < table.samples; ++s) table.weights[s] = samples[s].weight;
  const std::size_t size = static_cast<std::size_t>(table.stride) * table.columns;
  table.basis.resize(size);
  if (kind.shape == CapShape::kFlat) table.flattening.resize(size);
  write_basis(kind, samples, 1, kDerivativeCount, {table.basis.data(), table.stride},
              {table.flattening.data(), table.stride});
  return table;
}

}  // namespace

std::shared_ptr<const KernelTable> kernel_table(const PatchKind& kind, const QuadratureRule& rule) {
  static SharedCache<std::pair<PatchKind, QuadratureRule>, KernelTable> tables(kSharedTableBytes);
  return tables.get({kind, rule}, [&] { return make_table(kind, rule); });
}

}  // namespace umbilic
