// SPDX-License-Identifier: MIT
/// \file
/// Breadth-first enumeration of a group, and averages over it.
#include "mesh/exact_group.h"

#include <Eigen/SVD>
#include <algorithm>

namespace umbilic {
namespace {

using Eigen::Matrix3d;

constexpr int kMaxSteps = 12;
/// Largest entry of a defect that is pure rounding, for products of a few generators and of several hundred.
constexpr double kRounding = 2e-15, kAccepted = 1e-11;

Matrix3d nearest_orthogonal(const Matrix3d& m) {
  const Eigen::JacobiSVD<Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// Largest entry of R_{gh} - R_g R_h over all generators g and elements h.
double defect(const Elements& elements, const std::vector<Symmetry>& generators, const std::vector<Matrix3d>& r) {
  double largest = 0;
  for (std::size_t g = 0; g < generators.size(); ++g) {
    for (int h = 0; h < elements.count(); ++h) {
      const Matrix3d difference = r[elements.left[g][h]] - generators[g].isometry * r[h];
      largest = std::max(largest, difference.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

}  // namespace

Elements elements(const std::vector<Symmetry>& generators, Flag base, int halfedge_count) {
  Elements result{{base}, {-1}, {-1}, std::vector<std::vector<int>>(generators.size())};
  std::vector<int> number(2 * static_cast<std::size_t>(halfedge_count), -1);
  number[result.flags[0].index()] = 0;
  for (int i = 0; i < result.count(); ++i) {
    for (std::size_t g = 0; g < generators.size(); ++g) {
      const Flag image = image_of_flag(generators[g].map, result.flags[i]);
      int& known = number[image.index()];
      if (known < 0) {
        known = result.count();
        result.flags.push_back(image);
        result.by.push_back(static_cast<int>(g));
        result.from.push_back(i);
      }
      result.left[g].push_back(known);
    }
  }
  return result;
}

std::vector<Matrix3d> isometries(const Elements& elements, const std::vector<Symmetry>& generators) {
  std::vector<Matrix3d> result(elements.count());
  result[0].setIdentity();
  for (int i = 1; i < elements.count(); ++i) {
    result[i] = generators[elements.by[i]].isometry * result[elements.from[i]];
  }
  return result;
}

bool make_exact(const Elements& elements, std::vector<Symmetry>& generators) {
  std::vector<Matrix3d> r = isometries(elements, generators);
  double error = defect(elements, generators, r);
  for (int step = 0; step < kMaxSteps && error > kRounding; ++step) {
    std::vector<Symmetry> better = generators;
    for (std::size_t g = 0; g < generators.size(); ++g) {
      // Averages the correction of R_g rather than R_g itself, so that rounding stays small over thousands of elements.
      const Matrix3d& isometry = generators[g].isometry;
      Matrix3d correction = Matrix3d::Zero();
      for (int h = 0; h < elements.count(); ++h) {
        correction += (r[elements.left[g][h]] - isometry * r[h]) * r[h].transpose();
      }
      better[g].isometry = nearest_orthogonal(isometry + correction / elements.count());
    }
    std::vector<Matrix3d> products = isometries(elements, better);
    const double remaining = defect(elements, better, products);
    if (remaining >= error) break;
    error = remaining;
    generators.swap(better);
    r.swap(products);
  }
  return error <= kAccepted;
}

}  // namespace umbilic
