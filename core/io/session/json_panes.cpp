// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_panes.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/geometry/coordinate_range.h"
#include "core/io/session/json_layers.h"

namespace mes {
namespace {

using nlohmann::json;

// In the order of `FamilyKind`.
constexpr std::array<std::string_view, 3> kFamilies{"inner", "polar", "own"};
constexpr std::size_t kLongestPaneWord = 1000;

json pane_to_json(Precision precision) {
  return {{"precision", id_of(precision)}};
}
json pane_to_json(const ParameterChoice& choice) {
  return {{"parameter", choice.parameter.id}, {"value", choice.value}};
}
json pane_to_json(FamilyKind family) {
  return {{"family", kFamilies[static_cast<std::size_t>(family)]}};
}
json pane_to_json(const Bundle& bundle) {
  json object = to_json(bundle.layers);
  object["name"] = bundle.name;
  return {{"bundle", std::move(object)}};
}
json pane_to_json(const EvolvedChoice& evolved) {
  return {{"step", std::min(evolved.step, kMostPaneStep)}};
}
json pane_to_json(const BeforeLastEdit& /*choice*/) {
  return {{"before_last_edit", true}};
}

/// Reads one pane of a list; nothing for an unknown kind. Throws `PaneFault`.
class PaneReader {
 public:
  explicit PaneReader(std::size_t number) : where_(fmt::format("pane {}", number)) {}

  std::optional<PaneChoice> read(JsonView pane) const {
    if (!pane.is_object()) fail("not an object", pane);
    const auto [precision, parameter, value, family, bundle, step, before] =
        pane.pick<7>({"precision", "parameter", "value", "family", "bundle", "step", "before_last_edit"});
    if (precision) return precision_of(precision);
    if (parameter) return parameter_of(parameter, value ? value : pane);
    if (family) return family_of(family);
    if (bundle) return bundle_of(bundle);
    if (step) return step_of(step);
    if (before) return BeforeLastEdit{};
    return std::nullopt;
  }

  /// Nothing if the pane has no view of its own; an empty box (no corners) shows everything.
  std::optional<Box2> read_view(JsonView pane) const {
    const JsonView view = pane.find("view");
    if (!view) return std::nullopt;
    if (!view.is_list() || (view.size() != 0 && view.size() != 4)) fail("\"view\" is not two corners", view);
    Box2 out;
    std::optional<double> x;
    for (const JsonView number : view.elements()) {
      if (!number.is_number()) fail("\"view\" has something that is not a number", number);
      if (const auto fault = range_fault_of(number.number()))
        fail("\"view\": " + describe(*fault, number.number()), number);
      if (x)
        out.add(Vec2{*std::exchange(x, std::nullopt), number.number()});
      else
        x = number.number();
    }
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& text, JsonView at) const { throw PaneFault{where_ + ": " + text, at}; }
  std::string text_of(JsonView value, const char* key) const {
    // An escaped letter takes at most six bytes.
    if (!value.is_text() || value.text_length() > 6 * kLongestPaneWord)
      fail(fmt::format("\"{}\" is not a short text", key), value);
    std::string out = value.text();
    if (out.size() > kLongestPaneWord) fail(fmt::format("\"{}\" is not a short text", key), value);
    return out;
  }

  std::optional<PaneChoice> precision_of(JsonView value) const {
    const std::string id = text_of(value, "precision");
    for (const PrecisionDescriptor& descriptor : kPrecisionDescriptors)
      if (descriptor.id == id) return descriptor.precision;
    return std::nullopt;
  }
  std::optional<PaneChoice> parameter_of(JsonView name, JsonView value) const {
    const std::string id = text_of(name, "parameter");
    if (!value.is_number()) fail("\"value\" is not a number", value);
    const auto known = std::ranges::find(computation_parameters(), id, &Parameter::id);
    if (known != computation_parameters().end()) return ParameterChoice{*known, within(*known, value.number())};
    // An unknown parameter has no effect, but is written again when the session is saved.
    constexpr double kAnything = std::numeric_limits<double>::infinity();
    return ParameterChoice{{.id = id, .low = -kAnything, .high = kAnything}, value.number()};
  }
  std::optional<PaneChoice> family_of(JsonView value) const {
    const std::string id = text_of(value, "family");
    const auto found = std::ranges::find(kFamilies, id);
    if (found == kFamilies.end()) return std::nullopt;
    return static_cast<FamilyKind>(found - kFamilies.begin());
  }
  std::optional<PaneChoice> bundle_of(JsonView object) const {
    if (!object.is_object()) fail("\"bundle\" is not an object", object);
    Bundle out{.name = text_of(object.find("name"), "name")};
    auto layers = layer_configuration_from(object);
    if (!layers) fail(layers.error().text, object);
    out.layers = std::move(*layers);
    return out;
  }
  std::optional<PaneChoice> step_of(JsonView value) const {
    const auto step = value.is_number() ? value.count() : std::nullopt;
    if (!step || *step > kMostPaneStep)
      fail(fmt::format("\"step\" is not a whole number of at most {}", kMostPaneStep), value);
    return EvolvedChoice{*step};
  }

  std::string where_;
};

}  // namespace

json panes_to_json(std::span<const PaneChoice> panes, std::span<const Box2> views) {
  json out = json::array();
  for (std::size_t i = 0; i < panes.size(); ++i) {
    json object = std::visit([](const auto& choice) { return pane_to_json(choice); }, panes[i]);
    if (i < views.size()) {
      object["view"] = json::array();
      if (const Box2& box = views[i]; !box.is_empty())
        object["view"] = {box.low.x, box.low.y, box.high.x, box.high.y};
    }
    out.push_back(std::move(object));
  }
  return out;
}

std::expected<ReadPanes, PaneFault> panes_from(JsonView list) try {
  if (!list.is_list()) return std::unexpected(PaneFault{"panes: not a list", list});
  if (list.size() > kMostPanesBeside)
    return std::unexpected(PaneFault{fmt::format("panes: {}, more than {}", list.size(), kMostPanesBeside), list});
  ReadPanes out;
  std::size_t number = 0;
  bool has_views = false;
  for (const JsonView pane : list.elements()) {
    const PaneReader reader(++number);
    auto choice = reader.read(pane);
    if (!choice) continue;
    const std::optional<Box2> view = reader.read_view(pane);
    has_views = has_views || view;
    out.views.push_back(view.value_or(Box2{}));
    out.panes.push_back(std::move(*choice));
  }
  if (!has_views) out.views.clear();
  return out;
} catch (const PaneFault& fault) {
  return std::unexpected(fault);
}

}  // namespace mes
