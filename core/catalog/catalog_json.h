// SPDX-License-Identifier: MIT
/// \file
/// The catalog's files: catalog.json with every number, and one file per minimizer with its points.
///
/// catalog.json: {"version", "functionals": [{"name", "weights"}], "shapes": [{"name", "genus", "junctions", "arms",
/// "cage"}], "entries": […], "starts": […]}, with the parts of reports under their names. A minimizer's file,
/// <shape>.<functional>.json, is the report of its run, see problem/text.h. Numbers have all their digits, and none is
/// a time.
#pragma once

#include <string>
#include <string_view>

#include "catalog/entry.h"
#include "catalog/report_json.h"

namespace umbilic::catalog {

/// "two-3.bending".
std::string entry_name(const CatalogShape& shape, const CatalogFunctional& functional);

/// A problem's options, with "certified_faces" and "second_family".
Json json_of(const EntrySettings& settings);

Json json_of(const Entry& entry);
Json json_of(const StartResult& start);
/// The report of a version of the program, in one line.
std::string minimizer_text(const Entry& entry, std::string_view version);

/// Everything but entries and starts.
Json empty_catalog(std::string_view version);

/// How far the recomputed energy of the last level may be from a stored one, relative to it. The same program on the
/// same instruction set gives the same digits. Other sets and compilers round differently, which changes the number of
/// steps: a converged level ends within 1e-6 of its minimum, so that 1e-5 is ample where all have converged; where one
/// has not, the paths part, and 0.1 bounds what is left.
double reproducibility(const Json& entry);

/// Empty where `again` agrees with `stored` within `reproducibility`; else what differs.
std::string difference(const Json& stored, const Json& again);
std::string start_difference(const Json& stored, const Json& again);

/// Empty where the surface in a minimizer's file has the energies of its entry, to 1e-9; else what does not fit.
std::string misfit(const Json& entry, std::string_view minimizer);

}  // namespace umbilic::catalog
