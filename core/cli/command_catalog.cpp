// SPDX-License-Identifier: MIT
/// \file
/// `umbilic catalog`: computes the catalog, or recomputes it and compares.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <set>

#include "base/threads.h"
#include "cage/text.h"
#include "catalog/comparison.h"
#include "catalog/runner.h"
#include "cli/arguments.h"
#include "cli/catalog_folder.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "problem/text.h"

namespace umbilic::cli {

using namespace catalog;

namespace {

struct CatalogArguments {
  std::string folder;
  std::set<std::string> shapes, functionals;  ///< all if empty
  int threads = hardware_threads();
  int last_level = kMostLevels;
  bool anew = false;
  bool check = false;
  bool quiet = false;

  bool wants(const std::string& shape, const std::string& functional) const {
    return (shapes.empty() || shapes.contains(shape)) && (functionals.empty() || functionals.contains(functional));
  }
};

/// The tasks of a command on one folder, their results, and errors.
class Session {
 public:
  Session(CatalogFolder folder, const CatalogArguments& arguments)
      : folder_(std::move(folder)), arguments_(arguments) {}

  int run() {
    for (const CatalogShape& shape : catalog_shapes()) {
      for (const CatalogFunctional& functional : catalog_functionals()) {
        if (has_entry(shape, functional) && arguments_.wants(shape.name, functional.name)) add(shape, functional);
      }
    }
    for (const Start& start : catalog_starts()) {
      if (arguments_.wants(start.shape, start.functional)) add(start);
    }
    const InterruptWatch watch;
    CatalogBar bar(arguments_.quiet);
    const bool all = run_tasks(std::move(tasks_), [&](const CatalogProgress& progress) {
      bar.update(progress);
      return !watch.interrupted() && !failed_;
    });
    if (failed_) return fail(kCannotWrite, error_);
    if (!all && arguments_.check) return fail(kInterrupted, "interrupted before all was compared");
    if (!all) return kInterrupted;
    if (!arguments_.check) return kEnded;
    if (!print(summary())) return kCannotWrite;
    return different_ > 0 ? kMismatch : kEnded;
  }

 private:
  std::string summary() const {
    std::string text = fmt::format("{} compared, {} differ\n", compared_, different_);
    if (other_kernels_ > 0) {
      text +=
          fmt::format("{} of these {} stored with the kernels of another instruction set: compared to error bars, {}\n",
                      other_kernels_, other_kernels_ == 1 ? "was" : "were", "to 1e-3 where there are none");
    }
    return text;
  }

  void add(const CatalogShape& shape, const CatalogFunctional& functional) {
    const EntrySettings settings = entry_settings(shape, functional, arguments_.last_level);
    if (!arguments_.check && !arguments_.anew && folder_.has(shape, functional, settings)) return;
    tasks_.push_back({entry_name(shape, functional), cost_of(shape, settings), [=, this](const Watch& watch) {
                        if (const auto entry = compute_entry(shape, functional, settings, watch)) take(*entry);
                      }});
  }

  void add(const Start& start) {
    const EntrySettings settings = start_settings(start, arguments_.last_level);
    if (!arguments_.check && !arguments_.anew && folder_.has(start, settings)) return;
    const std::string name = fmt::format("{}.{} from thickness {}", start.shape, start.functional, start.thickness);
    tasks_.push_back({name, cost_of(shape_called(start.shape), settings), [=, this](const Watch& watch) {
                        if (const auto result = compute_start(start, settings, watch)) take(*result);
                      }});
  }

  void take(const Entry& entry) {
    const std::lock_guard lock(mutex_);
    if (!arguments_.check) return note(folder_.keep(entry));
    const Json* stored = folder_.entry(entry.shape, entry.functional);
    const std::string name = entry_name(entry.shape, entry.functional);
    if (!stored) return compare(name, "it is not in the catalog");
    const Result<std::string> minimizer = folder_.minimizer(*stored);
    if (!minimizer) return compare(name, minimizer.error().message);
    const Result<Report> report = parse_report(*minimizer);
    if (!report) return compare(name, report.error().message);
    std::string what = difference(*stored, json_of(entry), note_kernels(report->instruction_set));
    if (what.empty()) what = misfit(*stored, *minimizer);
    compare(name, what);
  }

  void take(const StartResult& result) {
    const std::lock_guard lock(mutex_);
    if (!arguments_.check) return note(folder_.keep(result));
    const Json* stored = folder_.start(result.start);
    const std::string name =
        fmt::format("{}.{} from thickness {}", result.start.shape, result.start.functional, result.start.thickness);
    if (!stored) return compare(name, "it is not in the catalog");
    const Kernels kernels = note_kernels(stored->value("instruction_set", ""));
    compare(name, start_difference(*stored, json_of(result), kernels));
  }

  Kernels note_kernels(const std::string& instruction_set) {
    const Kernels kernels = kernels_of(instruction_set);
    if (kernels == Kernels::kOther) ++other_kernels_;
    return kernels;
  }

  void note(const std::optional<Error>& error) {
    if (!error || failed_) return;
    failed_ = true;
    error_ = error->message;
  }

  void compare(const std::string& name, const std::string& what) {
    ++compared_;
    if (what.empty()) return;
    ++different_;
    print(fmt::format("{}: {}\n", name, what));
  }

  CatalogFolder folder_;
  const CatalogArguments& arguments_;
  std::vector<CatalogTask> tasks_;
  std::mutex mutex_;  // protects the members below, and `folder_` while tasks run
  std::atomic<bool> failed_ = false;
  std::string error_;
  int compared_ = 0, different_ = 0, other_kernels_ = 0;
};

int run(const CatalogArguments& arguments) {
  use_threads(arguments.threads);
  Result<CatalogFolder> folder = CatalogFolder::open(arguments.folder);
  if (!folder) return fail(kBadInput, folder.error().message);
  return Session(std::move(folder).value(), arguments).run();
}

template <class Named>
CLI::Validator known(const std::vector<Named>& list) {
  return checked([&list](const std::string& name) -> Result<std::string> {
    std::string names;
    for (const Named& item : list) {
      if (item.name == name) return name;
      names += (names.empty() ? "" : ", ") + item.name;
    }
    return Error{fmt::format("{} is none of {}", in_quotes(name), names)};
  });
}

}  // namespace

void add_catalog_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("catalog", "Compute the minimizers of the catalog and their energies");
  const auto arguments = std::make_shared<CatalogArguments>();
  command->add_option("--out", arguments->folder, "The catalog's folder: catalog.json and a file per minimizer")
      ->type_name("DIR")
      ->required();
  command->add_option("--shape", arguments->shapes, "Only this shape; may be repeated [all]")
      ->type_name("NAME")
      ->check(known(catalog_shapes()));
  command->add_option("--functional", arguments->functionals, "Only this functional; may be repeated [all]")
      ->type_name("NAME")
      ->check(known(catalog_functionals()));
  add_threads_option(*command, arguments->threads);
  const auto parse_level = [](const std::string& text) { return parse_count(text, 0, kMostLevels); };
  command
      ->add_option_function<std::string>(
          "--last-level",
          [arguments, parse_level](const std::string& text) { arguments->last_level = parse_level(text).value(); },
          "No level beyond L, for a quick look")
      ->type_name("L")
      ->check(checked(parse_level));
  command->add_flag("--anew", arguments->anew, "Compute also what is there with the same settings and version");
  command->add_flag("--check", arguments->check,
                    "Compute everything again and compare instead of writing: exit code 1\nwhere an energy differs by "
                    "more than rounding explains");
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on standard error");
  command->footer("Ctrl-C keeps what is finished; the same command goes on from there.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace umbilic::cli
