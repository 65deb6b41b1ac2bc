// SPDX-License-Identifier: MIT
/// \file
/// Fuzzes sequences of calls of the C contract. Each byte chooses a call, or an argument of the one before; cages are
/// so small, and levels so few, that a sequence takes milliseconds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "problem/json_node.h"
#include "tests/fuzz/targets.h"
#include "wasm/api.h"

namespace umbilic::fuzz {

namespace {

constexpr int kMostCalls = 24;
constexpr int kMostUnits = 16;  // of work in all, each about an energy evaluation
/// A run asked for level 1 takes the first level that can be evaluated.
constexpr int kFinestLevel = 3;

constexpr std::array<std::string_view, 9> kCages{
    R"({"generator":"cube"})",
    R"({"generator":"torus","segments":[3,3]})",
    R"({"text":"v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"})",
    R"({"text":"v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 2 0 0\nv 2 1 0\ng a\nf 1 2 3 4\ng b\nf 2 5 6 3\n"})",
    R"({"text":"ply\nformat ascii 1.0\nelement vertex 6\nproperty int x\nproperty int y\nproperty int z\nelement face 8\nproperty list int int vertex_indices\nend_header\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n"})",
    R"({"text":"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"})",
    R"({"generator":"cube","thickness":2})",
    R"({"file":"cube.obj"})",
    R"({"generator":"cube\u0000\u001b[2J"})"};

constexpr std::array<std::string_view, 8> kTerms{R"({"bending":1})",
                                                 R"({"willmore":1})",
                                                 R"({"mvs":1})",
                                                 R"({"mvs_cross":1})",
                                                 R"({"bending":0.5,"mehlum_tarrou":1})",
                                                 R"({"second_form_variation":1e-300})",
                                                 R"({"bending":1e300})",
                                                 R"({"bending":-1})"};

constexpr std::array<std::string_view, 12> kConstraints{
    R"({})",
    R"({"hold":{"faces":[1]}})",
    R"({"free":{"faces":[1,2]},"symmetric":true})",
    R"({"free":{"groups":["a"]}})",
    R"({"pins":[{"vertex":1}]})",
    R"({"pins":[{"face":1,"uv":[0.5,0.5],"at":[1,1,null]}],"symmetric":true})",
    R"({"pins":[{"vertex":2,"normal":true,"position":false}]})",
    R"({"closeness":{"weight":2}})",
    R"({"closeness":{"within":0.01}})",
    R"({"boundary":{"condition":"position"}})",
    R"({"boundary":{"condition":"free"}})",
    R"({"holes":{"faces":[1]},"boundary":{"condition":"curvature"}})"};

constexpr std::array<std::string_view, 4> kLevels{"[0,0]", "[1,1]", "[0,1]", "[1,0]"};
constexpr std::array<std::string_view, 3> kCaps{"smooth", "flat", "none"};
constexpr std::array<std::string_view, 6> kMetrics{"auto", "identity", "sobolev", "hessian", "newton", "none"};

constexpr std::array<std::string_view, 8> kTargetTexts{R"({})",
                                                       R"({"terms":{"willmore":1}})",
                                                       R"({"terms":{"mvs":1,"bending":1}})",
                                                       R"({"pins":[{"at":[0.5,1,0.5]}]})",
                                                       R"({"pins":[{}]})",
                                                       R"({"closeness":5})",
                                                       R"({"terms":{}})",
                                                       R"({"pins":[{},{"normal":[0,0,1]}])"};

constexpr std::array<std::string_view, 5> kFiles{
    "v 0 0 0", "ply\nformat ascii 1.0\n", "ply\nformat binary_little_endian 1.0\n",
    "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
    "element face 1\nproperty list char char vertex_index\nend_header\n\1\1\1\2\1\1\1\3\1\3\1\2\1",
    "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
    "element face 1\nproperty list char char vertex_index\nend_header\n\1\1\1\2\1\1\1\3\1\3\1\2\3"};

constexpr std::array<std::int32_t, 6> kIntegers{
    1, 2, 0, -1, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};

/// Takes choices off the front of some bytes; of none left each is the first.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }

  int below(int count) {
    if (bytes_.empty()) return 0;
    const int byte = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte % count;
  }

  template <class T, std::size_t n>
  const T& of(const std::array<T, n>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(n)))];
  }

 private:
  std::string_view bytes_;
};

/// One handle of each kind, or none, and the calls on them.
class Caller {
 public:
  explicit Caller(std::string_view bytes) : choices_(bytes) {}
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  ~Caller() {
    umbilic_cage_destroy(cage_);
    umbilic_run_destroy(run_);
    umbilic_certificate_destroy(certificate_);
    umbilic_mesh_destroy(mesh_);
  }

  void call_all() {
    create_run();
    for (int call = 0; call < kMostCalls && !choices_.empty(); ++call) call_one();
  }

 private:
  void call_one() {
    switch (choices_.below(18)) {
      case 0: return create_run();
      case 1: return create_cage();
      case 2: return step_run();
      case 3: return ask_part();
      case 4: return ask_report();
      case 5: return ask_state();
      case 6: return draw_run();
      case 7: return retarget();
      case 8: return answered(umbilic_run_cancel(run_));
      case 9: return certify();
      case 10: return step_certificate();
      case 11: return ask_certificate();
      case 12: return descend();
      case 13: return view();
      case 14: return restart();
      case 15: return ask_names();
      case 16: return draw_densities();
      default: return read_file();
    }
  }

  /// Whether a call that costs so many units is still to be made; then they are spent.
  bool affords(int units) {
    if (units_ + units > kMostUnits) return false;
    units_ += units;
    return true;
  }

  /// A status that puts the blame on this program or on its user, with words.
  void answered(umbilic_status status) {
    if (status == UMBILIC_OK) return;
    require(status == UMBILIC_BAD_INPUT || status == UMBILIC_BAD_ARGUMENT, "the library makes no mistakes");
    std::string message(umbilic_copy_message(nullptr, 0), '\0');
    umbilic_copy_message(message.data(), message.size() + 1);
    require_words(message);
  }

  /// Calls what answers with JSON.
  template <class Call>
  void expect_json(const Call& call) {
    umbilic_text text{"before", 6};
    const umbilic_status status = call(&text);
    answered(status);
    if (status != UMBILIC_OK) return require(text.length == 6, "a failure leaves a text as it was");
    require(parse_json({text.data, text.length}).ok(), "an answer is JSON");
    require(text.data[text.length] == '\0', "a zero follows a text");
  }

  /// Calls what makes a handle, in place of the one before.
  template <class Handle, class Call, class Destroy>
  void make(Handle*& handle, const Destroy& destroy, const Call& call) {
    Handle* made = nullptr;
    const umbilic_status status = call(&made);
    answered(status);
    require((status == UMBILIC_OK) == (made != nullptr), "there is a handle exactly if nothing failed");
    if (!made) return;
    destroy(handle);
    handle = made;
  }

  std::string problem(std::string_view start = "") {
    const std::string_view cage = choices_.of(kCages), terms = choices_.of(kTerms);
    const std::string_view constraints = choices_.of(kConstraints), levels = choices_.of(kLevels);
    const std::string_view cap = choices_.of(kCaps), metric = choices_.of(kMetrics);
    const int flags = choices_.below(8);
    return fmt::format(R"({{"umbilic":"problem","version":1,"cage":{},"terms":{},"constraints":{},)"
                       R"("options":{{"levels":{},"cap":"{}","metric":"{}","symmetry":{},"max_iterations":3{}}}{}{}}})",
                       cage, terms, constraints, levels, cap, metric, flags & 1 ? "false" : "true",
                       flags & 2 ? R"(,"accuracy":0.1)" : "", flags & 4 ? R"(,"fill":{})" : "", start);
  }

  void create_run() {
    const std::string text = problem();
    if (!affords(2)) return;
    make(run_, umbilic_run_destroy,
         [&](umbilic_run** out) { return umbilic_run_create(text.data(), text.size(), nullptr, 0, out); });
  }

  /// Begins a run where this one is.
  void restart() {
    std::int32_t level = 0;
    const double* points = nullptr;
    std::size_t count = 0;
    if (umbilic_run_state(run_, &level, &points, &count) != UMBILIC_OK) return;
    if (!affords(2)) return;
    const std::string text = problem(fmt::format(R"(,"start":{{"level":{},"points":[]}})", level));
    const std::size_t given = choices_.below(4) == 1 ? count - 1 : count;
    make(run_, umbilic_run_destroy,
         [&](umbilic_run** out) { return umbilic_run_create(text.data(), text.size(), points, given, out); });
  }

  void create_cage() {
    const std::string_view text = choices_.of(kCages);
    make(cage_, umbilic_cage_destroy,
         [&](umbilic_cage** out) { return umbilic_cage_create(text.data(), text.size(), out); });
    expect_json([&](umbilic_text* counts) { return umbilic_cage_counts(cage_, counts); });
    make(mesh_, umbilic_mesh_destroy, [&](umbilic_mesh** out) { return umbilic_cage_mesh(cage_, out); });
  }

  /// Of a step: what is asked for, as far as it can be afforded.
  std::int32_t units() {
    const std::int32_t asked = std::min(choices_.of(kIntegers), 4);
    return asked <= 0 || affords(asked) ? asked : 0;
  }

  void step_run() {
    std::int32_t done = 77;
    const umbilic_status status = umbilic_run_step(run_, units(), &done);
    answered(status);
    require(status == UMBILIC_OK ? done == 0 || done == 1 : done == 77, "a step says whether it was the last");
  }

  void ask_part() {
    const std::int32_t part = choices_.below(11) - 1;
    if (part == UMBILIC_PART_ENERGIES && !affords(4)) return;
    expect_json([&](umbilic_text* text) { return umbilic_run_part(run_, part, text); });
  }

  void ask_report() {
    const umbilic_certificate* with = choices_.below(2) ? certificate_ : nullptr;
    if (!affords(4)) return;
    expect_json([&](umbilic_text* text) { return umbilic_run_report(run_, with, text); });
  }

  template <class Call>
  void expect_points(const Call& call) {
    std::int32_t level = -7;
    const double* points = nullptr;
    std::size_t count = 0;
    const umbilic_status status = call(&level, &points, &count);
    answered(status);
    if (status != UMBILIC_OK)
      return require(level == -7 && !points && count == 0, "a failure leaves outputs as they were");
    require(level >= 0 && level <= kFinestLevel && count > 0, "a surface has points and a level");
    for (std::size_t i = 0; i < 3 * count; ++i) require(std::isfinite(points[i]), "a surface is finite");
  }

  void ask_state() {
    expect_points([&](auto... outputs) { return umbilic_run_state(run_, outputs...); });
  }

  void draw_run() {
    const std::int32_t density = choices_.of(kIntegers);
    if (!affords(1)) return;
    make(mesh_, umbilic_mesh_destroy, [&](umbilic_mesh** out) {
      return density == 2 ? umbilic_run_control_mesh(run_, out) : umbilic_run_limit_mesh(run_, density, out);
    });
  }

  void draw_densities() {
    const std::int32_t density = choices_.of(kIntegers);
    const std::string_view terms = choices_.of(kTerms);
    if (!affords(2)) return;
    make(mesh_, umbilic_mesh_destroy, [&](umbilic_mesh** out) {
      return umbilic_run_limit_mesh_with_densities(run_, density, terms.data(), terms.size(), out);
    });
  }

  void read_file() {
    const std::string_view file = choices_.of(kFiles);
    const std::int32_t threads = choices_.of(kIntegers);
    umbilic_text text{"before", 6};
    const umbilic_status status = umbilic_cage_text(file.data(), file.size(), &text);
    answered(status);
    if (status == UMBILIC_OK) {
      require(text.data[text.length] == '\0', "a zero follows a text");
    } else {
      require(text.length == 6, "a failure leaves a text as it was");
    }
    answered(umbilic_use_threads(threads));
    answered(umbilic_use_threads(1));
  }

  void retarget() {
    const std::string_view text = choices_.of(kTargetTexts);
    answered(umbilic_run_retarget(run_, text.data(), text.size()));
  }

  void certify() {
    if (!affords(4)) return;
    make(certificate_, umbilic_certificate_destroy,
         [&](umbilic_certificate** out) { return umbilic_run_certify(run_, out); });
  }

  void step_certificate() {
    std::int32_t done = 77;
    const umbilic_status status = umbilic_certificate_step(certificate_, units(), &done);
    answered(status);
    require(status == UMBILIC_OK ? done == 0 || done == 1 : done == 77, "a step says whether it was the last");
    double progress = -1;
    if (umbilic_certificate_progress(certificate_, &progress) == UMBILIC_OK) {
      require(progress >= 0 && progress <= 1, "progress is a fraction");
    }
  }

  void ask_certificate() {
    expect_json([&](umbilic_text* text) { return umbilic_certificate_report(certificate_, text); });
  }

  void descend() {
    if (!affords(8)) return;
    expect_points([&](auto... outputs) { return umbilic_certificate_descent(certificate_, outputs...); });
  }

  void view() {
    umbilic_mesh_arrays arrays{};
    const umbilic_status status = umbilic_mesh_view(mesh_, &arrays);
    answered(status);
    if (status != UMBILIC_OK) return;
    for (std::size_t i = 0; i < 3 * arrays.triangle_count; ++i) {
      require(arrays.triangles[i] < arrays.vertex_count, "a triangle has vertices");
    }
    for (std::size_t i = 0; i < 2 * arrays.edge_count; ++i) {
      require(arrays.edges[i] < arrays.vertex_count, "an edge has vertices");
    }
    for (std::size_t i = 0; i < 3 * arrays.vertex_count; ++i) {
      require(std::isfinite(arrays.positions[i]), "a vertex is finite");
    }
    const float* densities = nullptr;
    std::size_t count = 0;
    answered(umbilic_mesh_densities(mesh_, &densities, &count));
    require(count == (densities ? arrays.vertex_count : 0), "each vertex has a density, or none has");
    for (std::size_t i = 0; i < count; ++i) require(!std::isnan(densities[i]), "a density is a number");
    umbilic_text obj{};
    answered(umbilic_mesh_obj(mesh_, &obj));
  }

  void ask_names() {
    const std::string_view terms = choices_.of(kTerms);
    const double ratio = (choices_.below(6) - 1) / 4.0;
    require(umbilic_api_version() == UMBILIC_API_VERSION && umbilic_version()[0] != '\0', "the library has a version");
    expect_json([](umbilic_text* text) { return umbilic_cage_names(text); });
    expect_json([](umbilic_text* text) { return umbilic_functional_names(text); });
    expect_json([&](umbilic_text* text) { return umbilic_torus_energies(ratio, text); });
    expect_json([&](umbilic_text* text) { return umbilic_torus_minimizer(terms.data(), terms.size(), text); });
  }

  Choices choices_;
  int units_ = 0;
  umbilic_cage* cage_ = nullptr;
  umbilic_run* run_ = nullptr;
  umbilic_certificate* certificate_ = nullptr;
  umbilic_mesh* mesh_ = nullptr;
};

}  // namespace

void contract(std::string_view choices) { Caller(choices).call_all(); }

}  // namespace umbilic::fuzz
