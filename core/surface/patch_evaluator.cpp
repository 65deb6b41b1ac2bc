// SPDX-License-Identifier: MIT
/// \file
/// Regular patches by sum factorization or a table, patches of caps by products with their kind's table.
///
/// A flat cap's jets are W P - h n^T with the heights h = F P n, F the flattening. With A the jets' adjoint, a = A n
/// and t = F^T a, the adjoint of P is W^T A - t n^T, and that of n is -(A^T h + P^T t).
#include "surface/patch_evaluator.h"

#include <algorithm>
#include <cassert>

namespace umbilic {
namespace {

/// Samples in a range: few enough that jets and adjoints stay in the cache, but at least two patches, to fill the tiles
/// of the dense product.
constexpr int kSamplesAtATime = 256;

}  // namespace

PatchEvaluator::PatchEvaluator(const PatchLayout& layout, const BasisOf& basis_of) : layout_(layout) {
  for (const PatchSet& patches : layout.sets()) {
    bases_.push_back(basis_of(patches.kind));
    const int number = set_count() - 1, step = std::max(2, kSamplesAtATime / bases_.back().samples());
    for (int first = 0; first < patches.count(); first += step) {
      ranges_.push_back({number, first, std::min(step, patches.count() - first)});
    }
  }
}

void PatchEvaluator::move_to(const Points& control) {
  layout_.extend(control, points_);
  flat_frames(layout_, points_, frames_);
}

const double* PatchEvaluator::jets(PatchRange range, int derivatives, PatchMemory& memory, int from) const {
  memory.range = range;
  memory.derivatives = derivatives;
  memory.from = from;
  const PatchBasis& basis = bases_[range.set];
  const int rows = derivatives * basis.samples();
  double* jets = reserve(memory.jets, static_cast<std::size_t>(3) * rows * range.count);
  if (basis.regular()) {
    assert(from == 1);
    regular_jets(memory);
  } else {
    gather(memory);
    const DenseTable table = basis.table().from(from, basis.table().basis);
    surface_kernels().dense_product(table, rows, memory.local.data(), 3 * range.count, jets);
    if (flat(range)) flatten(memory);
  }
  return jets;
}

void PatchEvaluator::pull_back(const double* adjoint, int derivatives, PatchMemory& memory,
                               RangeAdjoint& result) const {
  assert(memory.from == 1 && derivatives <= memory.derivatives);
  const PatchRange range = memory.range;
  if (bases_[range.set].regular()) return pull_back_regular(adjoint, derivatives, memory, result);
  const BasisTable& table = bases_[range.set].table();
  double* points = reserve(result.points, static_cast<std::size_t>(3) * table.columns * range.count);
  surface_kernels().dense_transposed_product(table.from(1, table.basis), derivatives * table.samples, adjoint,
                                             3 * range.count, points);
  if (flat(range)) pull_back_flattening(adjoint, derivatives, memory, result);
}

void PatchEvaluator::clear(PatchAdjoint& sum) const {
  sum.points.setZero(layout_.point_count(), 3);
  sum.normals.assign(frames_.size(), Vector3::Zero());
}

void PatchEvaluator::add(PatchRange range, const RangeAdjoint& adjoint, PatchAdjoint& sum) const {
  const PatchSet& patches = set(range);
  const bool by_patch = bases_[range.set].regular() != nullptr;
  const int next_patch = by_patch ? patches.columns : 1, next_point = by_patch ? 1 : range.count;
  for (int p = 0; p < range.count; ++p) {
    const int* index = patches.points_of(range.first + p);
    for (int i = 0; i < patches.columns; ++i) {
      const double* local = adjoint.points.data() + static_cast<std::size_t>(3) * (next_patch * p + next_point * i);
      for (int c = 0; c < 3; ++c) sum.points(index[i], c) += local[c];
    }
    if (flat(range)) sum.normals[patches.caps[range.first + p]] += adjoint.normals[p];
  }
}

void PatchEvaluator::finish(PatchAdjoint& sum, Points& gradient) const {
  for (std::size_t c = 0; c < frames_.size(); ++c) {
    pull_back_frame(layout_.caps()[c], frames_[c], sum.normals[c], sum.points);
  }
  layout_.pull_back(sum.points);
  gradient = sum.points.topRows(layout_.control_count());
}

void PatchEvaluator::regular_jets(PatchMemory& memory) const {
  const PatchRange range = memory.range;
  const RegularKernel& kernel = *bases_[range.set].regular();
  const std::size_t stride = static_cast<std::size_t>(3) * memory.derivatives * kernel.samples();
  double* scratch = reserve(memory.scratch, kernel.scratch_size());
  for (int p = 0; p < range.count; ++p) {
    const int* index = set(range).points_of(range.first + p);
    double local[48];
    for (int i = 0; i < 16; ++i) {
      for (int c = 0; c < 3; ++c) local[3 * i + c] = points_(index[i], c);
    }
    kernel.jets(local, memory.derivatives, memory.jets.data() + p * stride, scratch);
  }
}

/// The points' adjoints are those of one patch after the other, [p][i][c].
void PatchEvaluator::pull_back_regular(const double* adjoint, int derivatives, PatchMemory& memory,
                                       RangeAdjoint& result) const {
  const PatchRange range = memory.range;
  const RegularKernel& kernel = *bases_[range.set].regular();
  const std::size_t stride = static_cast<std::size_t>(3) * derivatives * kernel.samples();
  double* points = reserve(result.points, static_cast<std::size_t>(48) * range.count);
  double* scratch = reserve(memory.scratch, kernel.scratch_size());
  std::fill_n(points, 48 * range.count, 0.0);
  for (int p = 0; p < range.count; ++p) kernel.pull_back(adjoint + p * stride, derivatives, points + 48 * p, scratch);
}

/// The points of all patches, [i][p][c], as a table's product needs them and its transpose leaves them.
void PatchEvaluator::gather(PatchMemory& memory) const {
  const PatchRange range = memory.range;
  const int columns = set(range).columns, count = range.count;
  reserve(memory.local, static_cast<std::size_t>(3) * columns * count);
  for (int p = 0; p < count; ++p) {
    const int* index = set(range).points_of(range.first + p);
    for (int i = 0; i < columns; ++i) {
      double* local = memory.local.data() + 3 * (count * i + p);
      for (int c = 0; c < 3; ++c) local[c] = points_(index[i], c);
    }
  }
}

void PatchEvaluator::flatten(PatchMemory& memory) const {
  const PatchRange range = memory.range;
  const BasisTable& table = bases_[range.set].table();
  const int rows = memory.derivatives * table.samples, columns = table.columns, count = range.count;
  double* along = reserve(memory.along_normal, static_cast<std::size_t>(columns) * count);
  double* all_heights = reserve(memory.heights, static_cast<std::size_t>(rows) * count);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = normal_at(range, p);
    for (int i = 0; i < columns; ++i) {
      const double* local = memory.local.data() + 3 * (count * i + p);
      along[count * i + p] = local[0] * n[0] + local[1] * n[1] + local[2] * n[2];
    }
  }
  const DenseTable flattening = table.from(memory.from, table.flattening);
  surface_kernels().dense_product(flattening, rows, along, count, all_heights);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = normal_at(range, p);
    const double* heights = all_heights + static_cast<std::size_t>(p) * rows;
    for (int c = 0; c < 3; ++c) {
      double* jets = memory.jets.data() + static_cast<std::size_t>(3 * p + c) * rows;
      for (int row = 0; row < rows; ++row) jets[row] -= heights[row] * n[c];
    }
  }
}

void PatchEvaluator::pull_back_flattening(const double* adjoints, int derivatives, PatchMemory& memory,
                                          RangeAdjoint& result) const {
  const PatchRange range = memory.range;
  const BasisTable& table = bases_[range.set].table();
  const int rows = derivatives * table.samples, columns = table.columns, count = range.count;
  reserve(memory.along, static_cast<std::size_t>(rows) * count);
  result.normals.resize(count);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = normal_at(range, p);
    const double* adjoint = adjoints + static_cast<std::size_t>(3 * p) * rows;
    const double* heights = memory.heights.data() + static_cast<std::size_t>(p) * memory.derivatives * table.samples;
    double* along = memory.along.data() + static_cast<std::size_t>(p) * rows;
    double sums[3] = {};
    for (int row = 0; row < rows; ++row) {
      const double a[3] = {adjoint[row], adjoint[rows + row], adjoint[2 * rows + row]};
      along[row] = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
      for (int c = 0; c < 3; ++c) sums[c] += a[c] * heights[row];
    }
    result.normals[p] = -Vector3(sums[0], sums[1], sums[2]);
  }
  double* t = memory.along_normal.data();
  surface_kernels().dense_transposed_product(table.from(1, table.flattening), rows, memory.along.data(), count, t);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = normal_at(range, p);
    for (int i = 0; i < columns; ++i) {
      const int at = count * i + p;
      for (int c = 0; c < 3; ++c) {
        result.points[3 * at + c] -= t[at] * n[c];
        result.normals[p][c] -= t[at] * memory.local[3 * at + c];
      }
    }
  }
}

}  // namespace umbilic
