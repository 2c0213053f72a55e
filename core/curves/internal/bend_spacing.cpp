// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/bend_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/geometry/infinity.h"

namespace mes {
namespace {

// Enough parts for a cubic piece, which has at most two bends.
constexpr std::size_t kParts = 6;
// Share of the mean length of the pieces of a curve; shorter pieces have no direction of their own.
constexpr double kNegligible = 0.02;

double angle_of_bend(Vec2 a, Vec2 b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

double spacing_of(double share, double length, double turn) {
  return turn > 0.0 ? share * length / turn : kInfinity;
}

/// Adds nodes to a stretch, piece after piece.
class BendReader {
 public:
  BendReader(double share, double least, StretchSpacing& out) : share_(share), least_(least), out_(out) {}

  void add(const Piece& piece, double length) {
    within_ = 0.0;
    if (length > least_) {
      const double part = piece.kind == PieceKind::line ? length : length / static_cast<double>(kParts);
      if (out_.at.empty()) {
        first_direction_ = piece.first_direction();
        first_length_ = part;
      }
      join(piece.first_direction(), part);
      if (piece.kind == PieceKind::line)
        add_node(length, kInfinity);
      else
        add_parts(piece, length);
      last_direction_ = piece.last_direction();
    }
    passed_ += length;
  }

  /// Extends the outermost values to the ends of the stretch. A closed curve without corners continues at its
  /// beginning, so both its ends get the value between the last node and the first, including the angle between them.
  void finish(bool goes_on) {
    const double all = out_.length;
    if (out_.at.empty()) {
      out_.at = {0.0, all};
      out_.spacing = {kInfinity, kInfinity};
      return;
    }
    double& first = out_.spacing.front();
    double& last = out_.spacing.back();
    double begin = first;
    double end = last;
    if (goes_on) {
      const double bend =
          spacing_of(share_, 0.5 * (last_length_ + first_length_), angle_of_bend(last_direction_, first_direction_));
      first = std::min(first, bend);
      last = std::min(last, bend);
      const double before = all - out_.at.back();
      const double after = out_.at.front();
      const bool is_finite = std::isfinite(first) && std::isfinite(last) && before + after > 0.0;
      begin = end = is_finite ? last + before / (before + after) * (first - last) : std::min(first, last);
    }
    out_.at.insert(out_.at.begin(), 0.0);
    out_.spacing.insert(out_.spacing.begin(), begin);
    out_.at.push_back(all);
    out_.spacing.push_back(end);
  }

 private:
  void join(Vec2 direction, double length) {
    pending_ = kInfinity;
    if (!out_.at.empty()) {
      pending_ = spacing_of(share_, 0.5 * (last_length_ + length), angle_of_bend(last_direction_, direction));
      out_.spacing.back() = std::min(out_.spacing.back(), pending_);
    }
  }

  void add_node(double length, double spacing) {
    out_.at.push_back(passed_ + within_ + 0.5 * length);
    out_.spacing.push_back(std::min(spacing, std::exchange(pending_, kInfinity)));
    last_length_ = length;
    within_ += length;
  }

  void add_parts(const Piece& piece, double length) {
    std::array<Vec2, kParts + 1> directions{};
    std::array<double, kParts> chords{};
    double sum = 0.0;
    Vec2 from = piece.from();
    for (std::size_t i = 0; i <= kParts; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(kParts);
      directions[i] = i == 0 ? piece.first_direction() : i == kParts ? piece.last_direction() : piece.derivative(t);
      if (i == 0) continue;
      const Vec2 to = piece.at(t);
      sum += chords[i - 1] = distance(from, to);
      from = to;
    }
    if (sum > 0.0)
      for (std::size_t i = 0; i < kParts; ++i)
        if (const double part = length * (chords[i] / sum); part > 0.0)
          add_node(part, spacing_of(share_, part, angle_of_bend(directions[i], directions[i + 1])));
  }

  double share_;
  double least_;
  StretchSpacing& out_;
  double passed_ = 0.0;
  double within_ = 0.0;  // within the current piece
  double pending_ = kInfinity;
  double last_length_ = 0.0;
  Vec2 last_direction_{};
  double first_length_ = 0.0;
  Vec2 first_direction_{};
};

}  // namespace

std::vector<std::vector<StretchSpacing>> spacings_by_bends(std::span<const MeasuredCurve> curves, double share) {
  std::vector<std::vector<StretchSpacing>> out(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const MeasuredCurve& curve = curves[c];
    if (curve.pieces.empty()) continue;
    const double least = kNegligible * curve.length() / static_cast<double>(curve.pieces.size());
    for (const Stretch& stretch : curve.stretches) {
      StretchSpacing& here = out[c].emplace_back(StretchSpacing{stretch.length, {}, {}});
      BendReader reader(share, least, here);
      for (std::size_t i = stretch.first; i < stretch.first + stretch.count; ++i)
        reader.add(curve.pieces[i], curve.lengths[i].total());
      reader.finish(curve.is_closed && !curve.has_corner_at_start);
    }
  }
  return out;
}

}  // namespace mes
