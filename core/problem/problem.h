// SPDX-License-Identifier: MIT
/// \file
/// The input of a run, the same for every interface. Its text form is in text.h.
///
///     {"umbilic": "problem", "version": 1,
///      "cage": {"generator": "two-3"},
///      "terms": {"bending": 0.95, "mvs_cross": 0.05},
///      "options": {"levels": [0, 3]}}
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "base/types.h"
#include "cage/generate.h"
#include "problem/constraints.h"
#include "problem/fill_request.h"
#include "problem/members.h"
#include "problem/options.h"

namespace umbilic {

/// A cage from `generate_cage`.
struct GeneratedCage {
  static constexpr std::string_view kKey = "generator";
  std::string generator;
  CageOptions options;

  /// Prints only the options that apply to this cage. Reads all, and ignores the others.
  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit.required("generator", self.generator, "Name of the cage; `umbilic cage --list` prints all");
    const CageParameters has = std::is_const_v<Self> ? parameters_of(self.generator) : CageParameters();
    if (has.family) visit("family", self.options.family, "Of frames: junctions as prisms, or made of flags");
    if (has.thickness) visit("thickness", self.options.thickness, "Of the arms or the tube, relative to the default");
    if (has.spread) visit("spread", self.options.spread, "Of frames two-N: distance of the arms from the axis");
    if (has.ratio) visit("ratio", self.options.ratio, "Of the torus: minor radius / major radius");
    if (has.segments) {
      // Printed as they are taken, so that a problem does not depend on the defaults.
      auto options = with_segments(self);
      visit.pair(
          "segments", options->major_segments, options->minor_segments,
          "Of the torus: quads around the axis and around the tube. Of open cages: quads around the boundary (of "
          "n-sided: along a side) and across");
    }
    if (has.radius) visit("radius", self.options.radius, "Of disk, cylinder, spherical-cap and n-sided");
    if (has.half_angle) visit("half_angle", self.options.half_angle, "Of spherical-cap: degrees from pole to boundary");
    if (has.height) visit("height", self.options.height, "Of cylinder and catenoid: from boundary to boundary");
    if (has.waist) visit("waist", self.options.waist, "Of catenoid: the smallest radius");
    if (has.sides) visit("sides", self.options.sides, "Of n-sided: how many");
    if (has.rise) visit("rise", self.options.rise, "Of n-sided: height of the corners of a saddle; flat if 0");
  }

 private:
  /// The options, to be read.
  static CageOptions* with_segments(GeneratedCage& self) { return &self.options; }
  /// The options with default segments, to be printed.
  static std::optional<const CageOptions> with_segments(const GeneratedCage& self) {
    return with_default_segments(self.generator, self.options);
  }
};

/// A cage as the text of an OBJ, OFF or PLY file; of binary PLY see cage_text (cage/read.h).
struct CageText {
  static constexpr std::string_view kKey = "text";
  std::string name;  ///< name in messages; may be empty
  std::string text;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("name", self.name, "What messages call it");
    visit.required("text", self.text, "The text of an OBJ, OFF or PLY file");
  }
};

/// A cage in a file, with a path relative to the problem. Only the command line can open it, and replaces it by the
/// file's text.
struct CagePath {
  static constexpr std::string_view kKey = "file";
  std::string file;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit.required("file", self.file, "Path of an OBJ, OFF or PLY file, for the command line only");
  }
};

using CageInput = std::variant<GeneratedCage, CageText, CagePath>;

/// A surface of a run in compact form: the control mesh `level` Catmull-Clark steps from the cage, given by the points
/// of the first vertex of each orbit of the symmetry that the run keeps. See driver/surface_state.h.
struct SurfaceState {
  int level = 0;
  Points points;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit.required("level", self.level, "Catmull-Clark steps from the cage to the mesh of the points");
    visit.required("points", self.points,
                   "x, y, z of the first vertex of each orbit of the symmetry, one after another");
  }
};

/// Whether the level is valid; otherwise `error` says why not.
bool in_range(const SurfaceState& state, Error& error);

struct Problem {
  static constexpr Unknown kUnknown = Unknown::kRefused;
  CageInput cage;
  std::optional<FillRequest> fill{};
  Constraints constraints{};
  RunOptions options{};  ///< with the terms
  /// The level and points from which the run starts; if empty, it starts from the cage at the first level.
  std::optional<SurfaceState> start{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit.required("cage", self.cage, "The cage: generated, or the text of a file");
    visit.required("terms", self.options.weights, "Weights of the functionals whose sum is minimized, 0 unless given");
    visit(
        "fill", self.fill,
        "Closes boundaries of the cage with quads first; unless the constraints hold or free faces, all are held that "
        "neither fill a boundary nor touch it");
    visit("constraints", self.constraints, "What the surface keeps besides its topology");
    visit("options", self.options, "How the sum is minimized");
    visit("start", self.start, "Where the run goes on, instead of beginning with the cage");
  }
};

}  // namespace umbilic
