// SPDX-License-Identifier: MIT
/// \file
/// Runs, certifies on the way, and decides the status.
#include "catalog/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbilic::catalog {
namespace {

/// An extrapolation with a relative error larger than this says no more than an upper bound does.
constexpr double kWidestError = 0.1;

/// Completes `run`, level by level. The certificate is computed when a level has ended, before its surface is refined:
/// on the last level with at most `certified_faces` faces.
class Computation {
 public:
  Computation(Run run, const EntrySettings& settings) : run_(std::move(run)), settings_(settings) {}

  /// Returns false if `watch` ended the run.
  bool finish(const Watch& watch) {
    while (run_.progress().phase != Phase::kDone) {
      if (run_.progress().phase == Phase::kReport) {
        if (certifiable() && !certify(watch)) return false;
        if (run_.progress().level == settings_.shown_level) shown_ = surface();
      }
      run_.step(1);
      if (!watch(run_)) return false;
    }
    if (certificate_ && !minimized(certificate_->level)) {
      certificate_.reset();
      descent_.reset();
    }
    return true;
  }

  const Run& run() const { return run_; }
  const std::optional<CertificateReport>& certificate() const { return certificate_; }
  /// A surface below the certified one; nothing unless the settings ask for it, and there is one.
  const std::optional<SurfaceState>& descent() const { return descent_; }
  /// The energy of the certified surface, whose level has ended.
  double certified_energy() const { return level(certificate_->level)->energy_reported; }

  /// Fills in the surface that the entry shows: that of the level that is set, or the best.
  void show(Entry& entry) const {
    entry.result = run_.result();
    const auto level = std::find_if(run_.levels().begin(), run_.levels().end(), [&](const LevelReport& report) {
      return shown_ && report.level == *settings_.shown_level;
    });
    if (level == run_.levels().end() || level->level >= entry.result.level) {
      fill(entry, surface());
    } else {
      entry.result = *level;
      fill(entry, *shown_);
    }
  }

 private:
  struct Shown {
    EnergyReport energies;
    OpinionReport second_opinion;
    std::optional<ConstraintsReport> constraints;
    Points orbit_points;
  };

  /// The run's best.
  Shown surface() const {
    return {run_.energies(), run_.second_opinion(OpinionFaces::kOnePerOrbit), run_.constraints(), run_.orbit_points()};
  }

  static void fill(Entry& entry, const Shown& shown) {
    entry.energies = shown.energies;
    entry.second_opinion = shown.second_opinion;
    entry.constraints = shown.constraints;
    entry.orbit_points = shown.orbit_points;
  }

  /// The report of a level; null if there is none.
  const LevelReport* level(int number) const {
    const auto found = std::find_if(run_.levels().begin(), run_.levels().end(),
                                    [&](const LevelReport& report) { return report.level == number; });
    return found == run_.levels().end() ? nullptr : &*found;
  }

  bool minimized(int number) const {
    const LevelReport* report = level(number);
    return report && (report->stop == StopReason::kConverged || report->stop == StopReason::kRoundOff);
  }

  bool certifiable() const {
    if (!settings_.certified_faces) return false;
    const int faces = run_.patches();
    return faces <= *settings_.certified_faces &&
           (4 * faces > *settings_.certified_faces || run_.progress().level == settings_.run.last_level);
  }

  bool certify(const Watch& watch) {
    Result<Certificate> certificate = run_.certify();
    if (!certificate) return true;
    while (!certificate->step()) {
      if (!watch(run_)) return false;
    }
    if (const Result<CertificateReport> report = certificate->report()) certificate_ = *report;
    if (settings_.descends) descent_ = certificate->descent();
    return true;
  }

  Run run_;
  const EntrySettings& settings_;
  std::optional<CertificateReport> certificate_;
  std::optional<SurfaceState> descent_;
  std::optional<Shown> shown_;
};

Result<Run> create_run(const CatalogShape& shape, const EntrySettings& settings, const CageOptions& options) {
  const Result<Cage> cage = generate_cage(shape.generator, options);
  if (!cage) return cage.error();
  return Run::create(*cage, settings.run, settings.constraints);
}

std::string reason_of(const LimitReport& limit, const std::vector<LevelReport>& levels) {
  switch (limit.status) {
    case LimitStatus::kConverging: return "";
    case LimitStatus::kNotResolved: return "the last level's energies are not its surface's";
    case LimitStatus::kNotComparable: return "each level is pulled to the cage's own surface with another weight";
    case LimitStatus::kTooFewLevels: return "three levels are needed to tell a limit";
    case LimitStatus::kNotMinimized:
      for (const LevelReport& level : levels) {
        if (level.stop != StopReason::kConverged) {
          return fmt::format("level {} ended before it had converged ({})", level.level, name_of(level.stop));
        }
      }
      return "a level ended before it had converged";
    case LimitStatus::kNotConverging: {
      const double last = levels.back().energy_reported, before = levels[levels.size() - 2].energy_reported;
      return fmt::format("the levels are in no asymptotic range: the energy changes by {:.2g} % from level {} to {}",
                         100 * (last - before) / before, levels[levels.size() - 2].level, levels.back().level);
    }
  }
  return "";
}

void judge(Entry& entry) {
  const double least = entry.result.energy_reported;
  entry.energy = least;
  if (!std::isfinite(least)) {
    entry.status = EntryStatus::kNoneFound;
    entry.reason = "no surface of finite energy was found";
  } else if (!entry.energies.credible()) {
    entry.status = EntryStatus::kNoneFound;
    entry.reason = "no level has energies that can be a surface's";
  } else if (entry.exact && entry.exact->energy == 0) {
    entry.status = EntryStatus::kZeroAttained;
    entry.energy = 0;
    entry.reason = "attained by " + entry.exact->source;
  } else if (entry.exact && !entry.exact->attained) {
    entry.status = EntryStatus::kInfimumNotAttained;
    entry.energy = entry.exact->energy;
    entry.reason = entry.exact->source;
  } else if (entry.limit.status == LimitStatus::kConverging && entry.limit.error > kWidestError * least) {
    entry.status = EntryStatus::kUpperBound;
    entry.reason = fmt::format("the levels leave an error of {:.2g} %", 100 * entry.limit.error / least);
  } else if (entry.limit.status == LimitStatus::kConverging) {
    entry.status = EntryStatus::kConverged;
    entry.energy = entry.limit.energy;
    entry.error = entry.limit.error;
  } else {
    entry.status = EntryStatus::kUpperBound;
    entry.reason = reason_of(entry.limit, entry.levels);
  }
}

}  // namespace

std::string_view name_of(EntryStatus status) {
  switch (status) {
    case EntryStatus::kConverged: return "converged";
    case EntryStatus::kUpperBound: return "upper_bound";
    case EntryStatus::kZeroAttained: return "zero_attained";
    case EntryStatus::kInfimumNotAttained: return "infimum_not_attained";
    case EntryStatus::kNoneFound: return "none_found";
  }
  return "";
}

std::optional<Entry> compute_entry(const CatalogShape& shape, const CatalogFunctional& functional,
                                   const EntrySettings& settings, const Watch& watch) {
  Computation computation(create_run(shape, settings, settings.cage).value(), settings);
  if (!computation.finish(watch)) return std::nullopt;
  const Run& run = computation.run();
  Entry entry;
  entry.shape = shape;
  entry.functional = functional;
  entry.settings = settings;
  entry.paper = paper_energy(shape, functional);
  entry.exact = exact_energy(shape, functional);
  entry.group = run.group();
  computation.show(entry);
  entry.levels = run.levels();
  entry.limit = run.limit();
  entry.certificate = computation.certificate();
  if (computation.descent()) {
    Problem problem{.cage = GeneratedCage{shape.generator, settings.cage}, .options = settings.run};
    problem.options.last_level = computation.descent()->level;
    problem.start = computation.descent();
    if (!descend(std::move(problem), computation.certified_energy(), watch, entry.below)) return std::nullopt;
  }
  if (settings.second_family) {
    CageOptions options = settings.cage;
    options.family = *settings.second_family;
    EntrySettings plain = settings;
    plain.certified_faces.reset();
    plain.descends = false;
    plain.shown_level.reset();
    plain.run.last_level = settings.second_last_level;
    Computation other(create_run(shape, plain, options).value(), plain);
    if (!other.finish(watch)) return std::nullopt;
    entry.second = SecondFamily{options.family, other.run().limit(), other.run().levels()};
  }
  judge(entry);
  return entry;
}

std::optional<StartResult> compute_start(const Start& start, const EntrySettings& settings, const Watch& watch) {
  Computation computation(create_run(shape_called(start.shape), settings, settings.cage).value(), settings);
  if (!computation.finish(watch)) return std::nullopt;
  return StartResult{start, computation.run().levels().back()};
}

std::optional<bool> agree(const LimitReport& a, const LimitReport& b) {
  if (a.status != LimitStatus::kConverging || b.status != LimitStatus::kConverging) return std::nullopt;
  return std::abs(a.energy - b.energy) <= a.error + b.error;
}

}  // namespace umbilic::catalog
