// SPDX-License-Identifier: MIT
/// \file
/// Reads cages from OBJ, OFF and PLY files. They are untrusted: every error names its line, or the element where bytes
/// are no lines.
#pragma once

#include <string>
#include <string_view>

#include "cage/cage.h"
#include "cage/read_limits.h"

namespace umbilic {

struct CheckedCage {
  Cage cage;
  CageReport report;  ///< with the repairs that the text needed, and what of it was ignored
};

/// Reads PLY when the first line is "ply", OFF when the first word is OFF (or COFF, NOFF, STOFF …), OBJ otherwise, and
/// validates. OBJ: `v`, `f` with v, v/vt, v//vn, v/vt/vn and negative indices, `g` and `o`, which both put the faces
/// after them into groups, line continuation and comments; everything else that OBJ knows is ignored, and where it
/// would change the surface (`t crease`), a note says so. PLY: text and binary, of the elements `vertex` and `face` the
/// properties `x`, `y`, `z` and `vertex_indices` or `vertex_index`, of any types; everything else is skipped. CRLF, CR
/// and a byte-order mark are accepted. What is larger than `limits` is refused as soon as it shows.
Result<CheckedCage> read_checked_cage(std::string_view file, const ReadLimits& limits = {});
/// The same without the report.
Result<Cage> read_cage(std::string_view file);

/// A file as a text that holds the same cage, for problems, which are text. A text is returned as it is, whether it
/// holds a cage or not. Binary PLY is read and validated, with errors as above; its polygons become OBJ with all
/// digits, not yet repaired.
Result<std::string> cage_text(std::string_view file);

}  // namespace umbilic
