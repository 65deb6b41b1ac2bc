// SPDX-License-Identifier: MIT
/// \file
/// Levels that go on from where another one is.
#include <utility>

#include "driver/equations.h"
#include "driver/level.h"
#include "driver/thickness.h"

namespace umbilic {
namespace {

/// A metric over unknowns y' = T y, from one over the unknowns y of the same points.
class MappedMetric : public Metric {
 public:
  /// `metric` must outlive this one.
  MappedMetric(const Metric& metric, Eigen::SparseMatrix<double> map) : metric_(metric), map_(std::move(map)) {}
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override {
    return map_ * metric_.solve(Eigen::VectorXd(map_.transpose() * gradient));
  }

 private:
  const Metric& metric_;
  Eigen::SparseMatrix<double> map_;
};

/// Of matrices without rows or columns, which are those of a level that has no unknowns, Eigen takes no norm.
bool same(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         (a.nonZeros() == 0 || (a - b).norm() == 0);
}

}  // namespace

Level::Work Level::work_done() const {
  return {iterations(),
          evaluations(),
          before_.metrics + metrics_,
          before_.factorizations + factorizations(),
          before_.stages + stages_.begun(),
          energy(),
          gradient_norm()};
}

std::unique_ptr<Level> Level::with_finer_rule() const {
  LevelOptions options = options_;
  ++options.quadrature;
  options.max_iterations -= lbfgs_->iterations();
  options.even_parameters = false;
  auto level = std::make_unique<Level>(best_cage(), surface_.level(), options);
  level->before_ = work_done();
  level->start_energy_ = start_energy_;
  level->thicknesses_tried_ = kThicknessRatios.size();
  level->thickened_ = thickened_;
  return level;
}

std::unique_ptr<Level> Level::with_closeness(double weight) const {
  RefinedCage start = best_cage();
  start.closeness = weight;
  LevelOptions options = options_;
  if (lbfgs_) options.even_parameters = false;
  auto level = std::make_unique<Level>(std::move(start), surface_.level(), options);
  level->before_ = work_done();
  return level;
}

std::unique_ptr<Level> Level::with_narrower_caps() const {
  LevelOptions options = options_;
  options.cap.most_rings = surface_.narrowest_cap() / 2;
  options.energy_before = std::numeric_limits<double>::infinity();
  options.even_parameters = false;
  auto level = std::make_unique<Level>(best_cage(), surface_.level(), options);
  level->thicknesses_tried_ = kThicknessRatios.size();
  return level;
}

std::unique_ptr<Level> Level::with_thicker_start() const {
  if (!thicker_) return nullptr;
  RefinedCage start = start_;
  start.control = *thicker_;
  auto level = std::make_unique<Level>(std::move(start), surface_.level(), options_);
  level->thicknesses_tried_ = kThicknessRatios.size();
  level->thickened_ = true;
  return level;
}

/// The change of the coordinates 3 v + c of the control points with each unknown.
Eigen::SparseMatrix<double> Level::directions() const {
  const Eigen::SparseMatrix<double> all = coordinates_.matrix();
  return solutions_ ? Eigen::SparseMatrix<double>(all * solutions_->basis()) : all;
}

/// Takes over the metric of a level whose surface and unknowns are nearly the same, also if it is still being built.
void Level::take_metric(std::unique_ptr<Level> from) {
  const bool has_metric = from->metric_ && (from->lbfgs_ || from->building_);
  if (!has_metric || from->metric_choice_ == MetricChoice::kIdentity) return;
  if (from->unknowns_.count() != unknowns_.count()) return;  // less symmetry is left
  // The level that made the metric may be an earlier one.
  const Level& maker = from->metric_owner_ ? *from->metric_owner_ : *from;
  const Eigen::SparseMatrix<double> own = directions(), others = maker.directions();
  if (!same(own, others)) {
    if (!has_orthonormal_unknowns() || !maker.has_orthonormal_unknowns()) return;
    mapped_metric_ =
        std::make_unique<MappedMetric>(*from->metric_, Eigen::SparseMatrix<double>(own.transpose() * others));
  }
  metric_ = from->metric_;
  building_ = from->building_;
  metric_owner_ = from->metric_owner_ ? std::move(from->metric_owner_) : std::move(from);
}

std::unique_ptr<Level> Level::retargeted(std::unique_ptr<Level> before, RefinedCage targets,
                                         const LevelOptions& options) {
  const Coordinates coordinates(targets.mesh, targets.symmetry, held_points(targets, options.cap));
  const Points& own_before = before->start_.own;
  const bool follows = own_before.rows() == targets.own.rows();
  targets.control = moved_to_equations(targets, coordinates, follows ? Points(targets.own - own_before) : Points());
  LevelOptions own = options;
  own.quadrature = before->quadrature();
  own.even_parameters = false;
  auto level = std::make_unique<Level>(std::move(targets), before->surface_.level(), own);
  level->thicknesses_tried_ = kThicknessRatios.size();
  level->take_metric(std::move(before));
  return level;
}

}  // namespace umbilic
