// SPDX-License-Identifier: MIT
/// \file
/// The catalog's files: catalog.json with every number, and one file per minimizer with its points.
///
/// catalog.json: {"version", "functionals": [{"name", "weights"}], "shapes": [{"name", "genus", "junctions", "arms",
/// "cage"}], "entries": […], "starts": […]}, in which parts of reports have their usual names. Holes have "sides" and
/// the "constraints" that their minimizers keep, too; their "energy" has the constant area of the cage's own surface as
/// its factor, like "free" in "energies". A minimizer's file, <shape>.<functional>.json, is the report of its run, see
/// problem/text.h; what it descends to is in <shape>.<functional>.below.json. A minimizer's file has its second opinion
/// (driver/second_opinion.h), of all integrals; the entry's "second_opinion" is {"energy", "difference"}: the minimized
/// functional as that finds it, and the main energy of the same surface minus this, relatively. Entries and starts that
/// an earlier version wrote lack what came later. Numbers have all their digits, and there are no times.
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

}  // namespace umbilic::catalog
