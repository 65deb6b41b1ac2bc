// SPDX-License-Identifier: MIT
/// \file
/// Regular patches by sum factorization, capped ones by products with their kind's table.
///
/// A flat cap's jets are W P - h n^T with the heights h = F P n, F the flattening. With A the jets' adjoint, a = A n
/// and t = F^T a, the adjoint of P is W^T A - t n^T, and that of n is -(A^T h + P^T t).
#include "surface/jet_pass.h"

#include <algorithm>

namespace umbilic {
namespace {

/// Samples of a block: few enough that jets and adjoints stay in the cache, but at least two patches for the dense
/// product's tiles.
constexpr int kBlockSamples = 256;

int block_patches(int samples) { return std::max(2, kBlockSamples / samples); }

}  // namespace

const int* JetPass::Block::points(int patch) const {
  return &group.set().points[static_cast<std::size_t>(group.set().columns) * (begin + patch)];
}

const double* JetPass::Block::normal(const JetPass& pass, int patch) const {
  return pass.frames_[cap(patch)].normal.data();
}

void JetPass::begin(const Points& control, int derivatives, std::span<const AdjointChannel> channels) {
  kernels_ = &surface_kernels();
  derivatives_ = derivatives;
  layout_.extend(control, points_);
  flat_frames(layout_, points_, frames_);
  channel_count_ = channels.size();
  if (channels_.size() < channel_count_) channels_.resize(channel_count_);
  adjoints_.resize(channel_count_);
  for (std::size_t i = 0; i < channel_count_; ++i) {
    channels_[i].derivatives = channels[i].derivatives;
    channels_[i].gradient.setZero(layout_.point_count(), 3);
    channels_[i].normal_adjoints.assign(frames_.size(), Vector3::Zero());
  }
}

void JetPass::run(const JetGroup& group, const JetVisitor& visit) {
  const bool regular = group.set().kind.regular();
  const int step = block_patches(group.samples());
  reserve_for(group, step);
  for (int begin = 0; begin < group.set().count(); begin += step) {
    const Block block{group, begin, std::min(step, group.set().count() - begin)};
    regular ? regular_jets(block) : capped_jets(block);
    visit({block.patches, group.samples(), derivatives_, group.weights(), group.set().multiplicities.data() + begin,
           jets_.data(), channel_count_ == 0 ? nullptr : adjoints_.data()});
    for (std::size_t i = 0; i < channel_count_; ++i) {
      regular ? pull_back_regular(block, channels_[i]) : pull_back_capped(block, channels_[i]);
    }
  }
}

void JetPass::finish(std::vector<Points>& gradients) {
  gradients.resize(channel_count_);
  for (std::size_t i = 0; i < channel_count_; ++i) {
    Channel& channel = channels_[i];
    for (std::size_t c = 0; c < frames_.size(); ++c) {
      pull_back_frame(layout_.caps()[c], frames_[c], channel.normal_adjoints[c], channel.gradient);
    }
    layout_.pull_back(channel.gradient);
    gradients[i] = channel.gradient.topRows(layout_.control_count());
  }
}

void JetPass::reserve_for(const JetGroup& group, int patches) {
  const std::size_t samples = static_cast<std::size_t>(patches) * group.samples();
  const std::size_t columns = static_cast<std::size_t>(patches) * group.set().columns;
  reserve(jets_, 3 * samples * derivatives_);
  reserve(local_, 3 * columns);
  reserve(local_gradient_, 3 * columns);
  if (group.flat()) {
    reserve(along_normal_, columns);
    reserve(heights_, samples * derivatives_);
    reserve(along_, samples * kThirdOrderCount);
  }
  for (std::size_t i = 0; i < channel_count_; ++i) {
    adjoints_[i] = reserve(channels_[i].adjoint, 3 * samples * channels_[i].derivatives);
  }
}

void JetPass::regular_jets(const Block& block) {
  const std::size_t stride = static_cast<std::size_t>(3) * derivatives_ * block.group.samples();
  for (int p = 0; p < block.patches; ++p) {
    const int* index = block.points(p);
    double local[48];
    for (int i = 0; i < 16; ++i) {
      for (int c = 0; c < 3; ++c) local[3 * i + c] = points_(index[i], c);
    }
    block.group.regular().jets(local, derivatives_, jets_.data() + p * stride);
  }
}

void JetPass::pull_back_regular(const Block& block, Channel& channel) {
  const std::size_t stride = static_cast<std::size_t>(3) * channel.derivatives * block.group.samples();
  for (int p = 0; p < block.patches; ++p) {
    double local[48] = {};
    block.group.regular().pull_back(channel.adjoint.data() + p * stride, channel.derivatives, local);
    const int* index = block.points(p);
    for (int i = 0; i < 16; ++i) {
      for (int c = 0; c < 3; ++c) channel.gradient(index[i], c) += local[3 * i + c];
    }
  }
}

void JetPass::gather(const Block& block) {
  for (int p = 0; p < block.patches; ++p) {
    const int* index = block.points(p);
    for (int i = 0; i < block.group.set().columns; ++i) {
      double* local = local_.data() + 3 * (block.patches * i + p);
      for (int c = 0; c < 3; ++c) local[c] = points_(index[i], c);
    }
  }
}

void JetPass::capped_jets(const Block& block) {
  gather(block);
  const int rows = derivatives_ * block.group.samples();
  kernels_->dense_product(block.group.basis(), rows, local_.data(), 3 * block.patches, jets_.data());
  if (block.group.flat()) flatten(block);
}

void JetPass::pull_back_capped(const Block& block, Channel& channel) {
  const int rows = channel.derivatives * block.group.samples(), columns = block.group.set().columns;
  double* local = local_gradient_.data();
  kernels_->dense_transposed_product(block.group.basis(), rows, channel.adjoint.data(), 3 * block.patches, local);
  if (block.group.flat()) pull_back_flattening(block, channel);
  for (int p = 0; p < block.patches; ++p) {
    const int* index = block.points(p);
    for (int i = 0; i < columns; ++i) {
      for (int c = 0; c < 3; ++c) channel.gradient(index[i], c) += local[3 * (block.patches * i + p) + c];
    }
  }
}

void JetPass::flatten(const Block& block) {
  const int rows = derivatives_ * block.group.samples(), columns = block.group.set().columns;
  for (int p = 0; p < block.patches; ++p) {
    const double* n = block.normal(*this, p);
    for (int i = 0; i < columns; ++i) {
      const double* local = local_.data() + 3 * (block.patches * i + p);
      along_normal_[block.patches * i + p] = local[0] * n[0] + local[1] * n[1] + local[2] * n[2];
    }
  }
  kernels_->dense_product(block.group.flattening(), rows, along_normal_.data(), block.patches, heights_.data());
  for (int p = 0; p < block.patches; ++p) {
    const double* n = block.normal(*this, p);
    const double* heights = heights_.data() + static_cast<std::size_t>(p) * rows;
    for (int c = 0; c < 3; ++c) {
      double* jets = jets_.data() + static_cast<std::size_t>(3 * p + c) * rows;
      for (int row = 0; row < rows; ++row) jets[row] -= heights[row] * n[c];
    }
  }
}

void JetPass::pull_back_flattening(const Block& block, Channel& channel) {
  const int rows = channel.derivatives * block.group.samples(), columns = block.group.set().columns;
  for (int p = 0; p < block.patches; ++p) {
    const double* n = block.normal(*this, p);
    const double* adjoint = channel.adjoint.data() + static_cast<std::size_t>(3 * p) * rows;
    const double* heights = heights_.data() + static_cast<std::size_t>(p) * derivatives_ * block.group.samples();
    double* along = along_.data() + static_cast<std::size_t>(p) * rows;
    double sums[3] = {};
    for (int row = 0; row < rows; ++row) {
      const double a[3] = {adjoint[row], adjoint[rows + row], adjoint[2 * rows + row]};
      along[row] = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
      for (int c = 0; c < 3; ++c) sums[c] += a[c] * heights[row];
    }
    for (int c = 0; c < 3; ++c) channel.normal_adjoints[block.cap(p)][c] -= sums[c];
  }
  double* t = along_normal_.data();
  kernels_->dense_transposed_product(block.group.flattening(), rows, along_.data(), block.patches, t);
  for (int p = 0; p < block.patches; ++p) {
    const double* n = block.normal(*this, p);
    for (int i = 0; i < columns; ++i) {
      const int at = block.patches * i + p;
      for (int c = 0; c < 3; ++c) {
        local_gradient_[3 * at + c] -= t[at] * n[c];
        channel.normal_adjoints[block.cap(p)][c] -= t[at] * local_[3 * at + c];
      }
    }
  }
}

}  // namespace umbilic
