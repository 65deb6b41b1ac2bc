// SPDX-License-Identifier: MIT
/// \file
/// Passes tables and jets to the kernel. Those of flat caps are first rotated so that the fixed normal is the third
/// axis.
#include "energy/energy_hessian.h"

#include <algorithm>
#include <cstddef>

#include "energy/energy_kernels.h"

namespace umbilic {
namespace {

static_assert(BasisTable::kColumnMultiple % HessianPatch::kColumnMultiple == 0);

/// A rotation or reflection whose last row is n.
Eigen::Matrix3d turn_to_axis(const Vector3& n) {
  Eigen::Matrix3d turn;
  const Vector3 first = n.unitOrthogonal();
  turn << first.transpose(), n.cross(first).transpose(), n.transpose();
  return turn;
}

/// Rotates the coordinates of a block back: turn^T block turn for each pair of points.
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
    : patches_(layout, [&](const PatchKind& kind) { return PatchBasis(shared_basis_table(kind, rule, 1)); }),
      weights_(weights) {
  integrand_.umbilic_eta = umbilic_eta;
}

void EnergyHessian::move_to(const Points& control, const EnergyValue& value, double parametrization) {
  patches_.move_to(control);
  for (int f = 0; f < kFunctionalCount; ++f) {
    integrand_.weights[f] = weights_[f] * area_to_the(area_power(f), value.area_factor);
  }
  integrand_.weights[kParametrization] = parametrization;
  integrand_.third_order = third_order(weights_);
  integrand_.area_slope = value.area_slope;
}

void EnergyHessian::patch(int set, int patch, HessianMemory& memory, std::vector<double>& block) const {
  const BasisTable& table = patches_.basis(set).table();
  const int derivatives = integrand_.third_order ? kThirdOrderCount : kSecondOrderCount;
  const double* jets = patches_.jets({set, patch, 1}, derivatives, memory.patches);
  const bool flat = patches_.layout().sets()[set].kind.shape == CapShape::kFlat;
  Eigen::Matrix3d turn;
  if (flat) {
    turn = turn_to_axis(patches_.normal(set, patch));
    memory.turned = Eigen::Map<const decltype(memory.turned)>(jets, derivatives * table.samples, 3) * turn.transpose();
    jets = memory.turned.data();
  }
  const auto columns = static_cast<std::size_t>(table.padded_columns);
  memory.scratch.resize(std::max<std::size_t>(memory.scratch.size(), HessianPatch::scratch(table.padded_columns)));
  block.resize(std::max(block.size(), 9 * columns * columns));
  const double* basis = table.basis.data();
  const HessianPatch input{
      table.samples, table.padded_columns, table.weights.data(), jets, {basis, basis, table.along_normal().data()},
      table.stride};
  energy_kernels().patch_hessian(input, integrand_, memory.scratch.data(), block.data());
  if (flat) turn_back(turn, table.padded_columns, block);
}

}  // namespace umbilic
