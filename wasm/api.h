/* SPDX-License-Identifier: MIT */
/**
 * \file
 * The C contract of umbilic, the same for the WebAssembly module and the native libraries. Installed, it is
 * <umbilic/api.h>; paths in comments are those of the project's folder `core`, installed beside it without `core/`
 * (core/problem/text.h is <umbilic/problem/text.h>).
 *
 *     umbilic_run* run;
 *     const char problem[] = "{\"umbilic\": \"problem\", \"version\": 1, \"cage\": {\"generator\": \"two-3\"},"
 *                            " \"terms\": {\"bending\": 1}}";
 *     if (umbilic_run_create(problem, strlen(problem), NULL, 0, &run) == UMBILIC_OK) {
 *       int32_t done = 0;
 *       while (!done && umbilic_run_step(run, 10, &done) == UMBILIC_OK) {}
 *       umbilic_text report;
 *       if (umbilic_run_report(run, NULL, &report) == UMBILIC_OK) fwrite(report.data, 1, report.length, stdout);
 *       umbilic_run_destroy(run);
 *     }
 *
 * Problems, reports and their parts are JSON texts, with members and versions as in core/problem/text.h; what the
 * program `umbilic optimize --print-schema` prints describes each member. Numbers that are not finite are null.
 *
 * Every function returns a status unless it cannot fail, and leaves its outputs untouched when it fails; no exception
 * leaves it. Pointers must not be null except where that is said, and are checked; so are enumerators, counts and
 * ranges. Handles are opaque; each is destroyed once, after which it must not be used, which cannot be checked. Calls
 * on different handles may run on different threads; calls on one handle may not run at the same time.
 */
#ifndef UMBILIC_API_H
#define UMBILIC_API_H

#include <stddef.h>
#include <stdint.h>

/** The version of the library that this header belongs to. */
#define UMBILIC_VERSION_MAJOR 0
#define UMBILIC_VERSION_MINOR 2
#define UMBILIC_VERSION_PATCH 0

/** Increases when the meaning of a function or struct in this file changes; the shared library's SOVERSION. */
#define UMBILIC_API_VERSION 3

/** Length of the longest text that is read, in bytes. */
#define UMBILIC_MAX_TEXT 268435456

#ifdef __cplusplus
extern "C" {
#endif

typedef struct umbilic_cage umbilic_cage;
typedef struct umbilic_run umbilic_run;
typedef struct umbilic_certificate umbilic_certificate;
typedef struct umbilic_mesh umbilic_mesh;

typedef enum umbilic_status {
  UMBILIC_OK = 0,
  UMBILIC_BAD_INPUT = 1,     /* the user's cage or problem; the message says where and why */
  UMBILIC_BAD_ARGUMENT = 2,  /* the caller's mistake: a null pointer, an enumerator or a count out of range */
  UMBILIC_OUT_OF_MEMORY = 3, /* a run in which that happens takes no more steps */
  UMBILIC_INTERNAL = 4       /* a mistake of this library */
} umbilic_status;

/**
 * UTF-8 text that the library keeps, followed by a zero byte that `length` does not count. It lives until the next call
 * on the same thread that answers with a text.
 */
typedef struct umbilic_text {
  const char* data;
  size_t length;
} umbilic_text;

/* What follows is exported by the shared library, which keeps all else to itself. */
#if defined(__GNUC__) && !defined(__EMSCRIPTEN__)
#pragma GCC visibility push(default)
#endif

/** UMBILIC_API_VERSION of the library, to be compared with that of the header. */
int32_t umbilic_api_version(void);

/** UMBILIC_VERSION_MAJOR.MINOR.PATCH of the library, in static storage: "0.2.0". */
const char* umbilic_version(void);

/**
 * Copies the message of the last failure on this thread, zero-terminated and cut to `capacity` bytes; returns its full
 * length. `buffer` may be null where `capacity` is 0.
 */
size_t umbilic_copy_message(char* buffer, size_t capacity);

/**
 * Sets how many threads compute, 1 to 256, for all calls together; one until then. Results are the same for every
 * number. Not while another function runs. In WebAssembly as far as JavaScript has made workers for them.
 */
umbilic_status umbilic_use_threads(int32_t count);

/** JSON arrays: the names of the generated cages, and those of the functionals. */
umbilic_status umbilic_cage_names(umbilic_text* names);
umbilic_status umbilic_functional_names(umbilic_text* names);

/* ---- cages ---- */

/** Makes a cage from a problem's "cage": {"generator": "two-3", …} or {"text": "the text of an OBJ, OFF or PLY file"}.
 */
umbilic_status umbilic_cage_create(const char* cage, size_t length, umbilic_cage** out);

/**
 * A text that holds the same cage as the bytes of a file, for a problem's "cage": {"text": …}. Binary PLY is checked
 * and becomes OBJ with all digits; any other file is returned as it is, and checked only where the text is used.
 */
umbilic_status umbilic_cage_text(const char* file, size_t length, umbilic_text* text);

/** Like all functions that destroy, does nothing if the handle is null. */
void umbilic_cage_destroy(umbilic_cage* cage);

/** A report's "cage": numbers of vertices, edges and faces, genus, components, boundary loops, groups of faces. */
umbilic_status umbilic_cage_counts(const umbilic_cage* cage, umbilic_text* counts);

/** The polygons of a closed cage; an open one is refused. */
umbilic_status umbilic_cage_mesh(const umbilic_cage* cage, umbilic_mesh** out);

/* ---- tori of revolution, in closed form ---- */

/** Energies of the torus whose tube has radius `ratio` times its radius, 0 < ratio < 1: {"bending": …, …}. */
umbilic_status umbilic_torus_energies(double ratio, umbilic_text* energies);

/**
 * The torus of least energy, for a problem's "terms": {"ratio", "energy", "attained"}. The ratio is null if all tori
 * have the same energy. If ever thinner tori approach the infimum, ratio is 0, energy the infimum and attained false.
 */
umbilic_status umbilic_torus_minimizer(const char* terms, size_t length, umbilic_text* minimizer);

/* ---- one run ---- */

/**
 * Begins the run of a problem, or, given a report, the run that continues where the report ended. `points`, unless
 * null, has 3 doubles for each of `count` points and replaces the problem's "start.points".
 */
umbilic_status umbilic_run_create(const char* problem, size_t length, const double* points, size_t count,
                                  umbilic_run** out);

void umbilic_run_destroy(umbilic_run* run);

/**
 * Does up to `units` >= 0 units of work. A unit is one energy evaluation, or a part of a level's preparation that costs
 * no more. `done` receives 1 if the run has ended, else 0.
 */
umbilic_status umbilic_run_step(umbilic_run* run, int32_t units, int32_t* done);

/**
 * Changes the weights of the terms, the targets of pins, the pull to the cage's own surface and the points of the cage
 * of a run, ended or not:
 * {"terms": {…}, "pins": [{"at": [x, y, z], "normal": [x, y, z]}, {}], "closeness": weight, "points": [x, y, z, …]},
 * each member or none. Points are those of the problem's cage, as many and of the same faces; what is held follows it.
 * The run goes on from its best surface; what was known of levels is forgotten. UMBILIC_BAD_INPUT if that does not fit
 * the problem; then the run stays as it is.
 */
umbilic_status umbilic_run_retarget(umbilic_run* run, const char* targets, size_t length);

/** Ends the run. Its result is what has been computed so far. */
umbilic_status umbilic_run_cancel(umbilic_run* run);

/** The parts of a run that can be asked for, named as in a report. */
typedef enum umbilic_part {
  UMBILIC_PART_PROGRESS = 0, /* in no report: phase, level, evaluations, energy, …; see core/problem/progress.h */
  UMBILIC_PART_PROBLEM = 1,  /* complete, with its version */
  UMBILIC_PART_CAGE = 2,
  UMBILIC_PART_GROUP = 3,
  UMBILIC_PART_LEVELS = 4,
  UMBILIC_PART_LIMIT = 5,
  UMBILIC_PART_ENERGIES = 6, /* takes several times as long as a step, once for each surface */
  UMBILIC_PART_GROUPS = 7,   /* in no report: the cage's groups, [{"name": …, "faces": [numbers from 1]}, …] */
  UMBILIC_PART_HELD = 8,     /* in no report: the numbers of the cage's faces that are held, from 1 */
  UMBILIC_PART_ESTIMATE = 9  /* what the run will probably take, seconds and bytes; asked before its first step */
} umbilic_part;

/** `part` is an umbilic_part, as an integer so that any other value can be told. */
umbilic_status umbilic_run_part(const umbilic_run* run, int32_t part, umbilic_text* text);

/** The complete report, with the surface. `certificate` is null or a ready certificate of this run. */
umbilic_status umbilic_run_report(const umbilic_run* run, const umbilic_certificate* certificate, umbilic_text* report);

/**
 * The best surface so far, as in a problem's "start": the level, and 3 doubles for each of `count` points, which stay
 * valid until the next call on the run.
 */
umbilic_status umbilic_run_state(umbilic_run* run, int32_t* level, const double** points, size_t* count);

/** The control mesh of the best surface so far. */
umbilic_status umbilic_run_control_mesh(const umbilic_run* run, umbilic_mesh** out);

/**
 * The limit surface of the best surface so far, with `density` >= 1 quads along each edge of a patch.
 * UMBILIC_BAD_INPUT if it would take more than 0.5 GB (2 GB natively); the message names the largest density that fits.
 */
umbilic_status umbilic_run_limit_mesh(const umbilic_run* run, int32_t density, umbilic_mesh** out);

/**
 * The same mesh with the density of an energy, for umbilic_mesh_densities. `terms` is as in a problem; it need not be
 * what is minimized. UMBILIC_BAD_INPUT, too, where it is wrong or the energy infinite.
 */
umbilic_status umbilic_run_limit_mesh_with_densities(const umbilic_run* run, int32_t density, const char* terms,
                                                     size_t length, umbilic_mesh** out);

/* ---- certificates: whether a surface is a minimum among all surfaces near it, symmetric or not ---- */

/**
 * Begins a certificate of the best surface so far. Keeps no reference to the run. Fails for flat caps and very large
 * meshes.
 */
umbilic_status umbilic_run_certify(const umbilic_run* run, umbilic_certificate** out);

void umbilic_certificate_destroy(umbilic_certificate* certificate);

/**
 * Does up to `units` >= 0 units of work. Each costs about one energy evaluation, the last one far more. `done` receives
 * 1 if the report is ready, else 0. Fails if rounding hides the signs of the eigenvalues.
 */
umbilic_status umbilic_certificate_step(umbilic_certificate* certificate, int32_t units, int32_t* done);

/** The completed fraction, in [0, 1]. */
umbilic_status umbilic_certificate_progress(const umbilic_certificate* certificate, double* progress);

/** A report's "certificate". The certificate must be ready. */
umbilic_status umbilic_certificate_report(const umbilic_certificate* certificate, umbilic_text* report);

/**
 * A surface of lower energy near the certificate's, which must be ready: as in a problem's "start", with the points of
 * all vertices, valid until the next call on the certificate. UMBILIC_BAD_INPUT where no direction leads down. Costs
 * some tens of evaluations.
 */
umbilic_status umbilic_certificate_descent(umbilic_certificate* certificate, int32_t* level, const double** points,
                                           size_t* count);

/* ---- meshes ---- */

/** Arrays of a mesh, which stay valid as long as its handle. Vertices are numbered from 0. */
typedef struct umbilic_mesh_arrays {
  const float* positions;    /* 3 per vertex, from the centre, so that a small mesh far away keeps its digits */
  const float* normals;      /* 3 per vertex; null for control meshes */
  const float* curvatures;   /* kappa1 >= kappa2 per vertex; null for control meshes */
  const uint32_t* triangles; /* 3 per triangle */
  const uint32_t* faces;     /* of each triangle: the face of the cage that it descends from, from 0 */
  const uint32_t* edges;     /* 2 per edge, each edge once; null for limit meshes */
  size_t vertex_count;
  size_t triangle_count;
  size_t edge_count; /* 0 for limit meshes */
  double centre[3];  /* the middle of the vertices' bounding box, in the coordinates of the cage */
} umbilic_mesh_arrays;

umbilic_status umbilic_mesh_view(const umbilic_mesh* mesh, umbilic_mesh_arrays* arrays);

/**
 * Energy per area at each vertex, in 1/length^2: the integrand of the weighted functionals with their powers of the
 * area, which integrates to the energy. Null and 0 for meshes that were made without.
 */
umbilic_status umbilic_mesh_densities(const umbilic_mesh* mesh, const float** densities, size_t* count);

/** OBJ text with all digits: the polygons of a control mesh, or the quads of a limit mesh with normals. */
umbilic_status umbilic_mesh_obj(const umbilic_mesh* mesh, umbilic_text* obj);

void umbilic_mesh_destroy(umbilic_mesh* mesh);

#if defined(__GNUC__) && !defined(__EMSCRIPTEN__)
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif
#endif
