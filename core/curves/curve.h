// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as drawings and maps have them: pieces that are lines, Bézier curves and arcs of ellipses. They are what
// samples are taken from (core/curves/sampling.h).
//
// Coordinates are those of the plane, without a unit; x points to the right, y up. Nothing is rounded or flattened:
// control points and arcs are kept as they are given.
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

#include "core/base/vec2.h"
#include "core/curves/affine.h"

namespace mes {

/// A piece of an ellipse: center + cos(w) u + sin(w) v, with w from `start` to `start + sweep`, in radians. `u` and `v`
/// are conjugate half diameters, which need not be at right angles: so any affine image is one again.
struct EllipticArc {
  Vec2 center{}, u{}, v{};
  double start = 0.0;
  double sweep = 0.0;  ///< in [-2 pi, 2 pi]; positive turns from u to v
  friend bool operator==(const EllipticArc&, const EllipticArc&) = default;
};

/// What SVG says with radii, rotation of the x axis (in radians, counter-clockwise where y points up) and two flags.
/// Radii that are too small are made larger. Nothing where SVG wants a line: a radius of zero, or equal ends.
std::optional<EllipticArc> arc_between(Vec2 from, Vec2 to, Vec2 radii, double rotation, bool is_large,
                                       bool turns_to_v);

enum class PieceKind : std::uint8_t { line, quadratic, cubic, arc };

/// One piece of a curve, as a function of a parameter in [0, 1].
struct Piece {
  PieceKind kind = PieceKind::line;
  std::array<Vec2, 4> points{};  ///< the ends first and last of two, three or four; of an arc the two ends
  EllipticArc arc{};             ///< of an arc

  Vec2 from() const { return points[0]; }
  Vec2 to() const;
  /// At 0 and 1 exactly the ends.
  Vec2 at(double t) const;
  Vec2 derivative(double t) const;
  /// Directions at the ends, of any length; zero for a piece that is a single point. Where control points coincide
  /// with an end, that of the next one.
  Vec2 first_direction() const;
  Vec2 last_direction() const;
  /// The part between two parameters, 0 <= begin < end <= 1; at 0 and 1 it has exactly the ends.
  Piece part(double begin, double end) const;
};

/// Pieces that follow each other. A closed curve ends exactly where it starts. 17 bytes for each line; an arc has 64
/// more.
class PlaneCurve {
 public:
  explicit PlaneCurve(Vec2 start) : points_{start} {}
  /// A curve put together again from what `points`, `kinds` and `arcs` gave. Nothing if their numbers do not fit, or
  /// the curve is closed and does not end where it starts.
  static std::optional<PlaneCurve> of_parts(std::vector<Vec2> points, std::vector<PieceKind> kinds,
                                            std::vector<EllipticArc> arcs, bool is_closed);

  void line_to(Vec2 to);
  /// A line to each.
  void lines_to(std::span<const Vec2> to);
  void quadratic_to(Vec2 control, Vec2 to);
  void cubic_to(Vec2 first, Vec2 second, Vec2 to);
  /// The end is given too, for it should not depend on rounding.
  void arc_to(const EllipticArc& arc, Vec2 to);
  /// Adds a line to the start unless the curve ends there.
  void close();
  void transform(const Affine& map);

  bool is_closed() const { return is_closed_; }
  bool is_polyline() const { return is_polyline_; }
  Vec2 start() const { return points_.front(); }
  Vec2 end() const { return points_.back(); }
  std::size_t piece_count() const { return kinds_.size(); }
  /// The start, then control points and end of each piece.
  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<PieceKind>& kinds() const { return kinds_; }
  /// Of the pieces that are arcs, in order.
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

  std::string name{};  ///< as the file has it; may be empty
  friend bool operator==(const PlaneCurve&, const PlaneCurve&) = default;

 private:
  static constexpr std::size_t points_added(PieceKind kind) {
    return kind == PieceKind::cubic ? 3 : kind == PieceKind::quadratic ? 2 : 1;
  }

  std::vector<Vec2> points_;  // the start, then control points and end of each piece
  std::vector<PieceKind> kinds_;
  std::vector<EllipticArc> arcs_;  // of the pieces that are arcs, in order
  bool is_closed_ = false;
  bool is_polyline_ = true;
};

/// What a drawing or a map consists of.
struct CurveSet {
  std::vector<PlaneCurve> curves{};
  std::vector<Vec2> points{};  ///< that lie on no curve
  /// Coordinates were rounded to multiples of about this, as a file with so many decimals has them; 0: to doubles. Ends
  /// of curves, and curves, that are no farther apart are meant to touch.
  double resolution = 0.0;
  bool is_empty() const { return curves.empty() && points.empty(); }
  friend bool operator==(const CurveSet&, const CurveSet&) = default;
};

}  // namespace mes
