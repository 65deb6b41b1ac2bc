// SPDX-License-Identifier: MIT
/// \file
/// One run: a cage, refined level by level and minimized on each, that can be stepped, watched, cancelled and read at
/// any time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "driver/certificate.h"
#include "driver/limit_mesh.h"
#include "driver/symmetric_cage.h"
#include "problem/options.h"
#include "problem/progress.h"
#include "problem/report.h"

namespace umbilic {

struct StartingCage;

class Run {
 public:
  /// Fails when the cage has a vertex of valence 2 or above 24 (after one step, which turns faces into vertices of
  /// their size), the weights are unusable, or the refined mesh would have more than kMaxFaces faces (2 million) or the
  /// run take more than kMostRunBytes of memory (driver/memory.h).
  static Result<Run> create(const Cage& cage, const RunOptions& options);
  /// The same from a refined mesh, whose levels count from the cage that it comes from: levels before its own are left
  /// out. Where its symmetry is known, there is no search for it.
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

  /// Faces of the mesh that the current level's surface is evaluated on.
  int patches() const;

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

  /// The best surface so far, small enough to be kept.
  SurfaceState state() const;

  /// All energies of the best surface so far by the reporting rule, with the quadrature error. One unit's work, several
  /// times the cost of an evaluation; cached until the surface changes. Of a cage that is not about the origin they are
  /// those of `control_mesh`, whose coordinates are rounded to where they lie; the levels' energies are not.
  const EnergyReport& energies() const;

  /// The best surface so far, `density` >= 1 quads along each edge of a patch. Fails where the mesh would take more
  /// than kMostMeshBytes (driver/memory.h), and names the largest density that would not.
  Result<LimitMesh> limit_mesh(int density) const;

 private:
  struct State;
  static Result<Run> begin(const StartingCage& start, const RunOptions& options);
  explicit Run(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All energies of the cage's surface after `levels` Catmull-Clark steps (raised when the cage needs more). Fails as
/// `Run::create`, and where a part of the surface is a curve or a point, which has no curvature.
Result<EvaluationReport> evaluate(const Cage& cage, CapKind cap, int levels);

/// Compares the analytic gradient along random directions with central differences of the energy.
/// The surface is the cage's at the first level that it can be evaluated at. Fails as `Run::create`.
Result<GradientReport> check_gradient(const Cage& cage, const Weights& weights, CapKind cap);

}  // namespace umbilic
