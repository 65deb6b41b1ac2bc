// SPDX-License-Identifier: MIT
/// \file
/// Orbits of vertices, the directions that their stabilizers leave free, and products with B.
#include "mesh/coordinates.h"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace umbilic {
namespace {

using Eigen::Matrix3d;

/// Singular values of S - I below this count as zero. Products of generators are exact to about 1e-13; a rotation of
/// order n has singular values 2 sin(pi / n), far above.
constexpr double kFixed = 1e-9;
/// Cosine of the angle between columns that count as orthogonal.
constexpr double kOrthogonal = 1e-14;

/// The subspace of vectors that isometries fix, spanned by the first `dimension` columns of an orthogonal matrix.
struct FixedSubspace {
  Matrix3d basis = Matrix3d::Identity();
  int dimension = 3;

  void intersect(const Matrix3d& isometry) {
    if (dimension > 0 && (isometry - Matrix3d::Identity()).norm() >= kFixed) intersect_with_another(isometry);
  }

  /// The fixed vectors are those that S - I maps to zero. Rotating pairs of its columns until all are orthogonal
  /// (one-sided Jacobi) makes the lengths of the columns its singular values; the same rotations are applied to the
  /// basis. Called rarely, but large once inlined: kept out of the loop over all vertices, so that a browser need not
  /// optimize it.
  [[gnu::noinline]] void intersect_with_another(const Matrix3d& isometry) {
    Matrix3d moved = isometry * basis - basis;
    for (bool rotated = true; rotated;) {
      rotated = false;
      for (int i = 0; i < dimension; ++i) {
        for (int j = i + 1; j < dimension; ++j) rotated = make_orthogonal(moved, i, j) || rotated;
      }
    }
    int fixed = 0;
    for (int i = 0; i < dimension; ++i) {
      if (moved.col(i).norm() < kFixed) basis.col(i).swap(basis.col(fixed++));
    }
    dimension = fixed;
  }

  /// Makes the columns i and j orthogonal; returns whether they had to be rotated. Columns shorter than kFixed count as
  /// zero.
  bool make_orthogonal(Matrix3d& moved, int i, int j) {
    const double squares = moved.col(i).squaredNorm(), others = moved.col(j).squaredNorm();
    const double product = moved.col(i).dot(moved.col(j));
    if (std::abs(product) <= kOrthogonal * std::max(std::sqrt(squares * others), kFixed * kFixed)) return false;
    Eigen::JacobiRotation<double> rotation;
    rotation.makeJacobi(squares, product, others);
    moved.applyOnTheRight(i, j, rotation);
    basis.applyOnTheRight(i, j, rotation);
    return true;
  }
};

}  // namespace

Coordinates::Coordinates(int vertex_count) : vertex_count_(vertex_count), count_(3 * vertex_count) {}

Coordinates::Coordinates(const PolygonMesh& mesh, const SymmetryGroup& group, HeldPoints held)
    : Coordinates(mesh.vertex_count()) {
  if (group.generators.empty() && !held.any()) return;
  cartesian_ = group.generators.empty();
  held_ = std::move(held);
  offset_ = group.center;
  count_ = 0;
  rows_.resize(vertex_count_);
  std::vector<std::vector<int>> images;
  for (const Symmetry& generator : group.generators) images.push_back(vertex_images(mesh, generator.map));

  // R_w maps the first vertex of an orbit to vertex w. rows_[w].basis holds R_w until the orbit is complete.
  std::vector<bool> reached(vertex_count_, false);
  std::vector<int> orbit;
  for (int first = 0; first < vertex_count_; ++first) {
    if (reached[first]) continue;
    reached[first] = true;
    first_of_orbit_.push_back(first);
    rows_[first].basis.setIdentity();
    orbit.assign(1, first);
    FixedSubspace fixed;
    for (std::size_t i = 0; i < orbit.size(); ++i) {
      const int v = orbit[i];
      for (std::size_t g = 0; g < images.size(); ++g) {
        const int w = images[g][v];
        const Matrix3d word = group.generators[g].isometry * rows_[v].basis;
        if (!reached[w]) {
          reached[w] = true;
          rows_[w].basis = word;
          orbit.push_back(w);
        } else {
          fixed.intersect(rows_[w].basis.transpose() * word);  // Schreier's generators of the stabilizer
        }
      }
    }
    if (held_.any() && held_.held[first]) fixed.dimension = 0;
    const Matrix3d basis = fixed.basis / std::sqrt(static_cast<double>(orbit.size()));
    for (const int v : orbit) {
      assert(!held_.any() || held_.held[v] == held_.held[first]);
      rows_[v].first = count_;
      rows_[v].dimension = fixed.dimension;
      rows_[v].basis = (rows_[v].basis * basis).eval();
    }
    count_ += fixed.dimension;
  }
}

Points Coordinates::control(const Eigen::VectorXd& unknowns) const {
  Points result;
  control(unknowns, result);
  return result;
}

void Coordinates::control(const Eigen::VectorXd& unknowns, Points& control) const {
  assert(unknowns.size() == count_);
  control.resize(vertex_count_, 3);
  if (rows_.empty()) {
    Eigen::Map<Eigen::VectorXd>(control.data(), control.size()) = unknowns;
    return;
  }
  for (int v = 0; v < vertex_count_; ++v) {
    if (held_.any() && held_.held[v]) {
      control.row(v) = held_.points.row(v);
      continue;
    }
    const Rows& rows = rows_[v];
    Vector3 point = offset_;
    for (int i = 0; i < rows.dimension; ++i) point += rows.basis.col(i) * unknowns[rows.first + i];
    control.row(v) = point.transpose();
  }
}

void Coordinates::project(const Points& rows, const Vector3& offset, Eigen::VectorXd& unknowns) const {
  assert(rows.rows() == vertex_count_);
  // A vector that Eigen fails to resize is freed twice; here the new one takes its place only once it is there.
  if (unknowns.size() != count_) unknowns = Eigen::VectorXd(count_);
  if (rows_.empty()) {
    unknowns = Eigen::Map<const Eigen::VectorXd>(rows.data(), rows.size());
    return;
  }
  unknowns.setZero();
  for (int v = 0; v < vertex_count_; ++v) {
    const Rows& block = rows_[v];
    const Vector3 row = rows.row(v).transpose() - offset;
    for (int i = 0; i < block.dimension; ++i) unknowns[block.first + i] += block.basis.col(i).dot(row);
  }
}

Eigen::VectorXd Coordinates::unknowns(const Points& control) const {
  Eigen::VectorXd result;
  unknowns(control, result);
  return result;
}

void Coordinates::unknowns(const Points& control, Eigen::VectorXd& unknowns) const {
  project(control, offset_, unknowns);
}

Eigen::VectorXd Coordinates::pull_back(const Points& gradient) const {
  Eigen::VectorXd result;
  pull_back(gradient, result);
  return result;
}

void Coordinates::pull_back(const Points& gradient, Eigen::VectorXd& unknowns) const {
  project(gradient, Vector3::Zero(), unknowns);
}

Points Coordinates::orbit_points(const Points& control) const {
  if (free()) return control;
  return control(first_of_orbit_, Eigen::all);
}

Points Coordinates::control_from_orbits(const Points& points) const {
  assert(points.rows() == orbit_count());
  if (free()) return points;
  Eigen::VectorXd unknowns(count_);
  for (int i = 0; i < orbit_count(); ++i) {
    const Rows& rows = rows_[first_of_orbit_[i]];
    const Vector3 point = points.row(i).transpose() - offset_;
    for (int k = 0; k < rows.dimension; ++k) {
      const auto column = rows.basis.col(k);  // its length is 1/sqrt(orbit size)
      unknowns[rows.first + k] = column.dot(point) / column.squaredNorm();
    }
  }
  return control(unknowns);
}

Coordinates::Block Coordinates::block(int vertex) const {
  if (rows_.empty()) return {3 * vertex, 3, Matrix3d::Identity()};
  const Rows& rows = rows_[vertex];
  return {rows.first, rows.dimension, rows.basis.leftCols(rows.dimension)};
}

Eigen::SparseMatrix<double> Coordinates::matrix() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < vertex_count_; ++v) {
    const Block rows = block(v);
    for (int k = 0; k < rows.dimension; ++k) {
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * v + c, rows.first + k, rows.basis(c, k));
    }
  }
  Eigen::SparseMatrix<double> result(3 * vertex_count_, count_);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace umbilic
