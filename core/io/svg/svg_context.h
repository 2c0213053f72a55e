// SPDX-License-Identifier: GPL-3.0-or-later
// Inherited state of an element of a drawing. Private to core/io.
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>

#include "core/curves/affine.h"
#include "core/curves/clip_region.h"
#include "core/io/svg/svg_values.h"

namespace mes {

/// Elements by id; the first one with an id counts.
using SvgNames = std::unordered_map<std::string_view, pugi::xml_node>;

struct SvgContext {
  Affine map{};  ///< to the plane
  SvgViewport viewport{};
  ClipRegion clip{};  ///< in the plane
  bool is_visible = true;
  bool has_fill = true;
  bool has_stroke = false;
  bool fills_even_odd = false;
  bool clips_even_odd = false;
  std::size_t companions = 0;  ///< elements of a clip path beside this one
  double fill_opacity = 1.0;
  double stroke_opacity = 1.0;
  double stroke_width = 1.0;
  bool has_pattern = false;  ///< in the filled area
  bool has_marker = false;

  bool is_filled() const { return has_fill && fill_opacity > 0.0; }
  bool is_stroked() const { return has_stroke && stroke_opacity > 0.0 && stroke_width > 0.0; }
};

}  // namespace mes
