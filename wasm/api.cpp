// SPDX-License-Identifier: MIT
/// \file
/// The C contract over core/driver: each function decodes, calls and encodes.
#include "api.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "cage/cage.h"
#include "cage/generate.h"
#include "cage/read.h"
#include "cage/write.h"
#include "driver/run.h"
#include "energy/torus.h"
#include "mesh/polygon_mesh.h"

using namespace umbilic;

struct umbilic_cage {
  Cage cage;
  CageReport report;
  std::optional<SymmetryGroup> symmetry;  // of `cage`, where it is known
};

struct umbilic_minimizer {
  Run run;
  GroupReport group;
  Points orbit_points;
};

struct umbilic_certificate {
  Certificate certificate;
};

struct umbilic_mesh {
  Cage cage;        // polygons with full digits; empty for a limit mesh
  LimitMesh limit;  // the same; empty for a control mesh
  Eigen::RowVector3d centre;
  std::vector<float> positions, normals, curvatures;  // positions from the centre
  std::vector<uint32_t> triangles, edges;
  int32_t faces = 0, corners = 0;
  std::string obj;
};

namespace {

std::string last_message;

umbilic_status fail(umbilic_status status, std::string message) {
  last_message = std::move(message);
  return status;
}

/// Runs `body`, which returns a Result; on success hands the value to `accept`.
template <class Body, class Accept>
umbilic_status attempt(const Body& body, const Accept& accept) {
  try {
    auto result = body();
    if (!result) return fail(UMBILIC_BAD_INPUT, result.error().message);
    accept(std::move(result).value());
    return UMBILIC_OK;
  } catch (const std::bad_alloc&) {
    return fail(UMBILIC_OUT_OF_MEMORY, "out of memory");
  }
}

Result<umbilic_cage*> make_cage(Result<Cage> cage) {
  if (!cage) return cage.error();
  Result<CageReport> report = validate(*cage);
  if (!report) return report.error();
  return new umbilic_cage{std::move(cage).value(), std::move(report).value(), {}};
}

/// Counts after Catmull-Clark steps, which keep components and genus: a closed mesh has two corners for each edge.
CageReport refined(CageReport report, int32_t level) {
  const auto refine = [](auto& counts) {
    counts.vertices += counts.edges + counts.faces;
    counts.faces = 2 * counts.edges;
    counts.edges *= 4;
  };
  for (; level > 0; --level) {
    refine(report);
    for (CageComponent& component : report.components) refine(component);
  }
  return report;
}

template <class Matrix>
std::vector<float> to_floats(const Matrix& matrix) {
  std::vector<float> floats(matrix.size());
  std::transform(matrix.data(), matrix.data() + matrix.size(), floats.begin(), [](double x) { return float(x); });
  return floats;
}

/// Halved before they are added, so that the sum of two large coordinates does not overflow.
Eigen::RowVector3d middle_of_box(const Points& points) {
  return points.colwise().minCoeff() / 2 + points.colwise().maxCoeff() / 2;
}

/// Fans of triangles, and each edge once.
umbilic_mesh* make_mesh(Cage cage) {
  auto mesh = std::make_unique<umbilic_mesh>();
  mesh->centre = middle_of_box(cage.vertices);
  mesh->positions = to_floats(Points(cage.vertices.rowwise() - mesh->centre));
  const PolygonMesh connectivity(cage);
  for (int h = 0; h < connectivity.halfedge_count(); ++h) {
    if (h < connectivity.twin(h)) {
      mesh->edges.push_back(connectivity.origin(h));
      mesh->edges.push_back(connectivity.target(h));
    }
  }
  for (const auto& face : cage.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      for (const int corner : {face[0], face[i - 1], face[i]}) mesh->triangles.push_back(corner);
    }
  }
  mesh->faces = int32_t(cage.faces.size());
  mesh->corners = connectivity.halfedge_count();
  mesh->cage = std::move(cage);
  return mesh.release();
}

/// Two triangles for each quad; their edges are nobody's concern.
umbilic_mesh* make_limit_mesh(LimitMesh limit) {
  auto mesh = std::make_unique<umbilic_mesh>();
  mesh->centre = middle_of_box(limit.positions);
  mesh->positions = to_floats(Points(limit.positions.rowwise() - mesh->centre));
  mesh->normals = to_floats(limit.normals);
  mesh->curvatures = to_floats(limit.curvatures);
  mesh->triangles.reserve(6 * limit.quads.size());
  for (const auto& [a, b, c, d] : limit.quads) {
    for (const int corner : {a, b, c, a, c, d}) mesh->triangles.push_back(corner);
  }
  mesh->faces = int32_t(limit.quads.size());
  mesh->corners = 4 * mesh->faces;
  mesh->limit = std::move(limit);
  return mesh.release();
}

template <class Names, class Name>
std::string joined(const Names& names, const Name& name) {
  std::string text;
  for (const auto& n : names) text.append(text.empty() ? "" : "\n").append(name(n));
  return text;
}

Weights to_weights(const double weights[kFunctionalCount]) {
  Weights result;
  std::copy_n(weights, kFunctionalCount, result.begin());
  return result;
}

template <class T>
const T* data_or_null(const std::vector<T>& values) {
  return values.empty() ? nullptr : values.data();
}

}  // namespace

const char* umbilic_version(void) { return UMBILIC_VERSION; }

size_t umbilic_copy_message(char* buffer, size_t capacity) {
  if (capacity > 0) {
    const size_t length = std::min(capacity - 1, last_message.size());
    std::memcpy(buffer, last_message.data(), length);
    buffer[length] = '\0';
  }
  return last_message.size();
}

const char* umbilic_cage_names(void) {
  static const std::string names = joined(cage_names(), [](const CageName& n) { return n.name; });
  return names.c_str();
}

const char* umbilic_functional_names(void) {
  static const std::string names = joined(kFunctionalNames, [](std::string_view n) { return std::string(n); });
  return names.c_str();
}

umbilic_status umbilic_cage_read(const char* text, size_t length, umbilic_cage** out) {
  return attempt([&] { return make_cage(read_cage({text, length})); }, [&](umbilic_cage* cage) { *out = cage; });
}

umbilic_status umbilic_cage_generate(const char* name, int32_t family, double thickness, umbilic_cage** out) {
  CageOptions options;
  options.family = family == 0 ? FrameFamily::kHub : FrameFamily::kFlag;
  options.thickness = thickness;
  return attempt([&] { return make_cage(generate_cage(name, options)); }, [&](umbilic_cage* cage) { *out = cage; });
}

umbilic_status umbilic_cage_refined(const umbilic_cage* cage, int32_t level, const double* points, int32_t count,
                                    umbilic_cage** out) {
  return attempt(
      [&] { return symmetric_cage(cage->cage, level, Eigen::Map<const Points>(points, std::max(count, 0), 3)); },
      [&](SymmetricCage finer) {
        *out = new umbilic_cage{std::move(finer.cage), refined(cage->report, level), std::move(finer.symmetry)};
      });
}

void umbilic_cage_destroy(umbilic_cage* cage) { delete cage; }

void umbilic_cage_counts(const umbilic_cage* cage, int32_t counts[5]) {
  const CageReport& r = cage->report;
  const int32_t values[5] = {r.vertices, r.edges, r.faces, int32_t(r.components.size()), r.genus};
  std::copy_n(values, 5, counts);
}

umbilic_status umbilic_torus_energies(double ratio, double energies[6]) {
  if (!(ratio > 0 && ratio < 1)) return fail(UMBILIC_BAD_INPUT, fmt::format("ratio {} is not between 0 and 1", ratio));
  const auto values = torus_energies(ratio);
  std::copy(values.begin(), values.end(), energies);
  return UMBILIC_OK;
}

umbilic_status umbilic_torus_minimizer(const double weights[6], double minimizer[3]) {
  const Weights wanted = to_weights(weights);
  if (Error error; !usable(wanted, error)) return fail(UMBILIC_BAD_INPUT, error.message);
  const TorusMinimizer found = torus_minimizer(wanted);
  const double values[3] = {found.ratio, found.energy, double(found.attained)};
  std::copy_n(values, 3, minimizer);
  return UMBILIC_OK;
}

umbilic_status umbilic_minimizer_create(const umbilic_cage* cage, const double weights[6], int32_t cap,
                                        int32_t symmetry, int32_t metric, int32_t first_level, int32_t last_level,
                                        int32_t max_iterations, double tolerance, umbilic_minimizer** out) {
  RunOptions options;
  options.weights = to_weights(weights);
  options.cap = static_cast<CapKind>(std::clamp(cap, 0, 2));
  options.symmetry = symmetry != 0;
  options.metric = static_cast<MetricChoice>(std::clamp(metric, 0, kMetricChoiceCount - 1));
  options.first_level = first_level;
  options.last_level = last_level;
  options.max_iterations = max_iterations;
  options.tolerance = tolerance;
  return attempt(
      [&] {
        if (cage->symmetry) return Run::create(SymmetricCage{cage->cage, *cage->symmetry}, options);
        return Run::create(cage->cage, options);
      },
      [&](Run run) {
        GroupReport group = run.group();
        *out = new umbilic_minimizer{std::move(run), std::move(group), {}};
      });
}

void umbilic_minimizer_destroy(umbilic_minimizer* minimizer) { delete minimizer; }

int32_t umbilic_minimizer_step(umbilic_minimizer* minimizer, int32_t units) { return minimizer->run.step(units); }

void umbilic_minimizer_cancel(umbilic_minimizer* minimizer) { minimizer->run.cancel(); }

void umbilic_minimizer_progress(const umbilic_minimizer* minimizer, double progress[8]) {
  const Progress& p = minimizer->run.progress();
  const double values[8] = {
      double(p.phase), double(p.level), double(p.iterations), double(p.evaluations), double(p.total_evaluations),
      p.energy,        p.gradient_norm, p.predicted_decrease};
  std::copy_n(values, 8, progress);
}

int32_t umbilic_minimizer_level_count(const umbilic_minimizer* minimizer) {
  return int32_t(minimizer->run.levels().size());
}

const char* umbilic_minimizer_level(const umbilic_minimizer* minimizer, int32_t index, double level[11]) {
  const LevelReport& r = minimizer->run.levels()[index];
  const double values[11] = {double(r.level),   double(r.patches),    double(r.unknowns),    r.energy,
                             r.energy_reported, double(r.iterations), double(r.evaluations), r.seconds,
                             double(r.metrics), double(r.evaluable),  double(r.quadrature)};
  std::copy_n(values, 11, level);
  return name_of(r.stop).data();
}

const char* umbilic_minimizer_level_metric(const umbilic_minimizer* minimizer, int32_t index) {
  return minimizer->run.levels()[index].metric.data();
}

const char* umbilic_minimizer_group(const umbilic_minimizer* minimizer, int32_t* order) {
  *order = minimizer->group.order;
  return minimizer->group.name.c_str();
}

const char* umbilic_minimizer_limit(const umbilic_minimizer* minimizer, double limit[3]) {
  const LimitReport r = minimizer->run.limit();
  const double values[3] = {r.energy, r.order, r.error};
  std::copy_n(values, 3, limit);
  return name_of(r.status).data();
}

void umbilic_minimizer_energies(const umbilic_minimizer* minimizer, double energies[9]) {
  const EnergyReport& r = minimizer->run.energies();
  std::copy(r.functionals.begin(), r.functionals.end(), energies);
  energies[kFunctionalCount] = r.area;
  energies[kFunctionalCount + 1] = r.gaussian;
  energies[kFunctionalCount + 2] = r.quadrature_error;
}

const double* umbilic_minimizer_orbit_points(umbilic_minimizer* minimizer, int32_t* count) {
  minimizer->orbit_points = minimizer->run.orbit_points();
  *count = int32_t(minimizer->orbit_points.rows());
  return minimizer->orbit_points.data();
}

umbilic_status umbilic_minimizer_certify(const umbilic_minimizer* minimizer, umbilic_certificate** out) {
  return attempt([&] { return minimizer->run.certify(); },
                 [&](Certificate certificate) { *out = new umbilic_certificate{std::move(certificate)}; });
}

void umbilic_certificate_destroy(umbilic_certificate* certificate) { delete certificate; }

umbilic_status umbilic_certificate_step(umbilic_certificate* certificate, int32_t units, int32_t* done) {
  return attempt(
      [&] {
        bool ended = false;
        for (int32_t i = 0; i < units && !ended; ++i) ended = certificate->certificate.step();
        if (!ended) return Result<bool>(false);
        const Result<CertificateReport> report = certificate->certificate.report();
        return report ? Result<bool>(true) : Result<bool>(report.error());
      },
      [&](bool ready) { *done = ready; });
}

double umbilic_certificate_progress(const umbilic_certificate* certificate) {
  return certificate->certificate.progress();
}

void umbilic_certificate_report(const umbilic_certificate* certificate, double report[5]) {
  const CertificateReport r = certificate->certificate.report().value();
  const double values[5] = {double(r.level), double(r.unknowns), double(r.gauge), r.tau, double(r.negative)};
  std::copy_n(values, 5, report);
}

umbilic_status umbilic_cage_mesh(const umbilic_cage* cage, umbilic_mesh** out) {
  return attempt([&] { return Result<umbilic_mesh*>(make_mesh(cage->cage)); }, [&](umbilic_mesh* m) { *out = m; });
}

umbilic_status umbilic_minimizer_control_mesh(const umbilic_minimizer* minimizer, umbilic_mesh** out) {
  return attempt([&] { return Result<umbilic_mesh*>(make_mesh(minimizer->run.control_mesh())); },
                 [&](umbilic_mesh* m) { *out = m; });
}

umbilic_status umbilic_minimizer_limit_mesh(const umbilic_minimizer* minimizer, int32_t density, umbilic_mesh** out) {
  return attempt(
      [&] { return Result<umbilic_mesh*>(make_limit_mesh(minimizer->run.limit_mesh(std::max(density, 1)))); },
      [&](umbilic_mesh* m) { *out = m; });
}

void umbilic_mesh_destroy(umbilic_mesh* mesh) { delete mesh; }

void umbilic_mesh_counts(const umbilic_mesh* mesh, int32_t counts[5]) {
  const int32_t values[5] = {int32_t(mesh->positions.size() / 3), mesh->faces, mesh->corners,
                             int32_t(mesh->edges.size() / 2), int32_t(mesh->triangles.size() / 3)};
  std::copy_n(values, 5, counts);
}

const float* umbilic_mesh_positions(const umbilic_mesh* mesh) { return data_or_null(mesh->positions); }
const float* umbilic_mesh_normals(const umbilic_mesh* mesh) { return data_or_null(mesh->normals); }
const float* umbilic_mesh_curvatures(const umbilic_mesh* mesh) { return data_or_null(mesh->curvatures); }
const uint32_t* umbilic_mesh_triangles(const umbilic_mesh* mesh) { return data_or_null(mesh->triangles); }
const uint32_t* umbilic_mesh_edges(const umbilic_mesh* mesh) { return data_or_null(mesh->edges); }

void umbilic_mesh_centre(const umbilic_mesh* mesh, double centre[3]) { std::copy_n(mesh->centre.data(), 3, centre); }

const char* umbilic_mesh_obj(umbilic_mesh* mesh, size_t* length) {
  const LimitMesh& limit = mesh->limit;
  mesh->obj = limit.quads.empty() ? write_obj(mesh->cage) : write_obj(limit.positions, limit.normals, limit.quads);
  *length = mesh->obj.size();
  return mesh->obj.c_str();
}
