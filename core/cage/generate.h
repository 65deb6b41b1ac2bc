// SPDX-License-Identifier: MIT
/// \file
/// The generated cages: cube, torus, the frames of the paper in two families, and open cages (open_cages.h).
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
  double ratio = 0.5;  ///< torus: minor radius / major radius of the control net, in (0, 1), also after thickness
  /// Torus: quads around the axis, 3 to 1000 [6]. Open cages: quads around each boundary, 8 to 1000, of those with a
  /// pole divisible by 4 [32]; of n-sided along each side, 2 to 100 and even [8]. 0: the default in brackets.
  int major_segments = 0;
  /// Torus: quads around the tube, 3 to 1000 [8]. Cylinder, catenoid: quads from one boundary to the other, 3 to 1000;
  /// disk, spherical-cap: quads from the boundary to the square grid in the middle, 2 to 200; n-sided: half of those
  /// along a side. 0: as many as make the quads about square.
  int minor_segments = 0;
  double radius = 1;       ///< disk, cylinder; of the sphere of spherical-cap; to the corners of n-sided; 0.01 to 100
  double half_angle = 90;  ///< spherical-cap: degrees from the pole to the boundary, 1 to 179
  double height = 2;       ///< cylinder, catenoid: from boundary to boundary, 0.01 to 100; catenoid: at most 10 waists
  double waist = 1;        ///< catenoid: its smallest radius, 0.01 to 100
  int sides = 5;           ///< n-sided: 3 to 12
  double rise = 0;         ///< n-sided: height of the corners, -100 to 100; the polygon is flat if 0
};

enum class CageKind { kCube, kTorus, kTwoJunctions, kPolyhedron, kDisk, kCylinder, kCatenoid, kSphericalCap, kNSided };

struct CageName {
  std::string name;         ///< "two-3", "tetrahedron-frame", …
  std::string description;  ///< one line, with the genus
  CageKind kind;
  int genus;
  bool open = false;  ///< whether the surface has boundaries
};

/// All generated cages, in the order of their genus within each kind, and the open ones last.
const std::vector<CageName>& cage_names();

/// Which options apply to a cage.
struct CageParameters {
  bool family = true;
  bool thickness = true;
  bool spread = true;
  bool ratio = true;
  bool segments = true;
  bool radius = true;
  bool half_angle = true;
  bool height = true;
  bool waist = true;
  bool sides = true;
  bool rise = true;
};

CageParameters parameters_of(CageKind kind);
/// The options that apply to the cage called `name`; all if there is no such cage.
CageParameters parameters_of(std::string_view name);

/// The options with the numbers of segments that `generate_cage` takes where they are 0.
CageOptions with_default_segments(std::string_view name, CageOptions options);

/// The cage called `name`: validated, with faces oriented outward. Errors name an unknown name or an option out of
/// range.
Result<Cage> generate_cage(std::string_view name, const CageOptions& options = {});

}  // namespace umbilic
