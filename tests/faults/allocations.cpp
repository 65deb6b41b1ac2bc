// SPDX-License-Identifier: MIT
/// \file
/// `umbilic_faults [--first N] [--later N] [--at POSITION MODE]`: lets allocations of the C contract fail, each in a
/// process of its own that has not computed anything before, and prints what happened as JSON. Linux with glibc.
/// Modes are "one" that fails, "all-from-there", and "one-of-2-threads", where live allocations vary and are not
/// compared.
///
/// What runs is a whole use of the contract (`use`). Its allocations up to the first step are the first part, all
/// others the later one; of each, N evenly spread positions fail (0 for all, in the mode "one"). A failure must become
/// the status "out of memory", unless the code copes without the memory. Afterwards the same use must succeed, and
/// leave as many live allocations as it does where nothing has failed before.
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <string_view>

#include "wasm/api.h"

namespace {

/// Which allocations fail, counted from 1. Nothing here allocates.
std::atomic<long> allocations = 0;
std::atomic<long> live = 0;
std::atomic<long> first_to_fail = 0;  // 0: none
std::atomic<long> last_to_fail = 0;

}  // namespace

/// A place for a debugger to stop at: the allocation that fails.
extern "C" [[gnu::noinline]] void umbilic_allocation_fails() { errno = ENOMEM; }

namespace {

bool fails() {
  const long position = ++allocations;
  const bool failing = position >= first_to_fail && position <= last_to_fail;
  if (failing) umbilic_allocation_fails();
  return failing;
}

void* counted(void* block) {
  if (block) ++live;
  return block;
}

}  // namespace

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) { return fails() ? nullptr : counted(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) { return fails() ? nullptr : counted(__libc_calloc(count, size)); }
void* realloc(void* block, std::size_t size) {
  if (fails()) return nullptr;
  void* moved = __libc_realloc(block, size);
  return block ? moved : counted(moved);
}
void* memalign(std::size_t alignment, std::size_t size) {
  return fails() ? nullptr : counted(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  void* made = memalign(alignment, size);
  if (made) *block = made;
  return made ? 0 : ENOMEM;
}
void free(void* block) {
  if (block) --live;
  __libc_free(block);
}
}

namespace {

constexpr char kProblem[] =
    R"({"umbilic": "problem", "version": 1, "cage": {"text": "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n)"
    R"(f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"}, "terms": {"bending": 1, "mvs": 0.1}, "options": {"levels": [0, 1]}})";

/// The first status that is not UMBILIC_OK; later calls are left out.
class Calls {
 public:
  /// Whether the call was made and succeeded.
  template <class Call>
  bool make(const Call& call) {
    if (status_ == UMBILIC_OK) status_ = call();
    return status_ == UMBILIC_OK;
  }
  umbilic_status status() const { return status_; }

 private:
  umbilic_status status_ = UMBILIC_OK;
};

void use_mesh(Calls& calls, umbilic_mesh* mesh) {
  umbilic_mesh_arrays arrays;
  umbilic_text text;
  calls.make([&] { return umbilic_mesh_view(mesh, &arrays); });
  calls.make([&] { return umbilic_mesh_obj(mesh, &text); });
  umbilic_mesh_destroy(mesh);
}

void use_certificate(Calls& calls, umbilic_run* run) {
  umbilic_certificate* certificate = nullptr;
  calls.make([&] { return umbilic_run_certify(run, &certificate); });
  int32_t done = 0;
  while (!done && calls.make([&] { return umbilic_certificate_step(certificate, 50, &done); })) {
  }
  umbilic_text text;
  calls.make([&] { return umbilic_certificate_report(certificate, &text); });
  calls.make([&] { return umbilic_run_report(run, certificate, &text); });
  umbilic_certificate_destroy(certificate);
}

/// Loads a problem, minimizes, and asks for all that a run offers. `loaded` receives the number of allocations up to
/// the first step.
umbilic_status use(long& loaded) {
  Calls calls;
  umbilic_run* run = nullptr;
  umbilic_text text;
  int32_t done = 0;
  calls.make([&] { return umbilic_run_create(kProblem, std::strlen(kProblem), nullptr, 0, &run); });
  calls.make([&] { return umbilic_run_step(run, 1, &done); });
  loaded = allocations;
  while (!done && calls.make([&] { return umbilic_run_step(run, 10, &done); })) {
  }
  for (int part = UMBILIC_PART_PROGRESS; part <= UMBILIC_PART_HELD; ++part) {
    calls.make([&] { return umbilic_run_part(run, part, &text); });
  }
  int32_t level;
  const double* points;
  std::size_t count;
  calls.make([&] { return umbilic_run_state(run, &level, &points, &count); });
  umbilic_mesh* mesh = nullptr;
  if (calls.make([&] { return umbilic_run_control_mesh(run, &mesh); })) use_mesh(calls, mesh);
  if (calls.make([&] { return umbilic_run_limit_mesh(run, 3, &mesh); })) use_mesh(calls, mesh);
  use_certificate(calls, run);
  constexpr char kNewTargets[] = R"({"terms": {"bending": 2}})";
  calls.make([&] { return umbilic_run_retarget(run, kNewTargets, std::strlen(kNewTargets)); });
  calls.make([&] { return umbilic_run_step(run, 10, &done); });
  umbilic_run_destroy(run);
  return calls.status();
}

/// What a process tells.
struct Told {
  long loaded, all, live_after;  ///< numbers of allocations
  umbilic_status status, status_after;
  char message[200];  ///< of the first failure
};

/// Uses the contract with failures at these positions, and once more without.
void use_twice(long first, long last, int threads, Told& told) {
  const long live_before = live;
  if (umbilic_use_threads(threads) != UMBILIC_OK) return;
  allocations = 0;
  last_to_fail = last;
  first_to_fail = first;
  told.status = use(told.loaded);
  told.all = allocations;
  umbilic_copy_message(told.message, sizeof told.message);
  first_to_fail = last_to_fail = 0;
  long ignored;
  told.status_after = use(ignored);
  umbilic_run* run = nullptr;  // for a message, so that each process keeps one of the same length
  umbilic_run_create("no problem at all", 17, nullptr, 0, &run);
  umbilic_use_threads(1);
  told.live_after = live - live_before;
}

/// Runs `use_twice` in another process; returns how that ended, as `waitpid` tells it.
int apart(long first, long last, int threads, Told& told) {
  void* const memory = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) std::exit(2);
  Told& shared = *static_cast<Told*>(memory);
  shared = {0, 0, 0, UMBILIC_INTERNAL, UMBILIC_INTERNAL, ""};
  const pid_t child = fork();
  if (child < 0) std::exit(2);
  if (child == 0) {
    constexpr int kMostSeconds = 60;
    alarm(kMostSeconds);
    use_twice(first, last, threads, shared);
    _exit(0);
  }
  int ended = 0;
  waitpid(child, &ended, 0);
  told = shared;
  munmap(memory, sizeof(Told));
  return ended;
}

struct Mode {
  const char* name;
  bool for_good;  ///< all later allocations of that use fail as well
  int threads;
};
constexpr std::array<Mode, 3> kModes = {
    {{"one", false, 1}, {"all-from-there", true, 1}, {"one-of-2-threads", false, 2}}};

class Experiment {
 public:
  explicit Experiment(const Mode& mode) : mode_(mode) {
    const int ended = apart(0, 0, mode.threads, clean_);
    if (ended == 0 && clean_.status == UMBILIC_OK && clean_.status_after == UMBILIC_OK) return;
    fmt::print(stderr, "without faults, status {} and {}, ended {}: {}\n", int(clean_.status), int(clean_.status_after),
               ended, clean_.message);
    std::exit(2);
  }

  const Told& clean() const { return clean_; }

  /// The outcome of a fault, in words.
  const char* outcome(long position) const {
    Told told;
    const int ended = apart(position, mode_.for_good ? clean_.all * 100 : position, mode_.threads, told);
    if (WIFSIGNALED(ended)) return WTERMSIG(ended) == SIGALRM ? "hung" : "crashed";
    if (told.status != UMBILIC_OK && told.status != UMBILIC_OUT_OF_MEMORY) return "wrong status";
    if (told.status_after != UMBILIC_OK) return "unusable afterwards";
    if (told.all < position) return "not reached";  // threads allocate a little more or less from run to run
    if (mode_.threads == 1 && told.live_after != clean_.live_after)
      return told.live_after > clean_.live_after ? "leaked" : "freed twice";
    return told.status == UMBILIC_OK ? "coped" : "out of memory";
  }

 private:
  const Mode& mode_;
  Told clean_{};
};

/// Prints the outcomes of `count` positions, evenly spread over (begin, end]; of all if `count` is 0.
void print_part(const Experiment& experiment, const char* name, const Mode& mode, long begin, long end, long count) {
  if (count == 0 || count > end - begin) count = end - begin;
  std::map<std::string, long> outcomes;
  std::map<std::string, long> examples;
  for (long i = 0; i < count; ++i) {
    const long position = begin + 1 + (end - begin) * i / count;
    const char* outcome = experiment.outcome(position);
    ++outcomes[outcome];
    examples.emplace(outcome, position);
  }
  fmt::print(R"({{"part": "{}", "mode": "{}", "positions": {}, "allocations": {}, "outcomes": {{)", name, mode.name,
             count, end - begin);
  const char* comma = "";
  for (const auto& [outcome, times] : outcomes) {
    fmt::print(R"({}"{}": {{"count": {}, "first": {}}})", comma, outcome, times, examples[outcome]);
    comma = ", ";
  }
  fmt::print("}}}}\n");
}

}  // namespace

int main(int argc, char** argv) {
  long first = 0, later = 200, at = 0;
  std::string_view only;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    const long number = std::atol(argv[i + 1]);
    if (option == "--first") first = number;
    if (option == "--later") later = number;
    if (option == "--at" && i + 2 < argc) at = number, only = argv[i + 2];
  }
  for (const Mode& mode : kModes) {
    if (at > 0 && only != mode.name) continue;
    if (at > 0) {  // in this process, for a debugger
      Told told;
      use_twice(at, mode.for_good ? 1L << 60 : at, mode.threads, told);
      fmt::print("status {}, then {}; {} live allocations\n", int(told.status), int(told.status_after),
                 told.live_after);
      return 0;
    }
    const Experiment experiment(mode);
    const long loaded = experiment.clean().loaded, all = experiment.clean().all;
    // Every position once; in the other modes samples, as of the later part.
    const bool sampled = mode.for_good || mode.threads > 1;
    print_part(experiment, "loading and the first step", mode, 0, loaded, sampled && first == 0 ? later : first);
    print_part(experiment, "later", mode, loaded, all, later);
  }
}
