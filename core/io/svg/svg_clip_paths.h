// SPDX-License-Identifier: GPL-3.0-or-later
// The `clipPath` elements of a drawing as regions of the plane. Private to core/io.
//
// Source: CSS Masking Module Level 1. Supports shapes and `use` of shapes, with their transforms, rules and own clip
// paths. Text in a clip path is left out with a remark, and so are clip paths given as basic shapes of CSS.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/io/svg/svg_context.h"
#include "core/io/svg/svg_geometry.h"
#include "core/io/svg/svg_style.h"
#include "core/io/xml/xml_source.h"

namespace mes {

/// Threads: one.
class SvgClipPaths {
 public:
  /// Work that counts towards the bounds of a drawing.
  struct Spent {
    std::size_t elements = 0;
    std::size_t pieces = 0;
  };

  SvgClipPaths(XmlSource& source, const SvgNames& names, SvgStyles& styles, SvgElements& elements,
               const JobControl* job)
      : source_(source), names_(names), styles_(styles), elements_(elements), job_(job) {}

  /// Sets the precision of clip paths, for a drawing of about this extent. Without a call the first clip path sets it.
  void set_extent(double extent);
  double grid() const { return grid_; }
  const Spent& spent() const { return spent_; }
  void set_most(Spent most) { most_ = most; }

  /// The region where the element is visible by its `clip-path`; the whole plane without a valid one. `box` returns its
  /// bounding box in its own coordinates, and is called if units refer to that box. Throws `Cancelled`.
  ClipRegion of(pugi::xml_node node, const SvgStyle& style, const SvgContext& context,
                const std::function<Box2()>& box);
  /// A rectangle with one corner at the origin.
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
  std::optional<ClipRegion> region_of_curves(std::vector<PlaneCurve> curves, const Affine& map, FillRule rule,
                                             std::size_t companions = 0);
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
  std::vector<pugi::xml_node> around_{};  // clip paths being read now
  std::vector<Known> known_{};            // the latest ones
  ClipRegion viewport_{};                 // the latest one
  SvgViewport viewport_size_{};
  Affine viewport_map_{};
};

}  // namespace mes
