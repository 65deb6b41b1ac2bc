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
  for (const PatchSet& set : layout.sets()) bases_.push_back(basis_of(set.kind));
}

int PatchEvaluator::patches_at_a_time(int set) const { return std::max(2, kSamplesAtATime / bases_[set].samples()); }

void PatchEvaluator::move_to(const Points& control) {
  kernels_ = &surface_kernels();
  layout_.extend(control, points_);
  flat_frames(layout_, points_, frames_);
}

const double* PatchEvaluator::jets(PatchRange range, int derivatives, int from) {
  range_ = range;
  derivatives_ = derivatives;
  from_ = from;
  const PatchBasis& basis = bases_[range.set];
  const int rows = derivatives * basis.samples();
  double* jets = reserve(jets_, static_cast<std::size_t>(3) * rows * range.count);
  if (basis.regular()) {
    assert(from == 1);
    regular_jets();
  } else {
    gather();
    const DenseTable table = basis.table().from(from, basis.table().basis);
    kernels_->dense_product(table, rows, local_.data(), 3 * range.count, jets);
    if (flat()) flatten();
  }
  return jets;
}

void PatchEvaluator::clear(PatchAdjoint& sum) const {
  sum.points.setZero(layout_.point_count(), 3);
  sum.normals.assign(frames_.size(), Vector3::Zero());
}

void PatchEvaluator::pull_back(const double* adjoint, int derivatives, PatchAdjoint& sum) {
  assert(from_ == 1 && derivatives <= derivatives_);
  if (bases_[range_.set].regular()) {
    pull_back_regular(adjoint, derivatives, sum.points);
  } else {
    pull_back_table(adjoint, derivatives, sum);
  }
}

void PatchEvaluator::finish(PatchAdjoint& sum, Points& gradient) const {
  for (std::size_t c = 0; c < frames_.size(); ++c) {
    pull_back_frame(layout_.caps()[c], frames_[c], sum.normals[c], sum.points);
  }
  layout_.pull_back(sum.points);
  gradient = sum.points.topRows(layout_.control_count());
}

void PatchEvaluator::regular_jets() {
  const RegularKernel& kernel = *bases_[range_.set].regular();
  const std::size_t stride = static_cast<std::size_t>(3) * derivatives_ * kernel.samples();
  for (int p = 0; p < range_.count; ++p) {
    const int* index = set().points_of(range_.first + p);
    double local[48];
    for (int i = 0; i < 16; ++i) {
      for (int c = 0; c < 3; ++c) local[3 * i + c] = points_(index[i], c);
    }
    kernel.jets(local, derivatives_, jets_.data() + p * stride);
  }
}

void PatchEvaluator::pull_back_regular(const double* adjoint, int derivatives, Points& gradient) {
  const RegularKernel& kernel = *bases_[range_.set].regular();
  const std::size_t stride = static_cast<std::size_t>(3) * derivatives * kernel.samples();
  for (int p = 0; p < range_.count; ++p) {
    double local[48] = {};
    kernel.pull_back(adjoint + p * stride, derivatives, local);
    const int* index = set().points_of(range_.first + p);
    for (int i = 0; i < 16; ++i) {
      for (int c = 0; c < 3; ++c) gradient(index[i], c) += local[3 * i + c];
    }
  }
}

void PatchEvaluator::gather() {
  const int columns = set().columns, count = range_.count;
  reserve(local_, static_cast<std::size_t>(3) * columns * count);
  for (int p = 0; p < count; ++p) {
    const int* index = set().points_of(range_.first + p);
    for (int i = 0; i < columns; ++i) {
      double* local = local_.data() + 3 * (count * i + p);
      for (int c = 0; c < 3; ++c) local[c] = points_(index[i], c);
    }
  }
}

void PatchEvaluator::pull_back_table(const double* adjoint, int derivatives, PatchAdjoint& sum) {
  const BasisTable& table = bases_[range_.set].table();
  const int rows = derivatives * table.samples, columns = table.columns, count = range_.count;
  double* local = reserve(local_gradient_, static_cast<std::size_t>(3) * columns * count);
  kernels_->dense_transposed_product(table.from(1, table.basis), rows, adjoint, 3 * count, local);
  if (flat()) pull_back_flattening(adjoint, derivatives, sum.normals);
  for (int p = 0; p < count; ++p) {
    const int* index = set().points_of(range_.first + p);
    for (int i = 0; i < columns; ++i) {
      for (int c = 0; c < 3; ++c) sum.points(index[i], c) += local[3 * (count * i + p) + c];
    }
  }
}

void PatchEvaluator::flatten() {
  const BasisTable& table = bases_[range_.set].table();
  const int rows = derivatives_ * table.samples, columns = table.columns, count = range_.count;
  reserve(along_normal_, static_cast<std::size_t>(columns) * count);
  reserve(heights_, static_cast<std::size_t>(rows) * count);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = frames_[cap(p)].normal;
    for (int i = 0; i < columns; ++i) {
      const double* local = local_.data() + 3 * (count * i + p);
      along_normal_[count * i + p] = local[0] * n[0] + local[1] * n[1] + local[2] * n[2];
    }
  }
  const DenseTable flattening = table.from(from_, table.flattening);
  kernels_->dense_product(flattening, rows, along_normal_.data(), count, heights_.data());
  for (int p = 0; p < count; ++p) {
    const Vector3& n = frames_[cap(p)].normal;
    const double* heights = heights_.data() + static_cast<std::size_t>(p) * rows;
    for (int c = 0; c < 3; ++c) {
      double* jets = jets_.data() + static_cast<std::size_t>(3 * p + c) * rows;
      for (int row = 0; row < rows; ++row) jets[row] -= heights[row] * n[c];
    }
  }
}

void PatchEvaluator::pull_back_flattening(const double* adjoints, int derivatives, std::vector<Vector3>& normals) {
  const BasisTable& table = bases_[range_.set].table();
  const int rows = derivatives * table.samples, columns = table.columns, count = range_.count;
  reserve(along_, static_cast<std::size_t>(rows) * count);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = frames_[cap(p)].normal;
    const double* adjoint = adjoints + static_cast<std::size_t>(3 * p) * rows;
    const double* heights = heights_.data() + static_cast<std::size_t>(p) * derivatives_ * table.samples;
    double* along = along_.data() + static_cast<std::size_t>(p) * rows;
    double sums[3] = {};
    for (int row = 0; row < rows; ++row) {
      const double a[3] = {adjoint[row], adjoint[rows + row], adjoint[2 * rows + row]};
      along[row] = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
      for (int c = 0; c < 3; ++c) sums[c] += a[c] * heights[row];
    }
    for (int c = 0; c < 3; ++c) normals[cap(p)][c] -= sums[c];
  }
  double* t = along_normal_.data();
  kernels_->dense_transposed_product(table.from(1, table.flattening), rows, along_.data(), count, t);
  for (int p = 0; p < count; ++p) {
    const Vector3& n = frames_[cap(p)].normal;
    for (int i = 0; i < columns; ++i) {
      const int at = count * i + p;
      for (int c = 0; c < 3; ++c) {
        local_gradient_[3 * at + c] -= t[at] * n[c];
        normals[cap(p)][c] -= t[at] * local_[3 * at + c];
      }
    }
  }
}

}  // namespace umbilic
