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
  BasisTable plain = basis_table(kind, samples, 1, kDerivativeCount);
  KernelTable table;
  table.samples = plain.samples;
  table.columns = round_up(plain.columns, kColumnMultiple);
  table.stride = round_up(table.rows(), kCacheLine / sizeof(double));
  table.weights = std::move(plain.weights);
  const auto aligned = [&](const Eigen::MatrixXd& values) {
    AlignedDoubles copy(static_cast<std::size_t>(table.stride) * table.columns);
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(copy.data(), values.rows(), values.cols(),
                                                         Eigen::OuterStride<>(table.stride)) = values;
    return copy;
  };
  table.basis = aligned(plain.basis);
  if (kind.shape == CapShape::kFlat) table.flattening = aligned(plain.flattening);
  return table;
}

}  // namespace

std::shared_ptr<const KernelTable> kernel_table(const PatchKind& kind, const QuadratureRule& rule) {
  static SharedCache<std::pair<PatchKind, QuadratureRule>, KernelTable> tables(kSharedTableBytes);
  return tables.get({kind, rule}, [&] { return make_table(kind, rule); });
}

}  // namespace umbilic
