// SPDX-License-Identifier: MIT
/// \file
/// The namespace of everything that is compiled once per instruction set (base/instruction_set.h), templates and inline
/// functions included: without it the linker would keep one copy of each, for whatever processor it was compiled.
#pragma once

/// The build defines it where it compiles kernels; everything else sees the portable ones.
#ifndef UMBILIC_INSTRUCTION_SET
#define UMBILIC_INSTRUCTION_SET portable
#endif

/// To be opened as umbilic::UMBILIC_KERNELS; inline, so that its members are found in umbilic.
#define UMBILIC_KERNELS inline UMBILIC_INSTRUCTION_SET
