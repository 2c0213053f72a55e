// SPDX-License-Identifier: GPL-3.0-or-later
// Reads paths and basic shapes from SVG elements. Private to core/io.
#pragma once

#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "core/io/svg/svg_path.h"
#include "core/io/svg/svg_style.h"
#include "core/io/svg/svg_values.h"
#include "core/io/xml/xml_source.h"

namespace mes {

struct SvgGeometry {
  enum class Kind : std::uint8_t { path, polyline, polygon, other };
  Kind kind = Kind::other;
  std::string_view data{};  ///< for all kinds but `other`; not yet read
  SvgPath path{};
  /// Reads `data`. Any thread.
  void finish(const JobControl* job);
};

/// The id that a `use` refers to; empty if it is not in this file.
inline std::string_view svg_link_of_use(pugi::xml_node node) {
  const pugi::xml_attribute plain = node.attribute("href");
  const std::string_view link = plain ? plain.value() : node.attribute("xlink:href").value();
  return link.starts_with('#') ? link.substr(1) : std::string_view();
}

/// Whether an element of this name is a path or a basic shape.
bool is_svg_shape(std::string_view kind);

/// Reads the geometry of elements. Each invalid value becomes a remark of the source, unless `is_quiet` is set.
class SvgElements {
 public:
  explicit SvgElements(XmlSource& source) : source_(source) {}

  /// Nothing if the length is missing or `auto`.
  std::optional<double> length(pugi::xml_node node, const SvgStyle& style, SvgProperty property, SvgAxis axis,
                               const SvgViewport& viewport);
  /// The shape in the coordinates of the element.
  SvgGeometry shape(pugi::xml_node node, std::string_view kind, const SvgStyle& style, const SvgViewport& viewport);
  /// The identity if the element has no transform.
  Affine transform(pugi::xml_node node, const SvgStyle& style);

  void remark(std::string one, std::string many, std::size_t place) {
    if (!is_quiet) source_.remarks.add(std::move(one), std::move(many), place);
  }
  void remark_ignored(std::string_view attribute, pugi::xml_node node, std::string_view value);

  bool is_quiet = false;

 private:
  std::optional<double> length_of(pugi::xml_node node, std::string_view name, std::string_view text, SvgAxis axis,
                                  const SvgViewport& viewport);
  std::optional<PlaneCurve> simple_shape(pugi::xml_node node, std::string_view kind, const SvgStyle& style,
                                         const SvgViewport& viewport);

  XmlSource& source_;
};

}  // namespace mes
