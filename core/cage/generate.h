// SPDX-License-Identifier: MIT
/// \file
/// The generated cages: cube, torus, and the frames of the paper in two families.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// Hub cages make each junction a prism with one side quad per arm; flag cages make it of flags (junction, arm, side),
/// and their only extraordinary vertices are the axis points, of valence 2n. Equal options give both families arms of
/// about one thickness.
enum class FrameFamily { kHub, kFlag };

/// "hub", "flag".
constexpr std::string_view name_of(FrameFamily family) {
  switch (family) {
    case FrameFamily::kHub: return "hub";
    case FrameFamily::kFlag: return "flag";
  }
  return "";
}

/// An option that does not apply to a cage is ignored by it.
struct CageOptions {
  FrameFamily family = FrameFamily::kFlag;
  /// Frames, torus: the arms' or the tube's width relative to the default, >= 0.01; errors name the upper bound, which
  /// depends on the cage. 1 puts the sides of a frame's arms a third of its radius beside their centre lines, or half
  /// the way to the middle of the narrowest tunnel where that is less.
  double thickness = 1;
  /// Two-N frames: distance of the arms' middles from the axis, in [0.5, 3]; the junctions are at 1.
  double spread = 1;
  double ratio = 0.5;      ///< torus: minor radius / major radius of the control net, in (0, 1), also after thickness
  int major_segments = 6;  ///< torus: quads around the axis, 3 to 1000
  int minor_segments = 8;  ///< torus: quads around the tube, 3 to 1000
};

enum class CageKind { kCube, kTorus, kTwoJunctions, kPolyhedron };

struct CageName {
  std::string name;         ///< "two-3", "tetrahedron-frame", …
  std::string description;  ///< one line, with the genus
  CageKind kind;
  int genus;
};

/// All generated cages, in the order of their genus within each kind.
const std::vector<CageName>& cage_names();

/// Which options apply to a cage; the others are ignored by it.
struct CageParameters {
  bool family = true;
  bool thickness = true;
  bool spread = true;
  bool ratio = true;
  bool segments = true;
};

CageParameters parameters_of(CageKind kind);
/// The same for the cage called `name`; all where there is no such cage.
CageParameters parameters_of(std::string_view name);

/// The cage called `name`: validated, its faces oriented outward. Errors name the unknown name or the option out of
/// range.
Result<Cage> generate_cage(std::string_view name, const CageOptions& options = {});

}  // namespace umbilic
