// SPDX-License-Identifier: MIT
/// \file
/// The symbols of the finite groups of isometries.
#include "mesh/schoenflies.h"

#include <gtest/gtest.h>

#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

TEST(Schoenflies, every_point_group_gets_its_symbol_in_every_position_and_order_of_its_elements) {
  const Matrix3 turn = some_rotation();
  for (const PointGroup& group : point_groups()) {
    std::vector<Matrix3> elements = closure(group.generators);
    ASSERT_EQ(static_cast<int>(elements.size()), group.order) << group.name;
    EXPECT_EQ(schoenflies_symbol(elements), group.name);
    for (Matrix3& m : elements) m = turn * m * turn.transpose();
    EXPECT_EQ(schoenflies_symbol(elements), group.name);
    std::reverse(elements.begin(), elements.end());
    EXPECT_EQ(schoenflies_symbol(elements), group.name);
  }
}

TEST(Schoenflies, groups_of_the_same_order_differ_by_their_axes) {
  const auto symbol = [](const std::vector<Matrix3>& generators) { return schoenflies_symbol(closure(generators)); };
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  EXPECT_EQ(symbol({rotation(1. / 12, z)}), "C12");
  EXPECT_EQ(symbol({rotation(1. / 6, z), rotation(0.5, x)}), "D6");
  EXPECT_EQ(symbol({rotation(1. / 12, z), rotation(0.5, x)}), "D12") << "24 rotations, as O";
  EXPECT_EQ(symbol({rotation(1. / 30, z), rotation(0.5, x)}), "D30") << "60 rotations, as I";
  EXPECT_EQ(symbol({rotation(1. / 30, z), rotation(0.5, x), reflection(z)}), "D30h") << "120 elements, as Ih";
  EXPECT_EQ(symbol({rotation(1. / 200, z), reflection(x)}), "C200v");
}

TEST(Schoenflies, one_mirror_is_Cs_whatever_its_normal) {
  EXPECT_EQ(schoenflies_symbol(closure({reflection({1, -2, 0.3})})), "Cs");
}

}  // namespace
}  // namespace umbilic::test
