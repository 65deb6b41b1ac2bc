// SPDX-License-Identifier: MIT
/// \file
/// Pins as equations: held to rounding on every level, and their multipliers against finite differences of the minimum.
#include "driver/pin_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/group_elements.h"
#include "mesh/rough_cages.h"
#include "mesh/symmetric_cages.h"
#include "solve/identity_metric.h"
#include "solve/lbfgs.h"

namespace umbilic::test {
namespace {

RefinedCage prepared(const Cage& cage, bool symmetric = false) { return prepare(cage, 2, symmetric).value(); }

std::vector<HeldPoint> held_by(const std::vector<Pin>& pins, const RefinedCage& cage) {
  Result<std::vector<HeldPoint>> held = hold(pins, cage);
  EXPECT_TRUE(held.ok()) << held.error().message;
  return held ? *held : std::vector<HeldPoint>();
}

std::string message(const Pin& pin, const Cage& cage) {
  const Result<std::vector<HeldPoint>> held = hold({{.vertex = 1}, pin}, prepared(cage));
  return held ? "" : held.error().message;
}

Eigen::VectorXd flat(const Points& points) { return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size()); }
Points points_of(const Eigen::VectorXd& flat) { return Eigen::Map<const Points>(flat.data(), flat.size() / 3, 3); }

TEST(PinRows, hold_the_surface_where_it_is_on_every_level) {
  const RefinedCage coarse = prepared(prism(5));
  const std::vector<HeldPoint> held = held_by({{.vertex = 2, .normal = true},
                                               {.face = 4, .uv = {{0.3, 0.8}}, .normal = true},
                                               {.face = 1, .corner = 2, .uv = {{0.25, 0.5}}, .normal = true}},
                                              coarse);
  std::vector<HeldPoint> here = held;
  RefinedCage level = coarse;
  for (int step = 0; step < 3; ++step) {
    const PinRows rows = pin_rows(here, level.mesh);
    ASSERT_EQ(rows.rows.count(), 15);
    EXPECT_LT((rows.rows.matrix * flat(level.control) - rows.rows.right).cwiseAbs().maxCoeff(), 1e-14) << step;
    EXPECT_TRUE(turned_over(here, level.mesh, level.control).empty());
    Points mirrored = level.control;
    mirrored.col(0) *= -1;
    EXPECT_FALSE(turned_over(here, level.mesh, mirrored).empty())
        << "a mirror image has its inside out where the mirror keeps the plane";
    here = refined(here, level.mesh);
    level = refine(level, 1);
  }
}

TEST(PinRows, put_points_and_normals_where_they_are_asked_for) {
  // In the cage's own coordinates, which are far from the unit ones.
  Cage cage = prism(6);
  cage.vertices = ((100 * cage.vertices).rowwise() + Eigen::RowVector3d(5000, 0, 0)).eval();
  const RefinedCage level = refine(prepared(cage), 1);
  const double nan = std::nan("");
  const std::vector<Pin> pins = {{.vertex = 3, .at = Coordinates3{5040, 90, 80}},
                                 {.vertex = 9, .at = Coordinates3{nan, nan, -75}},
                                 {.face = 5, .uv = {{0.5, 0.5}}, .normal = Coordinates3{3, 1, 0.5}}};
  const RefinedCage coarse = prepared(cage);
  const std::vector<HeldPoint> held = refined(held_by(pins, coarse), coarse.mesh);
  const PinRows rows = pin_rows(held, level.mesh);
  EXPECT_EQ(rows.rows.count(), 3 + 1 + 3 + 2);
  const AffineSubspace solutions(rows.rows, flat(level.control));
  ASSERT_TRUE(solutions.contradiction().empty());
  Random random(3);
  const Points control = points_of(solutions.point(0.05 * random.matrix<Eigen::VectorXd>(solutions.dimension(), 1)));
  std::vector<SurfacePlace> places;
  for (const HeldPoint& point : held) places.push_back(point.place);
  const std::vector<LimitStencil> stencils = limit_stencils(level.mesh, places);
  const auto position = [&](int i) { return level.placement.back(Vector3(stencils[i].apply(control).col(0))); };
  EXPECT_LT((position(0) - Vector3(5040, 90, 80)).norm(), 1e-11) << "1e-13 of the size";
  EXPECT_NEAR(position(1)[2], -75, 1e-11);
  const Eigen::Matrix3d jet = stencils[2].apply(control);
  const Vector3 normal = jet.col(1).cross(jet.col(2)).normalized(), asked = Vector3(3, 1, 0.5).normalized();
  EXPECT_LT(normal.cross(asked).norm(), 1e-13) << "in rad";
}

TEST(PinRows, refuse_what_the_cage_does_not_have) {
  EXPECT_EQ(message({.vertex = 9}, cube()), "constraints.pins[1].vertex: 9, but the cage has 8 vertices");
  EXPECT_EQ(message({.face = 7, .uv = {{0, 0}}}, cube()), "constraints.pins[1].face: 7, but the cage has 6 faces");
  EXPECT_EQ(message({.vertex = 8}, cube()), "");
  EXPECT_EQ(message({.face = 1, .corner = 1, .uv = {{0, 0}}}, cube()),
            "constraints.pins[1].corner: face 1 is a quad, in which uv alone says where");
  EXPECT_EQ(message({.face = 1, .uv = {{0, 0}}}, prism(5)),
            "constraints.pins[1].face: face 1 has 5 corners, and (u, v) only in the quads after one step: name one by "
            "\"corner\", 1 to 5, or refine the cage by one step");
  EXPECT_EQ(message({.face = 1, .corner = 6, .uv = {{0, 0}}}, prism(5)),
            "constraints.pins[1].corner: 6, but face 1 has 5 corners");
  EXPECT_EQ(message({}, cube()), "constraints.pins[1].vertex: expected either vertex, or face and uv");
}

TEST(PinRows, refuse_targets_beside_which_the_cage_has_no_digits_left) {
  for (const double far : {1e16, -1e40, 1e308}) {
    EXPECT_EQ(message({.vertex = 1, .at = Coordinates3{0, far, 0}}, cube()),
              "constraints.pins[1].at[1]: too large for the cage");
  }
  EXPECT_EQ(message({.vertex = 1, .at = Coordinates3{0, 1e9, 0}}, cube()), "");
}

TEST(PinRows, that_contradict_each_other_are_named) {
  const RefinedCage cage = prepared(cube());
  const std::vector<HeldPoint> held =
      held_by({{.vertex = 1}, {.vertex = 2}, {.face = 1, .uv = {{0, 0}}, .at = Coordinates3{0, 0, -1}}}, cage);
  const PinRows rows = pin_rows(held, cage.mesh);
  const AffineSubspace solutions(rows.rows, flat(cage.control));
  ASSERT_EQ(solutions.contradiction().size(), 2u) << "face 1 begins with vertex 1";
  EXPECT_EQ(rows.owners[solutions.contradiction()[0]].pin, 0);
  EXPECT_EQ(rows.owners[solutions.contradiction()[1]].pin, 2);
}

TEST(PinRows, in_symmetric_coordinates_hold_all_images) {
  const RefinedCage coarse = prepared(cube(), true);
  ASSERT_EQ(coarse.symmetry.order, 48);
  const std::vector<HeldPoint> held = held_by({{.face = 1, .uv = {{0.5, 0.5}}, .normal = true}}, coarse);
  const Coordinates coordinates(coarse.mesh, coarse.symmetry);
  const PinRows rows = pin_rows(held, coarse.mesh);
  const LinearRows reduced = in_coordinates(rows.rows, coordinates);
  const AffineSubspace solutions(reduced, coordinates.unknowns(coarse.control));
  EXPECT_TRUE(solutions.contradiction().empty());
  EXPECT_EQ(solutions.redundant().size(), 4u) << "symmetry keeps the point on its axis, and the normal";
  EXPECT_EQ(solutions.dimension(), coordinates.count() - 1);
  const Points control = coordinates.control(solutions.origin());
  EXPECT_LT((rows.rows.matrix * flat(control) - rows.rows.right).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(PinRows, keep_the_symmetries_that_map_them_to_one_another) {
  const RefinedCage cage = prepared(cube(), true);
  const std::vector<Symmetry> elements = all_elements(cage.symmetry, cage.mesh);
  ASSERT_EQ(elements.size(), 48u);
  const auto kept = [&](const std::vector<Pin>& pins) {
    const std::vector<HeldPoint> held = held_by(pins, cage);
    return std::count_if(elements.begin(), elements.end(),
                         [&](const Symmetry& g) { return keeps(g, cage.symmetry.center, held, cage.mesh); });
  };
  EXPECT_EQ(kept({}), 48);
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.5, 0.5}}}}), 8) << "C4v";
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.5, 0.5}}}, {.face = 2, .uv = {{0.5, 0.5}}}}), 16) << "D4h: opposite faces";
  EXPECT_EQ(kept({{.vertex = 1}}), 6) << "C3v";
  EXPECT_EQ(kept({{.vertex = 1, .normal = true}}), 6);
  EXPECT_EQ(kept({{.vertex = 1, .normal = Coordinates3{0, 0, -1}}}), 2) << "a mirror through the vertex";
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.3, 0.2}}}}), 1);
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.3, 0}}}}), 2) << "on an edge: the mirror that exchanges its faces";
  const Coordinates3 far = {0, 0, 1.5}, opposite = {0, 0, -1.5}, nearer = {0, 0, -1.4};
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.5, 0.5}}, .at = opposite}, {.face = 2, .uv = {{0.5, 0.5}}, .at = far}}), 16);
  EXPECT_EQ(kept({{.face = 1, .uv = {{0.5, 0.5}}, .at = nearer}, {.face = 2, .uv = {{0.5, 0.5}}, .at = far}}), 8);
  const double nan = std::nan("");
  EXPECT_EQ(kept({{.vertex = 1, .at = Coordinates3{nan, nan, -1}}}), 2) << "x and y are free, and alike";
}

/// The bending energy of the surfaces on which the pins hold, as a function of the coordinates of these.
class PinnedBending : public Objective {
 public:
  PinnedBending(const RefinedCage& cage, const std::vector<HeldPoint>& held)
      : surface_(cage, CapKind::kSmooth, single_bending()),
        rows_(pin_rows(held, cage.mesh)),
        solutions_(rows_.rows, flat(cage.control)) {}

  static Weights single_bending() {
    Weights weights{};
    weights[kBending] = 1;
    return weights;
  }

  void evaluate(const Eigen::VectorXd& y, Evaluation& result) const override {
    Points gradient;
    result.value = surface_.energy().evaluate(control(y), &gradient).energy;
    result.gradient = solutions_.basis().transpose() * flat(gradient);
  }
  Points control(const Eigen::VectorXd& y) const { return points_of(solutions_.point(y)); }

  struct Minimum {
    double energy;
    Points control;
    std::vector<Vector3> pulls;
  };
  Minimum minimize(const Points& start, int pins) const {
    const Identity identity;
    Lbfgs lbfgs(*this, identity, solutions_.coordinates(flat(start)), {.max_iterations = 3000, .tolerance = 1e-14});
    while (!lbfgs.step()) {
    }
    Minimum minimum{lbfgs.best_value(), control(lbfgs.best()), {}};
    Points gradient;
    surface_.energy().evaluate(minimum.control, &gradient);
    const Eigen::VectorXd multipliers = solutions_.multipliers(flat(gradient));
    for (int pin = 0; pin < pins; ++pin) minimum.pulls.push_back(pull(rows_, multipliers, pin));
    return minimum;
  }

 private:
  Surface surface_;
  PinRows rows_;
  AffineSubspace solutions_;
};

TEST(PinRows, multiplier_is_the_derivative_of_the_minimal_energy_by_the_pins_position) {
  // Points of the cube's surface that lie on no sphere: the vertices, one of them pulled out, and one point with its
  // normal turned.
  const RefinedCage coarse = prepared(cube());
  std::vector<Pin> pins;
  for (int v = 1; v <= 8; ++v) pins.push_back({.vertex = v});
  pins.push_back({.face = 2, .uv = {{0.5, 0.5}}, .position = false, .normal = Coordinates3{0.2, 0.1, 1}});
  std::vector<HeldPoint> held = held_by(pins, coarse);
  held[0].position *= 1.3;
  const RefinedCage level = refine(coarse, 1);
  const auto minimum = [&](const Vector3& shift, const Points& start) {
    std::vector<HeldPoint> moved = held;
    moved[0].position += shift;
    return PinnedBending(level, refined(moved, coarse.mesh)).minimize(start, static_cast<int>(pins.size()));
  };
  const PinnedBending::Minimum found = minimum(Vector3::Zero(), level.control);
  EXPECT_GT(found.energy, 8 * 3.14159);
  const Vector3 force = found.pulls[0];
  ASSERT_GT(force.norm(), 0.1);
  const double h = 1e-3;  // third derivatives times h^2 / 6 are below 1e-6, the energies exact to 1e-11
  for (int c = 0; c < 3; ++c) {
    const Vector3 shift = h * Vector3::Unit(c);
    const double slope = (minimum(shift, found.control).energy - minimum(-shift, found.control).energy) / (2 * h);
    EXPECT_NEAR(force[c], slope, 1e-4 * force.norm()) << c;
  }
  // In equilibrium the pins' forces balance, but for the torque of the turned normal.
  Vector3 sum = Vector3::Zero();
  for (const Vector3& pull : found.pulls) sum += pull;
  EXPECT_LT(sum.norm(), 1e-4 * force.norm());

  const std::vector<HeldPoint> here = refined(held, coarse.mesh);
  std::vector<SurfacePlace> places;
  for (const HeldPoint& point : here) places.push_back(point.place);
  const std::vector<LimitStencil> stencils = limit_stencils(level.mesh, places);
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT((stencils[i].apply(found.control).col(0) - here[i].position).norm(), 1e-13) << i;
  }
  const Eigen::Matrix3d jet = stencils[8].apply(found.control);
  EXPECT_LT(jet.col(1).cross(jet.col(2)).normalized().cross(here[8].normal).norm(), 1e-13);
  EXPECT_TRUE(turned_over(here, level.mesh, found.control).empty());
}

}  // namespace
}  // namespace umbilic::test
