// SPDX-License-Identifier: MIT
/// \file
/// Puts the rows of pins together, and solves them.
#include "driver/equations.h"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace umbilic {
namespace {

bool has_equations(const RefinedCage& cage) { return !cage.pins.empty() || holds_boundary(cage.boundary, cage.mesh); }

AffineSubspace subspace(const RefinedCage& cage, const Coordinates& coordinates) {
  return AffineSubspace(in_coordinates(equations_of(cage).rows, coordinates), coordinates.unknowns(cage.control));
}

}  // namespace

/// Appends the rows of boundaries, for x, y and z, with the values that the cage's own surface has.
PinRows equations_of(const RefinedCage& cage) {
  PinRows result = pin_rows(cage.pins, cage.mesh);
  const std::vector<PointRow> boundary = boundary_rows(cage.boundary, cage.mesh);
  if (boundary.empty()) return result;
  const int pins = result.rows.count(), count = pins + 3 * static_cast<int>(boundary.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < pins; ++row) {
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(result.rows.matrix, row); it; ++it) {
      entries.emplace_back(row, static_cast<int>(it.col()), it.value());
    }
  }
  result.rows.right.conservativeResize(count);
  int row = pins;
  for (const PointRow& held : boundary) {
    for (int c = 0; c < 3; ++c, ++row) {
      double value = 0;
      for (std::size_t i = 0; i < held.points.size(); ++i) {
        entries.emplace_back(row, 3 * held.points[i] + c, held.weights[i]);
        value += held.weights[i] * cage.own(held.points[i], c);
      }
      result.rows.right[row] = value;
      result.owners.push_back({-1, c, held.vertex});
    }
  }
  result.rows.matrix.resize(count, 3 * cage.mesh.vertex_count());
  result.rows.matrix.setFromTriplets(entries.begin(), entries.end());
  result.rows.scales = Eigen::VectorXd::Ones(count);
  return result;
}

std::string name_of(const RefinedCage& cage, const PinRows& rows, int row) {
  constexpr std::array kNames{"x", "y", "z", "normal", "normal"};
  const PinRow& owner = rows.owners[row];
  if (owner.pin < 0) return fmt::format("the boundary at vertex {}", owner.vertex + 1);
  const HeldPoint& point = cage.pins[owner.pin];
  return fmt::format("{}pin {} ({})", point.copy > 0 ? fmt::format("copy {} of ", point.copy) : "", point.pin + 1,
                     kNames[owner.coordinate]);
}

std::shared_ptr<const AffineSubspace> solutions_of(const RefinedCage& cage, const Coordinates& coordinates) {
  if (!has_equations(cage)) return nullptr;
  return std::make_shared<const AffineSubspace>(subspace(cage, coordinates));
}

std::optional<Error> contradiction_of(const RefinedCage& cage, const Coordinates& coordinates) {
  if (!has_equations(cage)) return std::nullopt;
  const AffineSubspace solutions = subspace(cage, coordinates);
  if (solutions.contradiction().empty()) return std::nullopt;
  const PinRows rows = equations_of(cage);
  std::string names;
  for (const int row : solutions.contradiction()) {
    if (const std::string name = name_of(cage, rows, row); names.find(name) == names.npos) {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  return Error{
      fmt::format("constraints: {} cannot all hold{}", names, cage.held.empty() ? "" : " while the held faces stay")};
}

namespace {

/// Weight of |d|^2, a displacement of all points, beside |L d|^2.
constexpr double kDisplacementWeight = 1e-6;
/// Equations hold where their residual is below this part of the size.
constexpr double kHolds = 1e-9;

/// L^2 + e I over the coordinates 3 v + c of the vertices; L has the valence on the diagonal and -1 for each edge.
Eigen::SparseMatrix<double> smoothness(const PolygonMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    for (int c = 0; c < 3; ++c) {
      entries.emplace_back(3 * mesh.origin(h) + c, 3 * mesh.target(h) + c, -1);
      entries.emplace_back(3 * mesh.origin(h) + c, 3 * mesh.origin(h) + c, 1);
    }
  }
  const int size = 3 * mesh.vertex_count();
  Eigen::SparseMatrix<double> laplacian(size, size), identity(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  identity.setIdentity();
  return laplacian * laplacian + kDisplacementWeight * identity;
}

/// The points as one vector, with the coordinates 3 v + c.
Eigen::VectorXd by_coordinates(const Points& points) {
  return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size());
}

bool equations_hold(const RefinedCage& cage, const Coordinates& coordinates, const Eigen::VectorXd& unknowns) {
  if (!has_equations(cage)) return true;
  const LinearRows rows = in_coordinates(equations_of(cage).rows, coordinates);
  return (rows.matrix * unknowns - rows.right).cwiseAbs().maxCoeff() <= kHolds;
}

}  // namespace

Points moved_to_equations(const RefinedCage& cage, const Coordinates& coordinates, const Points& expected) {
  const Eigen::VectorXd start = coordinates.unknowns(cage.control);
  Eigen::VectorXd nearest = by_coordinates(Points(coordinates.control(start) - cage.control));
  if (nearest.size() == 0 || nearest.cwiseAbs().maxCoeff() <= kHolds) nearest.setZero();
  if (nearest.isZero(0) && equations_hold(cage, coordinates, start)) return cage.control;
  const std::shared_ptr<const AffineSubspace> solutions = solutions_of(cage, coordinates);
  const Eigen::VectorXd origin = solutions ? solutions->origin() : start;
  const Eigen::SparseMatrix<double> basis = coordinates.matrix();
  const Eigen::SparseMatrix<double> move = solutions ? Eigen::SparseMatrix<double>(basis * solutions->basis()) : basis;
  if (move.cols() == 0) return coordinates.control(origin);
  const Eigen::SparseMatrix<double> smooth = smoothness(cage.mesh);
  const Eigen::SparseMatrix<double> reduced = move.transpose() * (smooth * move);
  nearest += basis * (origin - start);
  Eigen::VectorXd slope = smooth * nearest;
  if (expected.size() > 0) slope -= kDisplacementWeight * by_coordinates(expected);
  SparseCholesky factor(SparseCholesky::Pivots::kPositive);
  factor.begin(reduced.triangularView<Eigen::Lower>());
  while (!factor.advance()) {
  }
  if (!factor.succeeded()) return coordinates.control(origin);
  const Eigen::VectorXd y = -factor.solve(Eigen::VectorXd(move.transpose() * slope));
  return coordinates.control(solutions ? solutions->point(y) : Eigen::VectorXd(start + y));
}

Eigen::MatrixXd free_gauge(const RefinedCage& cage, const Gauge& gauge) {
  const bool nothing = !cage.held.empty() || cage.closeness || holds_boundary(cage.boundary, cage.mesh);
  if (nothing || gauge.dimension() == 0) return Eigen::MatrixXd(cage.control.size(), 0);
  const Eigen::MatrixXd all = orthonormal_gauge(gauge, cage.control);
  if (cage.pins.empty()) return all;
  return subspace(cage, Coordinates(cage.mesh.vertex_count())).kept(all);
}

bool leaves_size_open(const RefinedCage& cage) {
  Gauge isometries;
  isometries.scaling = false;
  return free_gauge(cage, Gauge()).cols() > free_gauge(cage, isometries).cols();
}

}  // namespace umbilic
