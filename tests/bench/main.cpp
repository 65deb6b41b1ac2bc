// SPDX-License-Identifier: MIT
/// \file
/// The benchmark: `umbilic_bench SUBJECT ARGUMENT…` measures one subject and writes JSON to standard output. `npm run
/// bench` runs it natively and as WebAssembly and prints the tables.
#include <cstdio>

#include "subjects.h"

namespace umbilic {
namespace {

/// Nothing for unknown subjects and arguments.
std::string measure(const std::string& subject, const std::vector<std::string>& arguments) {
  if (subject == "run") return whole_run(arguments);
  if (subject == "throughput") {
    return fmt::format(R"({{"peaks":{},"throughput":{},"phases":{}}})", peaks(), throughput(), phases());
  }
  if (subject == "peaks") return peaks();
  if (subject == "overhead") return overhead();
  if (subject == "scaling") return scaling();
  if (subject == "threads") return threads();
  if (subject == "cage") return cage_text(arguments);
  if (subject == "shares") return shares();
  if (subject == "rates") return rates();
  if (subject == "quadrature") return quadrature();
  if (subject == "caps") return caps();
  return "";
}

}  // namespace
}  // namespace umbilic

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty()) {
    const std::string text = umbilic::measure(arguments[0], {arguments.begin() + 1, arguments.end()});
    if (!text.empty()) return std::puts(text.c_str()) < 0;
  }
  std::fputs(
      "Usage: umbilic_bench throughput | peaks | overhead | scaling | threads | shares | rates | quadrature | caps\n"
      "       umbilic_bench cage NAME\n"
      "       umbilic_bench run CAGE FUNCTIONAL LAST_LEVEL auto|identity|sobolev|hessian symmetric|unsymmetric\n",
      stderr);
  return 2;
}
