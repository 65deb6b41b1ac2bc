// SPDX-License-Identifier: MIT
/// \file
/// Negative directions of Hessians against dense eigenvalues, and of minimizers that are known.
#include "driver/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cage/generate.h"
#include "driver/rules.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "optimize/hessian_assembly.h"

namespace umbilic::test {
namespace {

CertificateReport finished(Certificate certificate) {
  double progress = certificate.progress();
  EXPECT_EQ(progress, 0);
  while (!certificate.step()) {
    EXPECT_GE(certificate.progress(), progress);
    progress = certificate.progress();
    EXPECT_LT(progress, 1);
  }
  EXPECT_EQ(certificate.progress(), 1);
  EXPECT_TRUE(certificate.step());
  const Result<CertificateReport> report = certificate.report();
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : CertificateReport();
}

/// Directions along which energies do not change, by what they do to points.
Eigen::MatrixXd gauge(const Points& control, bool conformal) {
  const Eigen::Index count = control.rows();
  Eigen::MatrixXd directions(3 * count, conformal ? 10 : 7);
  for (Eigen::Index v = 0; v < count; ++v) {
    const Vector3 x = control.row(v).transpose();
    for (int i = 0; i < 3; ++i) {
      const Vector3 e = Vector3::Unit(i);
      directions.block<3, 1>(3 * v, i) = e;
      directions.block<3, 1>(3 * v, 3 + i) = e.cross(x);
      if (conformal) directions.block<3, 1>(3 * v, 7 + i) = x.squaredNorm() * e - 2 * e.dot(x) * x;
    }
    directions.block<3, 1>(3 * v, 6) = x;
  }
  return directions;
}

/// Eigenvalues below -tau of the pencil (K, S) on the complement of the gauge directions.
int negative_eigenvalues(const RefinedCage& cage, CapKind cap, const Weights& weights) {
  const PatchLayout layout(cage.mesh, cap);
  const Unknowns unknowns{Coordinates(cage.mesh.vertex_count())};
  HessianAssembly assembly(layout, unknowns, weights, minimizing_rule(cap, weights));
  assembly.begin(cage.control);
  while (!assembly.advance()) {
  }
  const auto dense = [](const Eigen::SparseMatrix<double>& lower) {
    return Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
  };
  Eigen::MatrixXd k = dense(assembly.combine(1, 0));
  const Eigen::MatrixXd s = dense(assembly.combine(0, 1)), f = assembly.factors();
  if (f.cols() == 2) k += f.col(0) * f.col(1).transpose() + f.col(1) * f.col(0).transpose();
  const Eigen::MatrixXd g = gauge(cage.control, f.cols() == 0);
  const Eigen::MatrixXd complement = orthogonal_complement(g);
  const Eigen::VectorXd values = eigenvalues(congruent(k, complement), congruent(s, complement));
  return static_cast<int>((values.array() < -kCertificateTau).count());
}

TEST(Certificate, counts_the_negative_eigenvalues_of_the_pencil_away_from_the_gauge_directions) {
  const Weights bending{1, 0, 0, 0, 0, 0}, variation{0, 0, 0, 1, 0, 0}, blend{1, 0, 0, 0, 0.05, 0};
  const Refined torus = rough(*generate_cage("torus", {.major_segments = 5, .minor_segments = 4}), 0, 0.1, 1);
  const Refined sphere = rough(trapezohedron(5), 1, 0.1, 2);
  int all = 0;
  for (const Refined& mesh : {torus, sphere}) {
    for (const CapKind cap : {CapKind::kSmooth, CapKind::kNone}) {
      for (const Weights& weights : {bending, variation, blend}) {
        if (cap == CapKind::kNone && third_order(weights)) continue;
        const RefinedCage cage{3, mesh.mesh, mesh.control, {}};
        const CertificateReport report = finished(*Certificate::create(cage, cap, weights));
        EXPECT_EQ(report.negative, negative_eigenvalues(cage, cap, weights));
        EXPECT_EQ(report.unknowns, 3 * mesh.mesh.vertex_count());
        EXPECT_EQ(report.gauge, third_order(weights) ? 7 : 10);
        EXPECT_EQ(report.tau, kCertificateTau);
        EXPECT_EQ(report.level, 3);
        all += report.negative;
      }
    }
  }
  EXPECT_GT(all, 10) << "surfaces far from minimizers have some";
}

TEST(Certificate, does_not_depend_on_place_and_size_nor_on_the_symmetry_that_a_surface_was_minimized_in) {
  const Weights bending{1, 0, 0, 0, 0, 0};
  const Refined mesh = rough(trapezohedron(5), 1, 0.1, 2);
  const RefinedCage here{0, mesh.mesh, mesh.control, {}};
  const RefinedCage there{0, mesh.mesh, (30 * mesh.control).rowwise() + Eigen::RowVector3d(4, 5, 6), {}};
  const int negative = finished(*Certificate::create(here, CapKind::kSmooth, bending)).negative;
  EXPECT_EQ(finished(*Certificate::create(there, CapKind::kSmooth, bending)).negative, negative);
  const RefinedCage symmetric = *refine_to_evaluable(trapezohedron(5), 1, true);
  RefinedCage free = symmetric;
  free.symmetry = {};
  EXPECT_GT(symmetric.symmetry.order, 1);
  const CertificateReport a = finished(*Certificate::create(symmetric, CapKind::kSmooth, bending)),
                          b = finished(*Certificate::create(free, CapKind::kSmooth, bending));
  EXPECT_EQ(a.negative, b.negative);
  EXPECT_EQ(a.unknowns, b.unknowns);
}

/// A sphere's cage whose patches shrink towards one pole by a factor of e^(2 kCrowding).
RefinedCage crowded(double crowding) {
  RefinedCage cage = *refine_to_evaluable(cube(), 2, false);
  for (Eigen::Index v = 0; v < cage.control.rows(); ++v) {
    cage.control.row(v) *= std::exp(crowding * cage.control(v, 2));
  }
  return cage;
}

TEST(Certificate, raises_tau_where_rounding_errors_would_hide_the_signs) {
  const Weights variation{0, 0, 0, 1, 0, 0};
  EXPECT_EQ(finished(*Certificate::create(crowded(1), CapKind::kSmooth, variation)).tau, kCertificateTau);
  EXPECT_GT(finished(*Certificate::create(crowded(4.4), CapKind::kSmooth, variation)).tau, 5 * kCertificateTau);
}

TEST(Certificate, is_refused_in_the_end_where_the_signs_cannot_be_told) {
  const auto refusal = [](RefinedCage cage) {
    Certificate certificate = *Certificate::create(cage, CapKind::kSmooth, {0, 0, 0, 1, 0, 0});
    while (!certificate.step()) {
    }
    EXPECT_EQ(certificate.progress(), 1);
    EXPECT_FALSE(certificate.report());
    return certificate.report() ? "" : certificate.report().error().message;
  };
  EXPECT_EQ(refusal(crowded(20)),
            "no certificate: rounding errors hide the signs of the Hessian's eigenvalues, even with tau 0.1");
  RefinedCage broken = crowded(0);
  broken.control(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(broken), "no certificate: the Hessian of this surface cannot be factored");
}

TEST(Certificate, is_refused_for_flat_caps_and_for_large_meshes) {
  const RefinedCage small = *refine_to_evaluable(cube(), 1, false);
  EXPECT_EQ(Certificate::create(small, CapKind::kFlat, {1, 0, 0, 0, 0, 0}).error().message,
            "no certificate with cap flat: its second derivatives take the caps' normals as fixed");
  const Cage torus = *generate_cage("torus", {.major_segments = 201, .minor_segments = 100});
  const RefinedCage large = *refine_to_evaluable(torus, 0, false);
  EXPECT_EQ(Certificate::create(large, CapKind::kSmooth, {1, 0, 0, 0, 0, 0}).error().message,
            "no certificate on 20100 patches; at most 10000 are possible");
}

CertificateReport of_bending_minimizer(const char* name, int level) {
  RunOptions options;
  options.weights = {1, 0, 0, 0, 0, 0};
  options.last_level = level;
  umbilic::Run run = *umbilic::Run::create(*generate_cage(name), options);
  while (!run.step(100)) {
  }
  EXPECT_GT(run.group().order, 1);
  const CertificateReport report = finished(*run.certify());
  EXPECT_EQ(report.level, level);
  return report;
}

TEST(Certificate, finds_no_negative_direction_at_the_clifford_torus) {
  // Marques & Neves 2014: it minimizes among all tori.
  EXPECT_EQ(of_bending_minimizer("torus", 2).negative, 0);
}

TEST(CertificateSlow, finds_no_negative_direction_at_lawsons_surface_of_genus_2) {
  EXPECT_EQ(of_bending_minimizer("two-3", 2).negative, 0);
}

TEST(CertificateSlow, finds_the_two_directions_that_lead_from_the_tetrahedral_surface_to_lawsons_of_genus_3) {
  EXPECT_EQ(of_bending_minimizer("tetrahedron-frame", 2).negative, 2);
}

}  // namespace
}  // namespace umbilic::test
