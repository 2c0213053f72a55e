// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/xml/css_selector.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/xml/css_text.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

using Kind = CssCondition::Kind;

constexpr std::size_t kMostCompounds = 64;
constexpr int kDeepestSelector = 4;  // nesting limit of selectors

class SelectorReader {
 public:
  SelectorReader(std::string_view text, int depth) : text_(text), depth_(depth) {}

  std::optional<std::vector<CssSelector>> read() {
    std::vector<CssSelector> out;
    if (depth_ > kDeepestSelector) return std::nullopt;
    do {
      auto selector = read_one();
      if (!selector) return std::nullopt;
      out.push_back(*std::move(selector));
    } while (text_.take(","));
    if (!text_.is_at_end()) return std::nullopt;
    return out;
  }

 private:
  std::optional<CssSelector> read_one() {
    CssSelector out;
    char before = '\0';
    for (;;) {
      text_.skip_blanks();
      CssCompound compound{.before = before};
      if (out.compounds.size() == kMostCompounds || !read_compound(compound, out.specificity)) return std::nullopt;
      out.compounds.push_back(std::move(compound));
      const bool has_blank = is_css_blank(text_.sign());
      text_.skip_blanks();
      if (text_.is_at_end() || text_.sign() == ',') break;
      before = has_blank ? ' ' : '\0';
      for (const char sign : {'>', '+', '~'})
        if (text_.take({&sign, 1})) before = sign;
      if (before == '\0') return std::nullopt;
    }
    std::ranges::reverse(out.compounds);
    return out;
  }

  bool read_compound(CssCompound& out, CssSpecificity& weight) {
    bool is_any = read_type(out, weight);
    for (;; is_any = true) {
      if (text_.take("#")) {
        std::string id = text_.name();
        if (id.empty() || (!out.id.empty() && out.id != id)) return false;
        out.id = std::move(id);
        ++weight.ids;
      } else if (text_.take(".")) {
        out.classes.push_back(text_.name());
        if (out.classes.back().empty()) return false;
        ++weight.classes;
      } else if (text_.sign() == '[') {
        auto condition = attribute_condition(text_.enclosed());
        if (!condition) return false;
        out.conditions.push_back(*std::move(condition));
        ++weight.classes;
      } else if (text_.sign() == ':') {
        if (!read_pseudo(out, weight)) return false;
      } else {
        return is_any;
      }
    }
  }

  /// Reads a type or "*". A prefix is ignored: elements of other vocabularies are not read.
  bool read_type(CssCompound& out, CssSpecificity& weight) {
    const auto part = [&](std::string& name) {
      if (text_.take("*")) return true;
      name = text_.name();
      return !name.empty();
    };
    bool is_any = part(out.type);
    if (text_.sign() == '|' && text_.sign(1) != '=') {
      text_.take("|");
      out.type.clear();
      is_any = part(out.type);
    }
    if (!out.type.empty()) ++weight.types;
    return is_any;
  }

  static std::optional<CssCondition> attribute_condition(std::string_view inside) {
    CssText text(inside);
    CssCondition out{.kind = Kind::attribute};
    text.skip_blanks();
    out.attribute = text.name();
    if (text.sign() == '|' && text.sign(1) != '=' && text.take("|")) out.attribute += ':' + text.name();
    if (out.attribute.empty()) return std::nullopt;
    text.skip_blanks();
    if (text.is_at_end()) return out;
    out.relation = '=';
    for (const char sign : {'~', '|', '^', '$', '*'})
      if (text.take({&sign, 1})) out.relation = sign;
    if (!text.take("=")) return std::nullopt;
    text.skip_blanks();
    out.value = text.string_or_name();
    text.skip_blanks();
    const std::string flag = lower_case(text.name());
    text.skip_blanks();
    out.ignores_case = flag == "i";
    if (!text.is_at_end() || (!flag.empty() && flag != "i" && flag != "s")) return std::nullopt;
    return out;
  }

  bool read_pseudo(CssCompound& out, CssSpecificity& weight) {
    const bool is_element = text_.take("::");
    if (!is_element) text_.take(":");
    const std::string name = lower_case(text_.name());
    if (name.empty()) return false;
    const bool has_words = text_.sign() == '(';
    const std::string_view words = has_words ? text_.enclosed() : std::string_view();
    CssCondition condition;
    if (is_element) {
      ++weight.types;  // a pseudo-element
      out.conditions.push_back(std::move(condition));
      return true;
    }
    if (name == "not" || name == "is" || name == "where" || name == "matches") {
      auto selectors = SelectorReader(words, depth_ + 1).read();
      if (!has_words || !selectors) return false;
      condition.kind = name == "not" ? Kind::none_of : Kind::any_of;
      if (name != "where") {
        CssSpecificity most;
        for (const CssSelector& selector : *selectors) most = std::max(most, selector.specificity);
        weight = {weight.ids + most.ids, weight.classes + most.classes, weight.types + most.types};
      }
      condition.selectors = *std::move(selectors);
      out.conditions.push_back(std::move(condition));
      return true;
    }
    ++weight.classes;
    return read_pseudo_class(name, has_words ? std::optional(words) : std::nullopt, out);
  }

  static bool read_pseudo_class(const std::string& name, std::optional<std::string_view> words, CssCompound& out) {
    const auto add = [&](Kind kind, int step = 0, int offset = 0) {
      out.conditions.push_back({.kind = kind, .step = step, .offset = offset});
      return true;
    };
    if (words) {
      const auto turn = turn_in(*words);
      if (!turn || (name != "nth-child" && name != "nth-last-child")) return false;
      return add(name == "nth-child" ? Kind::nth_child : Kind::nth_last_child, turn->first, turn->second);
    }
    if (name == "root") return add(Kind::root);
    if (name == "empty") return add(Kind::empty);
    if (name == "first-child") return add(Kind::nth_child, 0, 1);
    if (name == "last-child") return add(Kind::nth_last_child, 0, 1);
    if (name == "only-child") return add(Kind::nth_child, 0, 1) && add(Kind::nth_last_child, 0, 1);
    for (const std::string_view idle :
         {"hover", "active", "focus", "focus-visible", "focus-within", "visited", "target", "checked", "disabled"})
      if (name == idle) return add(Kind::never);
    return false;
  }

  /// "2n+1", "odd", "-n + 3", "4".
  static std::optional<std::pair<int, int>> turn_in(std::string_view words) {
    std::string text;
    for (const char c : words)
      if (!is_css_blank(c)) text += lower_case(c);
    if (text == "odd") return std::pair{2, 1};
    if (text == "even") return std::pair{2, 0};
    const auto number = [](std::string_view digits) -> std::optional<int> {
      if (digits.starts_with('+')) digits.remove_prefix(1);
      int value = 0;
      const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
      constexpr int kMost = 1'000'000'000;
      if (error != std::errc() || end != digits.data() + digits.size() || value > kMost || value < -kMost)
        return std::nullopt;
      return value;
    };
    const std::size_t n = text.find('n');
    if (n == std::string::npos) {
      const auto value = number(text);
      return value ? std::optional(std::pair{0, *value}) : std::nullopt;
    }
    const std::string step = text.substr(0, n);
    const std::string offset = text.substr(n + 1);
    const auto a = step.empty() || step == "+" ? std::optional(1) : step == "-" ? std::optional(-1) : number(step);
    const auto b = offset.empty() ? std::optional(0) : number(offset);
    return a && b ? std::optional(std::pair{*a, *b}) : std::nullopt;
  }

  CssText text_;
  int depth_;
};

bool is_turn(int turn, int step, int offset) {
  if (step == 0) return turn == offset;
  return (turn - offset) % step == 0 && (turn - offset) / step >= 0;
}

pugi::xml_node element_before(pugi::xml_node node) {
  do node = node.previous_sibling();
  while (node && node.type() != pugi::node_element);
  return node;
}

bool attribute_holds(const CssCondition& condition, pugi::xml_node node) {
  const pugi::xml_attribute attribute = node.attribute(condition.attribute.c_str());
  if (!attribute || condition.relation == '\0') return !attribute.empty();
  std::string_view text = attribute.value();
  std::string lower;
  std::string wanted = condition.value;
  if (condition.ignores_case) {
    text = lower = lower_case(text);
    wanted = lower_case(wanted);
  }
  switch (condition.relation) {
    case '~': return has_css_class(text, wanted);
    case '|': return text == wanted || text.starts_with(wanted + '-');
    case '^': return !wanted.empty() && text.starts_with(wanted);
    case '$': return !wanted.empty() && text.ends_with(wanted);
    case '*': return !wanted.empty() && text.find(wanted) != std::string_view::npos;
    default: return text == wanted;
  }
}

}  // namespace

std::optional<std::vector<CssSelector>> css_selectors(std::string_view text) {
  return SelectorReader(text, 0).read();
}

bool has_css_class(std::string_view classes, std::string_view wanted) {
  if (wanted.empty()) return false;
  for (std::size_t at = classes.find(wanted); at != std::string_view::npos; at = classes.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if ((at == 0 || is_css_blank(classes[at - 1])) && (end == classes.size() || is_css_blank(classes[end])))
      return true;
  }
  return false;
}

CssMatcher::Turn CssMatcher::turn_of(pugi::xml_node node) {
  if (const auto known = turns_.find(node.internal_object()); known != turns_.end()) return known->second;
  std::vector<pugi::xml_node> all;
  for (const pugi::xml_node child : node.parent().children())
    if (child.type() == pugi::node_element) all.push_back(child);
  looks_ += all.size();
  const int count = static_cast<int>(all.size());
  for (int i = 0; i < count; ++i)
    turns_[all[static_cast<std::size_t>(i)].internal_object()] = {.from_front = i + 1, .from_back = count - i};
  return turns_[node.internal_object()];
}

bool CssMatcher::holds(const CssCondition& condition, pugi::xml_node node) {
  const auto is_met = [&](const CssSelector& selector) { return matches(selector, node); };
  switch (condition.kind) {
    case Kind::attribute: return attribute_holds(condition, node);
    case Kind::root: return node.parent().type() == pugi::node_document;
    case Kind::empty: return !node.first_child();
    case Kind::nth_child: return is_turn(turn_of(node).from_front, condition.step, condition.offset);
    case Kind::nth_last_child: return is_turn(turn_of(node).from_back, condition.step, condition.offset);
    case Kind::any_of: return std::ranges::any_of(condition.selectors, is_met);
    case Kind::none_of: return std::ranges::none_of(condition.selectors, is_met);
    case Kind::never: return false;
  }
  return false;
}

bool CssMatcher::holds(const CssCompound& compound, pugi::xml_node node) {
  ++looks_;
  if (!compound.type.empty() && local_name(node.name()) != compound.type) return false;
  if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
  if (!compound.classes.empty()) {
    const std::string_view classes = node.attribute("class").value();
    for (const std::string& wanted : compound.classes)
      if (!has_css_class(classes, wanted)) return false;
  }
  return std::ranges::all_of(compound.conditions,
                             [&](const CssCondition& condition) { return holds(condition, node); });
}

bool CssMatcher::matches_from(const CssSelector& selector, std::size_t compound, pugi::xml_node node) {
  const CssCompound& here = selector.compounds[compound];
  if (has_given_up() || !holds(here, node)) return false;
  const std::size_t next = compound + 1;
  switch (here.before) {
    case '>': return node.parent().type() == pugi::node_element && matches_from(selector, next, node.parent());
    case '+': {
      const pugi::xml_node before = element_before(node);
      return before && matches_from(selector, next, before);
    }
    case ' ':
      for (node = node.parent(); node.type() == pugi::node_element; node = node.parent())
        if (matches_from(selector, next, node)) return true;
      return false;
    case '~':
      for (node = element_before(node); node; node = element_before(node))
        if (matches_from(selector, next, node)) return true;
      return false;
    default: return true;
  }
}

}  // namespace mes
