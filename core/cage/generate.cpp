// SPDX-License-Identifier: MIT
/// \file
/// The names of the generated cages, the cube and the torus. Frames are made in frame.cpp, open cages in
/// open_cages.cpp.
#include "cage/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cage/frame.h"
#include "cage/open_cages.h"
#include "cage/polyhedra.h"
#include "cage/text.h"

namespace umbilic {

namespace {

constexpr int kFewestArms = 3;
constexpr int kMostArms = 12;

std::vector<CageName> make_names() {
  std::vector<CageName> names{
      {"cube", "genus 0: six quads", CageKind::kCube, 0},
      {"torus", "genus 1: a torus of revolution, without extraordinary vertices", CageKind::kTorus, 1}};
  for (int arms = kFewestArms; arms <= kMostArms; ++arms) {
    names.push_back({fmt::format("two-{}", arms),
                     fmt::format("genus {}: two junctions joined by {} arms", arms - 1, arms), CageKind::kTwoJunctions,
                     arms - 1});
  }
  for (const Polyhedron& p : polyhedra()) {
    const int genus = p.edges - p.vertices + 1;
    names.push_back({std::string(p.name),
                     fmt::format("genus {}: the edges of {}, {} junctions", genus, p.solid, p.vertices),
                     CageKind::kPolyhedron, genus});
  }
  const auto add_open = [&](const char* name, const char* description, CageKind kind) {
    names.push_back({name, fmt::format("genus 0, open: {}", description), kind, 0, true});
  };
  add_open("disk", "a flat disk", CageKind::kDisk);
  add_open("cylinder", "a cylinder of revolution between two circles", CageKind::kCylinder);
  add_open("catenoid", "a catenoid between two circles", CageKind::kCatenoid);
  add_open("spherical-cap", "a part of a sphere around its pole", CageKind::kSphericalCap);
  add_open("n-sided", "a regular polygon, flat or with a saddle over it", CageKind::kNSided);
  return names;
}

Cage cube() {
  Cage cage;
  cage.vertices.resize(8, 3);
  cage.vertices << -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1;
  cage.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return cage;
}

Result<Cage> torus(const CageOptions& options) {
  constexpr int kMostSegments = 1000;
  const int around = options.major_segments;
  const int along = options.minor_segments;
  for (const int segments : {around, along}) {
    if (segments < 3 || segments > kMostSegments)
      return Error{fmt::format("{} segments are not 3 to {}", segments, kMostSegments)};
  }
  if (!(options.ratio > 0 && options.ratio < 1))
    return Error{fmt::format("ratio {} is not between 0 and 1", options.ratio)};
  constexpr double kThinnest = 0.01;
  if (!(options.thickness >= kThinnest && options.thickness * options.ratio < 1)) {
    return Error{fmt::format("thickness {} is not at least {} and less than {} (1 / ratio)", options.thickness,
                             kThinnest, 1 / options.ratio)};
  }
  const double minor = options.ratio * options.thickness;

  constexpr double kTwoPi = 6.283185307179586;
  Cage cage;
  cage.vertices.resize(around * along, 3);
  for (int i = 0; i < around; ++i) {
    const double longitude = kTwoPi * i / around;
    for (int j = 0; j < along; ++j) {
      const double latitude = kTwoPi * j / along;
      const double radius = 1 + minor * std::cos(latitude);
      cage.vertices.row(i * along + j) << radius * std::cos(longitude), radius * std::sin(longitude),
          minor * std::sin(latitude);
      const int next_i = (i + 1) % around * along;
      const int next_j = (j + 1) % along;
      cage.faces.push_back({i * along + j, next_i + j, next_i + next_j, i * along + next_j});
    }
  }
  return cage;
}

SphereMap sphere_map(const CageName& cage) {
  if (cage.kind == CageKind::kTwoJunctions) return hosohedron(cage.genus + 1);
  const auto polyhedron =
      std::find_if(polyhedra().begin(), polyhedra().end(), [&](const auto& p) { return p.name == cage.name; });
  return uniform_polyhedron(polyhedron->make());
}

Result<Cage> frame(const CageName& name, CageOptions options) {
  if (name.kind != CageKind::kTwoJunctions) options.spread = 1;
  const SphereMap map = sphere_map(name);
  const auto shape = frame_shape(map, options);
  if (!shape) return shape.error();
  return options.family == FrameFamily::kHub ? hub_frame(map, *shape) : flag_frame(map, *shape);
}

/// The cage with this name, or null.
const CageName* cage_called(std::string_view name) {
  const std::vector<CageName>& names = cage_names();
  const auto known = std::find_if(names.begin(), names.end(), [&](const CageName& n) { return n.name == name; });
  return known == names.end() ? nullptr : &*known;
}

}  // namespace

const std::vector<CageName>& cage_names() {
  static const std::vector<CageName> names = make_names();
  return names;
}

CageParameters parameters_of(CageKind kind) {
  const bool torus = kind == CageKind::kTorus, two = kind == CageKind::kTwoJunctions;
  const bool frame = two || kind == CageKind::kPolyhedron;
  const bool cylinder = kind == CageKind::kCylinder, chain = kind == CageKind::kCatenoid;
  const bool cap = kind == CageKind::kSphericalCap, polygon = kind == CageKind::kNSided;
  const bool round = cylinder || cap || kind == CageKind::kDisk;
  return {.family = frame,
          .thickness = frame || torus,
          .spread = two,
          .ratio = torus,
          .segments = torus || round || chain || polygon,
          .radius = round || polygon,
          .half_angle = cap,
          .height = cylinder || chain,
          .waist = chain,
          .sides = polygon,
          .rise = polygon};
}

CageParameters parameters_of(std::string_view name) {
  const CageName* known = cage_called(name);
  return known ? parameters_of(known->kind) : CageParameters();
}

CageOptions with_default_segments(std::string_view name, CageOptions options) {
  const CageName* known = cage_called(name);
  if (!known) return options;
  if (known->open) return with_open_defaults(known->kind, options);
  if (options.major_segments == 0) options.major_segments = 6;
  if (options.minor_segments == 0) options.minor_segments = 8;
  return options;
}

Result<Cage> generate_cage(std::string_view name, const CageOptions& given) {
  const CageOptions options = with_default_segments(name, given);
  const CageName* known = cage_called(name);
  if (!known) {
    std::string list;
    for (const CageName& n : cage_names()) list += (list.empty() ? "" : ", ") + n.name;
    return Error{fmt::format("there is no cage called {}; there are {}", printable(name), list)};
  }
  switch (known->kind) {
    case CageKind::kCube: return cube();
    case CageKind::kTorus: return torus(options);
    case CageKind::kTwoJunctions:
    case CageKind::kPolyhedron: break;
    case CageKind::kDisk: return flat_disk(options);
    case CageKind::kCylinder: return open_cylinder(options);
    case CageKind::kCatenoid: return catenoid(options);
    case CageKind::kSphericalCap: return spherical_cap(options);
    case CageKind::kNSided: return n_sided_polygon(options);
  }
  return frame(*known, options);
}

}  // namespace umbilic
