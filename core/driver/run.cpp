// SPDX-License-Identifier: MIT
/// \file
/// Begins a run, keeps its time, and reads its state.
#include "driver/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "driver/accuracy.h"
#include "driver/equations.h"
#include "driver/fixed_area.h"
#include "driver/memory.h"
#include "driver/run_state.h"
#include "driver/surface_state.h"
#include "driver/tessellate.h"
#include "mesh/coordinates.h"
#include "mesh/hierarchy.h"

namespace umbilic {

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

const OpinionReport& Run::second_opinion(OpinionFaces faces) const {
  return state_->energies.second_opinion(*state_->level, state_->options.caps(), faces);
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
