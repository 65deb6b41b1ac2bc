// SPDX-License-Identifier: MIT
/// \file
/// Reads cages from OBJ and OFF text. The files are untrusted: every error names its line.
#pragma once

#include <string_view>

#include "cage/cage.h"
#include "cage/read_limits.h"

namespace umbilic {

struct CheckedCage {
  Cage cage;
  CageReport report;  ///< with the repairs that the text needed, and what of it was ignored
};

/// Reads OFF when the first word is OFF (or COFF, NOFF, STOFF …), OBJ otherwise, and validates. OBJ: `v`, `f` with v,
/// v/vt, v//vn, v/vt/vn and negative indices, `g` and `o`, which both put the faces after them into groups, line
/// continuation and comments; everything else that OBJ knows is ignored, and where it would change the surface (`t
/// crease`), a note says so. CRLF, CR and a byte-order mark are accepted. What is larger than `limits` is refused as
/// soon as it shows.
Result<CheckedCage> read_checked_cage(std::string_view text, const ReadLimits& limits = {});
/// The same without the report.
Result<Cage> read_cage(std::string_view text);

}  // namespace umbilic
