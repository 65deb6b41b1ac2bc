// SPDX-License-Identifier: MIT
/// \file
/// The C contract in wrong hands: null pointers, numbers out of range, texts that are none, memory that runs out at
/// every allocation in turn, threads. Each call answers with a status; the sanitizers see the rest.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "cage/generate.h"
#include "cage/ply_writer.h"
#include "tests/wasm/runs.h"
#include "wasm/api.h"
#include "wasm/guard.h"

namespace {

/// Allocations of this thread until one fails; negative: none does.
thread_local std::int64_t g_allocations_left = -1;

void* allocate(std::size_t size) {
  if (g_allocations_left == 0) throw std::bad_alloc();
  if (g_allocations_left > 0) --g_allocations_left;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return g_allocations_left == 0 ? nullptr : std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace umbilic::test {
namespace {

constexpr int32_t kIntegers[] = {std::numeric_limits<int32_t>::min(), -1, 0, 1, 7, 512,
                                 std::numeric_limits<int32_t>::max()};

std::string cube_problem() { return problem_text(bending_of("cube", 1, 1), JsonPrinter::Layout::kCompact); }

/// Whether a status is one of the enumeration, and a failure has words.
void expect_an_answer(umbilic_status status) {
  EXPECT_GE(status, UMBILIC_OK);
  EXPECT_LE(status, UMBILIC_BAD_ARGUMENT) << message();
  EXPECT_TRUE(status == UMBILIC_OK || !message().empty());
}

/// One of each handle.
class Contract : public testing::Test {
 protected:
  Contract() {
    const std::string text = R"({"generator": "cube"})";
    EXPECT_EQ(umbilic_cage_create(text.data(), text.size(), &cage), UMBILIC_OK);
    run = begun(bending_of("cube", 1, 1));
    EXPECT_EQ(umbilic_run_certify(run, &certificate), UMBILIC_OK);
    EXPECT_EQ(umbilic_cage_mesh(cage, &mesh), UMBILIC_OK);
  }
  ~Contract() override {
    umbilic_cage_destroy(cage);
    umbilic_run_destroy(run);
    umbilic_certificate_destroy(certificate);
    umbilic_mesh_destroy(mesh);
  }

  umbilic_cage* cage = nullptr;
  umbilic_run* run = nullptr;
  umbilic_certificate* certificate = nullptr;
  umbilic_mesh* mesh = nullptr;
};

TEST_F(Contract, answers_a_null_pointer_with_a_status_and_writes_nothing) {
  const std::string problem = cube_problem();
  const char* text = problem.data();
  const size_t length = problem.size();
  umbilic_text answer{"before", 6};
  umbilic_cage* no_cage = nullptr;
  umbilic_run* no_run = nullptr;
  umbilic_certificate* no_certificate = nullptr;
  umbilic_mesh* no_mesh = nullptr;
  umbilic_mesh_arrays arrays{};
  int32_t done = 77, level = 77;
  double number = 77;
  const double* points = nullptr;
  const float* densities = nullptr;
  size_t count = 77;
  const umbilic_status statuses[] = {
      umbilic_cage_names(nullptr),
      umbilic_functional_names(nullptr),
      umbilic_cage_create(nullptr, 3, &no_cage),
      umbilic_cage_create(text, length, nullptr),
      umbilic_cage_text(nullptr, 3, &answer),
      umbilic_cage_text(text, length, nullptr),
      umbilic_cage_counts(nullptr, &answer),
      umbilic_cage_counts(cage, nullptr),
      umbilic_cage_mesh(nullptr, &no_mesh),
      umbilic_cage_mesh(cage, nullptr),
      umbilic_torus_energies(0.5, nullptr),
      umbilic_torus_minimizer(nullptr, 3, &answer),
      umbilic_torus_minimizer(text, length, nullptr),
      umbilic_run_create(nullptr, 3, nullptr, 0, &no_run),
      umbilic_run_create(text, length, nullptr, 0, nullptr),
      umbilic_run_create(text, length, nullptr, 3, &no_run),
      umbilic_run_step(nullptr, 1, &done),
      umbilic_run_step(run, 1, nullptr),
      umbilic_run_retarget(nullptr, text, length),
      umbilic_run_retarget(run, nullptr, 3),
      umbilic_run_cancel(nullptr),
      umbilic_run_part(nullptr, UMBILIC_PART_LEVELS, &answer),
      umbilic_run_part(run, UMBILIC_PART_LEVELS, nullptr),
      umbilic_run_report(nullptr, nullptr, &answer),
      umbilic_run_report(run, nullptr, nullptr),
      umbilic_run_state(nullptr, &level, &points, &count),
      umbilic_run_state(run, nullptr, &points, &count),
      umbilic_run_state(run, &level, nullptr, &count),
      umbilic_run_state(run, &level, &points, nullptr),
      umbilic_run_control_mesh(nullptr, &no_mesh),
      umbilic_run_control_mesh(run, nullptr),
      umbilic_run_limit_mesh(nullptr, 1, &no_mesh),
      umbilic_run_limit_mesh(run, 1, nullptr),
      umbilic_run_limit_mesh_with_densities(nullptr, 1, text, length, &no_mesh),
      umbilic_run_limit_mesh_with_densities(run, 1, nullptr, 3, &no_mesh),
      umbilic_run_limit_mesh_with_densities(run, 1, text, length, nullptr),
      umbilic_run_certify(nullptr, &no_certificate),
      umbilic_run_certify(run, nullptr),
      umbilic_certificate_step(nullptr, 1, &done),
      umbilic_certificate_step(certificate, 1, nullptr),
      umbilic_certificate_progress(nullptr, &number),
      umbilic_certificate_progress(certificate, nullptr),
      umbilic_certificate_report(nullptr, &answer),
      umbilic_certificate_report(certificate, nullptr),
      umbilic_certificate_descent(nullptr, &level, &points, &count),
      umbilic_certificate_descent(certificate, nullptr, &points, &count),
      umbilic_mesh_view(nullptr, &arrays),
      umbilic_mesh_view(mesh, nullptr),
      umbilic_mesh_densities(nullptr, &densities, &count),
      umbilic_mesh_densities(mesh, nullptr, &count),
      umbilic_mesh_densities(mesh, &densities, nullptr),
      umbilic_mesh_obj(nullptr, &answer),
      umbilic_mesh_obj(mesh, nullptr),
  };
  int i = 0;
  for (const umbilic_status status : statuses) EXPECT_EQ(status, UMBILIC_BAD_ARGUMENT) << "call " << i++;
  EXPECT_EQ(message(), "a null pointer");
  EXPECT_STREQ(answer.data, "before");
  EXPECT_EQ(done, 77);
  EXPECT_EQ(level, 77);
  EXPECT_EQ(number, 77);
  EXPECT_EQ(count, 77u);
  EXPECT_TRUE(!no_cage && !no_run && !no_certificate && !no_mesh && !points && !densities && !arrays.positions);
  umbilic_cage_destroy(nullptr);
  umbilic_run_destroy(nullptr);
  umbilic_certificate_destroy(nullptr);
  umbilic_mesh_destroy(nullptr);
}

TEST_F(Contract, checks_every_number) {
  umbilic_text text{};
  for (const int32_t number : kIntegers) {
    EXPECT_EQ(umbilic_run_part(run, number, &text), number >= 0 && number <= 7 ? UMBILIC_OK : UMBILIC_BAD_ARGUMENT);
    umbilic_mesh* limit = nullptr;
    const bool too_large = number > 10'000;
    if (number <= 7 || too_large) {
      const umbilic_status expected = number < 1 ? UMBILIC_BAD_ARGUMENT : too_large ? UMBILIC_BAD_INPUT : UMBILIC_OK;
      EXPECT_EQ(umbilic_run_limit_mesh(run, number, &limit), expected) << number;
    }
    umbilic_mesh_destroy(limit);
    int32_t done = -1;
    EXPECT_EQ(umbilic_run_step(run, number, &done), number >= 0 ? UMBILIC_OK : UMBILIC_BAD_ARGUMENT);
    EXPECT_EQ(umbilic_certificate_step(certificate, number, &done), number >= 0 ? UMBILIC_OK : UMBILIC_BAD_ARGUMENT);
  }
  for (const double ratio : {-1.0, 0.0, 1.0, 1e308, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(umbilic_torus_energies(ratio, &text), UMBILIC_BAD_INPUT) << ratio;
  }
}

TEST_F(Contract, checks_points_and_their_number) {
  Problem problem = bending_of("cube", 1, 1);
  const std::string without = problem_text(problem);
  problem.start = SurfaceState{1, {}};
  const std::string with = problem_text(problem);
  const double points[9] = {};
  umbilic_run* made = nullptr;
  EXPECT_EQ(umbilic_run_create(without.data(), without.size(), points, 1, &made), UMBILIC_BAD_ARGUMENT);
  EXPECT_EQ(umbilic_run_create(with.data(), with.size(), points, SIZE_MAX, &made), UMBILIC_BAD_ARGUMENT);
  EXPECT_EQ(umbilic_run_create(with.data(), with.size(), points, SIZE_MAX / 24, &made), UMBILIC_BAD_ARGUMENT);
  EXPECT_EQ(umbilic_run_create(with.data(), with.size(), points, 0, &made), UMBILIC_BAD_INPUT);
  EXPECT_EQ(umbilic_run_create(with.data(), with.size(), points, 2, &made), UMBILIC_BAD_INPUT);
  EXPECT_NE(message().find("start: 2 points: expected 3, one for each orbit"), std::string::npos) << message();
  const double endless[9] = {1, 2, 3, 4, std::numeric_limits<double>::infinity(), 6, 7, 8, 9};
  EXPECT_EQ(umbilic_run_create(with.data(), with.size(), endless, 3, &made), UMBILIC_BAD_INPUT);
  EXPECT_EQ(message(), "start: point 2 is not finite");
  EXPECT_EQ(made, nullptr);
}

TEST_F(Contract, reads_or_refuses_any_text) {
  std::mt19937 random(3);
  const std::string texts[] = {cube_problem(), R"({"generator": "cube"})", R"({"bending": 1})",
                               report_text(report_of(begun(bending_of("cube", 1, 1))))};
  const auto try_all = [](const std::string& text) {
    umbilic_cage* a_cage = nullptr;
    umbilic_run* a_run = nullptr;
    umbilic_text answer{};
    expect_an_answer(umbilic_cage_create(text.data(), text.size(), &a_cage));
    expect_an_answer(umbilic_run_create(text.data(), text.size(), nullptr, 0, &a_run));
    expect_an_answer(umbilic_torus_minimizer(text.data(), text.size(), &answer));
    umbilic_cage_destroy(a_cage);
    umbilic_run_destroy(a_run);
  };
  for (const std::string& text : texts) {
    try_all(text);
    for (int i = 0; i < 60; ++i) {
      try_all(text.substr(0, random() % text.size()));
      std::string changed = text;
      for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<char>(random() % 256);
      try_all(changed);
      std::string spliced = text;
      spliced.insert(random() % spliced.size(), texts[random() % 4]);
      try_all(spliced);
    }
  }
  try_all(std::string(100'000, '['));
  try_all(std::string(1000, '\0'));
  try_all("");
}

TEST_F(Contract, takes_calls_in_any_order) {
  std::mt19937 random(4);
  const auto integer = [&] { return kIntegers[random() % 5]; };  // the larger ones take long
  for (int i = 0; i < 400; ++i) {
    umbilic_text text{};
    int32_t done = 0, level = 0;
    const double* points = nullptr;
    size_t count = 0;
    double progress = 0;
    umbilic_mesh* made = nullptr;
    umbilic_certificate* another = nullptr;
    const std::string targets =
        random() % 2
            ? fmt::format(R"({{"terms": {{"bending": {}}}}})", integer())
            : fmt::format(R"({{"points": [{}]}})", fmt::join(std::vector(3 * (random() % 2 ? 8 : 7), 0.5), ","));
    switch (random() % 11) {
      case 0: expect_an_answer(umbilic_run_step(run, integer(), &done)); break;
      case 1: expect_an_answer(umbilic_run_part(run, integer(), &text)); break;
      case 2: expect_an_answer(umbilic_run_report(run, random() % 2 ? certificate : nullptr, &text)); break;
      case 3: expect_an_answer(umbilic_run_state(run, &level, &points, &count)); break;
      case 4: expect_an_answer(umbilic_run_limit_mesh(run, integer(), &made)); break;
      case 5: expect_an_answer(umbilic_run_control_mesh(run, &made)); break;
      case 6: expect_an_answer(umbilic_certificate_step(certificate, integer(), &done)); break;
      case 7: expect_an_answer(umbilic_certificate_progress(certificate, &progress)); break;
      case 8: expect_an_answer(umbilic_run_certify(run, &another)); break;
      case 9:
        if (i > 300) expect_an_answer(umbilic_run_cancel(run));
        break;
      case 10: expect_an_answer(umbilic_run_retarget(run, targets.data(), targets.size())); break;
    }
    umbilic_mesh_destroy(made);
    umbilic_certificate_destroy(another);
  }
}

/// Calls `call`, whose n-th allocation fails, for n = 0, 1, … until it succeeds.
template <class Call>
void expect_out_of_memory_until_there_is_enough(const char* what, const Call& call) {
  for (std::int64_t n = 0;; n = n < 300 ? n + 1 : n + 1 + n / 8) {
    g_allocations_left = n;
    const umbilic_status status = call();
    g_allocations_left = -1;
    if (status == UMBILIC_OK) return;
    ASSERT_EQ(status, UMBILIC_OUT_OF_MEMORY) << what << ", allocation " << n << ": " << message();
    ASSERT_LT(n, 100'000'000);
  }
}

TEST_F(Contract, survives_the_failure_of_any_allocation) {
  const std::string text = R"({"generator": "cube"})", problem = cube_problem(), terms = R"({"bending": 1})";
  const std::string ply = write_ply(generate_cage("cube").value(), "binary_little_endian");
  umbilic_text answer{};
  const auto out_of_memory = expect_out_of_memory_until_there_is_enough<std::function<umbilic_status()>>;
  out_of_memory("names", [&] { return umbilic_cage_names(&answer); });
  out_of_memory("functionals", [&] { return umbilic_functional_names(&answer); });
  out_of_memory("torus", [&] { return umbilic_torus_minimizer(terms.data(), terms.size(), &answer); });
  out_of_memory("energies", [&] { return umbilic_torus_energies(0.5, &answer); });
  out_of_memory("counts", [&] { return umbilic_cage_counts(cage, &answer); });
  out_of_memory("obj", [&] { return umbilic_mesh_obj(mesh, &answer); });
  umbilic_cage* a_cage = nullptr;
  out_of_memory("cage", [&] { return umbilic_cage_create(text.data(), text.size(), &a_cage); });
  umbilic_cage_destroy(a_cage);
  out_of_memory("cage text", [&] { return umbilic_cage_text(ply.data(), ply.size(), &answer); });
  umbilic_run* a_run = nullptr;
  out_of_memory("create", [&] { return umbilic_run_create(problem.data(), problem.size(), nullptr, 0, &a_run); });
  umbilic_run_destroy(a_run);
  umbilic_mesh *control = nullptr, *limit = nullptr;
  out_of_memory("mesh", [&] { return umbilic_run_control_mesh(run, &control); });
  out_of_memory("limit mesh", [&] { return umbilic_run_limit_mesh(run, 2, &limit); });
  umbilic_mesh_destroy(control);
  umbilic_mesh_destroy(limit);
  umbilic_certificate* another = nullptr;
  out_of_memory("certify", [&] { return umbilic_run_certify(run, &another); });
  umbilic_certificate_destroy(another);
  int32_t level = 0;
  const double* points = nullptr;
  size_t count = 0;
  out_of_memory("state", [&] { return umbilic_run_state(run, &level, &points, &count); });
  out_of_memory("report", [&] { return umbilic_run_report(run, nullptr, &answer); });
  for (int part = 0; part <= 6; ++part) {
    out_of_memory("part", [&] { return umbilic_run_part(run, part, &answer); });
  }
}

/// Where the allocations fail after which a run's and a certificate's steps run out of memory. Returns how often a run
/// did.
int expect_no_more_calls(const std::vector<std::int64_t>& allocations) {
  int32_t done = 0;
  int failures = 0;
  for (const std::int64_t n : allocations) {
    umbilic_run* a_run = begun(bending_of("cube", 1, 1));
    umbilic_certificate* another = nullptr;
    EXPECT_EQ(umbilic_run_certify(a_run, &another), UMBILIC_OK);
    g_allocations_left = n;
    const umbilic_status of_run = umbilic_run_step(a_run, 1000, &done);
    g_allocations_left = n;
    const umbilic_status of_certificate = umbilic_certificate_step(another, 1000, &done);
    g_allocations_left = -1;
    umbilic_text text{};
    if (of_run != UMBILIC_OK) {
      ++failures;
      EXPECT_EQ(of_run, UMBILIC_OUT_OF_MEMORY);
      EXPECT_EQ(umbilic_run_step(a_run, 1, &done), UMBILIC_BAD_ARGUMENT);
      EXPECT_EQ(umbilic_run_part(a_run, UMBILIC_PART_ENERGIES, &text), UMBILIC_BAD_ARGUMENT);
      EXPECT_EQ(message(), "it ran out of memory before and takes no more calls");
    }
    if (of_certificate != UMBILIC_OK) {
      EXPECT_EQ(of_certificate, UMBILIC_OUT_OF_MEMORY);
      EXPECT_EQ(umbilic_certificate_step(another, 1, &done), UMBILIC_BAD_ARGUMENT);
    }
    umbilic_certificate_destroy(another);
    umbilic_run_destroy(a_run);
  }
  return failures;
}

TEST_F(Contract, a_run_that_ran_out_of_memory_in_a_step_takes_no_more_calls_but_one_that_destroys_it) {
  EXPECT_GT(expect_no_more_calls({0, 1, 2, 5, 12, 31, 80, 200, 500, 1200, 2900}), 5);
}

TEST(ContractSlow, a_run_that_ran_out_of_memory_at_any_of_many_allocations_takes_no_more_calls) {
  std::vector<std::int64_t> allocations;
  for (std::int64_t n = 0; n < 3000; n = n < 100 ? n + 1 : n + n / 2) allocations.push_back(n);
  EXPECT_GT(expect_no_more_calls(allocations), 50);
}

TEST(Guard, turns_every_exception_into_a_status) {
  using api::guarded;
  EXPECT_EQ(guarded([]() -> umbilic_status { throw std::bad_alloc(); }), UMBILIC_OUT_OF_MEMORY);
  EXPECT_EQ(guarded([]() -> umbilic_status { throw std::length_error("vector"); }), UMBILIC_OUT_OF_MEMORY);
  EXPECT_EQ(message(), "more than memory can hold");
  EXPECT_EQ(guarded([]() -> umbilic_status { throw std::logic_error("never"); }), UMBILIC_INTERNAL);
  EXPECT_EQ(message(), "never");
  EXPECT_EQ(guarded([]() -> umbilic_status { throw 1; }), UMBILIC_INTERNAL);
  EXPECT_EQ(message(), "unknown failure");
  const std::string words(100'000, 'x');
  g_allocations_left = 0;
  EXPECT_EQ(api::fail(UMBILIC_BAD_INPUT, words), UMBILIC_BAD_INPUT);
  g_allocations_left = -1;
  EXPECT_EQ(message(), "no memory");
}

TEST(Guard, keeps_a_message_for_each_thread) {
  umbilic_text text{};
  EXPECT_EQ(umbilic_torus_energies(2, &text), UMBILIC_BAD_INPUT);
  const std::string mine = message();
  std::string theirs = "none";
  std::thread([&] {
    theirs = message();
    umbilic_text other{};
    umbilic_torus_energies(3, &other);
  }).join();
  EXPECT_EQ(theirs, "");
  EXPECT_EQ(message(), mine);
}

}  // namespace
}  // namespace umbilic::test
