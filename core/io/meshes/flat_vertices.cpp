// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/meshes/flat_vertices.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace mes {
namespace {

constexpr std::string_view kLeftOut = "heights are left out";

struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};
double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vec3 a) {
  return std::hypot(a.x, a.y, a.z);
}
Vec3 unit(Vec3 a) {
  return 1.0 / length(a) * a;
}

struct Extent {
  double low = 0.0;
  double high = 0.0;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double width() const { return high - low; }
};

class Vertices {
 public:
  Vertices(std::span<const Vec2> positions, std::span<const double> heights)
      : positions_(positions), heights_(heights) {}
  std::size_t count() const { return positions_.size(); }
  Vec3 at(std::size_t i) const { return {positions_[i].x, positions_[i].y, heights_[i]}; }

  /// The vertex with the largest value.
  template <class Value>
  Vec3 farthest(Value value) const {
    Vec3 out = at(0);
    double largest = -1.0;
    for (std::size_t i = 0; i < count(); ++i) {
      const double here = value(at(i));
      if (!(here > largest)) continue;
      largest = here;
      out = at(i);
    }
    return out;
  }

 private:
  std::span<const Vec2> positions_;
  std::span<const double> heights_;
};

/// The normal of the plane through three distant vertices, if all others are near this plane. For vertices on a line,
/// the normal of the plane through the line that is nearest to level.
std::optional<Vec3> common_normal(const Vertices& vertices, double tolerance) {
  const Vec3 first = vertices.at(0);
  const Vec3 second = vertices.farthest([&](Vec3 p) { return length(p - first); });
  const Vec3 along = unit(second - first);
  const auto off_line = [&](Vec3 p) { return cross(along, p - first); };
  const Vec3 third = vertices.farthest([&](Vec3 p) { return length(off_line(p)); });
  if (length(off_line(third)) <= tolerance) {
    const Vec3 level = cross({0.0, 0.0, 1.0}, along);
    return length(level) > 0.0 ? unit(cross(along, level)) : Vec3{0.0, -1.0, 0.0};
  }
  const Vec3 normal = unit(off_line(third));
  const Vec3 worst = vertices.farthest([&](Vec3 p) { return std::abs(dot(normal, p - first)); });
  if (std::abs(dot(normal, worst - first)) > tolerance) return std::nullopt;
  return normal;
}

struct Frame {
  Vec3 right;
  Vec3 up;
};

Frame frame_of(Vec3 normal) {
  constexpr double kSteep = 0.7071067811865476;
  if (std::abs(normal.z) >= kSteep) {
    const Vec3 toward = normal.z < 0.0 ? -1.0 * normal : normal;
    const Vec3 right = unit(Vec3{1.0, 0.0, 0.0} - toward.x * toward);
    return {right, cross(toward, right)};
  }
  // Choose the side from which x points to the right, or y where x points along the normal.
  constexpr double kAway = 1e-9;
  Vec3 right = unit({-normal.y, normal.x, 0.0});
  if (right.x < -kAway || (right.x <= kAway && right.y < 0.0)) right = -1.0 * right;
  Vec3 up = cross(normal, right);
  if (up.z < 0.0) up = -1.0 * up;
  return {right, up};
}

}  // namespace

std::string bring_into_plane(std::span<Vec2> positions, std::span<const double> heights, double rounding) {
  if (positions.size() != heights.size() || heights.empty()) return {};
  const Vec2 p = positions.front();
  Extent x{p.x, p.x};
  Extent y{p.y, p.y};
  Extent z{heights.front(), heights.front()};
  if (!std::ranges::all_of(heights, [](double height) { return std::isfinite(height); }))
    return std::string(kLeftOut);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    x.add(positions[i].x);
    y.add(positions[i].y);
    z.add(heights[i]);
  }
  if (z.width() == 0.0) return {};
  // The first is the resolution of single precision; the second, relative to the extent, is too small to be seen.
  constexpr double kSingle = 0x1p-24;
  constexpr double kUnseen = 1e-6;
  constexpr double kNormalToo = 8.0;  // the plane itself goes through rounded vertices
  double largest = 0.0;
  for (const Extent& extent : {x, y, z}) largest = std::max({largest, std::abs(extent.low), std::abs(extent.high)});
  const double size = std::max({x.width(), y.width(), z.width()});
  const double tolerance = std::max(kUnseen * size, kNormalToo * std::max(rounding, kSingle * largest));
  if (!std::isfinite(size) || z.width() <= tolerance) return std::string(kLeftOut);
  if (y.width() <= tolerance || x.width() <= tolerance) {
    const bool is_in_xz = y.width() <= tolerance;
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] = {is_in_xz ? positions[i].x : positions[i].y, heights[i]};
    return fmt::format("all vertices lie in one plane, of which {} and z are read", is_in_xz ? 'x' : 'y');
  }
  const Vertices vertices(positions, heights);
  const auto normal = common_normal(vertices, tolerance);
  if (!normal) return std::string(kLeftOut);
  const Frame frame = frame_of(*normal);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 at = vertices.at(i);
    positions[i] = {dot(frame.right, at), dot(frame.up, at)};
  }
  const Vec3 toward = cross(frame.right, frame.up);
  return fmt::format("all vertices lie in one plane, which is read as seen from ({:.3g}, {:.3g}, {:.3g})",
                     toward.x + 0.0, toward.y + 0.0, toward.z + 0.0);
}

}  // namespace mes
