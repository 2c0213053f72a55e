// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/cell_export.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/curves/clip_region.h"
#include "core/curves/curve_bounds.h"
#include "core/document/curve_source.h"
#include "core/kernel/point_predicates.h"
#include "core/structures/delaunay/voronoi_cells.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

using Ring = std::vector<Vec2>;

std::unexpected<Error> no_cells(ErrorCode code, std::string text) {
  return std::unexpected(Error{code, std::move(text), {}, 0, 0});
}

/// The convex hull, counter-clockwise. Empty if all points are on a line.
Ring hull_of(std::vector<Vec2> points) {
  std::ranges::sort(points, lexicographically_less);
  points.erase(std::ranges::unique(points).begin(), points.end());
  Ring out;
  const auto add_half = [&out](auto from, auto to) {
    const std::size_t begin = out.size();
    for (; from != to; ++from) {
      while (out.size() > begin + 1 && orientation(out[out.size() - 2], out.back(), *from) <= 0) out.pop_back();
      out.push_back(*from);
    }
    out.pop_back();
  };
  if (points.size() < 3) return {};
  add_half(points.begin(), points.end());
  add_half(points.rbegin(), points.rend());
  return out.size() < 3 ? Ring() : out;
}

PlaneCurve curve_of(const Ring& ring) {
  PlaneCurve out(ring.front());
  for (std::size_t i = 1; i < ring.size(); ++i) out.line_to(ring[i]);
  out.close();
  return out;
}

Ring ring_of(const PlaneCurve& curve) {
  Ring out{curve.start()};
  curve.for_each_piece([&out](const Piece& piece) {
    constexpr double kSidesOfTurn = 96.0;
    constexpr int kSidesOfBezier = 24;
    int sides = 1;
    if (piece.kind == PieceKind::arc)
      sides = std::max(
          1, static_cast<int>(std::ceil(std::abs(piece.arc.sweep) / (2.0 * std::numbers::pi) * kSidesOfTurn)));
    else if (piece.kind != PieceKind::line)
      sides = kSidesOfBezier;
    for (int i = 1; i < sides; ++i) out.push_back(piece.at(static_cast<double>(i) / sides));
    out.push_back(piece.to());
  });
  return out;
}

Box2 box_around(const std::vector<Vec2>& points, const Box2& curves) {
  Box2 out = curves;
  for (const Vec2 p : points) out.add(p);
  // Points that coincide have a box too.
  const double longer = std::max(out.width(), out.height());
  const double room =
      longer > 0.0 ? 0.1 * longer : std::max(1.0, 0.1 * std::max(std::abs(out.low.x), std::abs(out.low.y)));
  return {out.low - Vec2{room, room}, out.high + Vec2{room, room}};
}

/// The region that bounds the cells; the whole plane for the box.
Expected<ClipRegion> region_of(CellRegion region, const std::vector<Vec2>& points, const CurveSet* curves,
                               const Box2& box) {
  if (region == CellRegion::box) return ClipRegion();
  const double grid = clip_grid(std::max(box.width(), box.height()));
  if (region == CellRegion::hull) {
    const Ring hull = hull_of(points);
    if (hull.empty()) return no_cells(ErrorCode::cannot_compute, "all samples are on a line, so their hull is empty");
    return ClipRegion::of(std::vector{curve_of(hull)}, FillRule::nonzero, grid);
  }
  if (curves == nullptr || curves->curves.empty())
    return no_cells(ErrorCode::usage, "these samples have no outline: cells end at box or hull");
  std::vector<PlaneCurve> closed;
  std::ranges::copy_if(curves->curves, std::back_inserter(closed), &PlaneCurve::is_closed);
  if (closed.empty())
    return no_cells(ErrorCode::cannot_compute, "no curve is closed, so the outline encloses nothing");
  if (!ClipRegion::fits(closed, grid))
    return no_cells(ErrorCode::cannot_compute, "the curves cross too often to end cells at them");
  return ClipRegion::of(closed, FillRule::even_odd, grid);
}

/// The cells within the box.
std::vector<TextCell> cells_of(const Delaunay& delaunay, const Samples& samples, const Box2& box) {
  const VoronoiCells diagram(delaunay);
  std::vector<TextCell> out;
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    TextCell& cell = out.emplace_back(samples.id(delaunay.site_sample(site)).value, delaunay.site_position(site));
    for (SampleSlot other = delaunay.site_sample(site); other != kNoSlot; other = delaunay.next_duplicate(other))
      cell.sample = std::min<std::uint64_t>(cell.sample, samples.id(other).value);
    cell.rings.push_back(diagram.cell(site, box));
    cell.rings.back().push_back(cell.rings.back().front());
  }
  return out;
}

/// Drops cells of which nothing is left.
Expected<void> clip(std::vector<TextCell>& cells, const ClipRegion& region, JobControl& job) {
  // Sides of the region that are near a cell, for all cells together. So many take 12 s.
  constexpr std::size_t kMostWork = 100'000'000;
  std::size_t work = 0;
  for (const TextCell& cell : cells) {
    Box2 bounds;
    for (const Vec2 p : cell.rings.front()) bounds.add(p);
    work += region.cost_near(bounds, kMostWork + 1);
    if (work > kMostWork)
      return no_cells(ErrorCode::cannot_compute, "too many cells reach across the region; they can end at the box");
  }
  std::uint64_t done = 0;
  for (TextCell& cell : cells) {
    if (++done % 100 == 0) job.checkpoint(done, cells.size());
    const ClippedCurves seen = region.clipped({curve_of(cell.rings.front())}, Ink::even_odd_area);
    cell.rings.clear();
    for (const PlaneCurve& part : seen.curves) cell.rings.push_back(ring_of(part));
  }
  std::erase_if(cells, [](const TextCell& cell) { return cell.rings.empty(); });
  return {};
}

}  // namespace

const std::vector<Vec2>& points_with_cells(const SampleData& data, CellRegion region) {
  const CurveSet* const curves = data.source ? data.source->curves.get() : nullptr;
  const bool has_own_points = region == CellRegion::outline && curves != nullptr && !curves->points.empty();
  return has_own_points ? curves->points : data.positions;
}

CellRegion usual_region_of(const SampleData& data) {
  const CurveSet* const curves = data.source ? data.source->curves.get() : nullptr;
  const bool has_outline =
      curves != nullptr && !curves->points.empty() && std::ranges::any_of(curves->curves, &PlaneCurve::is_closed);
  return has_outline ? CellRegion::outline : CellRegion::box;
}

Expected<CellText> compute_cell_text(const Registry& registry, const SampleData& data, CellRegion region,
                                     std::string_view format, JobControl& job,
                                     const std::function<void(std::string_view)>& on_task, const CellOwners& owners) {
  const CurveSet* const curves = data.source ? data.source->curves.get() : nullptr;
  const std::vector<Vec2>& points = points_with_cells(data, region);
  if (points.empty()) return cell_text({}, data.map, format);
  const Box2 box = box_around(points, curves == nullptr ? Box2() : bounds_of(curves->curves));
  const auto limits = region_of(region, points, curves, box);
  if (!limits) return std::unexpected(limits.error());

  Workbench bench(registry, {.keeps_document = false});
  const auto& delaunay = bench.get<Delaunay>();
  if (auto good = bench.need({delaunay.id()}); !good) return std::unexpected(good.error());
  if (auto good = bench.load({.positions = points}); !good) return std::unexpected(good.error());
  bench.set_on_task(on_task);
  if (auto good = bench.run_or_throw(job); !good) return std::unexpected(good.error());

  auto cells = cells_of(delaunay, bench.get<Samples>(), box);
  const std::size_t without_cell = points.size() - cells.size();
  if (!limits->is_plane())
    if (auto good = clip(cells, *limits, job); !good) return std::unexpected(good.error());
  std::ranges::sort(cells, {}, &TextCell::sample);
  if (owners.of_point.size() == points.size())
    for (TextCell& cell : cells) {
      const CellOwner& owner = owners.of_point[cell.sample];
      cell.id = owner.id;
      cell.properties = owner.properties;
    }
  auto out = cell_text(cells, data.map, format, owners.columns);
  if (out) out->without_cell = without_cell;
  return out;
}

}  // namespace mes
