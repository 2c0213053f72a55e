// SPDX-License-Identifier: GPL-3.0-or-later
// Converts shapes of a drawing to curves, many at a time. Private to core/io.
#pragma once

#include <atomic>
#include <cstddef>
#include <pugixml.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/io/svg/svg_context.h"
#include "core/io/svg/svg_geometry.h"
#include "core/io/text/read_job.h"
#include "core/io/xml/xml_source.h"

namespace mes {

/// A path or a basic shape, and its curves.
struct SvgShape {
  pugi::xml_node node;
  SvgContext context;
  SvgGeometry geometry;
  ClippedCurves::Seen seen = ClippedCurves::Seen::whole;
  bool is_off_page = false;
  bool overlaps_itself = false;     ///< the boundary of its area has replaced its curves
  bool may_overlap_itself = false;  ///< this would take too long to find out
  bool is_unclipped = false;        ///< does not fit its clip path
};

/// Collects shapes until several threads have work. Through `use`, shapes may far outnumber the bytes of the file.
///
/// Reports omitted or clipped shapes to the source. Throws `Cancelled`.
class SvgShapeQueue {
 public:
  /// An empty `page` is unknown.
  SvgShapeQueue(XmlSource& source, ReadJob& job, std::size_t most_pieces)
      : source_(source), job_(job), most_pieces_(most_pieces) {}

  void set_page(const Box2& page) { page_ = page; }
  /// Precision of clip paths; used when shapes are finished.
  void set_grid(double grid) { grid_ = grid; }
  /// Error: `bad_input` for too many pieces, or for clip paths that cost too much.
  Expected<void> add(SvgShape shape);
  Expected<void> finish();
  std::vector<PlaneCurve> take() { return std::move(curves_); }

 private:
  void finish(SvgShape& shape);
  void remark_on(const SvgShape& shape);

  XmlSource& source_;
  ReadJob& job_;
  std::size_t most_pieces_;
  std::size_t pieces_ = 0;
  std::atomic<std::size_t> clip_cost_ = 0;  ///< of `ClipRegion::cost_near`, up to some more than is allowed
  Box2 page_{};
  double grid_ = 0.0;
  std::vector<SvgShape> waiting_{};
  std::size_t waiting_bytes_ = 0;
  std::vector<PlaneCurve> curves_{};
};

}  // namespace mes
