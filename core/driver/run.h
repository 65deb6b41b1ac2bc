// SPDX-License-Identifier: MIT
/// \file
/// One run: a cage, refined level by level and minimized on each. It can be stepped, cancelled and read at any time.
///
/// Its result is the best surface of all levels. Levels are not nested, as caps shrink from one to the next, so that an
/// energy can rise: a little in ordinary runs, much on rough cages, where a finer level shows curvature that the one
/// before missed. Of the levels whose energies can be a surface's (driver/contradiction.h) the one with the least
/// energy by the reporting rule is the result; where there is none, of those that only miss curvature; and of evaluable
/// levels before those that prepare the first of them. While the run goes on, "the best surface so far" is that of the
/// current level.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "driver/certificate.h"
#include "driver/limit_mesh.h"
#include "problem/estimate.h"
#include "problem/problem.h"
#include "problem/progress.h"
#include "problem/report.h"
#include "problem/targets.h"

namespace umbilic {

class Run {
 public:
  /// Fails when the cage has a vertex of valence 2 or above 24 (after one step, which turns faces into vertices of
  /// their size), the weights are unusable, or the refined mesh would have more than kMaxFaces faces (2 million) or the
  /// run take more than kMostRunBytes of memory (driver/memory.h).
  ///
  /// With `options.accuracy` the run ends with the first level from which the limit is known so well (`limit`). There
  /// are at most five levels that can be evaluated, and no more than fit; a level is not minimized further than
  /// matters.
  ///
  /// If `start` is given, it begins with that surface, and levels below that one's are left out. Fails, too, if the
  /// constraints or the start do not fit the cage.
  static Result<Run> create(const Cage& cage, const RunOptions& options, const Constraints& constraints = {},
                            const std::optional<SurfaceState>& start = {});

  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;
  ~Run();

  /// Does up to `units` units of work. A unit is one energy evaluation, or a part of a level's preparation that costs
  /// no more. Returns whether the run is done; further calls do nothing.
  bool step(int units);

  /// Changes the weights, the pins' targets, the pull to the cage's own surface and the points of the cage of a run,
  /// ended or not, which goes on from its best surface at the level where that is. What was known of levels so far is
  /// forgotten: the levels, the limit and the best surface are those since then. The next steps find where the surface
  /// goes to first order with the metric that is there, before one is built anew.
  ///
  /// Points are those of the cage that was given, as many and of the same faces. What is held is then where a run from
  /// the moved cage would hold it, to the last bit where its unit coordinates are the same, since this run keeps those
  /// of its first cage; what is free follows as smoothly as it can, and by the metric. Where nothing is held and
  /// nothing pulls, the surface stays.
  ///
  /// Of its symmetry the run keeps what the targets have. If they do not fit the problem, or contradict one another,
  /// the run stays as it is.
  std::optional<Error> retarget(const Targets& targets);

  /// The cage, with its points where the latest targets have them.
  const Cage& cage() const;

  /// Ends the run at once. Its result is what has been computed so far. The stop reason of the current level is
  /// kCancelled unless it had just ended by itself.
  void cancel();

  const Progress& progress() const;

  /// How long the run will probably take from its start, or from its latest targets, and how much memory: as known then
  /// (driver/estimate.h). What is left of that, `progress` tells.
  Estimate estimate() const;

  /// Faces of the mesh that the current level's surface is evaluated on, or the result's.
  int patches() const;

  /// The level whose surface is the result. The run is done; then `progress` is that of this level, too.
  const LevelReport& result() const;

  /// The levels ended so far, in order.
  const std::vector<LevelReport>& levels() const;

  /// The symmetry that the run keeps; C1 if there is none or it is not to be kept.
  GroupReport group() const;

  /// The limit of the levels ended so far.
  LimitReport limit() const;

  /// What the constraints do to the best surface so far; empty without any. Costs several evaluations.
  std::optional<ConstraintsReport> constraints() const;

  /// Begins to count the negative directions at the best surface so far; see CertificateReport. Fails for `flat` caps,
  /// whose normals the Hessian holds fixed, and for meshes of more than kMaxCertifiedFaces faces.
  Result<Certificate> certify() const;

  /// The control mesh of the best surface so far.
  Cage control_mesh() const;

  /// Of each face of `control_mesh`: the face of the cage that it descends from.
  std::vector<int> cage_faces() const;

  /// The faces of the cage whose surface is held, also those to which constraints.symmetric copies others; sorted.
  const std::vector<int>& held_faces() const;

  /// The points of the first vertex of each orbit of `control_mesh`, or of all its vertices if the run has started from
  /// points of all; see driver/surface_state.h.
  Points orbit_points() const;

  /// The best surface so far, in a compact form for saving.
  SurfaceState state() const;

  /// All energies of the best surface so far by the reporting rule, with the quadrature error. One unit's work, several
  /// times the cost of an evaluation; cached until the surface changes. Of a cage that is not about the origin they are
  /// those of `control_mesh`, whose coordinates are rounded to where they lie; the levels' energies are not.
  const EnergyReport& energies() const;

  /// What another way of computing finds of the best surface so far; see driver/second_opinion.h. Costs far more than
  /// an evaluation; cached until the surface changes.
  const OpinionReport& second_opinion(OpinionFaces faces = OpinionFaces::kAll) const;

  /// The best surface so far, `density` >= 1 quads along each edge of a patch. Fails where the mesh would take more
  /// than kMostMeshBytes (driver/memory.h), and names the largest density that would not.
  /// With weights it has the densities of their functionals (driver/tessellate.h), which need not be those that are
  /// minimized; fails, too, where their energy is infinite.
  Result<LimitMesh> limit_mesh(int density, const std::optional<Weights>& weights = {}) const;

 private:
  struct State;
  explicit Run(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All energies of the cage's surface after `levels` Catmull-Clark steps (raised when the cage needs more). Fails as
/// `Run::create`, and where a part of the surface is a curve or a point, which has no curvature. With `opinion` the
/// report also has what another way of computing finds (driver/second_opinion.h), from the cage on.
Result<EvaluationReport> evaluate(const Cage& cage, CapChoice cap, int levels, bool opinion = false);

/// Compares the analytic gradient along random directions with central differences of the energy, on the cage's surface
/// at the first evaluable level. Fails as `Run::create`.
Result<GradientReport> check_gradient(const Cage& cage, const Weights& weights, CapChoice cap);

}  // namespace umbilic
