// SPDX-License-Identifier: MIT
/// \file
/// Steps through the levels: prepare, minimize, report, refine.
#include "driver/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "cage/with_points.h"
#include "driver/accuracy.h"
#include "driver/best_energies.h"
#include "driver/cage_faces.h"
#include "driver/closeness_search.h"
#include "driver/constraints_report.h"
#include "driver/ended_level.h"
#include "driver/equations.h"
#include "driver/estimate.h"
#include "driver/extrapolate.h"
#include "driver/fixed_area.h"
#include "driver/level.h"
#include "driver/memory.h"
#include "driver/retarget.h"
#include "driver/surface_state.h"
#include "driver/tessellate.h"
#include "mesh/coordinates.h"
#include "mesh/hierarchy.h"

namespace umbilic {
namespace {

bool is_minimized(const Level& level, const LevelReport& report) {
  return (report.stop == StopReason::kConverged || report.stop == StopReason::kRoundOff) && !level.doubtful();
}

}  // namespace

struct Run::State {
  State(const RunOptions& asked, Constraints given, RefinedCage prepared, const Cage& asked_cage)
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

  RunOptions options;
  Constraints constraints;
  RefinedCage cage;  // at level 0
  Cage own;          // that it was made from
  /// Whether orbits are of the cage's symmetry, not of one that a start was found to have, or of a part.
  bool has_cages_orbits = true;
  CageFaces cage_faces;
  HeldRegions held_regions;     // of the cage
  std::vector<int> held_faces;  // of the cage, sorted
  int required_level = 0;       // the first level that can be evaluated
  std::unique_ptr<Level> level;
  std::unique_ptr<Level> narrower;  // the level before `level`, with narrower caps, while these are compared
  std::optional<EndedLevel> best;  // of the levels before `level`, as far as there are any
  std::size_t result = 0;          // the index of the best level, once the run is done
  std::vector<LevelReport> levels;
  std::vector<LevelEnergy> energies_of_levels;  // of the evaluable ones
  Progress progress;
  double level_seconds = 0;
  Forecast forecast;
  bool cancelled = false;
  std::optional<double> within;  // the largest deviation that is allowed, in unit coordinates
  std::optional<ClosenessSearch> search;
  std::optional<double> fixed_area;  // see Surface
  BestEnergies energies;

  LevelOptions level_options() const {
    LevelOptions next{options.caps(), options.weights, options.max_iterations, tolerance_of(options), options.metric};
    if (!levels.empty() && !within) next.energy_before = levels.back().energy_reported;
    next.fixed_area = fixed_area;
    return next;
  }

  /// Of a run that goes on with the level that is there; `near`: from a surface that has been minimized.
  void begin_forecast(bool near) {
    const Surface& surface = level->surface();
    LevelSize size = level_size(level->number(), surface.level(), surface.layout(), surface.mesh().surface_face_count(),
                                surface.symmetry().order, level->unknowns());
    for (const int genus : surface.genera()) size.genus = std::max(size.genus, genus);
    forecast = Forecast(size, required_level, options, near);
  }

  /// What the forecast says after some work.
  void update_forecast() {
    const bool done = progress.phase == Phase::kDone;
    if (narrower) {
      forecast.level_repeated(narrower->number(), narrower->evaluations(), level_seconds);
    } else if (!done) {
      forecast.level_advanced(progress.level, progress.evaluations, level_seconds);
    }
    progress.share_done = done ? 1 : forecast.share_done();
    progress.seconds_left = done ? 0 : forecast.seconds_left();
  }

  void update_progress() {
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

  void unit() {
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

  /// Begins with a weight by which a deviation of half the bound everywhere costs a tenth of the start's energy.
  void begin_search(double bound) {
    const Surface& surface = level->surface();
    within = std::ldexp(bound, -surface.placement().exponent);
    const EnergyValue start = surface.energy().evaluate(surface.start(), nullptr);
    const double half = *within / 2, weight = 0.1 * std::max(start.energy, kEnergyFloor) / (start.area * half * half);
    search.emplace(*within, std::isfinite(weight) && weight > 0 ? weight : 1);
    level = level->with_closeness(search->weight());
  }

  void replace_level(std::unique_ptr<Level> other) {
    level = std::move(other);
    narrower.reset();
    energies.forget();
    progress.phase = Phase::kPrepare;
    update_progress();
  }

  std::optional<Error> retarget(const Targets& targets) {
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

  /// Of a run whose cage has moved.
  void follow_cage(Cage moved) {
    own = std::move(moved);
    fixed_area = fixed_area_of(cage, required_level, options.caps());
    if (search) search.emplace(*within, search->weight());
  }

  LimitReport limit() const {
    if (within) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      const double energy = levels.empty() ? nan : levels.back().energy_reported;
      return {LimitStatus::kNotComparable, energy, nan, nan, nan};
    }
    return extrapolate(energies_of_levels, third_order(options.weights), level->surface().lower_bound());
  }

  void end_level() {
    const EnergyReport report_of_ended = energies.exact(*level);
    levels.push_back(level->report(report_of_ended));
    progress.ended_levels = static_cast<int>(levels.size());
    const LevelReport& report = levels.back();
    if (report.evaluable && !within) {
      const double left = tolerance_of(options) * std::max(report.energy_reported, kEnergyFloor);
      energies_of_levels.push_back({report.energy_reported, left + report_of_ended.quadrature_error,
                                    report_of_ended.functionals[kBending], is_minimized(*level, report),
                                    report_of_ended.credible(),
                                    report.cap_rings});
    }
    if (!cancelled && is_last() && caps_are_in_question()) {
      narrower = best->level->with_narrower_caps();
      progress.phase = Phase::kCompareCaps;
      forecast.level_repeated(narrower->number(), 0, 0);
    } else {
      go_on();
    }
  }

  /// Whether the run ends with the level that has ended.
  bool is_last() const {
    return cancelled || level->number() >= options.last_level || levels.back().stop == StopReason::kNotFinite ||
           (options.accuracy &&
            suffice(static_cast<int>(energies_of_levels.size()), limit(), *options.accuracy));
  }

  /// Whether there is a limit whose error would know that of the caps, if those of the level before were narrower, too.
  bool caps_are_in_question() const {
    const LimitReport found = limit();
    return found.status == LimitStatus::kConverging && !found.caps_included && best &&
           best->level->number() == level->number() - 1 && best->report.cap_rings == levels.back().cap_rings &&
           best->report.cap_rings > 1;
  }

  void compare_caps() {
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

  /// From a level that has ended to the next, or to the result.
  void go_on() {
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
};

Result<Run> Run::create(const Cage& cage, const RunOptions& asked, const Constraints& constraints,
                        const std::optional<SurfaceState>& start) {
  Error error;
  if (!in_range(asked, error)) return error;
  if (start && !in_range(*start, error)) return Error{"start." + error.message};
  if (!in_range(constraints, error)) return Error{"constraints." + error.message};
  if (constraints.closeness && asked.cap == CapKind::kFlat) {
    return Error{"constraints.closeness: caps flat are not linear in the control points; use smooth or none"};
  }
  if (asked.accuracy && constraints.closeness && constraints.closeness->within) {
    return Error{"accuracy: with constraints.closeness.within the levels tell no limit; give levels instead"};
  }
  RunOptions options = asked;
  if (asked.accuracy) options.last_level = asked.first_level;  // chosen below
  Result<RefinedCage> prepared =
      prepare(cage, std::max(options.last_level, start ? start->level : 0), options.symmetry || start, constraints);
  if (!prepared) return prepared.error();
  if (diverges(prepared->mesh, options.caps(), options.weights, error)) return error;
  const bool constrained = prepared->is_constrained();
  auto state = std::make_unique<State>(options, constraints, *prepared, cage);
  state->required_level = required_level(prepared->mesh).value();
  if (options.accuracy) choose_last_level(*prepared, state->required_level, start ? start->level : 0, options);
  state->options = options;
  if (auto error_of_size = too_large_a_run(*prepared, state->required_level, options)) return *error_of_size;
  state->fixed_area = fixed_area_of(*prepared, state->required_level, options.caps());
  if (start) {
    prepared = at_state(std::move(prepared).value(), *start, options.caps(), options.symmetry);
    if (!prepared) return Error{"start: " + prepared.error().message};
    state->has_cages_orbits = start->points.rows() != prepared->mesh.vertex_count();
    if (!options.symmetry) prepared->symmetry = {};
  }
  const int first_level = constrained ? std::max(options.first_level, state->required_level) : options.first_level;
  RefinedCage first = refine(std::move(prepared).value(), first_level - prepared->level);
  if (constrained) {
    const Coordinates coordinates(first.mesh, first.symmetry, held_points(first, options.caps()));
    if (auto error_of_rows = contradiction_of(first, coordinates)) return *error_of_rows;
    first.control = moved_to_equations(first, coordinates);
  }
  LevelOptions level_options = state->level_options();
  level_options.even_parameters = !start || start->level < first.level;
  state->level = std::make_unique<Level>(first, std::max(first.level, state->required_level), level_options);
  if (constraints.closeness && constraints.closeness->within) state->begin_search(*constraints.closeness->within);
  state->begin_forecast(start && start->level >= first.level);
  state->update_progress();
  state->update_forecast();
  return Run(std::move(state));
}

Run::Run(std::unique_ptr<State> state) : state_(std::move(state)) {}
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;
Run::~Run() = default;

bool Run::step(int units) {
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  double booked = 0;
  for (int i = 0; i < units && state_->progress.phase != Phase::kDone; ++i) {
    const std::size_t ended = state_->levels.size();
    const bool compares = state_->narrower != nullptr;
    state_->unit();
    const bool compared = compares && !state_->narrower;
    if (state_->levels.size() > ended || compared) {
      const double now = seconds(), taken = state_->level_seconds + now - booked;
      LevelReport& level = state_->levels.back();
      level.seconds += taken;
      if (compared) {
        state_->forecast.repetition_ended();
      } else {
        state_->forecast.level_ended(level.level, level.evaluations, taken);
      }
      state_->level_seconds = 0;
      booked = now;
    }
  }
  state_->level_seconds += seconds() - booked;
  state_->update_forecast();
  return state_->progress.phase == Phase::kDone;
}

std::optional<Error> Run::retarget(const Targets& targets) { return state_->retarget(targets); }

const Cage& Run::cage() const { return state_->own; }

void Run::cancel() {
  if (state_->progress.phase == Phase::kDone) return;
  state_->cancelled = true;
  if (state_->progress.phase == Phase::kCompareCaps) {
    state_->narrower.reset();
    state_->go_on();
    state_->update_forecast();
    return;
  }
  state_->level->cancel();
  state_->progress.phase = Phase::kReport;
  step(1);
}

Estimate Run::estimate() const { return state_->forecast.estimate(); }
const Progress& Run::progress() const { return state_->progress; }
int Run::patches() const { return state_->level->surface().mesh().surface_face_count(); }
const std::vector<LevelReport>& Run::levels() const { return state_->levels; }
const LevelReport& Run::result() const { return state_->levels[state_->result]; }
const EnergyReport& Run::energies() const { return state_->energies.written(*state_->level, state_->options.caps()); }

const OpinionReport& Run::second_opinion() const {
  return state_->energies.second_opinion(*state_->level, state_->options.caps());
}

GroupReport Run::group() const {
  const SymmetryGroup& group = state_->level->surface().symmetry();
  GroupReport report{group.name, group.order};
  if (!group.complete) report.incomplete = "the search was given up";
  return report;
}

LimitReport Run::limit() const { return state_->limit(); }

std::optional<ConstraintsReport> Run::constraints() const {
  const Surface& surface = state_->level->surface();
  if (!surface.cage().is_constrained()) return std::nullopt;
  ConstraintsReport report = constraints_report(surface, state_->level->best(), state_->held_regions);
  for (HeldRegionReport& region : report.regions) region.first_face = state_->cage_faces[region.first_face - 1] + 1;
  if (state_->level->unknowns() == 0) {
    report.notes.push_back(fmt::format("on level {} nothing can move: what is held determines all control points",
                                       state_->level->number()));
  }
  if (state_->search && !state_->search->binds()) {
    report.notes.push_back("the surface stays within the distance by itself: nothing pulls it");
  }
  return report;
}

Result<Certificate> Run::certify() const {
  const Level& level = *state_->level;
  RefinedCage cage = level.surface().cage();
  cage.control = level.best();
  return Certificate::create(cage, state_->options.caps(), state_->options.weights, level.quadrature(),
                             state_->fixed_area);
}

Cage Run::control_mesh() const { return umbilic::control_mesh(*state_->level); }

std::vector<int> Run::cage_faces() const {
  const RefinedCage cage = state_->level->best_cage();
  return state_->cage_faces.at_level(cage.level, cage.mesh.surface_face_count());
}

Points Run::orbit_points() const {
  const RefinedCage cage = state_->level->best_cage();
  if (!state_->has_cages_orbits) return cage.placement.back(cage.control);
  return cage.placement.back(Coordinates(cage.mesh, cage.symmetry).orbit_points(cage.control));
}

const std::vector<int>& Run::held_faces() const { return state_->held_faces; }

SurfaceState Run::state() const { return {state_->level->number(), orbit_points()}; }

Result<LimitMesh> Run::limit_mesh(int density, const std::optional<Weights>& weights) const {
  const Surface& surface = state_->level->surface();
  if (density < 1) return Error{fmt::format("density {}: expected a number >= 1", density)};
  if (auto error = too_large_a_mesh(surface.mesh(), density)) return *error;
  const Points& best = state_->level->best();
  std::optional<EnergyDensity> energy;
  if (weights) {
    if (Error error; diverges(surface.mesh(), state_->options.caps(), *weights, error)) return error;
    energy = {*weights, surface.energy().evaluate(best, nullptr).area_factor};
  }
  LimitMesh mesh = tessellate(surface.mesh(), surface.symmetry(), surface.whole_layout(), best, density, energy);
  put_back(mesh, surface.placement());
  mesh.cage_faces = state_->cage_faces.at_level(surface.level(), surface.mesh().surface_face_count());
  return mesh;
}

}  // namespace umbilic
