// SPDX-License-Identifier: MIT
/// \file
/// Rings, spokes and grids.
#include "cage/fill_quads.h"

#include <algorithm>
#include <numeric>

namespace umbilic {

namespace {

class Builder {
 public:
  explicit Builder(const std::vector<Vector3>& loop) {
    quads_.loop = static_cast<int>(loop.size());
    quads_.points = loop;
  }

  int add_vertex(const Vector3& point) {
    quads_.points.push_back(point);
    return static_cast<int>(quads_.points.size()) - 1;
  }

  /// The new vertices of a ring of quads within `outer`, which have the part `share` of their way to the middle.
  std::vector<int> add_ring(const std::vector<int>& outer, double share) {
    const Vector3 to = middle(outer);
    std::vector<int> inner;
    for (const int v : outer) inner.push_back(add_vertex(quads_.points[v] + share * (to - quads_.points[v])));
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const std::size_t next = (i + 1) % outer.size();
      quads_.quads.push_back({outer[i], outer[next], inner[next], inner[i]});
    }
    return inner;
  }

  /// The vertices of a straight line, with new ones between its ends.
  std::vector<int> add_spoke(int from, int to, int edges) {
    const Vector3 a = quads_.points[from], b = quads_.points[to];
    std::vector<int> spoke{from};
    for (int i = 1; i < edges; ++i) spoke.push_back(add_vertex(a + (b - a) * i / edges));
    spoke.push_back(to);
    return spoke;
  }

  /// The grid between a bottom and a top that go to the right, and a left and a right side that go up.
  void add_grid(const std::vector<int>& bottom, const std::vector<int>& right, const std::vector<int>& top,
                const std::vector<int>& left) {
    const std::size_t m = bottom.size() - 1, n = left.size() - 1;
    const std::vector<Vector3>& at = quads_.points;
    std::vector<std::vector<int>> rows(n + 1);
    for (std::size_t j = 0; j <= n; ++j) {
      const double v = static_cast<double>(j) / static_cast<double>(n);
      for (std::size_t i = 0; i <= m; ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(m);
        if (j == 0) {
          rows[j].push_back(bottom[i]);
        } else if (j == n) {
          rows[j].push_back(top[i]);
        } else if (i == 0) {
          rows[j].push_back(left[j]);
        } else if (i == m) {
          rows[j].push_back(right[j]);
        } else {
          const Vector3 ruled = (1 - v) * at[bottom[i]] + v * at[top[i]] + (1 - u) * at[left[j]] + u * at[right[j]];
          const Vector3 corners = (1 - u) * (1 - v) * at[bottom[0]] + u * (1 - v) * at[bottom[m]] +
                                  (1 - u) * v * at[top[0]] + u * v * at[top[m]];
          rows[j].push_back(add_vertex(ruled - corners));
        }
      }
    }
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < m; ++i) {
        quads_.quads.push_back({rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]});
      }
    }
  }

  Vector3 middle(const std::vector<int>& vertices) const {
    Vector3 sum = Vector3::Zero();
    for (const int v : vertices) sum += quads_.points[v];
    return sum / static_cast<double>(vertices.size());
  }

  FillQuads take() { return std::move(quads_); }

 private:
  FillQuads quads_;
};

/// The vertices of `loop` from one position on to another.
std::vector<int> stretch(const std::vector<int>& loop, int from, int edges) {
  std::vector<int> part;
  for (int i = 0; i <= edges; ++i) part.push_back(loop[(from + i) % loop.size()]);
  return part;
}

std::vector<int> reversed(std::vector<int> vertices) {
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

void add_four_sides(Builder& builder, const std::vector<int>& loop, const std::vector<int>& corners,
                    const std::vector<int>& sides) {
  builder.add_grid(stretch(loop, corners[0], sides[0]), stretch(loop, corners[1], sides[1]),
                   reversed(stretch(loop, corners[2], sides[2])), reversed(stretch(loop, corners[3], sides[3])));
}

void add_sectors(Builder& builder, const std::vector<int>& loop, const std::vector<int>& corners,
                 const std::vector<int>& lengths) {
  const std::size_t n = corners.size();
  const int centre = builder.add_vertex(builder.middle(loop));
  const auto size = static_cast<int>(loop.size());
  // The spoke i ends lengths[i + 1] edges before the corner i.
  std::vector<int> ends;
  std::vector<std::vector<int>> spokes;
  for (std::size_t i = 0; i < n; ++i) {
    ends.push_back((corners[i] - lengths[(i + 1) % n] + size) % size);
    spokes.push_back(builder.add_spoke(centre, loop[ends[i]], lengths[i]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    builder.add_grid(spokes[i], stretch(loop, ends[i], lengths[next]), reversed(stretch(loop, corners[i], lengths[i])),
                     spokes[next]);
  }
}

}  // namespace

FillQuads fill_quads(const std::vector<Vector3>& loop, const FillPattern& pattern) {
  Builder builder(loop);
  std::vector<int> vertices(loop.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  const std::vector<int> sides = sides_between(pattern.corners, static_cast<int>(loop.size()));
  const bool grid = sides.size() == 4;
  const std::vector<int> lengths = grid ? std::vector<int>() : spokes_of(sides);
  const double rings = grid ? std::min(sides[0], sides[1]) / 2. : *std::min_element(lengths.begin(), lengths.end());
  if (pattern.ring) vertices = builder.add_ring(vertices, 1 / (1 + rings));
  if (grid) {
    add_four_sides(builder, vertices, pattern.corners, sides);
  } else {
    add_sectors(builder, vertices, pattern.corners, lengths);
  }
  return builder.take();
}

}  // namespace umbilic
