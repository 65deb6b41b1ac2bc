// SPDX-License-Identifier: MIT
/// \file
/// Fills basis tables from B-splines and cap sectors.
#include "surface/basis_table.h"

#include <cmath>
#include <map>
#include <mutex>

#include "base/shared_cache.h"
#include "surface/bspline.h"

namespace umbilic {
namespace {

DerivativeRows pick(const DerivativeRows& all, const PatchColumns& columns, int net_size) {
  DerivativeRows rows(kDerivativeCount, columns.count());
  int column = 0;
  for (const int i : columns.net) rows.col(column++) = all.col(i);
  for (int i = 0; i < columns.coefficients; ++i) rows.col(column++) = all.col(net_size + i);
  return rows;
}

PatchColumns find_columns(const PatchKind& kind) {
  PatchColumns columns;
  if (kind.regular()) {
    for (int i = 0; i < 16; ++i) columns.net.push_back(i);
    return columns;
  }
  // The support of the limit surface over the face: probes on all subpatches that see different control points.
  const CapSector& sector = cap_sector(kind.valence, kind.shape);
  Eigen::VectorXd support = Eigen::VectorXd::Zero(sector.net().size());
  for (const double u : {0.2, 0.4, 0.7}) {
    for (const double v : {0.2, 0.4, 0.7}) {
      support += sector.net().basis(kind.cell % 2 + u, kind.cell / 2 + v).row(0).transpose().cwiseAbs();
    }
  }
  for (int i = 0; i < support.size(); ++i) {
    if (support[i] != 0) columns.net.push_back(i);
  }
  columns.coefficients = coefficient_count(kind.shape);
  return columns;
}

}  // namespace

const PatchColumns& patch_columns(const PatchKind& kind) {
  static std::mutex mutex;
  static std::map<PatchKind, PatchColumns> all;  // never moves what it holds
  const std::lock_guard lock(mutex);
  const auto found = all.find(kind);
  return found != all.end() ? found->second : all.emplace(kind, find_columns(kind)).first->second;
}

DerivativeRows patch_basis(const PatchKind& kind, const PatchColumns& columns, double u, double v) {
  if (!kind.regular()) {
    const CapSector& sector = cap_sector(kind.valence, kind.shape);
    return pick(sector.basis(kind.cell % 2 + u, kind.cell / 2 + v), columns, sector.net().size());
  }
  const Eigen::Matrix4d along_u = cubic_bspline(u), along_v = cubic_bspline(v);
  DerivativeRows rows(kDerivativeCount, 16);
  for (int d = 0; d < kDerivativeCount; ++d) {
    for (int i = 0; i < 16; ++i) rows(d, i) = along_u(kOrderU[d], i % 4) * along_v(kOrderV[d], i / 4);
  }
  return rows;
}

DerivativeRows patch_flattening(const PatchKind& kind, const PatchColumns& columns, double u, double v) {
  const CapSector& sector = cap_sector(kind.valence, kind.shape);
  return pick(sector.flattening(u, v), columns, sector.net().size());
}

BasisTable basis_table(const PatchKind& kind, const std::vector<Sample>& samples, int first, int last) {
  const PatchColumns& columns = patch_columns(kind);
  BasisTable table;
  table.samples = static_cast<int>(samples.size());
  table.columns = columns.count();
  table.weights.resize(table.samples);
  table.basis.resize((last - first) * table.samples, table.columns);
  const bool flat = kind.shape == CapShape::kFlat;
  if (flat) table.flattening.resize(table.basis.rows(), table.columns);
  for (int s = 0; s < table.samples; ++s) {
    const auto [u, v, weight] = samples[s];
    table.weights[s] = weight;
    const DerivativeRows rows = patch_basis(kind, columns, u, v);
    const DerivativeRows flattening = flat ? patch_flattening(kind, columns, u, v) : DerivativeRows();
    for (int d = first; d < last; ++d) {
      table.basis.row((d - first) * table.samples + s) = rows.row(d);
      if (flat) table.flattening.row((d - first) * table.samples + s) = flattening.row(d);
    }
  }
  return table;
}

std::vector<Sample> samples_of(const PatchKind& kind, const QuadratureRule& rule) {
  if (kind.regular()) return tensor_rule(rule.regular_points);
  return kind.at_extraordinary() ? graded_rule(rule.cap_points, rule.grading) : tensor_rule(rule.cap_points);
}

std::shared_ptr<const BasisTable> shared_basis_table(const PatchKind& kind, const QuadratureRule& rule) {
  static SharedCache<std::pair<PatchKind, QuadratureRule>, BasisTable> tables(kSharedTableBytes);
  return tables.get({kind, rule}, [&] { return basis_table(kind, samples_of(kind, rule), 0, kDerivativeCount); });
}

void pad_samples(std::vector<Sample>& samples, int lanes) {
  while (samples.size() % lanes != 0) {
    samples.push_back(samples.back());
    samples.back().weight = 0;
  }
}

}  // namespace umbilic
