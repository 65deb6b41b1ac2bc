// SPDX-License-Identifier: MIT
/// \file
/// Steps through the levels.
#include "driver/run_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cage/with_points.h"
#include "driver/accuracy.h"
#include "driver/fixed_area.h"
#include "driver/retarget.h"
#include "mesh/hierarchy.h"

namespace umbilic {
namespace {

bool is_minimized(const Level& level, const LevelReport& report) {
  return (report.stop == StopReason::kConverged || report.stop == StopReason::kRoundOff) && !level.doubtful();
}

}  // namespace

Run::State::State(const RunOptions& asked, Constraints given, RefinedCage prepared, const Cage& asked_cage)
    : options(asked),
      constraints(std::move(given)),
      cage(std::move(prepared)),
      own(asked_cage),
      cage_faces(own, cage.mesh),
      held_regions(cage.mesh, cage.held) {
  for (std::size_t f = 0; f < cage.held.size(); ++f) {
    if (cage.held[f]) held_faces.push_back(cage_faces[static_cast<int>(f)]);
  }
}

LevelOptions Run::State::level_options() const {
  LevelOptions next{options.caps(), options.weights, options.max_iterations, tolerance_of(options), options.metric};
  if (!levels.empty() && !within) next.energy_before = levels.back().energy_reported;
  next.fixed_area = fixed_area;
  return next;
}

void Run::State::begin_forecast(bool near) {
  const Surface& surface = level->surface();
  LevelSize size = level_size(level->number(), surface.level(), surface.layout(), surface.mesh().surface_face_count(),
                              surface.symmetry().order, level->unknowns());
  for (const int genus : surface.genera()) size.genus = std::max(size.genus, genus);
  forecast = Forecast(size, required_level, options, near);
}

void Run::State::update_forecast() {
  const bool done = progress.phase == Phase::kDone;
  if (narrower) {
    forecast.level_repeated(narrower->number(), narrower->evaluations(), level_seconds);
  } else if (!done) {
    forecast.level_advanced(progress.level, progress.evaluations, level_seconds);
  }
  progress.share_done = done ? 1 : forecast.share_done();
  progress.seconds_left = done ? 0 : forecast.seconds_left();
}

void Run::State::update_progress() {
  progress.level = level->number();
  const Lbfgs* lbfgs = level->lbfgs();
  progress.iterations = level->iterations();
  progress.evaluations = level->evaluations();
  progress.energy = level->energy();
  progress.gradient_norm = std::ldexp(level->gradient_norm(), -level->surface().placement().exponent);
  progress.predicted_decrease = lbfgs ? lbfgs->predicted_decrease() : std::numeric_limits<double>::quiet_NaN();
  progress.total_evaluations = progress.evaluations;
  for (const LevelReport& ended : levels) {
    if (ended.level != progress.level) progress.total_evaluations += ended.evaluations;
    progress.total_evaluations += ended.narrower_caps_evaluations;
  }
}

void Run::State::unit() {
  switch (progress.phase) {
    case Phase::kPrepare:
    case Phase::kMinimize: {
      const double before = progress.energy;
      const bool ended = level->step();
      progress.phase = ended ? Phase::kReport : level->preparing() ? Phase::kPrepare : Phase::kMinimize;
      update_progress();
      const bool stays = progress.energy == before || (std::isnan(progress.energy) && std::isnan(before));
      if (!stays) energies.forget();
      if (auto thicker = level->with_thicker_start()) replace_level(std::move(thicker));
      if (ended && search && !cancelled && !search->accepts(largest_deviation(level->surface(), level->best()))) {
        replace_level(level->with_closeness(search->weight()));
        break;
      }
      if (level->should_check_rule() && level->needs_finer_rule(energies.exact(*level)))
        replace_level(level->with_finer_rule());
      break;
    }
    case Phase::kReport: end_level(); break;
    case Phase::kCompareCaps: compare_caps(); break;
    case Phase::kDone: break;
  }
}

void Run::State::begin_search(double bound) {
  const Surface& surface = level->surface();
  within = std::ldexp(bound, -surface.placement().exponent);
  const EnergyValue start = surface.energy().evaluate(surface.start(), nullptr);
  const double half = *within / 2, weight = 0.1 * std::max(start.energy, kEnergyFloor) / (start.area * half * half);
  search.emplace(*within, std::isfinite(weight) && weight > 0 ? weight : 1);
  level = level->with_closeness(search->weight());
}

void Run::State::replace_level(std::unique_ptr<Level> other) {
  level = std::move(other);
  narrower.reset();
  energies.forget();
  progress.phase = Phase::kPrepare;
  update_progress();
}

std::optional<Error> Run::State::retarget(const Targets& targets) {
  RunOptions next = options;
  Constraints changed = constraints;
  if (auto error = set_targets(targets, next, changed)) return error;
  if (Error error; diverges(cage.mesh, options.caps(), next.weights, error)) return error;
  Result<Cage> moved = targets.points ? with_points(own, *targets.points) : own;
  if (!moved) return moved.error();
  Result<Retargeted> retargeted = with_targets(level->best_cage(), cage, targets, changed, *moved, options.caps());
  if (!retargeted) return retargeted.error();
  options = next;
  constraints = std::move(changed);
  cage = std::move(retargeted->cage);
  has_cages_orbits = has_cages_orbits && retargeted->has_cages_symmetry;
  if (targets.points) follow_cage(*std::move(moved));
  best.reset();
  levels.clear();
  energies_of_levels.clear();
  progress.ended_levels = 0;
  level_seconds = 0;
  cancelled = false;
  replace_level(Level::retargeted(std::move(level), std::move(retargeted->surface), level_options()));
  begin_forecast(true);
  update_forecast();
  return std::nullopt;
}

void Run::State::follow_cage(Cage moved) {
  own = std::move(moved);
  fixed_area = fixed_area_of(cage, required_level, options.caps());
  if (search) search.emplace(*within, search->weight());
}

LimitReport Run::State::limit() const {
  if (within) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double energy = levels.empty() ? nan : levels.back().energy_reported;
    return {LimitStatus::kNotComparable, energy, nan, nan, nan};
  }
  return extrapolate(energies_of_levels, third_order(options.weights), level->surface().lower_bound());
}

void Run::State::end_level() {
  const EnergyReport report_of_ended = energies.exact(*level);
  levels.push_back(level->report(report_of_ended));
  progress.ended_levels = static_cast<int>(levels.size());
  const LevelReport& report = levels.back();
  if (report.evaluable && !within) {
    const double left = tolerance_of(options) * std::max(report.energy_reported, kEnergyFloor);
    energies_of_levels.push_back({report.energy_reported, left + report_of_ended.quadrature_error,
                                  report_of_ended.functionals[kBending], is_minimized(*level, report),
                                  report_of_ended.credible(), report.cap_rings});
  }
  if (!cancelled && is_last() && caps_are_in_question()) {
    narrower = best->level->with_narrower_caps();
    progress.phase = Phase::kCompareCaps;
    forecast.level_repeated(narrower->number(), 0, 0);
  } else {
    go_on();
  }
}

bool Run::State::is_last() const {
  return cancelled || level->number() >= options.last_level || levels.back().stop == StopReason::kNotFinite ||
         (options.accuracy && suffice(static_cast<int>(energies_of_levels.size()), limit(), *options.accuracy));
}

bool Run::State::caps_are_in_question() const {
  const LimitReport found = limit();
  return found.status == LimitStatus::kConverging && !found.caps_included && best &&
         best->level->number() == level->number() - 1 && best->report.cap_rings == levels.back().cap_rings &&
         best->report.cap_rings > 1;
}

void Run::State::compare_caps() {
  if (!narrower->step()) return;
  const LevelReport report = narrower->report(narrower->surface().report(narrower->best()));
  LevelReport& compared = levels[levels.size() - 2];
  compared.narrower_caps_evaluations = report.evaluations;
  if (is_minimized(*narrower, report)) {
    compared.narrower_caps_energy = report.energy_reported;
    energies_of_levels[energies_of_levels.size() - 2].with_narrower_caps = report.energy_reported;
  }
  narrower.reset();
  go_on();
}

void Run::State::go_on() {
  const bool last = is_last();
  std::optional<RefinedCage> finer;
  if (!last) finer = refine(level->best_cage(), 1);
  const EnergyReport energies_of_ended = energies.exact(*level);
  EndedLevel ended{std::move(level), levels.back(), energies_of_ended};
  // Levels with different weights do not compare: the last one is the result.
  if (!best || within || ended.rank() <= best->rank()) {
    best = std::move(ended);
    result = levels.size() - 1;
  }
  if (last) {
    level = std::move(best->level);
    energies.become(best->energies);
    progress.phase = Phase::kDone;
    update_progress();
  } else {
    if (search) search.emplace(*within, search->weight());
    replace_level(std::make_unique<Level>(*finer, std::max(finer->level, required_level), level_options()));
  }
}

}  // namespace umbilic
