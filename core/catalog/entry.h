// SPDX-License-Identifier: MIT
/// \file
/// One entry of the catalog: a minimizer, its energies, and how well they are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/descent.h"
#include "catalog/reference.h"
#include "catalog/settings.h"

namespace umbilic::catalog {

enum class EntryStatus {
  kConverged,           ///< the levels' energies tend to `energy` +- `error`
  kUpperBound,          ///< the energy of an actual surface; its levels determine no limit
  kZeroAttained,        ///< surfaces of energy 0 are known
  kInfimumNotAttained,  ///< the infimum is known, but no surface has it
  kNoneFound,           ///< no surface of finite energy
};

/// "converged", "upper_bound", "zero_attained", "infimum_not_attained", "none_found".
std::string_view name_of(EntryStatus status);

/// The result for the same shape from the other family of cages.
struct SecondFamily {
  FrameFamily family;
  LimitReport limit;
  std::vector<LevelReport> levels;
};

struct Entry {
  CatalogShape shape;
  CatalogFunctional functional;
  EntrySettings settings;
  EntryStatus status = EntryStatus::kNoneFound;
  double energy = 0;
  std::optional<double> error;
  std::string reason;  ///< why there is no error bar; empty if there is one
  std::optional<double> paper;
  std::optional<ExactEnergy> exact;
  GroupReport group;
  EnergyReport energies;         ///< of the minimizer that is shown: the best level's, or EntrySettings::shown_level's
  LevelReport result;            ///< that level
  OpinionReport second_opinion;  ///< of that surface, from one face of each orbit
  std::vector<LevelReport> levels;
  LimitReport limit;
  std::optional<ConstraintsReport> constraints;  ///< what the boundary of that surface is held with
  std::optional<CertificateReport> certificate;
  std::optional<LowerMinimizer> below;  ///< what it descends to, where EntrySettings::descends
  std::optional<SecondFamily> second;
  Points orbit_points;  ///< of that minimizer, see driver/surface_state.h
};

/// Nothing if `watch` ended it.
std::optional<Entry> compute_entry(const CatalogShape& shape, const CatalogFunctional& functional,
                                   const EntrySettings& settings, const Watch& watch);

struct StartResult {
  Start start;
  LevelReport last;  ///< level
};

std::optional<StartResult> compute_start(const Start& start, const EntrySettings& settings, const Watch& watch);

/// Whether two results agree within their error bars; nothing if one has no error bar.
std::optional<bool> agree(const LimitReport& a, const LimitReport& b);

}  // namespace umbilic::catalog
