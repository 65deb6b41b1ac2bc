// SPDX-License-Identifier: MIT
/// \file
/// The generated cages: cube, torus, and the frames of the paper in two families.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// Hub cages have a prism at each junction, with one side quad per arm. Flag cages consist of flags (junction, arm,
/// side); their only extraordinary vertices are the axis points, of valence 2n. With equal options the arms of both
/// families have about the same thickness.
enum class FrameFamily { kHub, kFlag };

/// "hub", "flag".
constexpr std::string_view name_of(FrameFamily family) {
  switch (family) {
    case FrameFamily::kHub: return "hub";
    case FrameFamily::kFlag: return "flag";
  }
  return "";
}

/// A cage ignores options that do not apply to it.
struct CageOptions {
  FrameFamily family = FrameFamily::kFlag;
  /// Frames and torus: the width of the arms or the tube relative to the default, >= 0.01. Errors name the upper bound,
  /// which depends on the cage. With 1 the sides of a frame's arms are at a third of its radius from their centre
  /// lines, or at half the distance to the middle of the narrowest tunnel if that is less.
  double thickness = 1;
  /// Frames with two junctions: distance of the arms' middles from the axis, in [0.5, 3]; the junctions are at distance
  /// 1.
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

/// Which options apply to a cage.
struct CageParameters {
  bool family = true;
  bool thickness = true;
  bool spread = true;
  bool ratio = true;
  bool segments = true;
};

CageParameters parameters_of(CageKind kind);
/// The options that apply to the cage called `name`; all if there is no such cage.
CageParameters parameters_of(std::string_view name);

/// The cage called `name`: validated, with faces oriented outward. Errors name an unknown name or an option out of
/// range.
Result<Cage> generate_cage(std::string_view name, const CageOptions& options = {});

}  // namespace umbilic
