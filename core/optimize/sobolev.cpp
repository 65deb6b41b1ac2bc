// SPDX-License-Identifier: MIT
/// \file
/// Assembles the Sobolev matrix patch by patch over all points of the layout, then reduces it to the control points.
#include "optimize/sobolev.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "optimize/covariant.h"
#include "surface/flat_frame.h"

namespace umbilic {
namespace {

/// A metric needs no exact integrals, only that no direction is missed.
constexpr int kPoints = 3;
constexpr int kGrading = 2;

/// Samples whose contributions one `advance` adds.
constexpr int kSamplesPerPart = 3000;

double second_order_weight(const Weights& w) { return w[kBending] + w[kWillmore] / 4; }

double third_order_weight(const Weights& w) {
  return w[kMvs] + w[kMvsCross] + w[kMehlumTarrou] / 2 + w[kSecondFormVariation];
}

/// A kind's table, and the basis whose Sobolev products are taken: of `flat` caps that of the surface's normal part.
struct Kind {
  const PatchSet* set;
  BasisTable table;
  Eigen::MatrixXd functions;
};

}  // namespace

struct SobolevMetric::Assembly {
  enum class Stage { kArea, kPatches, kReduce, kFactor, kReady };

  const PatchLayout& layout;
  double second, third;
  Points points;
  std::vector<FlatFrame> frames;
  std::vector<Kind> kinds;
  double area = 0;
  Stage stage = Stage::kArea;
  std::size_t kind = 0;
  int patch = 0;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SparseMatrix<double> matrix;

  Assembly(const PatchLayout& patches, const Weights& weights, const Points& control)
      : layout(patches),
        second(second_order_weight(weights)),
        third(third_order_weight(weights)),
        points(patches.extend(control)),
        frames(flat_frames(patches, points)) {
    for (const PatchSet& set : layout.sets()) {
      const auto samples = set.kind.at_extraordinary() ? graded_rule(kPoints, kGrading) : tensor_rule(kPoints);
      kinds.push_back({&set, basis_table(set.kind, samples, 0, kDerivativeCount), {}});
      Kind& k = kinds.back();
      k.functions = k.table.basis;
      if (set.kind.shape == CapShape::kFlat) k.functions -= k.table.flattening;
    }
  }

  /// The surface's derivatives of order 0 to 3 at all samples of a patch, in the order of the table's rows.
  Eigen::Matrix<double, Eigen::Dynamic, 3> jets(const Kind& k, int p) const {
    Eigen::Matrix<double, Eigen::Dynamic, 3> local(k.set->columns, 3);
    for (int i = 0; i < k.set->columns; ++i) local.row(i) = points.row(k.set->points[k.set->columns * p + i]);
    Eigen::Matrix<double, Eigen::Dynamic, 3> result = k.table.basis * local;
    if (k.set->kind.shape == CapShape::kFlat) {
      const Vector3& n = frames[k.set->caps[p]].normal;
      result -= (k.table.flattening * (local * n)) * n.transpose();
    }
    return result;
  }

  /// The derivatives of order 1 to 3 at sample s of something with the table's rows.
  template <class Rows>
  static Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> at_sample(const Rows& all, int samples,
                                                                                    int s) {
    Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> rows(kThirdOrderCount, all.cols());
    for (int d = 0; d < kThirdOrderCount; ++d) rows.row(d) = all.row((d + 1) * samples + s);
    return rows;
  }

  void measure_area() {
    for (const Kind& k : kinds) {
      for (int p = 0; p < k.set->count(); ++p) {
        const auto x = jets(k, p);
        for (int s = 0; s < k.table.samples; ++s) {
          const Vector3 a = x.row(k.table.samples + s), b = x.row(2 * k.table.samples + s);
          area += k.table.weights[s] * a.cross(b).norm();
        }
      }
    }
  }

  void add_patch(const Kind& k, int p) {
    const BasisTable& table = k.table;
    const double length = 10 / std::sqrt(area);
    const double mass = 0.01 * (2 * second * std::pow(length, 4) + 2 * third * area * std::pow(length, 6));
    const auto x = jets(k, p);
    constexpr int kRows = 1 + 3 + 6;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(kRows * table.samples, table.columns);
    for (int s = 0; s < table.samples; ++s) {
      const auto basis = at_sample(k.functions, table.samples, s);
      const CovariantDerivatives covariant(at_sample(x, table.samples, s));
      const double measure = table.weights[s] * covariant.area;
      auto here = rows.middleRows<kRows>(kRows * s);
      here.row(0) = std::sqrt(measure * mass) * k.functions.row(s);
      if (second > 0) here.middleRows<3>(1).noalias() = std::sqrt(2 * second * measure) * covariant.second * basis;
      if (third > 0) here.middleRows<6>(4).noalias() = std::sqrt(2 * third * area * measure) * covariant.third * basis;
    }
    const Eigen::MatrixXd block = rows.transpose() * rows;
    const int* index = &k.set->points[static_cast<std::size_t>(k.set->columns) * p];
    for (int i = 0; i < k.set->columns; ++i) {
      for (int j = 0; j < k.set->columns; ++j) entries.emplace_back(index[i], index[j], block(i, j));
    }
  }

  void add_patches() {
    for (int samples = 0; samples < kSamplesPerPart && kind < kinds.size();) {
      add_patch(kinds[kind], patch);
      samples += kinds[kind].table.samples;
      if (++patch == kinds[kind].set->count()) {
        ++kind;
        patch = 0;
      }
    }
  }

  void reduce() {
    Eigen::SparseMatrix<double> full(layout.point_count(), layout.point_count());
    full.setFromTriplets(entries.begin(), entries.end());
    entries = {};
    const Eigen::SparseMatrix<double> extension = layout.extension();
    matrix = extension.transpose() * full * extension;
  }
};

SobolevMetric::SobolevMetric(const PatchLayout& layout, const Weights& weights, Points control)
    : assembly_(std::make_unique<Assembly>(layout, weights, control)) {}

SobolevMetric::~SobolevMetric() = default;

bool SobolevMetric::advance() {
  using Stage = Assembly::Stage;
  if (!assembly_) return true;
  switch (assembly_->stage) {
    case Stage::kArea:
      assembly_->measure_area();
      assembly_->stage = Stage::kPatches;
      break;
    case Stage::kPatches:
      assembly_->add_patches();
      if (assembly_->kind == assembly_->kinds.size()) assembly_->stage = Stage::kReduce;
      break;
    case Stage::kReduce:
      assembly_->reduce();
      factor_.analyzePattern(assembly_->matrix);
      assembly_->stage = Stage::kFactor;
      break;
    case Stage::kFactor:
      factor_.factorize(assembly_->matrix);
      assembly_->stage = Stage::kReady;
      break;
    case Stage::kReady: break;
  }
  if (assembly_->stage != Stage::kReady) return false;
  assembly_.reset();
  return true;
}

Eigen::VectorXd SobolevMetric::solve(const Eigen::VectorXd& gradient) const {
  assert(!assembly_);
  if (factor_.info() != Eigen::Success) return gradient;  // a surface too irregular for its own metric: the identity
  const Eigen::Map<const Points> rows(gradient.data(), gradient.size() / 3, 3);
  Eigen::VectorXd result(gradient.size());
  Eigen::Map<Points>(result.data(), rows.rows(), 3) = factor_.solve(Eigen::MatrixXd(rows));
  return result;
}

std::size_t SobolevMetric::factor_nonzeros() const { return factor_.matrixL().nestedExpression().nonZeros(); }

}  // namespace umbilic
