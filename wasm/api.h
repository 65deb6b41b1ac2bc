/* SPDX-License-Identifier: MIT */
/**
 * \file
 * The C contract of umbilic, the same for the WebAssembly module and the native library.
 *
 * Handles are opaque; every function that can fail returns an umbilic_status and leaves its outputs untouched on
 * failure. The words of the last failure are copied with umbilic_copy_message. Nothing here is thread-safe across calls
 * on one handle. Pointers returned by the getters point into the handle and live until the next call on it.
 */
#ifndef UMBILIC_API_H
#define UMBILIC_API_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct umbilic_cage umbilic_cage;
typedef struct umbilic_minimizer umbilic_minimizer;
typedef struct umbilic_certificate umbilic_certificate;
typedef struct umbilic_mesh umbilic_mesh;

typedef enum {
  UMBILIC_OK = 0,
  UMBILIC_BAD_INPUT = 1, /* the user's cage or options; the message says where and why */
  UMBILIC_OUT_OF_MEMORY = 2
} umbilic_status;

/** Program version, static storage. */
const char* umbilic_version(void);

/** Copies the message of the last failure, zero-terminated and cut to `capacity` bytes; returns its full length. */
size_t umbilic_copy_message(char* buffer, size_t capacity);

/** `count` names separated by newlines, static storage. */
const char* umbilic_cage_names(void);
const char* umbilic_functional_names(void);

/* ---- cages ---- */

/** Reads OBJ or OFF text of `length` bytes. */
umbilic_status umbilic_cage_read(const char* text, size_t length, umbilic_cage** out);

/** A generated cage; `family` 0 hub, 1 flag. Options as in core/cage/generate.h. */
umbilic_status umbilic_cage_generate(const char* name, int32_t family, double thickness, umbilic_cage** out);

/**
 * The control mesh `level` Catmull-Clark steps from the cage, with the cage's symmetry, from the points of the first
 * vertex of each of its orbits, 3 doubles each: what umbilic_minimizer_orbit_points gives of a surface on that level.
 */
umbilic_status umbilic_cage_refined(const umbilic_cage* cage, int32_t level, const double* points, int32_t count,
                                    umbilic_cage** out);

void umbilic_cage_destroy(umbilic_cage* cage);

/** counts: vertices, edges, faces, components, genus. */
void umbilic_cage_counts(const umbilic_cage* cage, int32_t counts[5]);

/* ---- tori of revolution, in closed form ---- */

/** energies: the six functionals in order, of the torus whose tube has `ratio` of its radius, 0 < ratio < 1. */
umbilic_status umbilic_torus_energies(double ratio, double energies[6]);

/**
 * The torus of least energy. minimizer: its ratio (NaN where all have the same energy), the energy, and 1 where it is
 * attained; 0 where it is the infimum as the ratio, reported as 0, tends to 0.
 */
umbilic_status umbilic_torus_minimizer(const double weights[6], double minimizer[3]);

/* ---- one run ---- */

/**
 * weights: six, in the order of umbilic_functional_names. cap: 0 none, 1 flat, 2 smooth. symmetry: whether the surface
 * keeps the cage's. metric: 0 auto, 1 identity, 2 sobolev, 3 hessian. Levels first..last count Catmull-Clark steps from
 * the cage to the mesh whose points are moved. The minimizer keeps no reference to the cage.
 */
umbilic_status umbilic_minimizer_create(const umbilic_cage* cage, const double weights[6], int32_t cap,
                                        int32_t symmetry, int32_t metric, int32_t first_level, int32_t last_level,
                                        int32_t max_iterations, double tolerance, umbilic_minimizer** out);

void umbilic_minimizer_destroy(umbilic_minimizer* minimizer);

/** Does up to `units` energy evaluations (or parts of a level's preparation of no greater cost); 1 when the run is
 * done. */
int32_t umbilic_minimizer_step(umbilic_minimizer* minimizer, int32_t units);

/** Ends the run; what there is so far is its result. */
void umbilic_minimizer_cancel(umbilic_minimizer* minimizer);

/**
 * progress: phase (0 prepare, 1 minimize, 2 report, 3 done), level, iterations, evaluations (both in this level),
 * evaluations in all, energy of the best surface (NaN before the first), its gradient norm,
 * predicted decrease (NaN before the first iteration).
 */
void umbilic_minimizer_progress(const umbilic_minimizer* minimizer, double progress[8]);

/** Number of levels ended so far. */
int32_t umbilic_minimizer_level_count(const umbilic_minimizer* minimizer);

/**
 * level: level, patches, unknowns, energy, energy_reported, iterations, evaluations, seconds, how often the metric was
 * built, whether the mesh that was moved is evaluable itself (1) or only prepares the first that is (0), steps by which
 * its quadrature rules became finer than usual. Returns the stop reason, static storage.
 */
const char* umbilic_minimizer_level(const umbilic_minimizer* minimizer, int32_t index, double level[11]);
/** "identity", "sobolev" or "hessian", static storage. */
const char* umbilic_minimizer_level_metric(const umbilic_minimizer* minimizer, int32_t index);

/** Schoenflies symbol of the symmetry that the run keeps, C1 where there is none; `order` receives its order. */
const char* umbilic_minimizer_group(const umbilic_minimizer* minimizer, int32_t* order);

/**
 * limit: energy, observed order (NaN where it cannot be told), error. Returns "converging": the levels' energies tend
 * to energy +- error; or why they tell no limit, with the least level's energy and error NaN: "too_few_levels",
 * "not_minimized", "not_converging", "not_whole". Static storage.
 */
const char* umbilic_minimizer_limit(const umbilic_minimizer* minimizer, double limit[3]);

/**
 * energies of the best surface by the reporting rule: the six functionals in order, area, Gaussian curvature integral,
 * quadrature error. NaN where a quantity diverges.
 */
void umbilic_minimizer_energies(const umbilic_minimizer* minimizer, double energies[9]);

/** 3 doubles for each of `count` points: of the first vertex of each orbit of the control mesh of the best surface so
 * far. */
const double* umbilic_minimizer_orbit_points(umbilic_minimizer* minimizer, int32_t* count);

/* ---- whether the best surface is a minimum among all surfaces near it, symmetric or not ---- */

/** Of the best surface so far; keeps no reference to the minimizer. Fails for flat caps and very large meshes. */
umbilic_status umbilic_minimizer_certify(const umbilic_minimizer* minimizer, umbilic_certificate** out);

void umbilic_certificate_destroy(umbilic_certificate* certificate);

/** Does up to `units` units of about the cost of an energy evaluation, the last one far more; 1 when the report is
 * ready. Fails where rounding hides the signs of the eigenvalues, and when memory runs out. */
umbilic_status umbilic_certificate_step(umbilic_certificate* certificate, int32_t units, int32_t* done);

/** In [0, 1]. */
double umbilic_certificate_progress(const umbilic_certificate* certificate);

/**
 * report, once ready: level, unknowns of the full Hessian, gauge directions removed from it, tau (eigenvalues relative
 * to the Sobolev product below -tau count as negative), number of directions along which the energy decreases.
 */
void umbilic_certificate_report(const umbilic_certificate* certificate, double report[5]);

/* ---- meshes: the control mesh or the limit surface of the best surface so far ---- */

/** The polygons of the cage as read; curvatures and normals are empty. */
umbilic_status umbilic_cage_mesh(const umbilic_cage* cage, umbilic_mesh** out);
/** The control mesh; curvatures and normals are empty. */
umbilic_status umbilic_minimizer_control_mesh(const umbilic_minimizer* minimizer, umbilic_mesh** out);
/** The limit surface, `density` >= 1 quads along each edge of a patch; edges are empty. */
umbilic_status umbilic_minimizer_limit_mesh(const umbilic_minimizer* minimizer, int32_t density, umbilic_mesh** out);

void umbilic_mesh_destroy(umbilic_mesh* mesh);

/** counts: vertices, faces, corners, edges, triangles. */
void umbilic_mesh_counts(const umbilic_mesh* mesh, int32_t counts[5]);
const float* umbilic_mesh_positions(const umbilic_mesh* mesh);    /* 3 per vertex */
const float* umbilic_mesh_normals(const umbilic_mesh* mesh);      /* 3 per vertex, or null */
const float* umbilic_mesh_curvatures(const umbilic_mesh* mesh);   /* kappa1 >= kappa2 per vertex, or null */
const uint32_t* umbilic_mesh_triangles(const umbilic_mesh* mesh); /* 3 per triangle */
const uint32_t* umbilic_mesh_edges(const umbilic_mesh* mesh);     /* 2 per edge, each edge once; or null */
/** OBJ text with full digits; `length` receives its bytes. */
const char* umbilic_mesh_obj(umbilic_mesh* mesh, size_t* length);

#ifdef __cplusplus
}
#endif
#endif
