// SPDX-License-Identifier: MIT
/// \file
/// The catalog's files: catalog.json with every number, and one file per minimizer with its points.
///
/// catalog.json: {"version", "functionals": [{"name", "weights"}], "shapes": [{"name", "genus", "junctions", "arms",
/// "cage"}], "entries": […], "starts": […]}, in which parts of reports have their usual names. A minimizer's file,
/// <shape>.<functional>.json, is the report of its run, see problem/text.h; what it descends to is in
/// <shape>.<functional>.below.json. Numbers have all their digits, and there
/// are no times.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalog/entry.h"
#include "catalog/report_json.h"

namespace umbilic::catalog {

/// The name of an entry, such as "two-3.bending".
std::string entry_name(const CatalogShape& shape, const CatalogFunctional& functional);

/// A problem's options, with "certified_faces" and "second_family".
Json json_of(const EntrySettings& settings);

Json json_of(const Entry& entry);
Json json_of(const StartResult& start);
/// The report of the entry's run by this version of the program, in one line.
std::string minimizer_text(const Entry& entry, std::string_view version);
/// The same of what the minimizer descends to, if it does.
std::optional<std::string> below_text(const Entry& entry, std::string_view version);

/// A catalog without entries and starts.
Json empty_catalog(std::string_view version);

/// How much the recomputed energy of the last level may differ from the stored one, relatively. The same program on the
/// same instruction set gives the same digits. Others round differently, which can change the number of steps. A
/// converged level ends within 1e-6 of its minimum, so 1e-5 suffices if all levels have converged. If one has not, the
/// runs may take different paths, and 0.1 bounds the difference.
double reproducibility(const Json& entry);

/// Says what differs between `stored` and `again` beyond `reproducibility`; empty if they agree.
std::string difference(const Json& stored, const Json& again);
std::string start_difference(const Json& stored, const Json& again);

/// Says which energies of the surface in a minimizer's file differ from its entry by more than 1e-9; empty if none
/// does.
std::string misfit(const Json& entry, std::string_view minimizer);

}  // namespace umbilic::catalog
