// SPDX-License-Identifier: MIT
/// \file
/// One entry of the catalog: a minimizer, its energies, and what is known of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "catalog/reference.h"
#include "catalog/settings.h"

namespace umbilic::catalog {

enum class EntryStatus {
  kConverged,           ///< the levels' energies tend to `energy` +- `error`
  kUpperBound,          ///< of a genuine surface, whose levels tell no limit
  kZeroAttained,        ///< surfaces of energy 0 are known
  kInfimumNotAttained,  ///< it is known
  kNoneFound,           ///< no surface of finite energy
};

/// "converged", "upper_bound", "zero_attained", "infimum_not_attained", "none_found".
std::string_view name_of(EntryStatus status);

/// The same shape from the other family of cages.
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
  std::string reason;  ///< why there is no error, empty where there is one
  std::optional<double> paper;
  std::optional<ExactEnergy> exact;
  GroupReport group;
  EnergyReport energies;  ///< of the best level's minimizer
  LevelReport result;     ///< that level
  std::vector<LevelReport> levels;
  LimitReport limit;
  std::optional<CertificateReport> certificate;
  std::optional<SecondFamily> second;
  Points orbit_points;  ///< of the best level's minimizer, see driver/symmetric_cage.h
};

/// Says where a computation stands and returns whether it is to go on.
using Watch = std::function<bool(const Run&)>;

/// Nothing where `watch` ends it.
std::optional<Entry> compute_entry(const CatalogShape& shape, const CatalogFunctional& functional,
                                   const EntrySettings& settings, const Watch& watch);

struct StartResult {
  Start start;
  LevelReport last;  ///< level
};

std::optional<StartResult> compute_start(const Start& start, const EntrySettings& settings, const Watch& watch);

/// Whether two results agree within their error bars; nothing where one has none.
std::optional<bool> agree(const LimitReport& a, const LimitReport& b);

}  // namespace umbilic::catalog
