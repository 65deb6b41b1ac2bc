// SPDX-License-Identifier: MIT
/// \file
/// Evaluates regular patches by sum factorization and capped ones by products with their kind's table.
#include "surface/jets.h"

#include <algorithm>
#include <cassert>

#include "base/lanes.h"
#include "surface/flat_frame.h"
#include "surface/regular_kernel.h"
#include "surface/surface_kernels.h"

namespace umbilic {
namespace {

/// Patches per block: two for the matrix product's tiles, and few enough samples that jets and adjoints stay in the
/// cache.
constexpr int kBlockSamples = 256;

int block_patches(int samples) { return std::max(2, kBlockSamples / samples); }

using MatrixMap = Eigen::Map<Eigen::MatrixXd>;

}  // namespace

struct JetEvaluator::Group {
  const PatchSet& set;
  std::unique_ptr<RegularKernel> regular;  // for regular faces
  BasisTable table;                        // for the others
  int samples;
  const double* weights;

  Group(const PatchSet& patches, const QuadratureRule& rule) : set(patches) {
    if (set.kind.regular()) {
      regular = std::make_unique<RegularKernel>(rule.regular_points);
      samples = regular->samples();
      weights = regular->weights().data();
      return;
    }
    std::vector<Sample> points =
        set.kind.at_extraordinary() ? graded_rule(rule.cap_points, rule.grading) : tensor_rule(rule.cap_points);
    pad_samples(points, kSampleMultiple);
    table = basis_table(set.kind, points, 1, kDerivativeCount);
    samples = table.samples;
    weights = table.weights.data();
  }

  bool flat() const { return set.kind.shape == CapShape::kFlat; }
};

JetEvaluator::JetEvaluator(const PatchLayout& layout, const QuadratureRule& rule) : layout_(layout) {
  for (const PatchSet& set : layout.sets()) groups_.push_back(std::make_unique<Group>(set, rule));
}

JetEvaluator::~JetEvaluator() = default;

long JetEvaluator::sample_count() const {
  long count = 0;
  for (const auto& group : groups_) {
    const Eigen::Map<const Eigen::VectorXd> weights(group->weights, group->samples);
    count += static_cast<long>((weights.array() > 0).count()) * group->set.count();
  }
  return count;
}

std::size_t JetEvaluator::table_bytes() const {
  std::size_t bytes = 0;
  for (const auto& group : groups_) bytes += group->regular ? group->regular->bytes() : group->table.bytes();
  return bytes;
}

namespace {

/// One evaluation's working memory and steps.
class Pass {
 public:
  Pass(const PatchLayout& layout, const Points& control, int derivatives, const std::vector<AdjointChannel>& channels)
      : layout_(layout),
        points_(layout.extend(control)),
        derivatives_(derivatives),
        channels_(channels),
        gradients_(channels.size(), Points::Zero(layout.point_count(), 3)),
        frames_(flat_frames(layout, points_)),
        adjoint_storage_(channels.size()),
        adjoints_(channels.size()) {
    normal_adjoints_.assign(channels.size(), std::vector<Vector3>(frames_.size(), Vector3::Zero()));
  }

  void run(const JetEvaluator::Group& group, const JetVisitor& visit) {
    const int step = block_patches(group.samples);
    reserve(group, step);
    for (int begin = 0; begin < group.set.count(); begin += step) {
      const int patches = std::min(step, group.set.count() - begin);
      group.regular ? regular_jets(group, begin, patches) : capped_jets(group, begin, patches);
      visit({patches, group.samples, derivatives_, group.weights, group.set.multiplicities.data() + begin, jets_.data(),
             channels_.empty() ? nullptr : adjoints_.data()});
      for (int channel = 0; channel < static_cast<int>(channels_.size()); ++channel) {
        group.regular ? pull_back_regular(group, begin, patches, channel)
                      : pull_back_capped(group, begin, patches, channel);
      }
    }
  }

  std::vector<Points> finish() {
    for (int channel = 0; channel < static_cast<int>(channels_.size()); ++channel) {
      for (int c = 0; c < static_cast<int>(frames_.size()); ++c) {
        pull_back_frame(layout_.caps()[c], frames_[c], normal_adjoints_[channel][c], gradients_[channel]);
      }
      layout_.pull_back(gradients_[channel]);
    }
    return std::move(gradients_);
  }

 private:
  void reserve(const JetEvaluator::Group& group, int patches) {
    const auto grow = [](std::vector<double>& storage, std::size_t size) {
      if (storage.size() < size) storage.resize(size);
    };
    const std::size_t samples = static_cast<std::size_t>(3) * patches * group.samples;
    grow(jets_, samples * derivatives_);
    grow(local_, static_cast<std::size_t>(3) * patches * group.set.columns);
    grow(local_gradient_, local_.size());
    if (group.flat()) {
      grow(offsets_, samples * derivatives_);
      grow(flattened_, samples * kThirdOrderCount);
    }
    for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
      grow(adjoint_storage_[channel], samples * channels_[channel].derivatives);
      adjoints_[channel] = adjoint_storage_[channel].data();
    }
  }

  void regular_jets(const JetEvaluator::Group& group, int begin, int patches) {
    const std::size_t stride = static_cast<std::size_t>(3) * derivatives_ * group.samples;
    for (int p = 0; p < patches; ++p) {
      const int* index = &group.set.points[16 * (begin + p)];
      double local[48];
      for (int i = 0; i < 16; ++i) std::copy_n(points_.data() + 3 * index[i], 3, local + 3 * i);
      group.regular->jets(local, derivatives_, jets_.data() + p * stride);
    }
  }

  void pull_back_regular(const JetEvaluator::Group& group, int begin, int patches, int channel) {
    const int derivatives = channels_[channel].derivatives;
    const std::size_t stride = static_cast<std::size_t>(3) * derivatives * group.samples;
    for (int p = 0; p < patches; ++p) {
      double local[48] = {};
      group.regular->pull_back(adjoints_[channel] + p * stride, derivatives, local);
      const int* index = &group.set.points[16 * (begin + p)];
      double* gradient = gradients_[channel].data();
      for (int i = 0; i < 16; ++i) {
        for (int c = 0; c < 3; ++c) gradient[3 * index[i] + c] += local[3 * i + c];
      }
    }
  }

  /// Local points of the block, columns x (3 patches).
  const double* gather(const JetEvaluator::Group& group, int begin, int patches) {
    const int columns = group.set.columns;
    double* local = local_.data();
    for (int p = 0; p < patches; ++p) {
      const int* index = &group.set.points[static_cast<std::size_t>(columns) * (begin + p)];
      for (int i = 0; i < columns; ++i) std::copy_n(points_.data() + 3 * index[i], 3, local + 3 * (patches * i + p));
    }
    return local;
  }

  void capped_jets(const JetEvaluator::Group& group, int begin, int patches) {
    const double* local = gather(group, begin, patches);
    const BasisTable& table = group.table;
    const int rows = derivatives_ * group.samples, stride = static_cast<int>(table.basis.rows());
    kernels_.dense_product(table.basis.data(), stride, rows, table.columns, local, patches, jets_.data());
    if (!group.flat()) return;
    kernels_.dense_product(table.flattening.data(), stride, rows, table.columns, local, patches, offsets_.data());
    MatrixMap jets(jets_.data(), rows, 3 * patches);
    const MatrixMap offsets(offsets_.data(), rows, 3 * patches);
    for (int p = 0; p < patches; ++p) {
      const Vector3& normal = frames_[group.set.caps[begin + p]].normal;
      jets.middleCols<3>(3 * p) -= (offsets.middleCols<3>(3 * p) * normal) * normal.transpose();
    }
  }

  void pull_back_capped(const JetEvaluator::Group& group, int begin, int patches, int channel) {
    const BasisTable& table = group.table;
    const int rows = channels_[channel].derivatives * group.samples, stride = static_cast<int>(table.basis.rows());
    double* local = local_gradient_.data();
    kernels_.dense_transposed_product(table.basis.data(), stride, rows, table.columns, adjoints_[channel], patches,
                                      local);
    scatter(group, begin, patches, 1, gradients_[channel]);
    if (!group.flat()) return;
    const MatrixMap adjoint(adjoints_[channel], rows, 3 * patches);
    const MatrixMap offsets(offsets_.data(), derivatives_ * group.samples, 3 * patches);
    MatrixMap flattened(flattened_.data(), rows, 3 * patches);
    for (int p = 0; p < patches; ++p) {
      const int cap = group.set.caps[begin + p];
      const Vector3& normal = frames_[cap].normal;
      const auto jet_adjoint = adjoint.middleCols<3>(3 * p);
      const auto offset = offsets.topRows(rows).middleCols<3>(3 * p);
      const Eigen::VectorXd along = jet_adjoint * normal;
      flattened.middleCols<3>(3 * p).noalias() = along * normal.transpose();
      normal_adjoints_[channel][cap] -= jet_adjoint.transpose() * (offset * normal) + offset.transpose() * along;
    }
    kernels_.dense_transposed_product(table.flattening.data(), stride, rows, table.columns, flattened_.data(), patches,
                                      local);
    scatter(group, begin, patches, -1, gradients_[channel]);
  }

  /// Adds `factor` times the block's local gradient.
  void scatter(const JetEvaluator::Group& group, int begin, int patches, double factor, Points& gradient) const {
    const int columns = group.set.columns;
    for (int p = 0; p < patches; ++p) {
      const int* index = &group.set.points[static_cast<std::size_t>(columns) * (begin + p)];
      for (int i = 0; i < columns; ++i) {
        const double* local = local_gradient_.data() + 3 * (patches * i + p);
        for (int c = 0; c < 3; ++c) gradient(index[i], c) += factor * local[c];
      }
    }
  }

  const SurfaceKernels& kernels_ = surface_kernels();
  const PatchLayout& layout_;
  Points points_;
  int derivatives_;
  const std::vector<AdjointChannel>& channels_;
  std::vector<Points> gradients_;
  std::vector<FlatFrame> frames_;
  std::vector<std::vector<Vector3>> normal_adjoints_;
  std::vector<std::vector<double>> adjoint_storage_;
  std::vector<double*> adjoints_;
  std::vector<double> jets_, offsets_, flattened_, local_, local_gradient_;
};

}  // namespace

void JetEvaluator::evaluate(const Points& control, int derivatives, const std::vector<AdjointChannel>& channels,
                            const JetVisitor& visit, std::vector<Points>& gradients) const {
  assert(derivatives == kSecondOrderCount || derivatives == kThirdOrderCount);
  Pass pass(layout_, control, derivatives, channels);
  for (const auto& group : groups_) pass.run(*group, visit);
  gradients = pass.finish();
}

}  // namespace umbilic
