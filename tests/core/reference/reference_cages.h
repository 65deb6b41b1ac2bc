// SPDX-License-Identifier: MIT
/// \file
/// Three perturbed cages without symmetry, read from the files in this folder.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "cage/read.h"

namespace umbilic::test {

/// "torus" (8 x 6 quads, regular), "cube", or "g2" (genus 2, valences 3 and 5).
inline Cage reference_cage(const std::string& name) {
  std::ifstream file(std::string(UMBILIC_SOURCE_DIR) + "/tests/core/reference/" + name + ".obj");
  std::stringstream text;
  text << file.rdbuf();
  Result<Cage> cage = read_cage(text.str());
  EXPECT_TRUE(cage.ok()) << name << ": " << cage.error().message;
  return cage ? std::move(cage).value() : Cage{};
}

}  // namespace umbilic::test
