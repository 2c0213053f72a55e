// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/interpolation/cubic_interpolation.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace mes {
namespace {

/// Row i: below x[i - 1] + diagonal x[i] + above x[i + 1] = right. The diagonal exceeds the sum of the other two.
struct Row {
  double below = 0.0;
  double diagonal = 1.0;
  double above = 0.0;
  Vec2 right{};
};

/// Elimination without pivoting, which a dominant diagonal does not need.
std::vector<Vec2> solved(std::vector<Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].below / rows[i - 1].diagonal;
    rows[i].diagonal -= factor * rows[i - 1].above;
    rows[i].right = rows[i].right - factor * rows[i - 1].right;
  }
  std::vector<Vec2> out(rows.size());
  for (std::size_t i = rows.size(); i > 0; --i) {
    const Row& row = rows[i - 1];
    const Vec2 later = i < rows.size() ? row.above * out[i] : Vec2{};
    out[i - 1] = (1.0 / row.diagonal) * (row.right - later);
  }
  return out;
}

/// The equation for a continuous second derivative at point `p`, between pieces of these lengths.
Row smooth_at(Vec2 before, Vec2 p, Vec2 after, double first, double second) {
  return {second, 2.0 * (first + second), first,
          3.0 * (second / first * (p - before) + first / second * (after - p))};
}

/// Derivatives at the points of an open curve of two points or more.
std::vector<Vec2> open_derivatives(std::span<const Vec2> at, std::span<const double> lengths,
                                   const EndTangents& tangents) {
  std::vector<Row> rows(at.size());
  const auto end_row = [](const std::optional<Vec2>& tangent, Vec2 chord, double chord_length, bool is_first) {
    const bool has_direction = tangent && length(*tangent) > 0.0;
    if (has_direction) return Row{.right = (1.0 / length(*tangent)) * *tangent};
    return Row{is_first ? 0.0 : 1.0, 2.0, is_first ? 1.0 : 0.0, (3.0 / chord_length) * chord};
  };
  rows.front() = end_row(tangents.at_start, at[1] - at[0], lengths.front(), true);
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
    rows[i] = smooth_at(at[i - 1], at[i], at[i + 1], lengths[i - 1], lengths[i]);
  rows.back() = end_row(tangents.at_end, at[at.size() - 1] - at[at.size() - 2], lengths.back(), false);
  return solved(std::move(rows));
}

/// Derivatives at the points of a closed curve of three points or more. The matrix has two corner entries beside the
/// three diagonals; the Sherman-Morrison formula removes them.
std::vector<Vec2> closed_derivatives(std::span<const Vec2> at, std::span<const double> lengths) {
  const std::size_t count = at.size();
  std::vector<Row> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    rows[i] = smooth_at(at[before], at[i], at[(i + 1) % count], lengths[before], lengths[i]);
  }
  const double top = rows.front().below;
  const double bottom = rows.back().above;
  const double shift = -rows.front().diagonal;
  rows.front().diagonal -= shift;
  rows.back().diagonal -= top * bottom / shift;
  std::vector<Row> correction = rows;
  for (Row& row : correction) row.right = {};
  correction.front().right = {shift, 0.0};
  correction.back().right = {bottom, 0.0};
  std::vector<Vec2> out = solved(std::move(rows));
  const std::vector<Vec2> z = solved(std::move(correction));
  const double share = top / shift;
  const Vec2 factor = (1.0 / (1.0 + z.front().x + share * z.back().x)) * (out.front() + share * out.back());
  for (std::size_t i = 0; i < count; ++i) out[i] = out[i] - z[i].x * factor;
  return out;
}

}  // namespace

std::optional<PlaneCurve> cubic_through(std::span<const Vec2> points, bool is_closed, const EndTangents& tangents) {
  std::vector<Vec2> at;
  for (const Vec2 p : points) {
    if (!is_finite(p)) return std::nullopt;
    if (at.empty() || at.back() != p) at.push_back(p);
  }
  if (is_closed && at.size() > 1 && at.front() == at.back()) at.pop_back();
  if (at.empty()) return std::nullopt;
  PlaneCurve out(at.front());
  const std::size_t count = at.size();
  constexpr std::size_t kLeastClosed = 3;
  is_closed = is_closed && count >= kLeastClosed;
  if (count == 1) return out;
  std::vector<double> lengths(is_closed ? count : count - 1);
  for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = distance(at[i], at[(i + 1) % count]);
  const std::vector<Vec2> derivatives =
      is_closed ? closed_derivatives(at, lengths) : open_derivatives(at, lengths, tangents);
  if (!std::ranges::all_of(derivatives, [](Vec2 v) { return is_finite(v); })) return std::nullopt;
  const bool is_line = count == 2 && !tangents.at_start && !tangents.at_end;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::size_t next = (i + 1) % count;
    const double third = lengths[i] / 3.0;
    if (is_line)
      out.line_to(at[next]);
    else
      out.cubic_to(at[i] + third * derivatives[i], at[next] - third * derivatives[next], at[next]);
  }
  if (is_closed) out.close();
  return out;
}

}  // namespace mes
