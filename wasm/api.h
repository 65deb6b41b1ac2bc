/* SPDX-License-Identifier: MIT */
/**
 * \file
 * The C contract of umbilic, the same for the WebAssembly module and the native library.
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

/** Rises when a function or a struct of this file changes what it means. */
#define UMBILIC_API_VERSION 2

/** Bytes of the longest text that is read. */
#define UMBILIC_MAX_TEXT 268435456
/** Most quads of a limit mesh: patches times the square of the density. */
#define UMBILIC_MAX_LIMIT_QUADS 4000000

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

/** UMBILIC_API_VERSION of the library, which a caller compares with that of its header. */
int32_t umbilic_api_version(void);

/** Program version, static storage. */
const char* umbilic_version(void);

/**
 * Copies the message of the last failure on this thread, zero-terminated and cut to `capacity` bytes; returns its full
 * length. `buffer` may be null where `capacity` is 0.
 */
size_t umbilic_copy_message(char* buffer, size_t capacity);

/** JSON arrays of names: of the generated cages, and of the functionals. */
umbilic_status umbilic_cage_names(umbilic_text* names);
umbilic_status umbilic_functional_names(umbilic_text* names);

/* ---- cages ---- */

/** From a problem's "cage": {"generator": "two-3", …} or {"text": "the text of an OBJ or OFF file"}. */
umbilic_status umbilic_cage_create(const char* cage, size_t length, umbilic_cage** out);

/** Does nothing with null, as all that destroy. */
void umbilic_cage_destroy(umbilic_cage* cage);

/** A report's "cage": numbers of vertices, edges and faces, genus, components. */
umbilic_status umbilic_cage_counts(const umbilic_cage* cage, umbilic_text* counts);

/** The polygons of the cage. */
umbilic_status umbilic_cage_mesh(const umbilic_cage* cage, umbilic_mesh** out);

/* ---- tori of revolution, in closed form ---- */

/** Of the torus whose tube has `ratio` of its radius, 0 < ratio < 1: {"bending": …, …}. */
umbilic_status umbilic_torus_energies(double ratio, umbilic_text* energies);

/**
 * The torus of least energy, of a problem's "terms": {"ratio", "energy", "attained"}. The ratio is null where all have
 * the same energy; attained is false where the energy is the infimum as the ratio, then 0, tends to 0.
 */
umbilic_status umbilic_torus_minimizer(const char* terms, size_t length, umbilic_text* minimizer);

/* ---- one run ---- */

/**
 * Begins the run that a problem asks for; from a report, the run that goes on where the report ended. `points`, where
 * it is not null, has 3 doubles for each of `count` points, which take the place of the problem's "start.points".
 */
umbilic_status umbilic_run_create(const char* problem, size_t length, const double* points, size_t count,
                                  umbilic_run** out);

void umbilic_run_destroy(umbilic_run* run);

/**
 * Does up to `units` >= 0 units of work: one energy evaluation each, or one part of a level's preparation of no greater
 * cost. `done` receives 1 when the run is done, else 0.
 */
umbilic_status umbilic_run_step(umbilic_run* run, int32_t units, int32_t* done);

/** Ends the run; what there is so far is its result. */
umbilic_status umbilic_run_cancel(umbilic_run* run);

/** What there is to say of a run, each under the name that it has in a report. */
typedef enum umbilic_part {
  UMBILIC_PART_PROGRESS = 0, /* in no report: phase, level, evaluations, energy, …; see core/problem/progress.h */
  UMBILIC_PART_PROBLEM = 1,  /* complete, with its version */
  UMBILIC_PART_CAGE = 2,
  UMBILIC_PART_GROUP = 3,
  UMBILIC_PART_LEVELS = 4,
  UMBILIC_PART_LIMIT = 5,
  UMBILIC_PART_ENERGIES = 6 /* takes several times as long as a step, once for each surface */
} umbilic_part;

/** `part` is an umbilic_part, as an integer so that any other value can be told. */
umbilic_status umbilic_run_part(const umbilic_run* run, int32_t part, umbilic_text* text);

/** All of it, with the surface. `certificate`, unless null, is one of this run that is ready. */
umbilic_status umbilic_run_report(const umbilic_run* run, const umbilic_certificate* certificate, umbilic_text* report);

/**
 * The best surface so far as a problem's "start" has it: the level, and 3 doubles for each of `count` points, which
 * live until the next call on the run.
 */
umbilic_status umbilic_run_state(umbilic_run* run, int32_t* level, const double** points, size_t* count);

/** The control mesh of the best surface so far. */
umbilic_status umbilic_run_control_mesh(const umbilic_run* run, umbilic_mesh** out);

/**
 * The limit surface of the best surface so far, `density` >= 1 quads along each edge of a patch, at most
 * UMBILIC_MAX_LIMIT_QUADS in all.
 */
umbilic_status umbilic_run_limit_mesh(const umbilic_run* run, int32_t density, umbilic_mesh** out);

/* ---- whether the best surface is a minimum among all surfaces near it, symmetric or not ---- */

/** Of the best surface so far; keeps no reference to the run. Fails for flat caps and very large meshes. */
umbilic_status umbilic_run_certify(const umbilic_run* run, umbilic_certificate** out);

void umbilic_certificate_destroy(umbilic_certificate* certificate);

/**
 * Does up to `units` >= 0 units of about the cost of an energy evaluation, the last one far more. `done` receives 1
 * when the report is ready, else 0. Fails where rounding hides the signs of the eigenvalues.
 */
umbilic_status umbilic_certificate_step(umbilic_certificate* certificate, int32_t units, int32_t* done);

/** In [0, 1]. */
umbilic_status umbilic_certificate_progress(const umbilic_certificate* certificate, double* progress);

/** A report's "certificate", once it is ready. */
umbilic_status umbilic_certificate_report(const umbilic_certificate* certificate, umbilic_text* report);

/* ---- meshes ---- */

/** Arrays of a mesh, which live as long as its handle. Vertices are counted from 0. */
typedef struct umbilic_mesh_arrays {
  const float* positions;    /* 3 per vertex, from the centre, so that a small mesh far away keeps its digits */
  const float* normals;      /* 3 per vertex; null for control meshes */
  const float* curvatures;   /* kappa1 >= kappa2 per vertex; null for control meshes */
  const uint32_t* triangles; /* 3 per triangle */
  const uint32_t* edges;     /* 2 per edge, each edge once; null for limit meshes */
  size_t vertex_count;
  size_t triangle_count;
  size_t edge_count; /* 0 for limit meshes */
  double centre[3];  /* the middle of the vertices' bounding box, in the coordinates of the cage */
} umbilic_mesh_arrays;

umbilic_status umbilic_mesh_view(const umbilic_mesh* mesh, umbilic_mesh_arrays* arrays);

/** OBJ text with full digits: the polygons of a control mesh, the quads of a limit mesh with normals. */
umbilic_status umbilic_mesh_obj(const umbilic_mesh* mesh, umbilic_text* obj);

void umbilic_mesh_destroy(umbilic_mesh* mesh);

#ifdef __cplusplus
}
#endif
#endif
