// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_layers.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/geometry/coordinate_range.h"
#include "core/io/session/json_color.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestLayerWord = 200;
constexpr std::size_t kLongestPath = 4096;

json style_to_json(const LayerStyle& style) {
  json out = {{"color", hexadecimal(style.color)}, {"opacity", style.opacity}, {"point_size", style.point_size_px},
              {"line_width", style.line_width_px}, {"dashed", style.dashed},   {"flat", style.flat}};
  if (!style.color_map.empty()) out["color_map"] = style.color_map;
  if (style.range_locked) out["range_locked"] = true;
  if (!style.thin_when_dense) out["thin_when_dense"] = false;
  if (style.range_low != 0.0 || style.range_high != 1.0) out["range"] = {style.range_low, style.range_high};
  return out;
}

constexpr double kAny = std::numeric_limits<double>::max();

/// Reads one object; the first value of the wrong kind is the fault.
class LayerReader {
 public:
  LayerReader(JsonView object, std::string where, std::string& fault)
      : object_(object), where_(std::move(where)), fault_(fault) {
    if (!object.is_object()) complain("not an object");
  }

  JsonView find(const char* key) const { return object_.find(key); }
  void number(const char* key, double low, double high, double& out) {
    if (const JsonView value = find(key)) to_number(value, key, low, high, out);
  }
  void to_number(JsonView value, const char* key, double low, double high, double& out) {
    if (!value.is_number())
      complain(fmt::format("\"{}\" is not a number", key));
    else
      out = std::clamp(value.number(), low, high);
  }
  void flag(const char* key, bool& out) {
    const JsonView value = find(key);
    if (!value) return;
    if (!value.is_flag())
      complain(fmt::format("\"{}\" is neither true nor false", key));
    else
      out = value.flag();
  }
  void text(const char* key, std::size_t longest, std::string& out) {
    const JsonView value = find(key);
    if (!value) return;
    std::string text = value.is_text() && value.text_length() <= 6 * longest ? value.text() : std::string();
    if (!value.is_text())
      complain(fmt::format("\"{}\" is not a text", key));
    else if (value.text_length() > 6 * longest || text.size() > longest)
      complain(fmt::format("\"{}\" is longer than {} bytes", key, longest));
    else
      out = std::move(text);
  }
  void numbers(const char* key, double& first, double& second) {
    const JsonView value = find(key);
    if (!value) return;
    if (value.size() != 2) {
      complain(fmt::format("\"{}\" is not two numbers", key));
      return;
    }
    auto element = value.elements().begin();
    to_number(*element, key, -kAny, kAny, first);
    to_number(*++element, key, -kAny, kAny, second);
  }
  /// Clamps coordinates into the range of the plane.
  void coordinates(std::initializer_list<double> numbers) {
    for (const double x : numbers)
      if (const auto fault = range_fault_of(x)) complain(describe(*fault, x));
  }
  void color(const char* key, Rgb& out) {
    std::string word = hexadecimal(out);
    text(key, kLongestLayerWord, word);
    if (const auto color = color_from(word))
      out = *color;
    else
      complain("a colour is #RRGGBB, not " + in_quotes(word));
  }
  void complain(const std::string& what) {
    if (fault_.empty()) fault_ = where_ + ": " + what;
  }

 private:
  JsonView object_;
  std::string where_;
  std::string& fault_;
};

LayerStyle style_from(JsonView object, LayerStyle out, const std::string& where, std::string& fault) {
  LayerReader reader(object, where, fault);
  reader.color("color", out.color);
  reader.number("opacity", 0.0, 1.0, out.opacity);
  reader.number("point_size", 0.5, 64.0, out.point_size_px);
  reader.number("line_width", 0.1, 64.0, out.line_width_px);
  reader.flag("dashed", out.dashed);
  reader.flag("flat", out.flat);
  reader.text("color_map", kLongestLayerWord, out.color_map);
  reader.flag("range_locked", out.range_locked);
  reader.flag("thin_when_dense", out.thin_when_dense);
  reader.numbers("range", out.range_low, out.range_high);
  out.range_high = std::max(out.range_low, out.range_high);
  return out;
}

}  // namespace

json to_json(const LayerConfiguration& configuration) {
  json layers = json::array();
  for (const LayerConfiguration::Entry& entry : configuration.layers)
    layers.push_back({{"layer", entry.layer}, {"visible", entry.visible}, {"style", style_to_json(entry.style)}});
  json out = {{"layers", std::move(layers)}};
  if (const BackgroundImage& image = configuration.image; image != BackgroundImage{})
    out["image"] = {{"file", image.file},
                    {"center", {image.center.x, image.center.y}},
                    {"width", image.width},
                    {"upright", image.is_upright}};
  return out;
}

Expected<LayerConfiguration> layer_configuration_from(JsonView value, const LayerStyleSource& style_of) {
  LayerConfiguration out;
  std::string fault;
  LayerReader reader(value, "the layers", fault);
  const JsonView layers = reader.find("layers");
  if (layers && !layers.is_list()) reader.complain("\"layers\" is not a list");
  std::size_t number = 0;
  for (const JsonView object : layers.elements()) {
    if (number == kMostLayers) reader.complain(fmt::format("more than {}", kMostLayers));
    if (!fault.empty()) break;
    LayerConfiguration::Entry entry;
    LayerReader part(object, fmt::format("layer {}", ++number), fault);
    part.text("layer", kLongestLayerWord, entry.layer);
    part.flag("visible", entry.visible);
    entry.style = style_of(entry.layer);
    if (const JsonView style = part.find("style"))
      entry.style = style_from(style, entry.style, "layer " + printable(entry.layer), fault);
    if (!entry.layer.empty()) out.layers.push_back(std::move(entry));
  }
  if (const JsonView image = reader.find("image")) {
    LayerReader part(image, "the traced picture", fault);
    part.text("file", kLongestPath, out.image.file);
    part.numbers("center", out.image.center.x, out.image.center.y);
    part.number("width", 0.0, kAny, out.image.width);
    out.image.is_upright = false;  // the behaviour of earlier versions
    part.flag("upright", out.image.is_upright);
    part.coordinates({out.image.center.x, out.image.center.y, out.image.width});
  }
  if (!fault.empty()) return std::unexpected(Error{ErrorCode::bad_input, fault});
  return out;
}

}  // namespace mes
