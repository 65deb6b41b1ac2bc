// SPDX-License-Identifier: MIT
/// \file
/// The contract except for runs: versions, names, cages, tori and meshes.
#include "wasm/api.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "base/threads.h"
#include "cage/generate.h"
#include "cage/read.h"
#include "cage/write.h"
#include "driver/surface.h"
#include "energy/torus.h"
#include "problem/cage_of.h"
#include "problem/json_node.h"
#include "problem/text.h"
#include "wasm/guard.h"
#include "wasm/handles.h"

using namespace umbilic;
using namespace umbilic::api;

static_assert(kLongestJson == UMBILIC_MAX_TEXT);

// The header's version is that of package.json, which the build passes.
#define UMBILIC_DIGITS(number) #number
#define UMBILIC_JOIN(major, minor, patch) UMBILIC_DIGITS(major) "." UMBILIC_DIGITS(minor) "." UMBILIC_DIGITS(patch)
static_assert(std::string_view(UMBILIC_VERSION) ==
                  UMBILIC_JOIN(UMBILIC_VERSION_MAJOR, UMBILIC_VERSION_MINOR, UMBILIC_VERSION_PATCH),
              "the version in api.h is not that of package.json");

namespace {

template <class T>
const T* data_or_null(const std::vector<T>& values) {
  return values.empty() ? nullptr : values.data();
}

}  // namespace

int32_t umbilic_api_version(void) { return UMBILIC_API_VERSION; }

const char* umbilic_version(void) { return UMBILIC_VERSION; }

size_t umbilic_copy_message(char* buffer, size_t capacity) {
  const std::string_view message = last_message();
  if (buffer && capacity > 0) {
    const size_t length = std::min(capacity - 1, message.size());
    std::memcpy(buffer, message.data(), length);
    buffer[length] = '\0';
  }
  return message.size();
}

umbilic_status umbilic_use_threads(int32_t count) {
  return guarded([&] {
    if (count < 1 || count > kMostThreads) {
      return fail(UMBILIC_BAD_ARGUMENT, fmt::format("threads: {} is not from 1 to {}", count, kMostThreads));
    }
    use_threads(count);
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_cage_names(umbilic_text* names) {
  return guarded([&] {
    if (!all_given(names)) return UMBILIC_BAD_ARGUMENT;
    std::vector<std::string> all;
    for (const CageName& cage : cage_names()) {
      if (!cage.open) all.push_back(cage.name);
    }
    return answer(json_text(all), names);
  });
}

umbilic_status umbilic_functional_names(umbilic_text* names) {
  return guarded([&] {
    if (!all_given(names)) return UMBILIC_BAD_ARGUMENT;
    return answer(json_text(std::vector(kFunctionalNames.begin(), kFunctionalNames.end())), names);
  });
}

umbilic_status umbilic_cage_create(const char* text, size_t length, umbilic_cage** out) {
  return guarded([&] {
    if (!all_given(text, out)) return UMBILIC_BAD_ARGUMENT;
    const Result<CageInput> input = parse_cage({text, length});
    if (!input) return fail(input.error());
    Result<CheckedCage> cage = cage_of(*input);
    if (!cage) return fail(cage.error());
    *out = new umbilic_cage{std::move(cage->cage), std::move(cage->report)};
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_cage_text(const char* file, size_t length, umbilic_text* text) {
  return guarded([&] {
    if (!all_given(file, text)) return UMBILIC_BAD_ARGUMENT;
    Result<std::string> cage = cage_text({file, length});
    if (!cage) return fail(cage.error());
    return answer(std::move(cage).value(), text);
  });
}

void umbilic_cage_destroy(umbilic_cage* cage) { delete cage; }

umbilic_status umbilic_cage_counts(const umbilic_cage* cage, umbilic_text* counts) {
  return guarded([&] {
    if (!all_given(cage, counts)) return UMBILIC_BAD_ARGUMENT;
    return answer(json_text(cage->report), counts);
  });
}

umbilic_status umbilic_cage_mesh(const umbilic_cage* cage, umbilic_mesh** out) {
  return guarded([&] {
    if (!all_given(cage, out)) return UMBILIC_BAD_ARGUMENT;
    hand_out(cage->cage, {}, out);
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_torus_energies(double ratio, umbilic_text* energies) {
  return guarded([&] {
    if (!all_given(energies)) return UMBILIC_BAD_ARGUMENT;
    if (!(ratio > 0 && ratio < 1)) return fail(Error{fmt::format("ratio {} is not between 0 and 1", ratio)});
    return answer(json_text(FunctionalValues{torus_energies(ratio)}), energies);
  });
}

umbilic_status umbilic_torus_minimizer(const char* terms, size_t length, umbilic_text* minimizer) {
  return guarded([&] {
    if (!all_given(terms, minimizer)) return UMBILIC_BAD_ARGUMENT;
    const Result<Weights> weights = parse_terms({terms, length});
    if (!weights) return fail(weights.error());
    return answer(json_text(torus_minimizer(*weights)), minimizer);
  });
}

umbilic_status umbilic_mesh_view(const umbilic_mesh* mesh, umbilic_mesh_arrays* arrays) {
  return guarded([&] {
    if (!all_given(mesh, arrays)) return UMBILIC_BAD_ARGUMENT;
    const DrawableMesh& drawn = mesh->drawable;
    *arrays = {data_or_null(drawn.positions),  data_or_null(drawn.normals),
               data_or_null(drawn.curvatures), data_or_null(drawn.triangles),
               data_or_null(drawn.faces),      data_or_null(drawn.edges),
               drawn.positions.size() / 3,     drawn.triangles.size() / 3,
               drawn.edges.size() / 2,         {drawn.centre.x(), drawn.centre.y(), drawn.centre.z()}};
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_mesh_densities(const umbilic_mesh* mesh, const float** densities, size_t* count) {
  return guarded([&] {
    if (!all_given(mesh, densities, count)) return UMBILIC_BAD_ARGUMENT;
    *densities = data_or_null(mesh->drawable.densities);
    *count = mesh->drawable.densities.size();
    return UMBILIC_OK;
  });
}

umbilic_status umbilic_mesh_obj(const umbilic_mesh* mesh, umbilic_text* obj) {
  return guarded([&] {
    if (!all_given(mesh, obj)) return UMBILIC_BAD_ARGUMENT;
    const LimitMesh& limit = mesh->limit;
    const bool polygons = limit.quads.empty();
    return answer(polygons ? write_obj(mesh->cage) : write_obj(limit.positions, limit.normals, limit.quads), obj);
  });
}

void umbilic_mesh_destroy(umbilic_mesh* mesh) { delete mesh; }
