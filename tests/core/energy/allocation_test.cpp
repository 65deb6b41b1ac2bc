// SPDX-License-Identifier: MIT
/// \file
/// An evaluation works in memory that the one before it has left: the C library's allocations are counted. This file is
/// not linked with the sanitized core (tests/CMakeLists.txt), since the address sanitizer has a malloc of its own.
#include <gtest/gtest.h>

#include <cstdlib>

#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "surface/all_caps.h"

#ifdef __GLIBC__
#define UMBILIC_COUNTS_ALLOCATIONS 1

namespace {
long allocations = 0;
}

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* at, std::size_t size) {
  ++allocations;
  return __libc_realloc(at, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
}
#else
#define UMBILIC_COUNTS_ALLOCATIONS 0
namespace {
long allocations = 0;
}
#endif

namespace umbilic::test {
namespace {

TEST(SurfaceEnergy, allocates_nothing_in_a_second_evaluation) {
  if (!UMBILIC_COUNTS_ALLOCATIONS) GTEST_SKIP();
  const Refined mesh = rough(trapezohedron(5), 2, 0.01, 8);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {4, 5, 1});
    for (const Weights& weights : {Weights{1}, Weights{0, 0, 0, 1}, Weights{1, 0, 0, 1}}) {
      const SurfaceEnergy energy(jets, weights);
      Points gradient;
      long before = allocations;
      energy.evaluate(mesh.control, &gradient);
      EXPECT_GT(allocations, before) << "or nothing is counted";
      energy.evaluate(mesh.control, nullptr);
      before = allocations;
      energy.evaluate(mesh.control, &gradient);
      EXPECT_EQ(allocations, before) << "cap " << static_cast<int>(cap);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
