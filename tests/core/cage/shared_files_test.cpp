// SPDX-License-Identifier: MIT
/// \file
/// Meshes that nobody on this project made, where a folder with them stands beside the repository.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cages.h"

namespace umbilic::test {
namespace {

class SharedFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << "there is no folder " << folder_;
  }

  std::string text(const char* name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  CageReport report(const char* name) const {
    Cage cage = cage_of(text(name));
    return validate(cage).value();
  }

 private:
  std::filesystem::path folder_ = std::filesystem::path(UMBILIC_SOURCE_DIR) / ".." / "shared" / "cages";
};

TEST_F(SharedFiles, closed_meshes_are_cages_of_their_genus) {
  const CageReport spot = report("spot_control_mesh.obj");
  EXPECT_EQ(spot.genus, 0);
  EXPECT_EQ(spot.components.size(), 1u);
  const CageReport chamfer = report("chamfer-cube.off");
  EXPECT_EQ(chamfer.vertices, 24);
  EXPECT_EQ(chamfer.faces, 26);
  EXPECT_EQ(chamfer.genus, 0);
  EXPECT_EQ(report("fandisk_quads.off").faces, 764);
  const CageReport dodecahedron = report("dodecahedron_poly.obj");
  EXPECT_EQ(dodecahedron.vertices, 20);
  EXPECT_EQ(dodecahedron.edges, 30);
  EXPECT_EQ(dodecahedron.faces, 12);
}

TEST_F(SharedFiles, open_meshes_are_cages_with_boundaries) {
  const CageReport hemisphere = report("hemisphere_open.off");
  EXPECT_EQ(hemisphere.genus, 0);
  ASSERT_EQ(hemisphere.boundaries.size(), 1u);
  EXPECT_EQ(hemisphere.boundaries[0].vertices, 120);
}

TEST_F(SharedFiles, a_moebius_band_is_refused) {
  EXPECT_NE(error_of(text("moebius.obj")).find("the surface is not orientable"), std::string::npos);
}

}  // namespace
}  // namespace umbilic::test
