// SPDX-License-Identifier: GPL-3.0-or-later
// The style of SVG elements: attributes, style sheets, the attribute `style`. Private to core/io.
//
// Source: CSS Cascading and Inheritance Level 3; SVG 2, chapter 6. Elements drawn through `use` have the style of their
// original position. Inheritance is left to the reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/io/xml/css_selector.h"
#include "core/io/xml/xml_source.h"

namespace mes {

/// The supported properties. Those from `x` on are geometry, which style sheets may set too.
enum class SvgProperty : std::uint8_t {
  display,
  visibility,
  opacity,
  fill,
  fill_opacity,
  fill_rule,
  stroke,
  stroke_opacity,
  stroke_width,
  clip_path,
  clip_rule,
  mask,
  overflow,
  marker_start,
  marker_mid,
  marker_end,
  transform,
  transform_origin,
  x,
  y,
  width,
  height,
  cx,
  cy,
  r,
  rx,
  ry,
};
inline constexpr std::size_t kSvgPropertyCount = static_cast<std::size_t>(SvgProperty::ry) + 1;

/// The winning values of one element. They live as long as the styles and the drawing.
class SvgStyle {
 public:
  /// Empty if there is no value. For `inherit` and similar keywords, the keyword in lower case.
  std::string_view operator[](SvgProperty property) const { return values_[static_cast<std::size_t>(property)]; }

 private:
  friend class SvgStyles;
  std::array<std::string_view, kSvgPropertyCount> values_{};
  std::array<std::uint64_t, kSvgPropertyCount> weights_{};
};

/// The style sheets of a drawing; computes the style of elements.
///
/// Cost: an element is compared with rules that end in its type, id or classes, or in none of these. Threads: one.
class SvgStyles {
 public:
  /// Reads all `style` elements. Reports omitted parts of sheets that could matter to `source`.
  SvgStyles(pugi::xml_node root, XmlSource& source);

  SvgStyle of(pugi::xml_node node);
  /// Whether the rules are too complex for this many elements: styles computed since then may be wrong.
  bool has_given_up() const { return matcher_.has_given_up(); }

 private:
  struct Declaration {
    SvgProperty property;
    std::string_view value;
    bool is_important;
  };
  struct Rule {
    CssSelector selector;
    std::uint64_t weight;
    std::size_t first;  // index of its first declaration
    std::size_t count;
  };

  void add_sheet(pugi::xml_node node);
  void read_rules(std::string_view text, pugi::xml_node node, int depth);
  void read_rule(std::string_view selectors, std::string_view block, pugi::xml_node node);
  void read_at_rule(std::string_view name, std::string_view words, std::string_view block, pugi::xml_node node,
                    int depth);
  void remark_unread(std::string_view name, std::string_view block, pugi::xml_node node);
  void take_declarations(std::string_view text, std::uint64_t weight, SvgStyle& out);
  void take_rules(const std::vector<std::size_t>& rules, pugi::xml_node node, SvgStyle& out);

  XmlSource& source_;
  std::deque<std::string> texts_{};  // texts of the sheets, without comments
  std::vector<Declaration> declarations_{};
  std::vector<Rule> rules_{};
  // Rules by their condition on the element itself: its id, else a class, else its type, else nothing.
  using RulesByName = std::unordered_map<std::string_view, std::vector<std::size_t>>;
  RulesByName by_id_{};
  RulesByName by_class_{};
  RulesByName by_type_{};
  std::vector<std::size_t> for_all_{};
  CssMatcher matcher_{};
};

}  // namespace mes
