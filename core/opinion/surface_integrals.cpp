// SPDX-License-Identifier: MIT
/// \file
/// Goes over the faces of a surface piece by piece, on each of which it is a bicubic spline blended into one function.
#include "opinion/surface_integrals.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/threads.h"
#include "opinion/cap_point.h"
#include "opinion/characteristic_map.h"
#include "opinion/clenshaw_curtis.h"
#include "opinion/corner_window.h"

namespace umbilic::opinion {
namespace {

constexpr int kIntervals = 16;
/// Pieces in each direction that a piece is cut into, with the paper's steep blend.
constexpr int kFlatCuts = 4;
/// Steps towards an extraordinary vertex. What is left then, or is less than kLeft of the face's integrals, is summed
/// as a geometric series.
constexpr int kMostSteps = 48, kLeastSteps = 3;
constexpr double kLeft = 1e-10;
/// Faces that are computed between two additions to the sums.
constexpr int kBlock = 32;

struct Sums {
  Quantities fine{}, coarse{};
  double samples = 0;

  void add(const Sums& o, int times = 1) {
    for (std::size_t i = 0; i < fine.size(); ++i) {
      fine[i] += times * o.fine[i];
      coarse[i] += times * o.coarse[i];
    }
    samples += o.samples;
  }
};

/// The extraordinary vertex's tangent plane.
struct Plane {
  Vector3 point, normal;
};

/// The limit of the window's corner and its normal: after many steps the corner is at the limit and the first ring is
/// an affine image of the characteristic map's, but for what its Fourier coefficients of the lowest frequency leave
/// out.
Plane tangent_plane(CornerWindow window) {
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i) window.step();
  Vector3 cosine = Vector3::Zero(), sine = Vector3::Zero();
  for (int j = 0; j < window.valence(); ++j) {
    const double angle = 2 * std::numbers::pi * j / window.valence();
    cosine += std::cos(angle) * window.spoke(j);
    sine += std::sin(angle) * window.spoke(j);
  }
  return {window.corner(), cosine.normalized().cross(sine.normalized()).normalized()};
}

/// Where a face lies in a cap.
struct Place {
  int cap = -1;
  int halfedge = -1;  ///< along u
  int sector = 0, i = 0, j = 0;
};

/// A square of a face on which S and the characteristic map are bicubic: the points u = u0 + size s, v = v0 + size t.
struct Piece {
  Grid surface;
  Vector3 origin;  ///< what the grid is relative to
  Grid map;        ///< of the characteristic map
  double u0, v0, size;
};

class Integrator {
 public:
  explicit Integrator(const PlainSurface& surface);

  Integrals integrate() const;

 private:
  Sums of_face(int f) const;
  Sums of_piece(const Piece& piece, const Place& place, int cuts) const;
  Sums at_corner(const Place& place) const;
  TaylorPoint blended(const TaylorPoint& s, const Piece& piece, const Place& place, const Eigen::Matrix4d& along_s,
                      const Eigen::Matrix4d& along_t, double at_s, double at_t) const;
  bool is_extraordinary(int h) const { return mesh_.valence(mesh_.origin(h)) != 4; }
  const CharacteristicMap* map_of(const Place& place) const;

  const PlainSurface& surface_;
  const PolygonMesh& mesh_;
  NestedRule rule_;
  std::vector<Place> places_;  // of each face of the surface
  std::vector<Plane> planes_;  // of each cap
  std::map<std::pair<int, int>, CharacteristicMap> maps_;
  bool diverges_ = false;
};

Integrator::Integrator(const PlainSurface& surface)
    : surface_(surface),
      mesh_(surface.mesh),
      rule_(clenshaw_curtis(kIntervals)),
      places_(surface.mesh.surface_face_count()) {
  for (int f = 0; f < mesh_.surface_face_count(); ++f) {
    places_[f].halfedge = mesh_.halfedge(f, 0);
    for (int i = 0; i < 4; ++i) {
      const int h = mesh_.halfedge(f, i);
      if (is_extraordinary(h)) places_[f].halfedge = h;
      diverges_ = diverges_ || (is_extraordinary(h) && surface.form == CapForm::kNone);
    }
  }
  const auto right = [&](int h) { return mesh_.next(mesh_.twin(mesh_.next(h))); };
  const auto above = [&](int h) { return mesh_.twin(mesh_.next(mesh_.next(h))); };
  for (std::size_t c = 0; c < surface.caps.size(); ++c) {
    const PlainCap& cap = surface.caps[c];
    int spoke = cap.halfedge;
    for (int sector = 0; sector < cap.sectors; ++sector, spoke = mesh_.rotate(spoke)) {
      int row = spoke;
      for (int j = 0; j < cap.rings; ++j) {
        if (j > 0) row = above(row);
        int h = row;
        for (int i = 0; i < cap.rings; ++i) {
          if (i > 0) h = right(h);
          places_[mesh_.face(h)] = {static_cast<int>(c), h, sector, i, j};
        }
      }
    }
    const int valence = mesh_.valence(mesh_.origin(cap.halfedge));
    if (surface.form == CapForm::kPlane) {
      planes_.push_back(tangent_plane(CornerWindow(mesh_, surface.control, cap.halfedge)));
    } else if (surface.form == CapForm::kPolynomial) {
      maps_.try_emplace({valence, cap.rings}, valence, cap.rings);
    }
  }
}

const CharacteristicMap* Integrator::map_of(const Place& place) const {
  if (place.cap < 0 || surface_.form != CapForm::kPolynomial) return nullptr;
  const PlainCap& cap = surface_.caps[place.cap];
  return &maps_.at({mesh_.valence(mesh_.origin(cap.halfedge)), cap.rings});
}

TaylorPoint Integrator::blended(const TaylorPoint& s, const Piece& piece, const Place& place,
                                const Eigen::Matrix4d& along_s, const Eigen::Matrix4d& along_t, double at_s,
                                double at_t) const {
  if (place.cap < 0 || surface_.form == CapForm::kNone) return s;
  const PlainCap& cap = surface_.caps[place.cap];
  const Taylor u = Taylor::along_s((place.i + piece.u0 + piece.size * at_s) / cap.rings, piece.size / cap.rings);
  const Taylor v = Taylor::along_t((place.j + piece.v0 + piece.size * at_t) / cap.rings, piece.size / cap.rings);
  if (surface_.form == CapForm::kPlane) {
    const Plane& plane = planes_[place.cap];
    Taylor height = -plane.normal.dot(plane.point);
    for (int c = 0; c < 3; ++c) height += plane.normal[c] * s[c];
    height = height * flat_blend(u) * flat_blend(v);
    return s - TaylorPoint{plane.normal[0], plane.normal[1], plane.normal[2]} * height;
  }
  const TaylorPoint z = bicubic(piece.map, along_s, along_t);
  const std::complex<double> turn =
      std::polar(1.0, 2 * std::numbers::pi * place.sector / mesh_.valence(mesh_.origin(cap.halfedge)));
  const Taylor x = turn.real() * z[0] - turn.imag() * z[1], y = turn.imag() * z[0] + turn.real() * z[1];
  return s + (polynomial(cap.coefficients, cap.degree, x, y) - s) * (smooth_blend(u) * smooth_blend(v));
}

Sums Integrator::of_piece(const Piece& piece, const Place& place, int cuts) const {
  const auto points = static_cast<int>(rule_.nodes.size());
  std::vector<double> nodes;
  std::vector<Eigen::Matrix4d> splines;
  for (int cut = 0; cut < cuts; ++cut) {
    for (const double node : rule_.nodes) {
      nodes.push_back((cut + node) / cuts);
      splines.push_back(bspline_coefficients(nodes.back()));
    }
  }
  Sums sums;
  const double cell = 1.0 / (cuts * cuts);
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      TaylorPoint s = bicubic(piece.surface, splines[i], splines[j]);
      for (int c = 0; c < 3; ++c) s[c].c[0] += piece.origin[c];
      const Quantities here = integrands(blended(s, piece, place, splines[i], splines[j], nodes[i], nodes[j]));
      const std::size_t along_u = i % points, along_v = j % points;
      const double fine = cell * rule_.weights[along_u] * rule_.weights[along_v];
      const double coarse = cell * rule_.coarse[along_u] * rule_.coarse[along_v];
      for (std::size_t q = 0; q < here.size(); ++q) {
        sums.fine[q] += fine * here[q];
        sums.coarse[q] += coarse * here[q];
      }
    }
  }
  sums.samples = static_cast<double>(nodes.size() * nodes.size());
  return sums;
}

/// Of a face with an extraordinary vertex: of the three quarters away from it, of the three of the fourth, and so on.
Sums Integrator::at_corner(const Place& place) const {
  CornerWindow window(mesh_, surface_.control, place.halfedge);
  const CharacteristicMap* characteristic = map_of(place);
  std::optional<CornerWindow> map;
  if (characteristic) map = characteristic->window();
  const int cuts = surface_.form == CapForm::kPlane ? kFlatCuts : 1;
  Sums total;
  Quantities before{};
  double size = 0.5;
  for (int step = 0; step < kMostSteps; ++step, size /= 2) {
    window.step();
    if (map) map->step();
    Sums here;
    for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
      here.add(
          of_piece({window.quarter(i, j), window.corner(), map ? map->quarter(i, j) : Grid(), i * size, j * size, size},
                   place, step < 2 ? cuts : 1));
    }
    total.add(here);
    Quantities rest{};
    bool small = step >= kLeastSteps;
    for (std::size_t q = 0; q < rest.size(); ++q) {
      const double ratio = here.fine[q] / before[q];
      if (ratio > 0 && ratio < 1) rest[q] = here.fine[q] * ratio / (1 - ratio);
      const double scale = std::abs(total.fine[q]) + 1e-10 * std::abs(total.fine[0]);
      small = small && ((diverges_ && kQuantities[q].third_order) ||
                        std::abs(rest[q]) + std::abs(here.fine[q]) <= kLeft * scale);
    }
    before = here.fine;
    if (small || step + 1 == kMostSteps) {
      for (std::size_t q = 0; q < rest.size(); ++q) {
        total.fine[q] += rest[q];
        total.coarse[q] += rest[q];
      }
      break;
    }
  }
  return total;
}

Sums Integrator::of_face(int f) const {
  const Place& place = places_[f];
  if (is_extraordinary(place.halfedge)) return at_corner(place);
  const CharacteristicMap* map = map_of(place);
  return of_piece({regular_grid(mesh_, surface_.control, place.halfedge), Vector3::Zero(),
                   map ? map->grid(place.i, place.j) : Grid(), 0, 0, 1},
                  place, 1);
}

Integrals Integrator::integrate() const {
  Sums total;
  const int faces = mesh_.surface_face_count(), blocks = (faces + kBlock - 1) / kBlock;
  const int slots = slot_count();
  std::vector<Sums> of_slot(slots);
  in_order(
      blocks, slots,
      [&](int block, int slot, int) {
        of_slot[slot] = {};
        for (int f = kBlock * block; f < std::min(faces, kBlock * (block + 1)); ++f) {
          const int times = surface_.times.empty() ? 1 : surface_.times[f];
          if (times > 0) of_slot[slot].add(of_face(f), times);
        }
      },
      [&](int, int slot) { total.add(of_slot[slot]); });
  Integrals result;
  result.samples = total.samples;
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    if (diverges_ && kQuantities[q].third_order) {
      result.values[q] = result.errors[q] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    const double exponent = kQuantities[q].area_exponent;
    result.values[q] = total.fine[q] * std::pow(total.fine[0], exponent);
    result.errors[q] = std::abs(result.values[q] - total.coarse[q] * std::pow(total.coarse[0], exponent));
  }
  return result;
}

}  // namespace

Integrals integrate(const PlainSurface& surface) { return Integrator(surface).integrate(); }

}  // namespace umbilic::opinion
