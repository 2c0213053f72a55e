// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json_annotations.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "core/io/json_color.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> role_names() {
  return {"itself", "origin", "product"};
}

json to_json(const Annotation& annotation) {
  json at = json::array();
  json follows = json::array();
  bool follows_any = false;
  for (const Anchor& anchor : annotation.anchors) {
    at.push_back(anchor.at.x);
    at.push_back(anchor.at.y);
    follows.push_back(anchor.samples);
    follows_any = follows_any || !anchor.samples.empty();
  }
  json out = {{"kind", id_of(annotation.kind)}, {"at", std::move(at)}};
  if (follows_any) out["follows"] = std::move(follows);
  if (!annotation.text.empty()) out["text"] = annotation.text;
  if (annotation.shift != Vec2{}) out["shift"] = {annotation.shift.x, annotation.shift.y};
  if (annotation.letters != kUsualLetters) out["letters"] = annotation.letters;
  if (annotation.color) out["color"] = hexadecimal(*annotation.color);
  if (annotation.elements.empty()) return out;
  json elements = json::array();
  for (const HighlightedElement& element : annotation.elements) {
    json one = {name_of(element.kind), role_names()[static_cast<std::size_t>(element.role)]};
    if (element.radius != 0.0) one.push_back(element.radius);
    elements.push_back(std::move(one));
  }
  out["elements"] = std::move(elements);
  return out;
}

/// Reads one; the first fault stays.
class Reader {
 public:
  /// Nothing for a kind that is not known, and where there is a fault.
  std::optional<Annotation> read(JsonView object) {
    if (!object.is_object()) return complain("is not an object");
    const auto [kind, at, follows, text, shift, letters, color, elements] =
        object.pick<8>({"kind", "at", "follows", "text", "shift", "letters", "color", "elements"});
    if (!kind.is_text()) return complain("does not say its kind");
    const auto known = kind.text_length() < 100 ? annotation_kind_of(kind.text()) : std::nullopt;
    if (!known) return std::nullopt;
    Annotation out{.kind = *known};
    if (out.kind == AnnotationKind::highlight && !read_elements(elements, out)) return std::nullopt;
    read_places(at, follows, out);
    if (text) read_text(text, out.text);
    if (shift) {
      if (shift.size() != 2) return complain("has a \"shift\" that is not two numbers");
      auto number = shift.elements().begin();
      out.shift.x = std::clamp(number_of(*number), -kMostShift, kMostShift);
      out.shift.y = std::clamp(number_of(*++number), -kMostShift, kMostShift);
    }
    if (letters) out.letters = std::clamp(number_of(letters), kLeastLetters, kMostLetters);
    if (color) {
      out.color = color.is_text() && color.text_length() < 100 ? color_from(color.text()) : std::nullopt;
      if (!out.color) return complain("has a \"color\" that is not #RRGGBB");
    }
    if (!fault_.empty()) return std::nullopt;
    constexpr std::size_t kAnySample = std::numeric_limits<std::size_t>::max();
    if (const std::string fault = fault_of(out, kAnySample); !fault.empty()) {
      fault_ = fault;
      return std::nullopt;
    }
    return out;
  }
  const std::string& fault() const { return fault_; }

 private:
  std::nullopt_t complain(std::string_view what) {
    if (fault_.empty()) fault_ = "an annotation " + std::string(what);
    return std::nullopt;
  }
  double number_of(JsonView value) {
    if (value.is_number()) return value.number();
    complain("has something that is not a number");
    return 0.0;
  }
  void read_text(JsonView value, std::string& out) {
    constexpr std::size_t kBytesOfAnEscape = 6;
    if (!value.is_text())
      complain("has a \"text\" that is not a text");
    else if (value.text_length() > kBytesOfAnEscape * kMostAnnotationBytes)
      complain("has too long a text");
    else
      out = value.text();
  }
  /// False for kinds and roles that are not known, and where there is a fault.
  bool read_elements(JsonView list, Annotation& out) {
    if (!list.is_list() || list.size() > kMostHighlighted) {
      complain(fmt::format("of the kind highlight has no list of up to {} \"elements\"", kMostHighlighted));
      return false;
    }
    out.elements.reserve(list.size());
    for (const JsonView one : list.elements()) {
      const auto element = element_of(one);
      if (!element) return false;
      out.elements.push_back(*element);
    }
    return true;
  }
  std::optional<HighlightedElement> element_of(JsonView list) {
    constexpr std::size_t kLongName = 100;
    const bool has_size = list.is_list() && (list.size() == 2 || list.size() == 3);
    std::array<JsonView, 3> part{};
    if (has_size) {
      std::size_t place = 0;
      for (const JsonView value : list.elements()) part[place++] = value;
    }
    const auto is_name = [](JsonView value) { return value.is_text() && value.text_length() < kLongName; };
    if (!has_size || !is_name(part[0]) || !is_name(part[1]) || (list.size() == 3 && !part[2].is_number()))
      return complain("has an element that is not its kind, its role, and a radius if it is round");
    constexpr auto kRoles = role_names();
    const std::string kind_name = part[0].text();
    const std::string role_name = part[1].text();
    const auto kind = std::ranges::find(kAllPrimitiveKinds, std::string_view(kind_name), name_of);
    const auto role = std::ranges::find(kRoles, std::string_view(role_name));
    if (kind == kAllPrimitiveKinds.end() || role == kRoles.end()) return std::nullopt;
    return HighlightedElement{*kind, static_cast<ProvenanceRole>(role - kRoles.begin()),
                              list.size() == 3 ? part[2].number() + 0.0 : 0.0};
  }
  void read_places(JsonView at, JsonView follows, Annotation& out) {
    const std::size_t count = anchor_count(out);
    if (!at.is_list() || at.size() != 2 * count) {
      complain(fmt::format("of the kind {} has no {} numbers in \"at\"", id_of(out.kind), 2 * count));
      return;
    }
    out.anchors.resize(count);
    auto number = at.elements().begin();
    for (Anchor& anchor : out.anchors) {
      // No negative zeros: annotations are compared by their bytes.
      for (double* const to : {&anchor.at.x, &anchor.at.y}) {
        *to = number_of(*number) + 0.0;
        ++number;
      }
    }
    if (!follows) return;
    if (!follows.is_list() || follows.size() != count) {
      complain("has a \"follows\" without a list for each place");
      return;
    }
    std::size_t i = 0;
    for (const JsonView list : follows.elements()) read_followed(list, out.anchors[i++]);
  }
  void read_followed(JsonView list, Anchor& out) {
    if (!list.is_list() || list.size() > 3) {
      complain("follows something that is not a list of up to three samples");
      return;
    }
    for (const JsonView element : list.elements()) {
      const auto sample = element.is_number() ? element.count() : std::nullopt;
      if (!sample || *sample > std::numeric_limits<std::uint32_t>::max()) {
        complain("follows something that is not the number of a sample");
        return;
      }
      out.samples.push_back(static_cast<std::uint32_t>(*sample));
    }
  }

  std::string fault_;
};

}  // namespace

json to_json(const Annotations& annotations) {
  json out = json::array();
  for (const Annotation& annotation : annotations) out.push_back(to_json(annotation));
  return out;
}

Expected<Annotations> annotations_from(JsonView value) {
  const auto bad = [](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), {}, 0, 0});
  };
  if (!value.is_list()) return bad("the annotations are not a list");
  Annotations out;
  Reader reader;
  for (const JsonView element : value.elements()) {
    auto annotation = reader.read(element);
    if (!reader.fault().empty()) return bad(reader.fault());
    if (!annotation) continue;
    if (out.size() == kMostAnnotations) return bad(fmt::format("more than {} annotations", kMostAnnotations));
    out.push_back(std::move(*annotation));
  }
  return out;
}

}  // namespace mes
