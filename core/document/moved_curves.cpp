// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/moved_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/curves/affine.h"
#include "core/document/document.h"

namespace mes {
namespace {

/// Part of the largest coordinate by which rounding may displace a point.
constexpr double kRounding = 1e-9;

struct Move {
  Vec2 from{};
  Vec2 to{};
};

double magnitude_of(std::span<const Move> moves) {
  double out = 0.0;
  for (const Move& move : moves)
    out = std::max({out, std::abs(move.from.x), std::abs(move.from.y), std::abs(move.to.x), std::abs(move.to.y)});
  return out;
}

bool maps_all(const Affine& map, std::span<const Move> moves) {
  const double most = kRounding * magnitude_of(moves);
  return std::ranges::all_of(moves, [&](const Move& move) {
    const Vec2 off = map.of_point(move.from) - move.to;
    return std::abs(off.x) <= most && std::abs(off.y) <= most;
  });
}

/// The affine map of three points that span the most; nothing if all lie on a line.
std::optional<Affine> spanned_map(std::span<const Move> moves) {
  const Move& first = moves.front();
  const auto reach = [&](const Move& move) { return dot(move.from - first.from, move.from - first.from); };
  const Move& second = *std::ranges::max_element(moves, {}, reach);
  const Vec2 along = second.from - first.from;
  const auto height = [&](const Move& move) { return std::abs(cross(along, move.from - first.from)); };
  const Move& third = *std::ranges::max_element(moves, {}, height);
  const Vec2 across = third.from - first.from;
  const double area = cross(along, across);
  if (std::abs(area) <= kRounding * dot(along, along)) return std::nullopt;
  const Vec2 along_to = second.to - first.to;
  const Vec2 across_to = third.to - first.to;
  // The columns of the linear part are the images of the unit vectors.
  const Vec2 x = {(along_to.x * across.y - across_to.x * along.y) / area,
                  (along_to.y * across.y - across_to.y * along.y) / area};
  const Vec2 y = {(across_to.x * along.x - along_to.x * across.x) / area,
                  (across_to.y * along.x - along_to.y * across.x) / area};
  const Affine linear{x.x, x.y, y.x, y.y, 0.0, 0.0};
  const Vec2 shift = first.to - linear.of_vector(first.from);
  return Affine::translation(shift.x, shift.y) * linear;
}

std::optional<Affine> common_map(std::span<const Move> moves) {
  if (moves.empty()) return std::nullopt;
  const Vec2 shift = moves.front().to - moves.front().from;
  const Affine translation = Affine::translation(shift.x, shift.y);
  if (maps_all(translation, moves)) return translation;
  constexpr std::size_t kLeastForMap = 4;  // any three points are mapped to any others
  if (moves.size() < kLeastForMap) return std::nullopt;
  const std::optional<Affine> map = spanned_map(moves);
  return map && maps_all(*map, moves) ? map : std::nullopt;
}

/// Whether a condition holds for all live samples of the curves. Ends at the first for which it does not.
template <class Condition>
bool holds_for_all(const Document& document, Condition condition) {
  const CurveSource& source = *document.source();
  const std::uint32_t first = document.first_id().value + source.first;
  for (std::uint32_t i = 0; i < source.count; ++i) {
    const SampleId id{first + i};
    if (document.slot_of(id) != kNoSlot && !condition(id)) return false;
  }
  return true;
}

class MovedCurves {
 public:
  MovedCurves(const Document& document, std::span<const SampleEdit> moves)
      : document_(document), source_(*document.source()) {
    moves_.reserve(moves.size());
    for (const SampleEdit& move : moves) moves_.emplace(move.id, Move{move.from, move.to});
  }

  /// Null if none has moved.
  std::shared_ptr<const CurveSet> curves() const {
    const CurveSet& before = *source_.curves;
    if (const auto map = common_map(moves_of_all())) {
      CurveSet out = before;
      for (PlaneCurve& curve : out.curves) curve.transform(*map);
      for (Vec2& point : out.points) point = map->of_point(point);
      return std::make_shared<const CurveSet>(std::move(out));
    }
    const std::vector<CurveOrder::Contour>& contours = document_.curve_order()->contours;
    if (contours.size() != before.curves.size()) return nullptr;
    std::vector<std::optional<Affine>> maps(contours.size());
    for (std::size_t i = 0; i < contours.size(); ++i) maps[i] = common_map(moves_of(contours[i]));
    if (std::ranges::none_of(maps, [](const auto& map) { return map.has_value(); }) || !are_as_taken(contours))
      return nullptr;
    CurveSet out = before;
    for (std::size_t i = 0; i < maps.size(); ++i)
      if (maps[i]) out.curves[i].transform(*maps[i]);
    return std::make_shared<const CurveSet>(std::move(out));
  }

 private:
  /// Empty unless all live samples of the curves have moved.
  std::vector<Move> moves_of_all() const {
    std::vector<Move> out;
    if (!holds_for_all(document_, [&](SampleId id) { return moves_.contains(id); })) return out;
    for (const SampleId id : document_.samples_of_source()) out.push_back(moves_.at(id));
    return out;
  }

  /// Empty unless all live samples of the contour have moved.
  std::vector<Move> moves_of(const CurveOrder::Contour& contour) const {
    std::vector<Move> out;
    for (const SampleId id : contour.samples) {
      if (document_.slot_of(id) == kNoSlot) continue;
      const auto move = moves_.find(id);
      if (move == moves_.end()) return {};
      out.push_back(move->second);
    }
    return out;
  }

  /// Whether the contours are still those of the sampled curves, in their order: each has the samples that follow
  /// those of the contour before.
  bool are_as_taken(const std::vector<CurveOrder::Contour>& contours) const {
    const std::uint32_t first = document_.first_id().value + source_.first;
    std::uint32_t end = first;
    for (const CurveOrder::Contour& contour : contours) {
      if (contour.samples.empty()) return false;
      const auto [least, greatest] = std::ranges::minmax(contour.samples);
      if (least.value < end) return false;
      end = greatest.value + 1;
    }
    return end <= first + source_.count;
  }

  const Document& document_;
  const CurveSource& source_;
  std::unordered_map<SampleId, Move> moves_;
};

}  // namespace

std::shared_ptr<const CurveSource> source_after_move(const Document& document, std::span<const SampleEdit> edits) {
  const auto is_move = [](const SampleEdit& edit) { return edit.kind == SampleEdit::Kind::move; };
  if (!document.source() || edits.empty() || !std::ranges::all_of(edits, is_move)) return nullptr;
  CurveSource out = *document.source();
  out.curves = MovedCurves(document, edits).curves();
  return out.curves ? std::make_shared<const CurveSource>(std::move(out)) : nullptr;
}

bool are_all_of_source(const Document& document, std::span<const SampleId> samples) {
  if (!document.source()) return false;
  const std::unordered_set<SampleId> ids(samples.begin(), samples.end());
  return holds_for_all(document, [&](SampleId id) { return ids.contains(id); });
}

}  // namespace mes
