// SPDX-License-Identifier: GPL-3.0-or-later
// Selectors of style sheets. Private to core/io.
//
// Source: Selectors Level 3, with `:not`, `:is` and `:where` of Level 4. Selectors that depend on a pointer or a visit,
// such as `:hover`, match no element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mes {

/// Numbers of ids, of classes and similar conditions, and of types in a selector.
struct CssSpecificity {
  std::uint32_t ids = 0;
  std::uint32_t classes = 0;
  std::uint32_t types = 0;
  auto operator<=>(const CssSpecificity&) const = default;
};

struct CssCondition;

/// The conditions on one element.
struct CssCompound {
  std::string type{};  ///< empty: any
  std::string id{};
  std::vector<std::string> classes{};
  std::vector<CssCondition> conditions{};
  char before = '\0';  ///< combinator with the compound to the left: ' ', '>', '+', '~'; none for the leftmost
};

struct CssSelector {
  std::vector<CssCompound> compounds{};  ///< the rightmost first
  CssSpecificity specificity{};
};

struct CssCondition {
  enum class Kind : std::uint8_t { attribute, root, empty, nth_child, nth_last_child, any_of, none_of, never };
  Kind kind = Kind::never;
  std::string attribute{};
  char relation = '\0';  ///< relation of an attribute: none for presence, '=' or the sign before it
  std::string value{};
  bool ignores_case = false;
  int step = 0;  ///< condition on the index of a child: step n + offset
  int offset = 0;
  std::vector<CssSelector> selectors{};
};

/// Parses a list with commas; nothing if a part of it is not supported.
std::optional<std::vector<CssSelector>> css_selectors(std::string_view text);

/// Whether a class list contains a class; `classes` is the attribute value.
bool has_css_class(std::string_view classes, std::string_view wanted);

/// Threads: one.
class CssMatcher {
 public:
  /// Selectors that go back and forth among many elements would take forever: after this many steps nothing matches.
  static constexpr std::size_t kMostLooks = 100'000'000;

  bool matches(const CssSelector& selector, pugi::xml_node node) { return matches_from(selector, 0, node); }
  bool has_given_up() const { return looks_ > kMostLooks; }

 private:
  bool matches_from(const CssSelector& selector, std::size_t compound, pugi::xml_node node);
  bool holds(const CssCompound& compound, pugi::xml_node node);
  bool holds(const CssCondition& condition, pugi::xml_node node);
  /// Index among the elements with the same parent: from 1, from the front and from the back.
  struct Turn {
    int from_front = 0;
    int from_back = 0;
  };
  Turn turn_of(pugi::xml_node node);

  std::unordered_map<const void*, Turn> turns_;  // for all children of the parents asked for so far
  std::size_t looks_ = 0;
};

}  // namespace mes
