// SPDX-License-Identifier: MIT
/// \file
/// Fills basis tables from B-splines and cap sectors.
#include "surface/basis_table.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

#include "base/lanes.h"
#include "base/shared_cache.h"
#include "surface/bspline.h"

namespace umbilic {
namespace {

PatchColumns find_columns(const PatchKind& kind) {
  PatchColumns columns;
  if (kind.regular()) {
    for (int i = 0; i < 16; ++i) columns.net.push_back(i);
    return columns;
  }
  columns.net = cap_sector(kind.valence, kind.shape).net().support(kind.cell);
  columns.coefficients = coefficient_count(kind.shape);
  return columns;
}

}  // namespace

const PatchColumns& patch_columns(const PatchKind& kind) {
  static std::mutex mutex;
  static std::map<PatchKind, PatchColumns> all;  // a map never moves its elements
  const std::lock_guard lock(mutex);
  const auto found = all.find(kind);
  return found != all.end() ? found->second : all.emplace(kind, find_columns(kind)).first->second;
}

DerivativeRows patch_basis(const PatchKind& kind, double u, double v) {
  if (!kind.regular()) return cap_sector(kind.valence, kind.shape).basis(kind.cell, u, v);
  const Eigen::Matrix4d along_u = cubic_bspline(u), along_v = cubic_bspline(v);
  DerivativeRows rows(kDerivativeCount, 16);
  for (int i = 0; i < 16; ++i) {
    for (int d = 0; d < kDerivativeCount; ++d) rows(d, i) = along_u(kOrderU[d], i % 4) * along_v(kOrderV[d], i / 4);
  }
  return rows;
}

DerivativeRows patch_flattening(const PatchKind& kind, double u, double v) {
  return cap_sector(kind.valence, kind.shape).flattening(u, v);
}

namespace {

constexpr int round_up(int count, int multiple) { return (count + multiple - 1) / multiple * multiple; }

/// Samples written together, so that their entries of a column fill a cache line.
constexpr int kTogether = 8;

void write_rows(const std::vector<DerivativeRows>& rows, int count, int first, int last, int samples, double* entries,
                Eigen::Index stride) {
  for (Eigen::Index column = 0; column < rows.front().cols(); ++column) {
    for (int d = first; d < last; ++d) {
      double* to = entries + column * stride + (d - first) * samples;
      for (int k = 0; k < count; ++k) to[k] = rows[k](d, column);
    }
  }
}

void write_basis(const PatchKind& kind, const std::vector<Sample>& samples, BasisTable& table) {
  const bool flat = kind.shape == CapShape::kFlat;
  const int last = table.first + table.derivatives;
  std::vector<DerivativeRows> rows(kTogether), flat_rows(kTogether);
  for (int begin = 0; begin < table.samples; begin += kTogether) {
    const int count = std::min(kTogether, table.samples - begin);
    for (int k = 0; k < count; ++k) {
      const Sample& sample = samples[begin + k];
      rows[k] = patch_basis(kind, sample.u, sample.v);
      if (flat) flat_rows[k] = patch_flattening(kind, sample.u, sample.v);
    }
    write_rows(rows, count, table.first, last, table.samples, table.basis.data() + begin, table.stride);
    if (flat) {
      write_rows(flat_rows, count, table.first, last, table.samples, table.flattening.data() + begin, table.stride);
    }
  }
}

}  // namespace

BasisTable basis_table(const PatchKind& kind, std::vector<Sample> samples, int first, int last) {
  BasisTable table;
  table.first = first;
  table.derivatives = last - first;
  table.distinct = static_cast<int>(samples.size());
  pad_samples(samples, kSampleMultiple);
  table.samples = static_cast<int>(samples.size());
  table.columns = patch_columns(kind).count();
  table.padded_columns = round_up(table.columns, BasisTable::kColumnMultiple);
  table.stride = round_up(table.derivatives * table.samples, kCacheLine / sizeof(double));
  table.weights.resize(table.samples);
  for (int s = 0; s < table.samples; ++s) table.weights[s] = samples[s].weight;
  const std::size_t size = static_cast<std::size_t>(table.stride) * table.padded_columns;
  table.basis.resize(size);
  if (kind.shape == CapShape::kFlat) table.flattening.resize(size);
  write_basis(kind, samples, table);
  if (kind.shape == CapShape::kFlat) {
    table.normal_part = table.basis;
    for (std::size_t i = 0; i < size; ++i) table.normal_part[i] -= table.flattening[i];
  }
  return table;
}

std::vector<Sample> samples_of(const PatchKind& kind, const QuadratureRule& rule) {
  if (kind.regular() || samples_as_regular(kind.shape, kind.cell)) return tensor_rule(rule.regular_points);
  return kind.at_extraordinary() ? graded_rule(rule.cap_points, rule.grading) : tensor_rule(rule.cap_points);
}

std::shared_ptr<const BasisTable> shared_basis_table(const PatchKind& kind, const QuadratureRule& rule, int first) {
  static SharedCache<std::tuple<PatchKind, QuadratureRule, int>, BasisTable> tables(kSharedTableBytes);
  return tables.get({kind, rule, first},
                    [&] { return basis_table(kind, samples_of(kind, rule), first, kDerivativeCount); });
}

void pad_samples(std::vector<Sample>& samples, int lanes) {
  while (samples.size() % lanes != 0) {
    samples.push_back(samples.back());
    samples.back().weight = 0;
  }
}

}  // namespace umbilic
