// SPDX-License-Identifier: MIT
/// \file
/// Reparametrizes linearly so that the parameter directions are orthonormal at the point; Christoffel symbols are then
/// dot products.
///
///   Gamma^m_ij            = e_m . Y_ij
///   d_k Gamma^m_ij        = e_m . Y_ijk - Gamma^l_ij Gamma^m_lk + II_ij II_mk
///   (grad^2 f)_ij         = f_ij - Gamma^m_ij f_m
///   (grad^3 f)_kij        = f_ijk - (d_k Gamma^m_ij) f_m - Gamma^m_ij f_mk - Gamma^m_ki (grad^2 f)_mj - Gamma^m_kj
///   (grad^2 f)_im
#include "optimize/covariant.h"

#include <cmath>
#include <numbers>

namespace umbilic {

CovariantDerivatives::CovariantDerivatives(const Eigen::Matrix<double, kThirdOrderCount, 3>& jet, bool with_third) {
  const Vector3 a = jet.row(0), b = jet.row(1), cross = a.cross(b);
  area = cross.norm();
  const Vector3 n = cross / area;
  const double alpha = 1 / a.norm(), gamma = a.norm() / area, beta = -a.dot(b) * alpha / area;

  // How the reparametrization acts on derivatives: T[1] on (u, v), T[2] on (uu, uv, vv), T[3] on (uuu, uuv, uvv, vvv).
  using Row = Eigen::Matrix<double, 1, kThirdOrderCount>;
  const auto unit = [](int d) -> Row { return Row::Unit(d); };
  const Row f1 = alpha * unit(0), f2 = beta * unit(0) + gamma * unit(1);
  const Row* first[2] = {&f1, &f2};
  Row second_partial[2][2], third_partial[2][2][2];
  const double direction[2][2] = {{alpha, 0}, {beta, gamma}};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      second_partial[i][j].setZero();
      for (int k = 0; k < 2; ++k) third_partial[i][j][k].setZero();
      for (int u = 0; u < 2; ++u) {
        for (int v = 0; v < 2; ++v) {
          second_partial[i][j] += direction[i][u] * direction[j][v] * unit(2 + u + v);
          for (int k = 0; k < 2 && with_third; ++k) {
            for (int w = 0; w < 2; ++w) {
              third_partial[i][j][k] += direction[i][u] * direction[j][v] * direction[k][w] * unit(5 + u + v + w);
            }
          }
        }
      }
    }
  }

  Vector3 e[2];
  for (int m = 0; m < 2; ++m) e[m] = (*first[m] * jet).transpose();
  double christoffel[2][2][2], form[2][2];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const Vector3 y = (second_partial[i][j] * jet).transpose();
      form[i][j] = n.dot(y);
      for (int m = 0; m < 2; ++m) christoffel[m][i][j] = e[m].dot(y);
    }
  }
  Row hessian[2][2];
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      hessian[i][j] = second_partial[i][j] - christoffel[0][i][j] * f1 - christoffel[1][i][j] * f2;
    }
  }
  const auto derivative = [&](int k, int i, int j) {
    const Vector3 y = (third_partial[i][j][k] * jet).transpose();
    Row row = third_partial[i][j][k];
    for (int m = 0; m < 2; ++m) {
      double slope = e[m].dot(y) + form[i][j] * form[m][k];
      for (int l = 0; l < 2; ++l) slope -= christoffel[l][i][j] * christoffel[m][l][k];
      row -= slope * *first[m] + christoffel[m][i][j] * second_partial[m][k] + christoffel[m][k][i] * hessian[m][j] +
             christoffel[m][k][j] * hessian[i][m];
    }
    return row;
  };
  constexpr double kTwice = std::numbers::sqrt2;  // accounts for the equal entries 12 and 21
  second << hessian[0][0], kTwice * hessian[0][1], hessian[1][1];
  if (!with_third) return;
  third << derivative(0, 0, 0), kTwice * derivative(0, 0, 1), derivative(0, 1, 1), derivative(1, 0, 0),
      kTwice * derivative(1, 0, 1), derivative(1, 1, 1);
}

}  // namespace umbilic
