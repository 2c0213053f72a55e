// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as in drawings and maps: pieces that are lines, Bézier curves and arcs of ellipses. Samples are taken from
// these curves (core/curves/sampling.h).
//
// Coordinates are those of the plane, without a unit; x points right, y up. Nothing is rounded or flattened: control
// points and arcs are stored as given.
//
// Smallest use:
//     PlaneCurve curve({0.0, 0.0});
//     curve.line_to({1.0, 0.0});
//     curve.cubic_to({1.5, 0.0}, {1.5, 1.0}, {1.0, 1.0});
//     curve.close();
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/curves/affine.h"

namespace mes {

/// An arc of an ellipse: center + cos(w) u + sin(w) v, with w from `start` to `start + sweep`, in radians. `u` and `v`
/// are conjugate half diameters and need not be at right angles, so that every affine image is again such an arc.
struct EllipticArc {
  Vec2 center{}, u{}, v{};
  double start = 0.0;
  double sweep = 0.0;  ///< in [-2 pi, 2 pi]; positive turns from u to v
  friend bool operator==(const EllipticArc&, const EllipticArc&) = default;
};

/// The arc that SVG defines by radii, rotation of the x axis (radians, counter-clockwise if y points up) and two flags.
/// Radii that are too small are enlarged. Returns nothing where SVG requires a line: for a zero radius or equal ends.
std::optional<EllipticArc> arc_between(Vec2 from, Vec2 to, Vec2 radii, double rotation, bool is_large,
                                       bool turns_to_v);

enum class PieceKind : std::uint8_t { line, quadratic, cubic, arc };

/// One piece of a curve, as a function of a parameter in [0, 1].
struct Piece {
  PieceKind kind = PieceKind::line;
  std::array<Vec2, 4> points{};  ///< two, three or four points with the ends first and last; for an arc, its two ends
  EllipticArc arc{};             ///< only for arcs

  Vec2 from() const { return points[0]; }
  Vec2 to() const;
  /// The point at a parameter; exactly the ends at 0 and 1.
  Vec2 at(double t) const;
  Vec2 derivative(double t) const;
  /// Directions at the ends, of any length; zero for a piece that is a single point. If control points coincide with an
  /// end, the next different one determines the direction.
  Vec2 first_direction() const;
  Vec2 last_direction() const;
  /// The part between two parameters, 0 <= begin < end <= 1; at 0 and 1 its ends are exactly those of the piece.
  Piece part(double begin, double end) const;
};

/// A chain of pieces. A closed curve ends exactly where it starts. 17 bytes for each line; an arc takes 64 more.
class PlaneCurve {
 public:
  explicit PlaneCurve(Vec2 start) : points_{start} {}
  /// Rebuilds a curve from the results of `points`, `kinds` and `arcs`. Returns nothing if the counts do not match, or
  /// if the curve is closed and does not end where it starts.
  static std::optional<PlaneCurve> of_parts(std::vector<Vec2> points, std::vector<PieceKind> kinds,
                                            std::vector<EllipticArc> arcs, bool is_closed);

  void line_to(Vec2 to);
  /// Adds a line to each point.
  void lines_to(std::span<const Vec2> to);
  void quadratic_to(Vec2 control, Vec2 to);
  void cubic_to(Vec2 first, Vec2 second, Vec2 to);
  /// The end is passed as well, so that it does not depend on rounding. An arc that turns by 2^-16 at most, about a
  /// centre far away, becomes the parabola that leaves it by less than 2^-53 of its length.
  void arc_to(const EllipticArc& arc, Vec2 to);
  /// Adds a line to the start unless the curve ends there.
  void close();
  void transform(const Affine& map);

  bool is_closed() const { return is_closed_; }
  bool is_polyline() const { return is_polyline_; }
  Vec2 start() const { return points_.front(); }
  Vec2 end() const { return points_.back(); }
  std::size_t piece_count() const { return kinds_.size(); }
  /// The start, then the control points and the end of each piece.
  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<PieceKind>& kinds() const { return kinds_; }
  /// The arcs, in order, of the pieces that are arcs.
  const std::vector<EllipticArc>& arcs() const { return arcs_; }
  void add(const Piece& piece);

  /// Calls `use(const Piece&)` for each piece in order.
  template <class Use>
  void for_each_piece(Use use) const {
    std::size_t point = 0;
    std::size_t arc = 0;
    for (const PieceKind kind : kinds_) {
      Piece piece{.kind = kind};
      const std::size_t added = points_added(kind);
      for (std::size_t i = 0; i <= added; ++i) piece.points[i] = points_[point + i];
      if (kind == PieceKind::arc) piece.arc = arcs_[arc++];
      point += added;
      use(piece);
    }
  }

  std::string name{};  ///< name from the file; may be empty
  friend bool operator==(const PlaneCurve&, const PlaneCurve&) = default;

 private:
  static constexpr std::size_t points_added(PieceKind kind) {
    return kind == PieceKind::cubic ? 3 : kind == PieceKind::quadratic ? 2 : 1;
  }

  std::vector<Vec2> points_;  // the start, then the control points and the end of each piece
  std::vector<PieceKind> kinds_;
  std::vector<EllipticArc> arcs_;  // for the pieces that are arcs, in order
  bool is_closed_ = false;
  bool is_polyline_ = true;
};

/// The content of a drawing or a map.
struct CurveSet {
  std::vector<PlaneCurve> curves{};
  std::vector<Vec2> points{};  ///< isolated points, on no curve
  /// Coordinates were rounded to multiples of about this, as in a file with a fixed number of decimals; 0: only rounded
  /// to doubles. Ends of curves, and curves, that are no farther apart are meant to touch.
  double resolution = 0.0;
  bool is_empty() const { return curves.empty() && points.empty(); }
  friend bool operator==(const CurveSet&, const CurveSet&) = default;
};

}  // namespace mes
