// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_shape_queue.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/curves/curve_bounds.h"
#include "core/curves/filled_area.h"

namespace mes {
namespace {

using Seen = ClippedCurves::Seen;

// Clipping that costs this much takes some twenty seconds.
constexpr std::size_t kMostClipCost = 100'000'000;

/// Filling closes open curves; a curve that misses its start only by the rounding of coordinates is closed, too.
void close_what_looks_closed(PlaneCurve& curve, const SvgContext& context) {
  if (curve.is_closed() || curve.piece_count() < 2) return;
  if (context.is_filled() && !context.is_stroked()) return curve.close();
  double around = 0.0;
  curve.for_each_piece([&](const Piece& piece) { around += distance(piece.from(), piece.to()); });
  constexpr double kRounding = 1e-4;
  if (distance(curve.start(), curve.end()) <= kRounding * around) curve.close();
}

bool lie_off(const Box2& page, std::span<const PlaneCurve> curves) {
  if (page.is_empty() || curves.empty()) return false;
  if (page.contains(curves.front().start())) return false;
  return !overlap(page, bounds_of(curves));
}

}  // namespace

Expected<void> SvgShapeQueue::add(SvgShape shape) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 22U;
  constexpr std::size_t kMostShapes = 4096;
  waiting_bytes_ += shape.geometry.data.size();
  waiting_.push_back(std::move(shape));
  if (waiting_bytes_ < kMostBytes && waiting_.size() < kMostShapes) return {};
  return finish();
}

Expected<void> SvgShapeQueue::finish() {
  constexpr std::size_t kBytesEach = std::size_t{1} << 16U;
  constexpr std::size_t kBytesOfClipping = std::size_t{1}
                                           << 12U;  // clipping takes about as long as reading this many
  std::vector<std::size_t> ends;                    // ends of runs of shapes with enough work each
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    bytes += waiting_[i].geometry.data.size() + (waiting_[i].context.clip.is_plane() ? 0 : kBytesOfClipping);
    if (bytes < kBytesEach && i + 1 < waiting_.size()) continue;
    ends.push_back(i + 1);
    bytes = 0;
  }
  run_tasks(ends.size(), [&](std::size_t run) {
    for (std::size_t i = run == 0 ? 0 : ends[run - 1]; i < ends[run]; ++i) finish(waiting_[i]);
  });
  if (clip_cost_ > kMostClipCost)
    return source_.refuse(source_.place_of(waiting_.back().node),
                          "up to here, clip paths cross themselves and the shapes too often");
  for (SvgShape& shape : waiting_) {
    remark_on(shape);
    for (PlaneCurve& curve : shape.geometry.path.curves) {
      pieces_ += curve.piece_count();
      if (pieces_ > most_pieces_)
        return source_.refuse(source_.place_of(shape.node),
                              fmt::format("the drawing has more than {} pieces of curves", most_pieces_));
      curves_.push_back(std::move(curve));
    }
  }
  if (!waiting_.empty()) {
    const SvgShape& last = waiting_.back();
    const std::string_view data = last.geometry.data;
    job_.passed(source_.bytes().data() + source_.place_of(last.node, data, data.size()));
  }
  waiting_.clear();
  waiting_bytes_ = 0;
  return {};
}

/// Finishes one shape, on any thread.
void SvgShapeQueue::finish(SvgShape& shape) {
  if (job_.control() != nullptr && job_.control()->stop_requested()) throw Cancelled{};
  shape.geometry.finish(job_.control());
  std::vector<PlaneCurve>& curves = shape.geometry.path.curves;
  for (PlaneCurve& curve : curves) {
    close_what_looks_closed(curve, shape.context);
    curve.transform(shape.context.map);
  }
  shape.is_off_page = lie_off(page_, curves);
  bool is_even_odd = shape.context.fills_even_odd;
  // Basic shapes do not overlap themselves.
  const bool may_overlap = shape.geometry.kind != SvgGeometry::Kind::other;
  if (shape.context.is_filled() && !is_even_odd && may_overlap && !curves.empty()) {
    FilledArea area = nonzero_area(std::move(curves));
    curves = std::move(area.curves);
    shape.overlaps_itself = is_even_odd = area.is_changed;
    shape.may_overlap_itself = area.is_unknown;
  }
  if (!shape.context.clip.is_plane() && !curves.empty()) {
    shape.is_unclipped = !ClipRegion::fits(curves, grid_);
    // Once it is too much, the drawing is refused, whatever becomes of the shapes that are left.
    if (!shape.is_unclipped && clip_cost_ <= kMostClipCost)
      clip_cost_ += shape.context.clip.cost_near(bounds_of(curves), kMostClipCost + 1);
    if (!shape.is_unclipped && clip_cost_ <= kMostClipCost) {
      const Ink area = is_even_odd ? Ink::even_odd_area : Ink::nonzero_area;
      auto clipped = shape.context.clip.clipped(std::move(curves), shape.context.is_filled() ? area : Ink::line);
      shape.seen = clipped.seen;
      curves = std::move(clipped.curves);
    }
  }
  for (PlaneCurve& curve : curves) curve.name = shape.node.attribute("id").value();
}

void SvgShapeQueue::remark_on(const SvgShape& shape) {
  const std::size_t place = source_.place_of(shape.node);
  const SvgGeometry& geometry = shape.geometry;
  CountedRemarks& remarks = source_.remarks;
  if (geometry.path.fault)
    remarks.add("list of coordinates is read up to a fault", "lists of coordinates are read up to a fault",
                source_.place_of(shape.node, geometry.data, *geometry.path.fault));
  if (shape.overlaps_itself)
    remarks.add("shape overlaps itself, and is read as the boundary of its area",
                "shapes overlap themselves, and are read as the boundaries of their areas", place);
  if (shape.may_overlap_itself)
    remarks.add("shape crosses itself too often for the nonzero fill rule, and is read by the even-odd rule",
                "shapes cross themselves too often for the nonzero fill rule, and are read by the even-odd rule",
                place);
  if (shape.seen == Seen::nothing)
    remarks.add("shape is left out, which its clip path hides", "shapes are left out, which clip paths hide", place);
  if (shape.seen == Seen::part) remarks.add("shape is cut by its clip path", "shapes are cut by clip paths", place);
  if (shape.is_unclipped)
    remarks.add("shape is too large or crosses itself too often for its clip path, which is not applied",
                "shapes are too large or cross themselves too often for their clip paths, which are not applied",
                place);
  if (shape.is_off_page && shape.seen != Seen::nothing)
    remarks.add("shape lies outside the page, and is read", "shapes lie outside the page, and are read", place);
  if (shape.context.has_pattern && shape.context.is_filled())
    remarks.add("pattern that fills a shape is left out", "patterns that fill shapes are left out", place);
  if (shape.context.has_marker && geometry.kind != SvgGeometry::Kind::other)
    remarks.add("shape has markers, which are left out", "shapes have markers, which are left out", place);
}

}  // namespace mes
