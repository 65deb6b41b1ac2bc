// SPDX-License-Identifier: MIT
/// \file
/// Runs and certificates.
#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "driver/surface.h"
#include "problem/text.h"
#include "wasm/api.h"
#include "wasm/guard.h"
#include "wasm/handles.h"

using namespace umbilic;
using namespace umbilic::api;

namespace {

/// A group with the numbers of its faces, from 1.
struct NumberedGroup {
  std::string name;
  std::vector<int> faces;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("name", self.name);
    visit("faces", self.faces);
  }
};

std::vector<int> from_one(std::vector<int> numbers) {
  for (int& number : numbers) ++number;
  return numbers;
}

std::vector<NumberedGroup> numbered(const std::vector<FaceGroup>& groups) {
  std::vector<NumberedGroup> result;
  for (const FaceGroup& group : groups) result.push_back({group.name, from_one(group.faces)});
  return result;
}

/// Replaces the points of the problem.
umbilic_status take_points(Problem& problem, const double* points, size_t count) {
  if (!points) return count == 0 ? UMBILIC_OK : fail(UMBILIC_BAD_ARGUMENT, "a null pointer");
  if (!problem.start) return fail(UMBILIC_BAD_ARGUMENT, "points without the problem's start, which tells their level");
  if (count > static_cast<size_t>(kMaxFaces) * 4) return fail(UMBILIC_BAD_ARGUMENT, "more points than a mesh can have");
  problem.start->points = Eigen::Map<const Points>(points, static_cast<Eigen::Index>(count), 3);
  return UMBILIC_OK;
}

template <class Handle>
bool usable(const Handle& handle) {
  if (handle.broken) fail(UMBILIC_BAD_ARGUMENT, "it ran out of memory before and takes no more calls");
  return !handle.broken;
}

/// Whether the report can be read.
bool ready(const umbilic_certificate& certificate) {
  const bool there = certificate.ended && certificate.certificate.report().ok();
  if (!there) fail(UMBILIC_BAD_ARGUMENT, "the certificate is not ready");
  return there;
}

/// Runs `work`, which changes the object behind the handle. If it throws, the object may be half changed, so it is
/// marked as broken.
template <class Handle, class Work>
auto changing(Handle& handle, const Work& work) {
  handle.broken = true;
  auto result = work();
  handle.broken = false;
  return result;
}

umbilic_status limit_mesh(const umbilic_run* run, int32_t density, const std::optional<Weights>& weights,
                          umbilic_mesh** out) {
  if (!all_given(run, out) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
  if (density < 1) return fail(UMBILIC_BAD_ARGUMENT, fmt::format("density {}: expected at least 1", density));
  Result<LimitMesh> mesh = run->run.run.limit_mesh(density, weights);
  if (!mesh) return fail(mesh.error());
  hand_out(std::move(mesh).value(), out);
  return UMBILIC_OK;
}

}  // namespace

umbilic_status umbilic_run_create(const char* text, size_t length, const double* points, size_t count,
                                  umbilic_run** out) {
  return guarded([&] {
    if (!all_given(text, out)) return UMBILIC_BAD_ARGUMENT;
    Result<Problem> problem = parse_problem({text, length});
    if (!problem) return fail(problem.error());
    if (const umbilic_status status = take_points(*problem, points, count); status != UMBILIC_OK) return status;
    Result<ProblemRun> run = begin_run(std::move(problem).value());
    if (!run) return fail(run.error());
    *out = new umbilic_run{std::move(run).value()};
    return UMBILIC_OK;
  });
}

void umbilic_run_destroy(umbilic_run* run) { delete run; }

umbilic_status umbilic_run_step(umbilic_run* run, int32_t units, int32_t* done) {
  return guarded([&] {
    if (!all_given(run, done) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    if (units < 0) return fail(UMBILIC_BAD_ARGUMENT, fmt::format("{} units", units));
    *done = changing(*run, [&] { return run->run.run.step(units); });
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_run_retarget(umbilic_run* run, const char* text, size_t length) {
  return guarded([&] {
    if (!all_given(run, text) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    const Result<Targets> targets = parse_targets({text, length});
    if (!targets) return fail(targets.error());
    const std::optional<Error> error = changing(*run, [&] { return run->run.retarget(*targets); });
    return error ? fail(*error) : UMBILIC_OK;
  });
}

umbilic_status umbilic_run_cancel(umbilic_run* run) {
  return guarded([&] {
    if (!all_given(run) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    changing(*run, [&] {
      run->run.run.cancel();
      return true;
    });
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_run_part(const umbilic_run* handle, int32_t part, umbilic_text* text) {
  return guarded([&] {
    if (!all_given(handle, text) || !usable(*handle)) return UMBILIC_BAD_ARGUMENT;
    const Run& run = handle->run.run;
    switch (part) {
      case UMBILIC_PART_PROGRESS: return answer(json_text(run.progress()), text);
      case UMBILIC_PART_PROBLEM: return answer(problem_text(handle->run.problem, JsonPrinter::Layout::kCompact), text);
      case UMBILIC_PART_CAGE: return answer(json_text(handle->run.cage), text);
      case UMBILIC_PART_GROUP: return answer(json_text(run.group()), text);
      case UMBILIC_PART_LEVELS: return answer(json_text(run.levels()), text);
      case UMBILIC_PART_LIMIT: return answer(json_text(run.limit()), text);
      case UMBILIC_PART_ENERGIES: return answer(json_text(run.energies()), text);
      case UMBILIC_PART_GROUPS: return answer(json_text(numbered(handle->run.groups)), text);
      case UMBILIC_PART_ESTIMATE: return answer(json_text(run.estimate()), text);
      case UMBILIC_PART_HELD: return answer(json_text(from_one(run.held_faces())), text);
    }
    return fail(UMBILIC_BAD_ARGUMENT, fmt::format("a run has no part {}", part));
  });
}

umbilic_status umbilic_run_report(const umbilic_run* run, const umbilic_certificate* certificate,
                                  umbilic_text* report) {
  return guarded([&] {
    if (!all_given(run, report) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    if (certificate && !ready(*certificate)) return UMBILIC_BAD_ARGUMENT;
    Report all = run->run.report();
    all.program = UMBILIC_VERSION;
    if (certificate) all.certificate = certificate->certificate.report().value();
    return answer(report_text(all), report);
  });
}

umbilic_status umbilic_run_state(umbilic_run* run, int32_t* level, const double** points, size_t* count) {
  return guarded([&] {
    if (!all_given(run, level, points, count) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    run->state = run->run.run.state();
    *level = run->state.level;
    *points = run->state.points.data();
    *count = static_cast<size_t>(run->state.points.rows());
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_run_control_mesh(const umbilic_run* run, umbilic_mesh** out) {
  return guarded([&] {
    if (!all_given(run, out) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    hand_out(run->run.run.control_mesh(), run->run.run.cage_faces(), out);
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_run_limit_mesh(const umbilic_run* run, int32_t density, umbilic_mesh** out) {
  return guarded([&] { return limit_mesh(run, density, {}, out); });
}

umbilic_status umbilic_run_limit_mesh_with_densities(const umbilic_run* run, int32_t density, const char* terms,
                                                     size_t length, umbilic_mesh** out) {
  return guarded([&] {
    if (!all_given(run, terms, out)) return UMBILIC_BAD_ARGUMENT;
    const Result<Weights> weights = parse_terms({terms, length});
    if (!weights) return fail(weights.error());
    return limit_mesh(run, density, *weights, out);
  });
}

umbilic_status umbilic_run_certify(const umbilic_run* run, umbilic_certificate** out) {
  return guarded([&] {
    if (!all_given(run, out) || !usable(*run)) return UMBILIC_BAD_ARGUMENT;
    Result<Certificate> certificate = run->run.run.certify();
    if (!certificate) return fail(certificate.error());
    *out = new umbilic_certificate{std::move(certificate).value()};
    return UMBILIC_OK;
  });
}

void umbilic_certificate_destroy(umbilic_certificate* certificate) { delete certificate; }

umbilic_status umbilic_certificate_step(umbilic_certificate* handle, int32_t units, int32_t* done) {
  return guarded([&] {
    if (!all_given(handle, done) || !usable(*handle)) return UMBILIC_BAD_ARGUMENT;
    if (units < 0) return fail(UMBILIC_BAD_ARGUMENT, fmt::format("{} units", units));
    changing(*handle, [&] {
      for (int32_t i = 0; i < units && !handle->ended; ++i) handle->ended = handle->certificate.step();
      return true;
    });
    if (handle->ended) {
      const Result<CertificateReport> report = handle->certificate.report();
      if (!report) return fail(report.error());
    }
    *done = handle->ended;
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_certificate_progress(const umbilic_certificate* certificate, double* progress) {
  return guarded([&] {
    if (!all_given(certificate, progress)) return UMBILIC_BAD_ARGUMENT;
    *progress = certificate->certificate.progress();
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_certificate_report(const umbilic_certificate* certificate, umbilic_text* report) {
  return guarded([&] {
    if (!all_given(certificate, report) || !ready(*certificate)) return UMBILIC_BAD_ARGUMENT;
    return answer(json_text(certificate->certificate.report().value()), report);
  });
}

umbilic_status umbilic_certificate_descent(umbilic_certificate* handle, int32_t* level, const double** points,
                                           size_t* count) {
  return guarded([&] {
    if (!all_given(handle, level, points, count) || !usable(*handle) || !ready(*handle)) return UMBILIC_BAD_ARGUMENT;
    std::optional<SurfaceState> lower = handle->certificate.descent();
    if (!lower) return fail(Error{"no direction from this surface leads to one of lower energy"});
    handle->lower = std::move(*lower);
    *level = handle->lower.level;
    *points = handle->lower.points.data();
    *count = static_cast<size_t>(handle->lower.points.rows());
    return UMBILIC_OK;
  });
}
