// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_annotations.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "core/io/session/json_color.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> role_names() {
  return {"itself", "origin", "product"};
}

json annotation_to_json(const Annotation& annotation) {
  json at = json::array();
  json follows = json::array();
  json balls = json::array();
  json along = json::array();
  json scales = json::array();
  bool follows_any = false;
  bool follows_balls = false;
  bool is_along = false;
  bool is_scaled = false;
  for (const Anchor& anchor : annotation.anchors) {
    at.push_back(anchor.at.x);
    at.push_back(anchor.at.y);
    follows.push_back(anchor.samples);
    balls.push_back(anchor.balls);
    along.push_back(anchor.along);
    scales.push_back(anchor.scale);
    follows_any = follows_any || !anchor.samples.empty();
    follows_balls = follows_balls || !anchor.balls.empty();
    is_along = is_along || anchor.along != 0.0;
    is_scaled = is_scaled || anchor.scale != 1.0;
  }
  json out = {{"kind", id_of(annotation.kind)}, {"at", std::move(at)}};
  if (follows_any) out["follows"] = std::move(follows);
  if (follows_balls) out["balls"] = std::move(balls);
  if (is_along) out["along"] = std::move(along);
  if (is_scaled) out["scales"] = std::move(scales);
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

/// Reads one annotation; keeps the first fault.
class AnnotationReader {
 public:
  /// Nothing after a fault, such as an unknown kind.
  std::optional<Annotation> read(JsonView object) {
    if (!object.is_object()) return complain("is not an object");
    const auto [kind, at, follows, balls, along, scales, text, shift, letters, color, elements] = object.pick<11>(
        {"kind", "at", "follows", "balls", "along", "scales", "text", "shift", "letters", "color", "elements"});
    if (!kind.is_text()) return complain("does not say its kind");
    const auto known = kind.text_length() < kLongName ? annotation_kind_of(kind.text()) : std::nullopt;
    if (!known) return refuse_unknown("of the kind", kind);
    Annotation out{.kind = *known};
    if (out.kind == AnnotationKind::highlight && !read_elements(elements, out)) return std::nullopt;
    read_places(at, out);
    read_followed(follows, "follows", 3, &Anchor::samples, out);
    read_followed(balls, "balls", 4, &Anchor::balls, out);
    read_numbers(along, "along", &Anchor::along, out);
    read_numbers(scales, "scales", &Anchor::scale, out);
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
    constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
    if (const std::string fault = fault_of(out, {kAny, kAny}); !fault.empty()) {
      fault_ = fault;
      return std::nullopt;
    }
    return out;
  }
  const std::string& fault() const { return fault_; }

 private:
  static constexpr std::size_t kLongName = 100;

  std::nullopt_t complain(std::string_view what) {
    if (fault_.empty()) fault_ = "an annotation " + std::string(what);
    return std::nullopt;
  }
  /// The fault of an unknown name.
  std::nullopt_t refuse_unknown(std::string_view what, JsonView name) {
    const std::string named = name.text_length() < kLongName ? ' ' + in_quotes(name.text()) : std::string();
    return complain(fmt::format(
        "{}{}, which this version of the program does not know: it is misspelled, or of a later one", what, named));
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
  /// False after a fault, such as an unknown kind or role.
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
    if (kind == kAllPrimitiveKinds.end()) return refuse_unknown("has an element of the kind", part[0]);
    if (role == kRoles.end()) return refuse_unknown("has an element of the role", part[1]);
    return HighlightedElement{*kind, static_cast<ProvenanceRole>(role - kRoles.begin()),
                              list.size() == 3 ? part[2].number() + 0.0 : 0.0};
  }
  void read_places(JsonView at, Annotation& out) {
    const std::size_t count = anchor_count(out);
    if (!at.is_list() || at.size() != 2 * count) {
      complain(fmt::format("of the kind {} has no {} numbers in \"at\"", id_of(out.kind), 2 * count));
      return;
    }
    out.anchors.resize(count);
    auto number = at.elements().begin();
    for (Anchor& anchor : out.anchors) {
      // Avoids negative zeros: annotations are compared by their bytes.
      for (double* const to : {&anchor.at.x, &anchor.at.y}) {
        *to = number_of(*number) + 0.0;
        ++number;
      }
    }
  }
  /// Reads `key`, a list for each anchor, of at most `most` numbers.
  void read_followed(JsonView value, std::string_view key, std::size_t most, std::vector<std::uint32_t> Anchor::*to,
                     Annotation& out) {
    if (!value) return;
    if (!value.is_list() || value.size() != out.anchors.size()) {
      complain(fmt::format("has a \"{}\" without a list for each place", key));
      return;
    }
    std::size_t i = 0;
    for (const JsonView list : value.elements()) {
      std::vector<std::uint32_t>& numbers = out.anchors[i++].*to;
      if (!list.is_list() || list.size() > most) {
        complain(fmt::format("has something in \"{}\" that is not a list of up to {} numbers", key, most));
        return;
      }
      for (const JsonView element : list.elements()) {
        const auto number = element.is_number() ? element.count() : std::nullopt;
        if (!number || *number > std::numeric_limits<std::uint32_t>::max()) {
          complain(fmt::format("has something in \"{}\" that is not the number of a {}", key,
                               key == "balls" ? "ball" : "sample"));
          return;
        }
        numbers.push_back(static_cast<std::uint32_t>(*number));
      }
    }
  }
  /// Reads `key`, a number for each anchor.
  void read_numbers(JsonView value, std::string_view key, double Anchor::*to, Annotation& out) {
    if (!value) return;
    if (!value.is_list() || value.size() != out.anchors.size()) {
      complain(fmt::format("has a \"{}\" without a number for each place", key));
      return;
    }
    std::size_t i = 0;
    for (const JsonView number : value.elements()) out.anchors[i++].*to = number_of(number) + 0.0;
  }

  std::string fault_;
};

}  // namespace

json to_json(const Annotations& annotations) {
  json out = json::array();
  for (const Annotation& annotation : annotations) out.push_back(annotation_to_json(annotation));
  return out;
}

std::uint64_t schema_of(const Annotations& annotations) {
  constexpr std::uint64_t kOfCenterLines = 4;
  if (std::ranges::find(annotations, AnnotationKind::center_line, &Annotation::kind) != annotations.end())
    return kOfCenterLines;
  const auto is_later = [](const Annotation& annotation) {
    return annotation.kind == AnnotationKind::highlight ||
           std::ranges::any_of(annotation.anchors, [](const Anchor& anchor) { return !anchor.balls.empty(); });
  };
  return std::ranges::any_of(annotations, is_later) ? 2 : 1;
}

Expected<Annotations> annotations_from(JsonView value) {
  const auto bad = [](std::string text) {
    return std::unexpected(Error{ErrorCode::bad_input, std::move(text), {}, 0, 0});
  };
  if (!value.is_list()) return bad("the annotations are not a list");
  Annotations out;
  AnnotationReader reader;
  for (const JsonView element : value.elements()) {
    auto annotation = reader.read(element);
    if (!reader.fault().empty()) return bad(reader.fault());
    if (out.size() == kMostAnnotations) return bad(fmt::format("more than {} annotations", kMostAnnotations));
    out.push_back(std::move(*annotation));
  }
  return out;
}

}  // namespace mes
