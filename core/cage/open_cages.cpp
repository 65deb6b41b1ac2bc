// SPDX-License-Identifier: MIT
/// \file
/// Profiles that are turned about the axis, disks within rings, and polygons.
#include "cage/open_cages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>
#include <optional>

#include "cage/fill_quads.h"
#include "cage/limit_fit.h"

namespace umbilic {

namespace {

constexpr double kPi = 3.141592653589793;
constexpr int kFewestAround = 8;
constexpr int kMostAround = 1000;

std::optional<Error> check(std::string_view what, double value, double least, double most) {
  if (value >= least && value <= most) return std::nullopt;
  return Error{fmt::format("{} {} is not between {} and {}", what, value, least, most)};
}

std::optional<Error> check_segments(const CageOptions& options, int least_across, int most_across, int step = 1) {
  const int around = options.major_segments, across = options.minor_segments;
  if (around < kFewestAround || around > kMostAround || around % step != 0) {
    return Error{fmt::format("{} segments around are not {} to {}{}", around, kFewestAround, kMostAround,
                             step > 1 ? fmt::format(" and divisible by {}", step) : "")};
  }
  if (across < least_across || across > most_across) {
    return Error{fmt::format("{} segments across are not {} to {}", across, least_across, most_across)};
  }
  return std::nullopt;
}

template <class... Errors>
std::optional<Error> first_of(const Errors&... errors) {
  std::optional<Error> first;
  (void)((errors ? (first = errors, true) : false) || ...);
  return first;
}

/// A point of a meridian: its distance from the axis, and its height.
using Profile = Eigen::Vector2d;

/// A meridian and its derivatives by a parameter of which a quad takes 1.
struct Meridian {
  std::function<Profile(double)> at, first, second;
};

/// The control points G, P and Q of a row across the boundary at parameter t, inward if `inward` is 1, else -1.
std::array<Profile, 3> across(const Meridian& meridian, double t, double inward) {
  const Profile c = meridian.at(t), d = inward * meridian.first(t), e = meridian.second(t);
  const Profile p = c - e / 6;
  return {p - d + e / 2, p, p + d + e / 2};
}

/// The distance from the axis of the M control points of a spline that interpolates the unit circle at its knots.
double circle_factor(int around) { return 6 / (4 + 2 * std::cos(2 * kPi / around)); }

/// The control points of the spline along the meridian, from before the parameter 0 to after n, n >= 3: three at each
/// end by the exact derivatives there, the others so that it interpolates the meridian at 2, …, n - 2.
std::vector<Profile> spline_along(const Meridian& meridian, int n) {
  const std::array<Profile, 3> begin = across(meridian, 0, 1), end = across(meridian, n, -1);
  std::vector<Profile> points(n + 3);
  std::copy(begin.begin(), begin.end(), points.begin());
  std::reverse_copy(end.begin(), end.end(), points.end() - 3);
  // (x[i-1] + 4 x[i] + x[i+1]) / 6 = the meridian's point; points[i] belongs to the parameter i - 1. Thomas' algorithm.
  std::vector<double> pivot(points.size(), 0);
  for (int i = 3; i < n; ++i) {
    points[i] = 6 * meridian.at(i - 1) - points[i - 1] / (i == 3 ? 1 : pivot[i - 1]);
    if (i == n - 1) points[i] -= points[n];
    pivot[i] = 4 - (i == 3 ? 0 : 1 / pivot[i - 1]);
  }
  for (int i = n - 1; i >= 3; --i) points[i] = (points[i] - (i == n - 1 ? Profile(0, 0) : points[i + 1])) / pivot[i];
  return points;
}

/// Puts circles of M points at these profiles into rows of vertices from `first` on.
void set_circle(Cage& cage, int first, int around, const Profile& profile) {
  const double radius = profile.x() * circle_factor(around);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * kPi * i / around;
    cage.vertices.row(first + i) << radius * std::cos(angle), radius * std::sin(angle), profile.y();
  }
}

/// Adds the quads between two circles; the surface's outside is where they and the way from the first to the second
/// turn left.
void add_band(Cage& cage, int first, int second, int around) {
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    cage.faces.push_back({first + i, first + next, second + next, second + i});
  }
}

void mark_last(Cage& cage, int holes) {
  cage.holes.resize(holes);
  std::iota(cage.holes.begin(), cage.holes.end(), static_cast<int>(cage.faces.size()) - holes);
}

/// The surface of revolution of a meridian over [0, n].
Cage revolved(const Meridian& meridian, int around, int n) {
  const std::vector<Profile> profile = spline_along(meridian, n);
  Cage cage;
  const auto rows = static_cast<int>(profile.size());
  cage.vertices.resize(rows * around, 3);
  // The circles of the surface first.
  const auto first = [&](int row) { return (row == 0 ? rows - 2 : row == rows - 1 ? rows - 1 : row - 1) * around; };
  for (int row = 0; row < rows; ++row) set_circle(cage, first(row), around, profile[row]);
  for (int row = 1; row + 2 < rows; ++row) add_band(cage, first(row), first(row + 1), around);
  add_band(cage, first(0), first(1), around);
  add_band(cage, first(rows - 2), first(rows - 1), around);
  mark_last(cage, 2 * around);
  return cage;
}

/// Positions in the unit disk of a disk's vertices: circles that shrink evenly, and a grid within the last, smoothed.
std::vector<Eigen::Vector2d> disk_positions(const FillQuads& grid, int around, int rings) {
  const double width = 1 / (rings + around / 8.);
  std::vector<Eigen::Vector2d> positions;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      positions.push_back((1 - ring * width) * Eigen::Vector2d(grid.points[i].x(), grid.points[i].y()));
    }
  }
  for (std::size_t i = around; i < grid.points.size(); ++i) {
    positions.push_back((1 - rings * width) * Eigen::Vector2d(grid.points[i].x(), grid.points[i].y()));
  }
  return positions;
}

/// Moves all but the first vertices towards the means of their neighbours.
void smooth(std::vector<Eigen::Vector2d>& positions, const std::vector<std::vector<int>>& quads, int first) {
  constexpr int kIterations = 300;
  std::vector<Eigen::Vector2d> sums(positions.size());
  std::vector<double> counts(positions.size());
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    std::fill(sums.begin(), sums.end(), Eigen::Vector2d::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (const std::vector<int>& quad : quads) {
      for (int i = 0; i < 4; ++i) {
        sums[quad[i]] += positions[quad[(i + 1) % 4]] + positions[quad[(i + 3) % 4]];
        counts[quad[i]] += 2;
      }
    }
    for (std::size_t v = first; v < positions.size(); ++v) positions[v] = (positions[v] + sums[v] / counts[v]) / 2;
  }
}

/// A disk-like surface of revolution, whose profile is a function of the distance 0 … 1 from the pole. The meridian
/// goes from the boundary inward, at the pace of the quads there.
Cage disk_like(const std::function<Profile(double)>& profile, const Meridian& meridian, const CageOptions& options) {
  const int around = options.major_segments, rings = options.minor_segments, quarter = around / 4;
  Cage circle;
  circle.vertices.resize(around, 3);
  set_circle(circle, 0, around, {1 / circle_factor(around), 0});
  std::vector<Vector3> points;
  for (int i = 0; i < around; ++i) points.push_back(circle.vertices.row(i));
  const FillQuads grid = fill_quads(points, {false, {0, quarter, 2 * quarter, 3 * quarter}});

  Cage cage;
  for (int ring = 0; ring < rings; ++ring) add_band(cage, ring * around, (ring + 1) * around, around);
  for (const std::array<int, 4>& quad : grid.quads) {
    cage.faces.emplace_back();
    for (const int v : quad) cage.faces.back().push_back(v + rings * around);
  }
  std::vector<Eigen::Vector2d> positions = disk_positions(grid, around, rings);
  const auto count = static_cast<int>(positions.size());
  smooth(positions, cage.faces, 3 * around);
  add_band(cage, count, 0, around);
  mark_last(cage, around);

  Points targets(count + around, 3);
  for (int v = 0; v < count; ++v) {
    const double distance = positions[v].norm();
    const Profile at = profile(distance);
    const Eigen::Vector2d direction = distance > 0 ? Eigen::Vector2d(positions[v] / distance) : positions[v];
    targets.row(v) << at.x() * direction.x(), at.x() * direction.y(), at.y();
  }
  cage.vertices = targets;
  const std::array<Profile, 3> rows = across(meridian, 0, 1);
  set_circle(cage, count, around, rows[0]);
  set_circle(cage, 0, around, rows[1]);
  set_circle(cage, around, around, rows[2]);
  std::vector<int> free(count - 2 * around);
  std::iota(free.begin(), free.end(), 2 * around);
  fit_limit(cage, free, targets);
  return cage;
}

/// The width of a ring of a disk, of which the whole meridian takes 1.
double ring_width(const CageOptions& options) { return 1 / (options.minor_segments + options.major_segments / 8.); }

void lift_to_saddle(Cage& cage, const CageOptions& options) {
  for (auto point : cage.vertices.rowwise()) {
    const std::complex<double> at(point.x() / options.radius, point.y() / options.radius);
    point.z() = options.rise * std::pow(at, options.sides).real();
  }
}

constexpr double kSmallest = 0.01;
constexpr double kLargest = 100;
constexpr int kMostRings = 200;
/// Three rows at the boundary have exact derivatives, and no extraordinary vertex.
constexpr int kFewestRings = 2;

}  // namespace

Result<Cage> open_cylinder(const CageOptions& options) {
  const double radius = options.radius, height = options.height;
  const int n = options.minor_segments;
  if (auto error = first_of(check("radius", radius, kSmallest, kLargest), check("height", height, kSmallest, kLargest),
                            check_segments(options, 3, kMostAround))) {
    return *error;
  }
  const Meridian line{[=](double t) { return Profile(radius, height * (t / n - 0.5)); },
                      [=](double) { return Profile(0, height / n); }, [](double) { return Profile(0, 0); }};
  return revolved(line, options.major_segments, n);
}

Result<Cage> catenoid(const CageOptions& options) {
  const double waist = options.waist, height = options.height;
  const int n = options.minor_segments;
  constexpr double kMostWaists = 10;  // beyond, the ends are 74 times as wide as the waist
  if (auto error = first_of(check("waist", waist, kSmallest, kLargest),
                            check("height", height, kSmallest, std::min(kLargest, kMostWaists * waist)),
                            check_segments(options, 3, kMostAround))) {
    return *error;
  }
  // By the arc length s = w sinh(z / w), so that the quads are equally long.
  const double half = waist * std::sinh(height / 2 / waist), step = 2 * half / n;
  const auto s = [=](double t) { return t * step - half; };
  const auto radius = [=](double t) { return std::hypot(waist, s(t)); };
  const Meridian chain{[=](double t) { return Profile(radius(t), waist * std::asinh(s(t) / waist)); },
                       [=](double t) { return Profile(step * s(t) / radius(t), step * waist / radius(t)); },
                       [=](double t) {
                         const double cube = std::pow(radius(t), 3);
                         return Profile(step * step * waist * waist / cube, -step * step * waist * s(t) / cube);
                       }};
  return revolved(chain, options.major_segments, n);
}

Result<Cage> flat_disk(const CageOptions& options) {
  const double radius = options.radius;
  if (auto error = first_of(check("radius", radius, kSmallest, kLargest),
                            check_segments(options, kFewestRings, kMostRings, 4))) {
    return *error;
  }
  const double width = radius * ring_width(options);
  const Meridian line{[=](double t) { return Profile(radius - t * width, 0); },
                      [=](double) { return Profile(-width, 0); }, [](double) { return Profile(0, 0); }};
  return disk_like([=](double distance) { return Profile(radius * distance, 0); }, line, options);
}

Result<Cage> spherical_cap(const CageOptions& options) {
  const double radius = options.radius;
  if (auto error =
          first_of(check("radius", radius, kSmallest, kLargest), check("half_angle", options.half_angle, 1, 179),
                   check_segments(options, kFewestRings, kMostRings, 4))) {
    return *error;
  }
  const double whole = options.half_angle * kPi / 180, width = whole * ring_width(options);
  const auto circle = [=](double angle) { return Profile(radius * std::sin(angle), radius * std::cos(angle)); };
  const Meridian meridian{[=](double t) { return circle(whole - t * width); },
                          [=](double t) {
                            const Profile at = circle(whole - t * width);
                            return Profile(-width * at.y(), width * at.x());
                          },
                          [=](double t) { return Profile(-width * width * circle(whole - t * width)); }};
  return disk_like([=](double distance) { return circle(whole * distance); }, meridian, options);
}

Result<Cage> n_sided_polygon(const CageOptions& options) {
  const int sides = options.sides, along = options.major_segments;
  constexpr int kMostAlong = 100;
  if (auto error = first_of(check("radius", options.radius, kSmallest, kLargest), check("sides", sides, 3, 12),
                            check("rise", options.rise, -kLargest, kLargest))) {
    return *error;
  }
  if (along < 2 || along > kMostAlong || along % 2 != 0) {
    return Error{fmt::format("{} segments along a side are not 2 to {} and even", along, kMostAlong)};
  }
  if (options.minor_segments != along / 2) {
    return Error{fmt::format("{} segments across are not half of the {} along a side", options.minor_segments, along)};
  }
  const auto corner = [&](int i) {
    const double angle = 2 * kPi * (i % sides) / sides;
    return Vector3(options.radius * std::cos(angle), options.radius * std::sin(angle), 0);
  };
  std::vector<Vector3> loop;
  FillPattern pattern;
  for (int side = 0; side < sides; ++side) {
    pattern.corners.push_back(static_cast<int>(loop.size()));
    for (int i = 0; i < along; ++i) loop.push_back(corner(side) + (corner(side + 1) - corner(side)) * i / along);
  }
  FillQuads patch = fill_quads(loop, pattern);

  // Beyond the sides the points are mirrored in them; beyond a corner in both of its sides.
  const int length = patch.loop;
  std::vector<Vector3>& points = patch.points;
  std::vector<int> within(length, -1);
  for (const std::array<int, 4>& quad : patch.quads) {
    for (int i = 0; i < 4; ++i) {
      const int v = quad[i], left = quad[(i + 3) % 4];
      if (v < length && quad[(i + 1) % 4] == (v + 1) % length) within[v] = left;
    }
  }
  const auto add = [&](const Vector3& point) {
    points.push_back(point);
    return static_cast<int>(points.size()) - 1;
  };
  const auto surface = patch.quads.size();
  std::vector<int> before(length), after(length);  // the points beyond v, of the edges that end and begin there
  for (int v = 0; v < length; ++v) {
    const int last = (v + length - 1) % length, next = (v + 1) % length;
    if (v % along != 0) {
      before[v] = after[v] = add(2 * points[v] - points[within[v]]);
      continue;
    }
    const int opposite = within[next];  // of the corner's only quad
    before[v] = add(2 * points[v] - points[next]);
    const int corner_point = add(4 * points[v] - 2 * points[last] - 2 * points[next] + points[opposite]);
    after[v] = add(2 * points[v] - points[last]);
    patch.quads.push_back({v, before[v], corner_point, after[v]});
  }
  for (int v = 0; v < length; ++v) {
    const int next = (v + 1) % length;
    patch.quads.push_back({next, v, after[v], before[next]});
  }
  Cage cage;
  cage.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) cage.vertices.row(static_cast<Eigen::Index>(v)) = points[v];
  for (const std::array<int, 4>& quad : patch.quads) cage.faces.emplace_back(quad.begin(), quad.end());
  mark_last(cage, static_cast<int>(patch.quads.size() - surface));
  if (options.rise != 0) lift_to_saddle(cage, options);
  return cage;
}

CageOptions with_open_defaults(CageKind kind, CageOptions options) {
  int& around = options.major_segments;
  int& across = options.minor_segments;
  if (around == 0) around = kind == CageKind::kNSided ? 8 : 32;
  if (across != 0) return options;
  // About as long as the quads at the boundary are wide; numbers out of range are refused later.
  const auto by_length = [&](double length, double radius, int least) {
    const double count = std::round(length * around / (2 * kPi * radius));
    return count >= least && count <= kMostRings ? static_cast<int>(count) : count > kMostRings ? kMostRings : least;
  };
  constexpr int kRings = 3;
  switch (kind) {
    case CageKind::kNSided: across = around / 2; break;
    case CageKind::kCylinder: across = by_length(options.height, options.radius, 4); break;
    case CageKind::kCatenoid: {
      const double half = options.height / 2 / options.waist;
      across = by_length(2 * options.waist * std::sinh(half), options.waist * std::cosh(half), 4);
      break;
    }
    case CageKind::kSphericalCap:
      across = std::max(kRings, by_length(options.half_angle * kPi / 180, 1, kRings) - around / 8);
      break;
    default: across = kRings;
  }
  return options;
}

}  // namespace umbilic
