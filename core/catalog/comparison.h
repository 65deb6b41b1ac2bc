// SPDX-License-Identifier: MIT
/// \file
/// Compares stored entries with recomputed ones, and with the surfaces in their files.
///
/// The same program with the same kernels (base/instruction_set.h) gives the same digits. Other compilers round
/// differently, which can change the number of steps; a converged level still ends within 1e-6 of its minimum. With the
/// kernels of another instruction set, a run may also end in another local minimum of the parametrization, some 1e-4
/// away. Then an energy agrees if it lies within the error bar that the stored entry has.
#pragma once

#include <string>
#include <string_view>

#include "catalog/report_json.h"

namespace umbilic::catalog {

/// Whose kernels computed a stored result, beside those that computed it again.
enum class Kernels {
  kSame,
  kOther,  ///< those of another instruction set
};

/// Whether `instruction_set`, as a report has it, is the one in use. A report that names none counts as kSame.
Kernels kernels_of(std::string_view instruction_set);

/// By how much a recomputed energy of the entry may differ, relatively: 1e-5 if all levels have converged. If one has
/// not, the runs may take different paths, and 0.1 bounds the difference.
double reproducibility(const Json& entry);

/// Says what differs between `stored` and `again` beyond what the kernels explain; empty if they agree.
/// With the same kernels the status is the same, and the energies of the last level and of what the entry descends to
/// agree to `reproducibility`. With others, those of all levels and of the entry agree to the stored entry's `error`,
/// to 1e-3 where it has none; and one status may be "upper_bound" where the other is "converged", unless the bound is
/// below the error bar of the limit.
/// The second opinions are compared as energies are, where both have one.
std::string difference(const Json& stored, const Json& again, Kernels kernels);
std::string start_difference(const Json& stored, const Json& again, Kernels kernels);

/// Says which energies of the surface in a minimizer's file differ from its entry by more than 1e-9; empty if none
/// does.
std::string misfit(const Json& entry, std::string_view minimizer);

}  // namespace umbilic::catalog
