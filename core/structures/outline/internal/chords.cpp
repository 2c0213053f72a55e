// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/internal/chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/curves/joined_ends.h"

namespace mes {
namespace {

/// Chords turn by at most this from end to end, and joins that turn by less are smooth.
constexpr double kSmoothTurn = 1.0 / 16.0;

/// The centre of the circle of an arc, or nothing for one of an ellipse.
std::optional<Vec2> center_of_circle(const Piece& piece) {
  if (piece.kind != PieceKind::arc) return std::nullopt;
  const EllipticArc& arc = piece.arc;
  const double size = dot(arc.u, arc.u);
  const double error = std::max(std::abs(dot(arc.u, arc.v)), std::abs(size - dot(arc.v, arc.v)));
  return error <= 0x1p-40 * size ? std::optional(arc.center) : std::nullopt;
}

/// The centre of the circle through three points, or nothing if they nearly lie on a line.
std::optional<Vec2> center_through(Vec2 from, Vec2 middle, Vec2 to) {
  const Vec2 a = from - middle;
  const Vec2 b = to - middle;
  const double area = cross(a, b);
  constexpr double kFlat = 1e-6;
  if (!(std::abs(area) > kFlat * dot(b - a, b - a))) return std::nullopt;
  return middle + (0.5 / area) * Vec2{dot(a, a) * b.y - dot(b, b) * a.y, dot(b, b) * a.x - dot(a, a) * b.x};
}

/// The share at which part number `part` of an arc of a circle is divided, near 1/2. Chords of equal length all touch one
/// smaller circle, and exact predicates are slow there.
double share_of_first(std::uint32_t part, std::uint32_t parts) {
  std::uint32_t mixed = (part + parts) * 2654435761U;  // 2^32 over the golden ratio
  mixed ^= mixed >> 15U;
  return 0.5 + 0x1p-6 * (static_cast<double>(mixed % 1024U) / 1024.0 - 0.5);
}

/// Adds the chords of a curved piece, which is part number `part` when the whole piece has `parts` equal ones.
void add_chords(const Piece& piece, double tolerance, std::uint32_t part, std::uint32_t parts,
                std::vector<OutlineChord>& out) {
  std::optional<Vec2> center = center_of_circle(piece);
  const bool is_arc = center.has_value();
  const double share = is_arc ? share_of_first(part, parts) : 0.5;
  if (!is_arc) center = center_through(piece.from(), piece.at(0.5), piece.to());
  const auto is_near = [&](double t) {
    constexpr double kArc = 1.0 / 64.0;  // arcs follow curves better than chords do
    const double from_chord = distance_from_chord(piece.at(t), piece.from(), piece.to());
    const double from_arc =
        center ? std::abs(distance(piece.at(t), *center) - distance(piece.from(), *center)) : from_chord;
    return from_chord <= tolerance && from_arc <= kArc * tolerance;
  };
  const bool is_straight = std::ranges::all_of(std::array{0.25, 0.5, 0.75}, is_near);
  constexpr std::uint32_t kMostParts = 4096;
  if (parts == kMostParts || (is_straight && go_on(piece.first_direction(), piece.last_direction()))) {
    out.push_back({piece.to(), center, is_arc});
    return;
  }
  add_chords(piece.part(0.0, share), tolerance, 2 * part, 2 * parts, out);
  add_chords(piece.part(share, 1.0), tolerance, 2 * part + 1, 2 * parts, out);
}

/// An arc has many descriptions, and turning it round rounds its angles. This one depends on its ends alone where they
/// lie on it: its first end has the angle 0 on a circle.
void describe_by_ends(Piece& piece) {
  EllipticArc& arc = piece.arc;
  if (center_of_circle(piece)) {
    constexpr double kRounding = 0x1p-40;
    if (cross(arc.u, arc.v) < 0.0) arc.sweep = -arc.sweep;
    const double radius = length(arc.u);
    arc.u = piece.from() - arc.center;
    if (const double own = length(arc.u); std::abs(own - radius) > kRounding * radius) arc.u = (radius / own) * arc.u;
    arc.v = perpendicular(arc.u);
  }
  if (!is_finite(arc.u) || cross(arc.u, arc.v) == 0.0) return;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  arc.start = angle_on(arc, piece.from());
  const double sweep = angle_on(arc, piece.to()) - arc.start;
  arc.sweep = sweep + kTurn * std::round((arc.sweep - sweep) / kTurn);
}

/// Whether the piece begins with its lexicographically larger end, or goes around clockwise.
bool is_backwards(const Piece& piece) {
  if (piece.from() != piece.to()) return lexicographically_less(piece.to(), piece.from());
  return piece.kind == PieceKind::arc && (cross(piece.arc.u, piece.arc.v) < 0.0) != (piece.arc.sweep < 0.0);
}

}  // namespace

double angle_on(const EllipticArc& arc, Vec2 p) {
  const double area = cross(arc.u, arc.v);
  return std::atan2(cross(arc.u, p - arc.center) / area, cross(p - arc.center, arc.v) / area);
}

bool go_on(Vec2 before, Vec2 after) {
  return dot(before, after) > 0.0 && std::abs(cross(before, after)) <= kSmoothTurn * dot(before, after);
}

double distance_from_chord(Vec2 p, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double size = length(along);
  return size > 0.0 ? std::abs(cross(along, p - from)) / size : distance(p, from);
}

void add_chords_of(const Piece& piece, double tolerance, std::vector<OutlineChord>& out) {
  if (piece.kind == PieceKind::line) {
    out.push_back({piece.to()});
    return;
  }
  const bool is_turned = is_backwards(piece);
  Piece forwards = is_turned ? reversed(piece) : piece;
  if (piece.kind == PieceKind::arc) describe_by_ends(forwards);
  if (!is_turned) return add_chords(forwards, tolerance, 0, 1, out);
  std::vector<OutlineChord> chords;
  add_chords(forwards, tolerance, 0, 1, chords);
  for (std::size_t i = chords.size(); i > 0; --i) {
    OutlineChord chord = chords[i - 1];
    chord.to = i > 1 ? chords[i - 2].to : forwards.from();
    out.push_back(chord);
  }
}

}  // namespace mes
