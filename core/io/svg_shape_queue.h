// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of a drawing on their way to curves, many at a time. Private to core/io.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <vector>

#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/io/read_job.h"
#include "core/io/svg_context.h"
#include "core/io/svg_geometry.h"
#include "core/io/xml_source.h"

namespace mes {

/// What a path or a basic shape becomes.
struct SvgShape {
  pugi::xml_node node;
  SvgContext context;
  SvgGeometry geometry;
  ClippedCurves::Seen seen = ClippedCurves::Seen::whole;
  bool is_off_page = false;
  bool is_too_far = false;  ///< for its clip path
};

/// Shapes wait until there is work for several threads. With `use`, they may be far more than the file has bytes.
///
/// What is left out or cut is told to the source. Throws `Cancelled`.
class SvgShapeQueue {
 public:
  /// `page` may be empty: it is not known.
  SvgShapeQueue(XmlSource& source, ReadJob& job, std::size_t most_pieces)
      : source_(source), job_(job), most_pieces_(most_pieces) {}

  void set_page(const Box2& page) { page_ = page; }
  /// Of clip paths; asked for when shapes are finished.
  void set_grid(double grid) { grid_ = grid; }
  /// Error: `bad_input` for too many pieces.
  Expected<void> add(SvgShape shape);
  Expected<void> finish();
  std::vector<PlaneCurve> take() { return std::move(curves_); }

 private:
  void finish(SvgShape& shape) const;
  void remark_on(const SvgShape& shape);

  XmlSource& source_;
  ReadJob& job_;
  std::size_t most_pieces_;
  std::size_t pieces_ = 0;
  Box2 page_{};
  double grid_ = 0.0;
  std::vector<SvgShape> waiting_{};
  std::size_t waiting_bytes_ = 0;
  std::vector<PlaneCurve> curves_{};
};

}  // namespace mes
