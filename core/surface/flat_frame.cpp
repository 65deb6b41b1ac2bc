// SPDX-License-Identifier: MIT
/// \file
/// Cross product of the limit tangents, forwards and backwards.
#include "surface/flat_frame.h"

namespace umbilic {

FlatFrame flat_frame(const Cap& cap, const Points& points) {
  const auto& weights = cap_sector(cap.valence, cap.shape).net().limit_tangents();
  FlatFrame frame{{Vector3::Zero(), Vector3::Zero()}, Vector3::Zero(), 0};
  for (int i = 0; i < weights.cols(); ++i) {
    for (int k = 0; k < 2 && cap.net[i] >= 0; ++k)
      frame.tangents[k] += weights(k, i) * points.row(cap.net[i]).transpose();
  }
  const Vector3 cross = frame.tangents[0].cross(frame.tangents[1]);
  frame.length = cross.norm();
  frame.normal = cross / frame.length;
  return frame;
}

void pull_back_frame(const Cap& cap, const FlatFrame& frame, const Vector3& normal_adjoint, Points& gradient) {
  const Vector3 cross_adjoint = (normal_adjoint - frame.normal * frame.normal.dot(normal_adjoint)) / frame.length;
  const Vector3 adjoints[2] = {frame.tangents[1].cross(cross_adjoint), cross_adjoint.cross(frame.tangents[0])};
  const auto& weights = cap_sector(cap.valence, cap.shape).net().limit_tangents();
  for (int i = 0; i < weights.cols(); ++i) {
    for (int k = 0; k < 2 && cap.net[i] >= 0; ++k) gradient.row(cap.net[i]) += weights(k, i) * adjoints[k].transpose();
  }
}

std::vector<FlatFrame> flat_frames(const PatchLayout& layout, const Points& points) {
  std::vector<FlatFrame> frames;
  flat_frames(layout, points, frames);
  return frames;
}

void flat_frames(const PatchLayout& layout, const Points& points, std::vector<FlatFrame>& frames) {
  frames.clear();
  if (layout.cap() != CapKind::kFlat) return;
  for (const Cap& cap : layout.caps()) frames.push_back(flat_frame(cap, points));
}

}  // namespace umbilic
