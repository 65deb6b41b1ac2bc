// SPDX-License-Identifier: MIT
/// \file
/// Prepares tables and jets for the kernel; turns flat caps so that the frozen normal is the third axis.
#include "energy/energy_hessian.h"

#include <algorithm>

#include "energy/energy_kernels.h"

namespace umbilic {
namespace {

static_assert(kColumnMultiple % HessianPatch::kColumnMultiple == 0);

/// Orthogonal, with last row n.
Eigen::Matrix3d turn_to_axis(const Vector3& n) {
  Eigen::Matrix3d turn;
  const Vector3 first = n.unitOrthogonal();
  turn << first.transpose(), n.cross(first).transpose(), n.transpose();
  return turn;
}

/// Rows and columns of the coordinates turned back: block = turn^T block turn over the coordinates.
void turn_back(const Eigen::Matrix3d& turn, int columns, std::vector<double>& block) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor> lower(block.data(), 3 * columns, 3 * columns);
  const RowMajor full = lower.selfadjointView<Eigen::Lower>();
  lower.setZero();
  for (int c = 0; c < 3; ++c) {
    for (int e = 0; e <= c; ++e) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          lower.block(c * columns, e * columns, columns, columns) +=
              turn(a, c) * turn(b, e) * full.block(a * columns, b * columns, columns, columns);
        }
      }
    }
  }
}

}  // namespace

EnergyHessian::EnergyHessian(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights,
                             double umbilic_eta)
    : layout_(layout), weights_(weights) {
  integrand_.umbilic_eta = umbilic_eta;
  int widest = 0;
  for (const PatchSet& set : layout.sets()) {
    Kind kind{kernel_table(set.kind, rule), {}};
    if (set.kind.shape == CapShape::kFlat) {
      kind.normal_part = kind.table->basis;
      for (std::size_t i = 0; i < kind.normal_part.size(); ++i) kind.normal_part[i] -= kind.table->flattening[i];
    }
    widest = std::max(widest, kind.table->columns);
    kinds_.push_back(std::move(kind));
  }
  scratch_.resize(HessianPatch::scratch(widest));
  block_.resize(static_cast<std::size_t>(9) * widest * widest);
}

void EnergyHessian::move_to(const Points& control, const EnergyValue& value) {
  points_ = layout_.extend(control);
  frames_ = flat_frames(layout_, points_);
  for (int f = 0; f < kFunctionalCount; ++f) {
    integrand_.weights[f] = weights_[f] * (is_third_order(f) ? value.area : 1);
  }
  integrand_.third_order = third_order(weights_);
  integrand_.area_factor = integrand_.third_order ? value.third : 0;
}

const double* EnergyHessian::patch(int set, int patch) {
  const PatchSet& patches = layout_.sets()[set];
  const Kind& kind = kinds_[set];
  const KernelTable& table = *kind.table;
  const bool flat = patches.kind.shape == CapShape::kFlat;
  const Eigen::Matrix3d turn = flat ? turn_to_axis(frames_[patches.caps[patch]].normal) : Eigen::Matrix3d::Identity();
  local_.resize(patches.columns, 3);
  for (int i = 0; i < patches.columns; ++i) {
    local_.row(i) = points_.row(patches.points[static_cast<std::size_t>(patches.columns) * patch + i]);
  }
  if (flat) local_ = (local_ * turn.transpose()).eval();
  const int rows = (integrand_.third_order ? kThirdOrderCount : kSecondOrderCount) * table.samples;
  jets_.resize(static_cast<std::size_t>(3) * rows);
  const SurfaceKernels& kernels = surface_kernels();
  kernels.dense_product({table.basis.data(), table.stride, patches.columns}, rows, local_.data(), 3, jets_.data());
  if (flat) {
    const Eigen::VectorXd heights = local_.col(2);
    kernels.dense_product({kind.normal_part.data(), table.stride, patches.columns}, rows, heights.data(), 1,
                          jets_.data() + 2 * rows);
  }

  const double* basis = table.basis.data();
  const HessianPatch input{table.samples,
                           table.columns,
                           table.weights.data(),
                           jets_.data(),
                           {basis, basis, flat ? kind.normal_part.data() : basis},
                           table.stride};
  energy_kernels().patch_hessian(input, integrand_, scratch_.data(), block_.data());
  if (flat) turn_back(turn, table.columns, block_);
  return block_.data();
}

}  // namespace umbilic
