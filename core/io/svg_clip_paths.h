// SPDX-License-Identifier: GPL-3.0-or-later
// The elements `clipPath` of a drawing as parts of the plane. Private to core/io.
//
// Source: CSS Masking Module Level 1. Shapes and `use` of shapes are read, with their transforms, rules and clip paths of
// their own; text in a clip path is left out, and said. So are clip paths that are given as basic shapes of CSS.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/io/svg_context.h"
#include "core/io/svg_geometry.h"
#include "core/io/svg_style.h"
#include "core/io/xml_source.h"

namespace mes {

/// Threads: one.
class SvgClipPaths {
 public:
  /// What is counted towards the bounds of a drawing.
  struct Spent {
    std::size_t elements = 0;
    std::size_t pieces = 0;
  };

  SvgClipPaths(XmlSource& source, const SvgNames& names, SvgStyles& styles, SvgElements& elements,
               const JobControl* job)
      : source_(source), names_(names), styles_(styles), elements_(elements), job_(job) {}

  /// How finely clip paths are taken apart: of a drawing of about this extent. The first clip path says it else.
  void set_extent(double extent);
  double grid() const { return grid_; }
  const Spent& spent() const { return spent_; }
  void set_most(Spent most) { most_ = most; }

  /// Where the element is seen by its `clip-path`; the plane where it has none, or none that is applied. `box` gives its
  /// bounding box in its own coordinates, and is asked where units are those of that box. Throws `Cancelled`.
  ClipRegion of(pugi::xml_node node, const SvgStyle& style, const SvgContext& context,
                const std::function<Box2()>& box);
  /// A rectangle from the origin on.
  ClipRegion viewport(const SvgViewport& size, const Affine& map);

 private:
  struct Known {
    pugi::xml_node clip_path;
    Affine map;
    ClipRegion region;
  };

  std::optional<ClipRegion> region_of(pugi::xml_node clip_path, const SvgContext& context,
                                      const std::function<Box2()>& box);
  void add_child(pugi::xml_node node, SvgContext context, std::vector<ClipRegion>& to, int depth);
  std::optional<ClipRegion> region_of_curves(std::vector<PlaneCurve> curves, const Affine& map, FillRule rule);
  void remark_not_applied(pugi::xml_node node, std::string_view why);
  bool is_within_bounds() const;

  XmlSource& source_;
  const SvgNames& names_;
  SvgStyles& styles_;
  SvgElements& elements_;
  const JobControl* job_;
  double grid_ = 0.0;
  Spent spent_{};
  Spent most_{};
  std::vector<pugi::xml_node> around_{};  // clip paths that are being read
  std::vector<Known> known_{};            // the last ones
  ClipRegion viewport_{};                 // the last one
  SvgViewport viewport_size_{};
  Affine viewport_map_{};
};

}  // namespace mes
