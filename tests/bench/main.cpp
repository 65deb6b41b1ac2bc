// SPDX-License-Identifier: MIT
/// \file
/// The benchmark: throughput of energy and gradient, seconds per phase of a level, and the errors of quadrature rules,
/// as JSON on standard output. `npm run bench` runs it natively and as WebAssembly and prints the tables.
#include <cstdio>
#include <cstring>

#include "subjects.h"

int main(int argc, char** argv) {
  using namespace umbilic;
  const bool rules = argc > 1 && std::strcmp(argv[1], "quadrature") == 0;
  const std::string text =
      rules ? fmt::format(R"({{"quadrature":{}}})", quadrature())
            : fmt::format(R"({{"peaks":{},"throughput":{},"phases":{}}})", peaks(), throughput(), phases());
  std::puts(text.c_str());
}
