// SPDX-License-Identifier: MIT
/// \file
/// The jet evaluator: dense evaluation as a second implementation, equivariance, and <Jv, w> = <v, J^T w>.
#include "surface/jets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/lanes.h"
#include "mesh/rough_cages.h"
#include "surface/all_caps.h"
#include "surface/flat_frame.h"

namespace umbilic::test {
namespace {

constexpr QuadratureRule kRule{3, 3, 1};

/// All jets of a surface, block after block.
Eigen::VectorXd all_jets(const JetEvaluator& jets, const Points& control, int derivatives) {
  std::vector<double> all;
  std::vector<Points> none;
  jets.evaluate(
      control, derivatives, {},
      [&](int, const JetBlock& block) {
        all.insert(all.end(), block.jets, block.jets + 3 * block.derivatives * block.samples * block.patches);
      },
      none);
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<int>(all.size()));
}

/// Pulls back a cotangent vector: entry i of each channel is weights(i), different in every channel by its factor.
std::vector<Points> pulled_back(const JetEvaluator& jets, const Points& control, int derivatives,
                                const std::vector<AdjointChannel>& channels, const std::vector<Eigen::VectorXd>& w) {
  std::vector<Points> gradients;
  std::vector<Eigen::Index> at(channels.size(), 0);
  jets.evaluate(
      control, derivatives, channels,
      [&](int, const JetBlock& block) {
        for (std::size_t k = 0; k < channels.size(); ++k) {
          const int size = 3 * channels[k].derivatives * block.samples * block.patches;
          std::copy_n(w[k].data() + at[k], size, block.adjoints[k]);
          at[k] += size;
        }
      },
      gradients);
  return gradients;
}

/// Row sizes of jets with `count` derivatives cut out of jets with `derivatives`.
Eigen::VectorXd first_derivatives(const JetEvaluator& jets, const Points& control, const Eigen::VectorXd& all,
                                  int derivatives, int count) {
  std::vector<double> part;
  std::vector<Points> none;
  Eigen::Index at = 0;
  jets.evaluate(
      control, derivatives, {},
      [&](int, const JetBlock& block) {
        for (int pc = 0; pc < 3 * block.patches; ++pc) {
          for (int i = 0; i < count * block.samples; ++i) part.push_back(all[at + i]);
          at += derivatives * block.samples;
        }
      },
      none);
  return Eigen::Map<const Eigen::VectorXd>(part.data(), static_cast<int>(part.size()));
}

TEST(JetEvaluator, pull_back_is_the_transpose_of_the_derivative) {
  for (const CapKind cap : kAllCaps) {
    for (const int steps : {1, 2}) {
      const Refined mesh = rough(trapezohedron(5), steps, steps == 1 ? 0.15 : 0.03, 3);
      const PatchLayout layout(mesh.mesh, cap);
      const JetEvaluator jets(layout, kRule);
      for (const int derivatives : {kSecondOrderCount, kThirdOrderCount}) {
        Random random(17);
        const Points v = random.points(mesh.control.rows());
        // J v: exact for linear caps; the flat one by a difference quotient of order 4.
        const double h = cap == CapKind::kFlat ? 1e-3 : 1;
        const auto at = [&](double t) { return all_jets(jets, mesh.control + t * v, derivatives); };
        const Eigen::VectorXd jv = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);

        std::vector<AdjointChannel> channels{{derivatives}, {kFirstOrderCount}, {kSecondOrderCount}};
        std::vector<Eigen::VectorXd> parts, w;
        for (const AdjointChannel& channel : channels) {
          parts.push_back(first_derivatives(jets, mesh.control, jv, derivatives, channel.derivatives));
          w.push_back(random.matrix<Eigen::VectorXd>(parts.back().size(), 1));
        }
        const std::vector<Points> gradients = pulled_back(jets, mesh.control, derivatives, channels, w);
        ASSERT_EQ(gradients.size(), channels.size());
        for (std::size_t k = 0; k < channels.size(); ++k) {
          ASSERT_EQ(gradients[k].rows(), mesh.control.rows());
          const double forward = parts[k].dot(w[k]), backward = gradients[k].cwiseProduct(v).sum();
          const double tolerance = cap == CapKind::kFlat ? 1e-9 : 1e-12;  // difference quotient, round-off
          EXPECT_NEAR(forward, backward, tolerance * parts[k].norm() * w[k].norm() / std::sqrt(1.0 * w[k].size()) * 10)
              << "cap " << static_cast<int>(cap) << " channel " << channels[k].derivatives;
        }
      }
    }
  }
}

TEST(JetEvaluator, equals_basis_times_points_patch_by_patch) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(6), 2, 0.03, 4);
    const PatchLayout layout(mesh.mesh, cap);
    const Points points = layout.extend(mesh.control);
    const std::vector<FlatFrame> frames = flat_frames(layout, points);
    const JetEvaluator evaluator(layout, kRule);
    const Eigen::VectorXd jets = all_jets(evaluator, mesh.control, kThirdOrderCount);
    Eigen::Index at = 0;  // sets stand in the order of the layout
    for (const PatchSet& set : layout.sets()) {
      std::vector<Sample> samples;
      if (set.kind.regular()) {  // each row of nodes padded
        for (const Sample& sample : tensor_rule(kRule.regular_points)) {
          samples.push_back(sample);
          if (samples.size() % kSampleMultiple == 3) samples.push_back(sample);
        }
      } else {
        samples =
            set.kind.at_extraordinary() ? graded_rule(kRule.cap_points, kRule.grading) : tensor_rule(kRule.cap_points);
        pad_samples(samples, kSampleMultiple);
      }
      const int count = static_cast<int>(samples.size());
      for (int p = 0; p < set.count(); ++p) {
        for (int s = 0; s < count; ++s) {
          const auto [u, v, weight] = samples[s];
          const DerivativeRows basis = patch_basis(set.kind, u, v);
          Points local(set.columns, 3);
          for (int i = 0; i < set.columns; ++i) local.row(i) = points.row(set.points[p * set.columns + i]);
          Points expected = basis * local;
          if (set.kind.shape == CapShape::kFlat) {
            const Vector3 n = frames[set.caps[p]].normal;
            expected -= patch_flattening(set.kind, u, v) * local * n * n.transpose();
          }
          for (int d = 0; d < kThirdOrderCount; ++d) {
            for (int c = 0; c < 3; ++c) {
              EXPECT_NEAR(jets[at + ((p * 3 + c) * kThirdOrderCount + d) * count + s], expected(d + 1, c), 1e-9);
            }
          }
        }
      }
      at += static_cast<Eigen::Index>(3) * kThirdOrderCount * count * set.count();
    }
    EXPECT_EQ(at, jets.size());
  }
}

TEST(JetEvaluator, linear_caps_commute_with_affine_maps_and_the_flat_one_with_similarities) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(7), 2, 0.03, 5);
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, kRule);
    const Eigen::Matrix3d map =
        cap == CapKind::kFlat ? Eigen::Matrix3d(1.7 * some_rotation()) : Random(2).matrix<Eigen::Matrix3d>(3, 3);
    const Points moved = (mesh.control * map.transpose()).rowwise() + Eigen::RowVector3d(3, -1, 2);
    const Eigen::VectorXd before = all_jets(jets, mesh.control, kThirdOrderCount);
    const Eigen::VectorXd after = all_jets(jets, moved, kThirdOrderCount);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(before.size());
    Eigen::Index at = 0;
    std::vector<Points> none;
    jets.evaluate(
        mesh.control, kThirdOrderCount, {},
        [&](int, const JetBlock& block) {
          const int size = kThirdOrderCount * block.samples;
          for (int p = 0; p < block.patches; ++p, at += 3 * size) {
            for (int i = 0; i < 3; ++i) {
              for (int j = 0; j < 3; ++j)
                expected.segment(at + i * size, size) += map(i, j) * before.segment(at + j * size, size);
            }
          }
        },
        none);
    EXPECT_LT((after - expected).norm(), 1e-11 * expected.norm()) << "cap " << static_cast<int>(cap);
  }
}

TEST(JetEvaluator, lower_orders_are_the_same_numbers) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(5), 2, 0.03, 6);
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, kRule);
    const Eigen::VectorXd third = all_jets(jets, mesh.control, kThirdOrderCount);
    const Eigen::VectorXd second = all_jets(jets, mesh.control, kSecondOrderCount);
    const Eigen::VectorXd part = first_derivatives(jets, mesh.control, third, kThirdOrderCount, kSecondOrderCount);
    EXPECT_LT((part - second).cwiseAbs().maxCoeff(), 1e-12 * second.cwiseAbs().maxCoeff());
  }
}

TEST(JetEvaluator, visits_each_face_with_weights_that_sum_to_one) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = refined(trapezohedron(5), 2);
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {3, 5, 2});
    double sum = 0;
    long samples = 0;
    std::vector<Points> none;
    jets.evaluate(
        mesh.control, kSecondOrderCount, {},
        [&](int, const JetBlock& block) {
          for (int s = 0; s < block.samples; ++s) {
            sum += block.patches * block.weights[s];
            samples += block.weights[s] > 0 ? block.patches : 0;
          }
        },
        none);
    EXPECT_NEAR(sum, mesh.mesh.face_count(), 1e-11);
    EXPECT_EQ(samples, jets.sample_count());
  }
}

TEST(FlatFrame, normal_is_that_of_the_limit_surface_at_the_vertex) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 7);
  const PatchLayout layout(mesh.mesh, CapKind::kFlat);
  for (const Cap& cap : layout.caps()) {
    const RingNet& net = cap_sector(cap.valence, cap.shape).net();
    Points local = Points::Zero(net.size(), 3);
    for (int i = 0; i < net.size(); ++i) {
      if (cap.net[i] >= 0) local.row(i) = mesh.control.row(cap.net[i]);
    }
    const double e = std::ldexp(1.0, -25);
    const Points jet = net.basis(e, e) * local;
    const Vector3 normal = Vector3(jet.row(1)).cross(Vector3(jet.row(2))).normalized();
    // Tends like (mu / lambda)^k, k = 25.
    EXPECT_LT((flat_frame(cap, mesh.control).normal - normal).norm(), 1e-3);
    EXPECT_NEAR(flat_frame(cap, mesh.control).normal.norm(), 1, 1e-15);
  }
}

}  // namespace
}  // namespace umbilic::test
