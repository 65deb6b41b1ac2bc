// SPDX-License-Identifier: MIT
/// \file
/// Vectors of three numbers of any arithmetic type, for inner loops in which compilers do not vectorize Eigen's
/// fixed-size vectors of lanes.
#pragma once

#include "base/kernel_namespace.h"

namespace umbilic::UMBILIC_KERNELS {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  Vec3& operator+=(const Vec3& o) {
    x += o.x;
    y += o.y;
    z += o.z;
    return *this;
  }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator*(const Vec3& a, const T& s) { return {a.x * s, a.y * s, a.z * s}; }
};

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace umbilic::UMBILIC_KERNELS
