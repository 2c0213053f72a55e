// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_style.h"

#include <fmt/core.h>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/svg/svg_values.h"
#include "core/io/text/ascii_text.h"
#include "core/io/xml/css_text.h"

namespace mes {
namespace {

using P = SvgProperty;
using Named = std::pair<std::string_view, SvgProperty>;

/// Sorted by name.
constexpr std::array<Named, kSvgPropertyCount> kProperties{{
    {"clip-path", P::clip_path},
    {"clip-rule", P::clip_rule},
    {"cx", P::cx},
    {"cy", P::cy},
    {"display", P::display},
    {"fill", P::fill},
    {"fill-opacity", P::fill_opacity},
    {"fill-rule", P::fill_rule},
    {"height", P::height},
    {"marker-end", P::marker_end},
    {"marker-mid", P::marker_mid},
    {"marker-start", P::marker_start},
    {"mask", P::mask},
    {"opacity", P::opacity},
    {"overflow", P::overflow},
    {"r", P::r},
    {"rx", P::rx},
    {"ry", P::ry},
    {"stroke", P::stroke},
    {"stroke-opacity", P::stroke_opacity},
    {"stroke-width", P::stroke_width},
    {"transform", P::transform},
    {"transform-origin", P::transform_origin},
    {"visibility", P::visibility},
    {"width", P::width},
    {"x", P::x},
    {"y", P::y},
}};
static_assert(std::ranges::is_sorted(kProperties, {}, &Named::first));

std::optional<SvgProperty> property_named(std::string_view name) {
  const auto found = std::ranges::lower_bound(kProperties, name, {}, &Named::first);
  return found != kProperties.end() && found->first == name ? std::optional(found->second) : std::nullopt;
}

constexpr std::array<std::string_view, 5> kWide{"inherit", "initial", "unset", "revert", "revert-layer"};

/// Whether a value is valid for its property: an invalid declaration is ignored and overrides nothing.
bool is_value_of(SvgProperty property, const std::string& lower) {
  constexpr std::array<std::string_view, 12> kDisplays{"none",      "inline", "block",    "inline-block",
                                                       "list-item", "run-in", "flow",     "flow-root",
                                                       "flex",      "grid",   "contents", "ruby"};
  constexpr std::array<std::string_view, 3> kVisibilities{"visible", "hidden", "collapse"};
  constexpr std::array<std::string_view, 2> kRules{"nonzero", "evenodd"};
  constexpr std::array<std::string_view, 5> kOverflows{"visible", "hidden", "scroll", "auto", "clip"};
  if (lower.empty()) return false;
  if (is_one_of(lower, kWide)) return true;
  switch (property) {
    case P::display:
      return is_one_of(lower, kDisplays) || lower.starts_with("table") || lower.starts_with("inline-") ||
             lower.find(' ') != std::string::npos;
    case P::visibility: return is_one_of(lower, kVisibilities);
    case P::fill_rule:
    case P::clip_rule: return is_one_of(lower, kRules);
    case P::overflow: return is_one_of(lower.substr(0, lower.find(' ')), kOverflows);
    case P::opacity:
    case P::fill_opacity:
    case P::stroke_opacity: return svg_share(lower).has_value();
    default: return true;
  }
}

/// Keywords ignore case; this gives them one case.
std::string_view word_in_lower_case(std::string_view value, const std::string& lower) {
  constexpr std::array<std::string_view, 17> kWords{
      "none",  "hidden", "visible",      "collapse",    "inherit",     "initial",
      "unset", "revert", "revert-layer", "nonzero",     "evenodd",     "scroll",
      "auto",  "clip",   "contents",     "transparent", "currentcolor"};
  const auto found = std::ranges::find(kWords, lower);
  return found == kWords.end() ? value : *found;
}

/// Later and more specific declarations weigh more, those of `style` more than all rules, important ones most.
constexpr std::uint64_t kImportant = std::uint64_t{1} << 62U;
constexpr std::uint64_t kOfElement = std::uint64_t{1} << 61U;
constexpr std::uint64_t kOfAttribute = 1;

std::uint64_t weight_of(const CssSpecificity& specificity, std::size_t order) {
  constexpr std::uint64_t kMostOfKind = 1023;
  constexpr std::uint64_t kMostRules = (std::uint64_t{1} << 30U) - 1;
  std::uint64_t out = 0;
  for (const std::uint32_t count : {specificity.ids, specificity.classes, specificity.types})
    out = out << 10U | std::min<std::uint64_t>(count, kMostOfKind);
  return out << 30U | std::min<std::uint64_t>(order + 2, kMostRules);
}

/// Calls `use(property, value, is_important)`.
template <class Use>
void for_each_declaration(std::string_view text, Use use) {
  CssText rest(text);
  for (; !rest.is_at_end(); rest.take(";")) {
    const std::string_view one = css_trimmed(rest.up_to(";"));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string name = lower_case(css_trimmed(one.substr(0, colon)));
    std::string_view value = css_trimmed(one.substr(colon + 1));
    bool is_important = false;
    if (const std::size_t mark = value.rfind('!'); mark != std::string_view::npos) {
      if (lower_case(css_trimmed(value.substr(mark + 1))) != "important") continue;
      is_important = true;
      value = css_trimmed(value.substr(0, mark));
    }
    const std::string lower = lower_case(value);
    const auto hand_on = [&](SvgProperty property) {
      if (is_value_of(property, lower)) use(property, word_in_lower_case(value, lower), is_important);
    };
    if (name == "marker") {
      for (const SvgProperty property : {P::marker_start, P::marker_mid, P::marker_end}) hand_on(property);
    } else if (const auto property = property_named(name)) {
      hand_on(*property);
    } else if (name == "all" && is_one_of(lower, kWide)) {
      for (const Named& each : kProperties) hand_on(each.second);
    } else if (name == "mask-image" || name == "-webkit-mask" || name == "-webkit-mask-image") {
      hand_on(P::mask);
    } else if (name == "-webkit-clip-path") {
      hand_on(P::clip_path);
    }
  }
}

bool says_something(std::string_view declarations) {
  bool out = false;
  for_each_declaration(declarations, [&](SvgProperty, std::string_view, bool) { out = true; });
  return out;
}

enum class Answer : std::uint8_t { no, yes, unknown };

/// Whether a list of media includes the screen.
Answer is_for_screen(std::string_view media) {
  media = css_trimmed(media);
  if (media.empty()) return Answer::yes;
  Answer out = Answer::no;
  CssText rest(media);
  for (; !rest.is_at_end(); rest.take(",")) {
    const std::string one = lower_case(css_trimmed(rest.up_to(",")));
    if (one == "all" || one == "screen" || one == "only screen" || one == "not print") return Answer::yes;
    if (one.find('(') == std::string::npos) continue;
    const bool is_of_other = one.starts_with("print") || one.starts_with("only print") || one.starts_with("speech");
    if (!is_of_other) out = Answer::unknown;
  }
  return out;
}

}  // namespace

SvgStyles::SvgStyles(pugi::xml_node root, XmlSource& source) : source_(source) {
  // Avoids recursion because the depth has not been checked yet.
  for (pugi::xml_node node = root; node;) {
    if (node.type() == pugi::node_element && local_name(node.name()) == "style") add_sheet(node);
    if (pugi::xml_attribute style = node.attribute("style"))
      if (std::string_view(style.value()).find("/*") != std::string_view::npos)
        style.set_value(without_css_comments(style.value()).c_str());
    if (const pugi::xml_node child = node.first_child()) {
      node = child;
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    node = !node || node == root ? pugi::xml_node() : node.next_sibling();
  }
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    const CssCompound& last = rules_[i].selector.compounds.front();
    auto& list = !last.id.empty()        ? by_id_[last.id]
                 : !last.classes.empty() ? by_class_[last.classes.front()]
                 : !last.type.empty()    ? by_type_[last.type]
                                         : for_all_;
    list.push_back(i);
  }
}

void SvgStyles::add_sheet(pugi::xml_node node) {
  const std::string type = lower_case(css_trimmed(node.attribute("type").value()));
  if (!type.empty() && type != "text/css") {
    source_.remarks.add("style sheet is left out, which is not CSS", "style sheets are left out, which are not CSS",
                        source_.place_of(node));
    return;
  }
  std::string text;
  for (const pugi::xml_node child : node.children())
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
  texts_.push_back(without_css_comments(text));
  const std::string_view media = node.attribute("media").value();
  switch (is_for_screen(media)) {
    case Answer::yes: return read_rules(texts_.back(), node, 0);
    case Answer::unknown: return remark_unread("media", texts_.back(), node);
    case Answer::no: return;
  }
}

void SvgStyles::read_rules(std::string_view text, pugi::xml_node node, int depth) {
  CssText rest(text);
  for (rest.skip_blanks(); !rest.is_at_end(); rest.skip_blanks()) {
    if (rest.take("<!--") || rest.take("-->") || rest.take(";")) continue;
    if (!rest.take("@")) {
      const std::string_view selectors = rest.up_to("{");
      if (!rest.is_at_end()) read_rule(selectors, rest.enclosed(), node);
      continue;
    }
    const std::string name = lower_case(rest.name());
    const std::string_view words = css_trimmed(rest.up_to(";{"));
    const bool has_block = rest.sign() == '{';
    const std::string_view block = has_block ? rest.enclosed() : std::string_view();
    read_at_rule(name, words, block, node, depth);
  }
}

void SvgStyles::read_at_rule(std::string_view name, std::string_view words, std::string_view block,
                             pugi::xml_node node, int depth) {
  constexpr int kDeepest = 16;
  if (name == "import") {
    source_.remarks.add("style sheet of another file is not read", "style sheets of other files are not read",
                        source_.place_of(node));
    return;
  }
  constexpr std::array<std::string_view, 8> kIdle{"charset", "namespace",     "font-face", "keyframes",
                                                  "page",    "counter-style", "property",  "-webkit-keyframes"};
  if (is_one_of(name, kIdle)) return;
  const Answer holds = name == "media" ? is_for_screen(words) : Answer::unknown;
  if (holds == Answer::yes && depth < kDeepest) return read_rules(block, node, depth + 1);
  if (holds != Answer::no) remark_unread(name, block, node);
}

/// Adds a remark if the unread block contains a rule that would have an effect.
void SvgStyles::remark_unread(std::string_view name, std::string_view block, pugi::xml_node node) {
  CssText rest(block);
  for (rest.skip_blanks(); !rest.is_at_end(); rest.skip_blanks()) {
    rest.up_to("{;}");
    if (rest.sign() != '{') {
      rest.take(rest.sign() == ';' ? ";" : "}");
      continue;
    }
    const std::string_view inside = rest.enclosed();
    if (!says_something(inside) && inside.find('{') == std::string_view::npos) continue;
    const std::string kind = name.size() > 20 ? "..." : std::string(name);
    source_.remarks.add(fmt::format("part of a style sheet is left out, which holds under conditions (@{})", kind),
                        fmt::format("parts of style sheets are left out, which hold under conditions (@{})", kind),
                        source_.place_of(node));
    return;
  }
}

void SvgStyles::read_rule(std::string_view selectors, std::string_view block, pugi::xml_node node) {
  const std::size_t first = declarations_.size();
  for_each_declaration(block, [&](SvgProperty property, std::string_view value, bool is_important) {
    declarations_.push_back({property, value, is_important});
  });
  const std::size_t count = declarations_.size() - first;
  if (count == 0) return;
  auto all = css_selectors(css_trimmed(selectors));
  if (!all) {
    source_.remarks.add("rule of a style sheet is left out, whose selector is not understood",
                        "rules of style sheets are left out, whose selectors are not understood",
                        source_.place_of(node));
    return;
  }
  for (CssSelector& selector : *all) {
    const std::uint64_t weight = weight_of(selector.specificity, rules_.size());
    rules_.push_back({std::move(selector), weight, first, count});
  }
}

void SvgStyles::take_rules(const std::vector<std::size_t>& rules, pugi::xml_node node, SvgStyle& out) {
  for (const std::size_t rule : rules) {
    const Rule& one = rules_[rule];
    if (!matcher_.matches(one.selector, node)) continue;
    for (std::size_t i = one.first; i < one.first + one.count; ++i) {
      const Declaration& declared = declarations_[i];
      const std::uint64_t weight = one.weight | (declared.is_important ? kImportant : 0);
      const auto property = static_cast<std::size_t>(declared.property);
      if (weight < out.weights_[property]) continue;
      out.weights_[property] = weight;
      out.values_[property] = declared.value;
    }
  }
}

void SvgStyles::take_declarations(std::string_view text, std::uint64_t weight, SvgStyle& out) {
  for_each_declaration(text, [&](SvgProperty property, std::string_view value, bool is_important) {
    const std::uint64_t here = weight | (is_important ? kImportant : 0);
    const auto place = static_cast<std::size_t>(property);
    if (here < out.weights_[place]) return;
    out.weights_[place] = here;
    out.values_[place] = value;
  });
}

SvgStyle SvgStyles::of(pugi::xml_node node) {
  SvgStyle out;
  std::string_view style;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "style") style = attribute.value();
    const auto property = property_named(name);
    const std::string_view value = css_trimmed(attribute.value());
    if (!property || value.empty()) continue;
    const std::string lower = lower_case(value.substr(0, 64));
    if (!is_value_of(*property, lower)) continue;
    out.values_[static_cast<std::size_t>(*property)] = value.size() > 64 ? value : word_in_lower_case(value, lower);
    out.weights_[static_cast<std::size_t>(*property)] = kOfAttribute;
  }
  if (!rules_.empty()) {
    const auto take = [&](const RulesByName& by_name, std::string_view name) {
      if (const auto found = by_name.find(name); found != by_name.end()) take_rules(found->second, node, out);
    };
    take_rules(for_all_, node, out);
    take(by_type_, local_name(node.name()));
    std::string_view classes = node.attribute("class").value();
    while (!(classes = css_trimmed(classes)).empty()) {
      const auto end = static_cast<std::size_t>(std::ranges::find_if(classes, is_css_blank) - classes.begin());
      take(by_class_, classes.substr(0, end));
      classes.remove_prefix(end);
    }
    take(by_id_, node.attribute("id").value());
  }
  if (!style.empty()) take_declarations(style, kOfElement, out);
  return out;
}

}  // namespace mes
