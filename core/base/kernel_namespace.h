// SPDX-License-Identifier: MIT
/// \file
/// The namespace of all code that is compiled once per instruction set (base/instruction_set.h), including templates
/// and inline functions. Without it the linker would keep a single copy of each, compiled for an arbitrary processor.
#pragma once

/// The build defines this name while it compiles kernels; all other code sees the portable kernels.
#ifndef UMBILIC_INSTRUCTION_SET
#define UMBILIC_INSTRUCTION_SET portable
#endif

/// Open it as umbilic::UMBILIC_KERNELS. It is inline, so its members are also found in umbilic.
#define UMBILIC_KERNELS inline UMBILIC_INSTRUCTION_SET
