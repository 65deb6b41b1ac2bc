// SPDX-License-Identifier: MIT
/// \file
/// Validates a cage, in the order in which a user can correct what is found.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cage/cage.h"
#include "cage/component_size.h"
#include "cage/count.h"
#include "cage/edges.h"
#include "cage/outward.h"

namespace umbilic {

namespace {

/// Names elements of a cage in error messages.
class Naming {
 public:
  explicit Naming(const CageSource& source) : source_(source) {}

  int vertex(int v) const { return v + source_.first_index; }

  Error at_face(int face, const std::string& what) const {
    return Error{fmt::format("{}face {} {}", line(source_.face_lines, face), face + 1, what)};
  }
  Error at_vertex(int v, const std::string& what) const {
    return Error{fmt::format("{}vertex {} {}", line(source_.vertex_lines, v), vertex(v), what)};
  }
  Error at_edge(const EdgeUse& use, const std::string& what) const {
    return Error{fmt::format("{}edge between vertices {} and {} {}", line(source_.face_lines, use.face),
                             vertex(use.low), vertex(use.high), what)};
  }

 private:
  static std::string line(const std::vector<int>& lines, int element) {
    const auto index = static_cast<std::size_t>(element);
    return index < lines.size() ? fmt::format("line {}: ", lines[index]) : std::string();
  }

  const CageSource& source_;
};

std::optional<Error> check_vertices(const Cage& cage, const Naming& naming) {
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    if (!cage.vertices.row(v).allFinite()) return naming.at_vertex(v, "is not finite");
  }
  return std::nullopt;
}

std::optional<Error> check_faces(const Cage& cage, const Naming& naming) {
  if (cage.faces.empty()) return Error{"the cage has no faces"};
  const auto vertex_count = static_cast<int>(cage.vertices.rows());
  std::vector<int> last_face(vertex_count, -1);
  for (int f = 0; f < static_cast<int>(cage.faces.size()); ++f) {
    const std::vector<int>& face = cage.faces[f];
    for (const int v : face) {
      if (v < 0 || v >= vertex_count) {
        return naming.at_face(
            f, fmt::format("names vertex {}, but there are {} vertices", naming.vertex(v), vertex_count));
      }
      if (std::exchange(last_face[v], f) == f) {
        return naming.at_face(f, fmt::format("names vertex {} twice", naming.vertex(v)));
      }
    }
    if (face.size() < 3) {
      return naming.at_face(f, fmt::format("has {} {}", face.size(), face.size() == 1 ? "vertex" : "vertices"));
    }
  }
  return std::nullopt;
}

/// Two vertices of open edges at the same place: a program has probably written the vertices of a seam twice. Empty
/// where there are none.
std::optional<std::string> coincident_pair(const Cage& cage, const std::vector<EdgeUse>& open, const Naming& naming) {
  std::vector<int> rim;
  for (const EdgeUse& use : open) rim.insert(rim.end(), {use.low, use.high});
  std::sort(rim.begin(), rim.end());
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  const auto position = [&](int v) {
    return std::array{cage.vertices(v, 0), cage.vertices(v, 1), cage.vertices(v, 2)};
  };
  std::stable_sort(rim.begin(), rim.end(), [&](int a, int b) { return position(a) < position(b); });
  const auto twin =
      std::adjacent_find(rim.begin(), rim.end(), [&](int a, int b) { return position(a) == position(b); });
  if (twin == rim.end()) return std::nullopt;
  return fmt::format("vertices {} and {} coincide, so merging duplicate vertices may close", naming.vertex(twin[0]),
                     naming.vertex(twin[1]));
}

std::optional<Error> check_edges(const std::vector<EdgeUse>& uses, const Naming& naming) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && same_edge(uses[i], uses[end])) ++end;
    if (end - i > 2) return naming.at_edge(uses[i + 2], fmt::format("belongs to {} faces: not a manifold", end - i));
    i = end;
  }
  return std::nullopt;
}

std::optional<Error> check_fans(const Cage& cage, const std::vector<EdgeUse>& uses, const Naming& naming) {
  const std::vector<int> fans = fan_counts(cage, uses);
  const auto pinched = std::find_if(fans.begin(), fans.end(), [](int count) { return count > 1; });
  if (pinched == fans.end()) return std::nullopt;
  return naming.at_vertex(static_cast<int>(pinched - fans.begin()),
                          fmt::format("joins {} separate fans of faces: not a manifold", *pinched));
}

/// Returns how many.
int drop_unused_vertices(Cage& cage) {
  std::vector<int> renumbered(cage.vertices.rows(), -1);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) renumbered[v] = 0;
  }
  int kept = 0;
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    if (renumbered[v] < 0) continue;
    cage.vertices.row(kept) = cage.vertices.row(v).eval();
    renumbered[v] = kept++;
  }
  const int dropped = static_cast<int>(cage.vertices.rows()) - kept;
  if (dropped == 0) return 0;
  cage.vertices.conservativeResize(kept, Eigen::NoChange);
  for (std::vector<int>& face : cage.faces) {
    for (int& v : face) v = renumbered[v];
  }
  return dropped;
}

std::optional<Error> check_sizes(const std::vector<ComponentSize>& sizes, const Naming& naming) {
  for (const ComponentSize& size : sizes) {
    const std::string_view of = sizes.size() > 1 ? "of the component of this face" : "of the cage";
    const auto at_fault = [&](std::string_view all, std::string_view what) {
      return naming.at_face(size.first_face, fmt::format("is part of no surface: all {} {} {}", all, of, what));
    };
    if (size.coincident) return at_fault("vertices", "coincide");
    if (size.is_line()) return at_fault("vertices", "lie on one line");
    if (size.is_without_area()) return at_fault("faces", "have zero area");
  }
  return std::nullopt;
}

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::vector<std::string> sentences(const TurnedFaces& turned, int dropped) {
  std::vector<std::string> repairs;
  if (turned.inward > 0) {
    repairs.push_back(
        fmt::format("turned {}, so that what pointed inward points outward", counted(turned.inward, "face", "faces")));
  }
  if (turned.disagreed > 0) {
    repairs.push_back(fmt::format("turned {}, so that all faces agree on one side as the outside",
                                  counted(turned.disagreed, "face", "faces")));
  }
  if (dropped > 0) {
    repairs.push_back(fmt::format("dropped {} that no face uses", counted(dropped, "vertex", "vertices")));
  }
  return repairs;
}

}  // namespace

Result<CageReport> validate(Cage& cage, const CageSource& source) {
  const Naming naming(source);
  if (auto error = check_vertices(cage, naming)) return *error;
  if (auto error = check_faces(cage, naming)) return *error;
  const std::vector<EdgeUse> uses = edge_uses(cage);
  if (auto error = check_edges(uses, naming)) return *error;
  const Orientation orientation = orient(cage, uses);
  if (orientation.conflict >= 0) {
    return naming.at_face(orientation.conflict,
                          "cannot be turned to match all of its neighbours: the surface is not orientable");
  }
  if (auto error = check_fans(cage, uses, naming)) return *error;
  const std::vector<ComponentSize> sizes = component_sizes(cage, orientation);
  if (auto error = check_sizes(sizes, naming)) return *error;

  const std::vector<EdgeUse> open = open_uses(uses);
  std::vector<bool> is_open(sizes.size(), false);
  for (const EdgeUse& use : open) is_open[orientation.component[use.face]] = true;
  const std::optional<std::string> pair = coincident_pair(cage, open, naming);
  const TurnedFaces turned = turn_outward(cage, orientation, sizes, is_open);
  CageReport report = count(cage);
  for (CageBoundary& boundary : report.boundaries) boundary.first_vertex = naming.vertex(boundary.first_vertex);
  if (pair) report.notes.push_back(*pair + " the surface");
  report.repairs = sentences(turned, drop_unused_vertices(cage));
  return report;
}

}  // namespace umbilic
