// SPDX-License-Identifier: MIT
/// \file
/// Frames do not intersect themselves, thin or fat, and their tunnels are open.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "cage/frame.h"
#include "cage/generate.h"
#include "cage/polyhedra.h"
#include "cages.h"

namespace umbilic::test {

namespace {

struct Triangle {
  std::array<int, 3> vertices;
  std::array<Vector3, 3> corners;
  Eigen::AlignedBox3d box;
};

/// Faces cut into fans from their first corner.
std::vector<Triangle> triangles(const Cage& cage) {
  std::vector<Triangle> all;
  for (const std::vector<int>& face : cage.faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      Triangle t{{face[0], face[i - 1], face[i]}, {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        t.corners[k] = cage.vertices.row(t.vertices[k]);
        t.box.extend(t.corners[k]);
      }
      all.push_back(t);
    }
  }
  return all;
}

/// Where the segment a + t (b − a), 0 <= t <= 1, meets the triangle, if it crosses it.
std::optional<double> crossing(const Vector3& a, const Vector3& b, const Triangle& t) {
  Eigen::Matrix3d system;
  system << t.corners[1] - t.corners[0], t.corners[2] - t.corners[0], a - b;
  if (std::abs(system.determinant()) < 1e-14) return std::nullopt;
  const Vector3 s = system.inverse() * (a - t.corners[0]);
  const bool inside = s[0] >= 0 && s[1] >= 0 && s[0] + s[1] <= 1 && s[2] >= 0 && s[2] <= 1;
  return inside ? std::optional(s[2]) : std::nullopt;
}

bool touch(const Triangle& s, const Triangle& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (crossing(s.corners[k], s.corners[(k + 1) % 3], t) || crossing(t.corners[k], t.corners[(k + 1) % 3], s))
      return true;
  }
  return false;
}

bool share_a_vertex(const Triangle& s, const Triangle& t) {
  return std::any_of(s.vertices.begin(), s.vertices.end(),
                     [&](int v) { return std::find(t.vertices.begin(), t.vertices.end(), v) != t.vertices.end(); });
}

int self_intersections(const Cage& cage) {
  const std::vector<Triangle> all = triangles(cage);
  int count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (all[i].box.intersects(all[j].box) && !share_a_vertex(all[i], all[j]) && touch(all[i], all[j])) ++count;
    }
  }
  return count;
}

SphereMap map_of(const CageName& name) {
  if (name.kind == CageKind::kTwoJunctions) return hosohedron(name.genus + 1);
  for (const Polyhedron& p : polyhedra()) {
    if (p.name == name.name) return uniform_polyhedron(p.make());
  }
  return {};
}

/// Calls `check(cage, name, what)` for frames of both families.
template <class Check>
void for_each_frame(const std::vector<double>& thicknesses, const std::vector<double>& spreads, Check check) {
  for (const CageName& name : cage_names()) {
    if (name.kind != CageKind::kTwoJunctions && name.kind != CageKind::kPolyhedron) continue;
    for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
      for (const double thickness : thicknesses) {
        for (const double spread : spreads) {
          if (name.kind == CageKind::kPolyhedron && spread != spreads[0]) continue;
          CageOptions options;
          options.family = family;
          options.thickness = thickness;
          options.spread = spread;
          const Result<Cage> cage = generate_cage(name.name, options);
          ASSERT_TRUE(cage.ok()) << cage.error().message;
          check(*cage, name,
                name.name + (family == FrameFamily::kHub ? " hub" : " flag") + " thickness " +
                    std::to_string(thickness) + " spread " + std::to_string(spread));
        }
      }
    }
  }
}

}  // namespace

TEST(FrameEmbedding, the_test_sees_an_intersection_where_there_is_one) {
  Cage cage = generate_cage("two-3").value();
  EXPECT_EQ(self_intersections(cage), 0);
  cage.vertices.row(0).swap(cage.vertices.row(1));
  EXPECT_GT(self_intersections(cage), 0);
}

TEST(FrameEmbedding, no_frame_intersects_itself_from_thin_to_three_times_as_fat) {
  for_each_frame({0.05, 0.5, 1, 1.5, 1.69}, {1, 0.5, 3},
                 [](const Cage& cage, const CageName&, const std::string& what) {
                   EXPECT_EQ(self_intersections(cage), 0) << what;
                 });
}

TEST(FrameEmbedding, one_can_look_to_the_centre_through_every_tunnel) {
  for_each_frame({0.5, 1.69}, {1, 2}, [](const Cage& cage, const CageName& name, const std::string& what) {
    const SphereMap map = map_of(name);
    EXPECT_EQ(map.tunnels.size(), static_cast<std::size_t>(name.genus) + 1) << what;
    const std::vector<Triangle> all = triangles(cage);
    for (const Vector3& tunnel : map.tunnels) {
      const bool blocked = std::any_of(all.begin(), all.end(), [&](const Triangle& t) {
        return crossing(Vector3::Zero(), 10 * tunnel, t).has_value();
      });
      EXPECT_FALSE(blocked) << what;
    }
    // An arm is in the way beside its middle, outside and inside; at the middle itself the ray would run through edges.
    for (const Vector3& middle : map.middles) {
      const Vector3 direction = 10 * (middle + 0.01 * Vector3(0.3, 0.47, 0.71));
      const auto hits = std::count_if(all.begin(), all.end(), [&](const Triangle& t) {
        return crossing(Vector3::Zero(), direction, t).has_value();
      });
      EXPECT_EQ(hits, 2) << what;
    }
  });
}

}  // namespace umbilic::test
