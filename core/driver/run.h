// SPDX-License-Identifier: MIT
/// \file
/// One run: a cage, refined level by level and minimized on each, that can be stepped, watched, cancelled and read at
/// any time.
///
/// Its result is the best surface of all levels. Levels are not nested, as caps shrink from one to the next, so that an
/// energy can rise: a little in ordinary runs, much on rough cages, where a finer level shows curvature that the one
/// before missed. Of the levels whose energies can be a surface's (driver/contradiction.h) the one with the least
/// energy by the reporting rule is the result; where there is none, of those that only miss curvature; and of evaluable
/// levels before those that prepare the first of them. While the run goes on, "the best surface so far" is that of the
/// current level.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "driver/certificate.h"
#include "driver/limit_mesh.h"
#include "driver/symmetric_cage.h"
#include "problem/options.h"
#include "problem/report.h"

namespace umbilic {

struct StartingCage;

/// What a run is about to do; every `step` finishes at most one of these.
enum class Phase { kPrepare, kMinimize, kReport, kDone };

struct Progress {
  Phase phase = Phase::kPrepare;
  int level = 0;              ///< the current one, or the result's when the run is done
  int iterations = 0;         ///< in this level
  int evaluations = 0;        ///< in this level
  int total_evaluations = 0;  ///< over all levels
  /// Of the best surface of this level, by the minimizing rule; NaN before the first evaluation. Where the surface
  /// makes use of that rule's error the level goes on from it with a finer rule, by which its energy is higher.
  double energy = 0;
  double gradient_norm = 0;       ///< Euclidean, of the best surface, with respect to the control points
  double predicted_decrease = 0;  ///< estimate of what this level can still gain; NaN before the first iteration
};

class Run {
 public:
  /// Fails when the cage has a vertex of valence 2 or above 24 (after one step, which turns faces into vertices of
  /// their size), the weights are unusable, or the refined mesh would have more than 2 million faces.
  static Result<Run> create(const Cage& cage, const RunOptions& options);
  /// The same, without a search for the symmetry.
  static Result<Run> create(const SymmetricCage& cage, const RunOptions& options);

  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;
  ~Run();

  /// Does up to `units` units of work: one energy evaluation each, or one part of a level's preparation of no greater
  /// cost. Returns whether the run is done; further calls do nothing.
  bool step(int units);

  /// Ends the run at once; what there is so far is its result. The current level's stop reason is kCancelled unless it
  /// had just ended by itself.
  void cancel();

  const Progress& progress() const;

  /// Faces of the mesh that the current level's surface is evaluated on, or the result's.
  int patches() const;

  /// The level whose surface is the result. The run is done; then `progress` is that of this level, too.
  const LevelReport& result() const;

  /// The levels ended so far, in order.
  const std::vector<LevelReport>& levels() const;

  /// The symmetry that the run keeps; C1 where there is none or none is wanted.
  GroupReport group() const;

  /// The limit of the levels ended so far.
  LimitReport limit() const;

  /// Counts the negative directions at the best surface so far; see CertificateReport. Fails for `flat` caps, whose
  /// normal directions the Hessian takes as fixed, and for meshes of more than kMaxCertifiedFaces faces.
  Result<Certificate> certify() const;

  /// The control mesh of the best surface so far.
  Cage control_mesh() const;

  /// The points of the first vertex of each orbit of `control_mesh`; see driver/symmetric_cage.h.
  Points orbit_points() const;

  /// All energies of the best surface so far by the reporting rule, with the quadrature error. One unit's work, several
  /// times the cost of an evaluation; cached until the surface changes.
  const EnergyReport& energies() const;

  /// The best surface so far, `density` >= 1 quads along each edge of a patch.
  LimitMesh limit_mesh(int density) const;

 private:
  struct State;
  static Result<Run> begin(const StartingCage& start, const RunOptions& options);
  explicit Run(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All energies of the cage's surface after `levels` Catmull-Clark steps (raised when the cage needs more). Fails as
/// `Run::create`.
Result<EvaluationReport> evaluate(const Cage& cage, CapKind cap, int levels);

/// Compares the analytic gradient along random directions with central differences of the energy.
/// The surface is the cage's at the first level that it can be evaluated at. Fails as `Run::create`.
Result<GradientReport> check_gradient(const Cage& cage, const Weights& weights, CapKind cap);

}  // namespace umbilic
