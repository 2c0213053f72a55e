// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/style_request.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "app/cli/console/messages.h"
#include "app/cli/requests/names.h"
#include "app/cli/requests/picture.h"
#include "app/export/page_size.h"
#include "core/graph/registry.h"
#include "core/io/text/text_numbers.h"
#include "render/figure/figure.h"

namespace mes::cli {
namespace {

constexpr std::array<std::string_view, 9> kKeys{"color", "opacity",   "point-size", "line-width",     "dashed",
                                                "flat",  "color-map", "range",      "thin-when-dense"};

/// One KEY=VALUE for one layer.
class Setting {
 public:
  Setting(std::string_view key, std::string_view value, std::span<const std::string> maps, double scale)
      : key_(key), value_(value), maps_(maps), scale_(scale) {}

  Expected<void> apply(const LayerDescriptor& layer, LayerStyle& style) const {
    if (key_ == "color") return color(style);
    if (key_ == "opacity") return number(style.opacity, 0.0, 1.0);
    if (key_ == "point-size") return pixels(style.point_size_px, 0.5, 64.0);
    if (key_ == "line-width") return pixels(style.line_width_px, 0.1, 64.0);
    if (key_ == "dashed") return flag(style.dashed);
    if (key_ == "flat") return flag(style.flat);
    if (key_ == "thin-when-dense") return flag(style.thin_when_dense);
    if (key_ == "color-map") return color_map(layer, style);
    if (key_ == "range") return range(style);
    return usage_error(
        fmt::format("unknown style key {}; did you mean {}?", in_quotes(key_), one_of(nearest_names(key_, kKeys))));
  }

 private:
  std::unexpected<Error> fail(const std::string& expected) const {
    return usage_error(fmt::format("{} expects {}, not {}", key_, expected, in_quotes(value_)));
  }
  Expected<void> color(LayerStyle& style) const {
    const auto value = parse_rgb(value_);
    if (!value) return fail("RRGGBB");
    style.color = *value;
    return {};
  }
  Expected<void> number(double& out, double low, double high) const {
    const auto value = parse_number(value_);
    if (!value || *value < low || *value > high) {
      std::string text = "a number from ";
      append_number(text, low);
      text += " to ";
      append_number(text, high);
      return fail(text);
    }
    out = *value;
    return {};
  }
  /// Reads a length in pixels; with a unit it is a length on paper, where a pixel is 1/96 inch.
  Expected<void> pixels(double& out, double low, double high) const {
    const auto points = parse_length(value_);
    if (!points) return number(out, low, high);
    const double value = *points / figure::kPointsPerPixel;
    if (value < low || value > high) {
      std::string text = "a length from ";
      append_number(text, low);
      text += "px to ";
      append_number(text, high);
      return fail(text + "px");
    }
    out = value / scale_;
    return {};
  }
  Expected<void> flag(bool& out) const {
    if (value_ != "on" && value_ != "off") return fail("on or off");
    out = value_ == "on";
    return {};
  }
  Expected<void> color_map(const LayerDescriptor& layer, LayerStyle& style) const {
    if (value_ != "none" && layer.scalar.empty())
      return usage_error(fmt::format("layer {} has no number that a colour map could show", layer.id));
    if (value_ != "none" && std::ranges::find(maps_, value_) == maps_.end()) {
      const std::vector<std::string_view> names(maps_.begin(), maps_.end());
      return usage_error(fmt::format("unknown colour map {}; did you mean {}?", in_quotes(value_),
                                     one_of(nearest_names(value_, names))));
    }
    style.color_map = value_ == "none" ? std::string() : std::string(value_);
    return {};
  }
  Expected<void> range(LayerStyle& style) const {
    style.range_locked = value_ != "fit";
    if (!style.range_locked) return {};
    const std::size_t colon = value_.find(':');
    if (colon == std::string_view::npos) return fail("LOW:HIGH or fit");
    const auto low = parse_number(value_.substr(0, colon));
    const auto high = parse_number(value_.substr(colon + 1));
    if (!low || !high || *low > *high) return fail("LOW:HIGH, two numbers in this order, or fit");
    style.range_low = *low;
    style.range_high = *high;
    return {};
  }

  std::string_view key_;
  std::string_view value_;
  std::span<const std::string> maps_;
  double scale_;
};

}  // namespace

std::string style_keys() {
  std::string out;
  for (const std::string_view key : kKeys) out += (out.empty() ? "" : ", ") + std::string(key);
  return out;
}

Expected<std::vector<LayerStyle>> changed_styles(const Registry& registry, std::vector<LayerStyle> styles,
                                                 std::span<const std::string> requests,
                                                 std::span<const VariantLayer> drawn,
                                                 std::span<const std::string> color_maps, double scale) {
  std::vector<LayerIndex> sized;  // their size was requested, so it is kept where samples are dense
  std::vector<LayerIndex> told;   // the request says whether to keep it
  for (const std::string& request : requests) {
    const std::size_t colon = request.find(':');
    if (colon == std::string::npos)
      return usage_error("--set-style expects LAYER:KEY=VALUE[,KEY=VALUE...], not " + in_quotes(request));
    const auto layer = select_layer(registry, request.substr(0, colon));
    if (!layer) return std::unexpected(layer.error());
    const LayerDescriptor& descriptor = registry.layers()[*layer];
    if (std::ranges::find(drawn, VariantLayer(*layer)) == drawn.end())
      return usage_error(fmt::format("--set-style is given for {}, which is not drawn", descriptor.id));
    std::string_view rest = std::string_view(request).substr(colon + 1);
    while (true) {
      const std::string_view setting = rest.substr(0, rest.find(','));
      const std::size_t equals = setting.find('=');
      if (equals == std::string_view::npos)
        return usage_error("--set-style expects KEY=VALUE, not " + in_quotes(setting));
      const std::string_view key = setting.substr(0, equals);
      const auto good = Setting(key, setting.substr(equals + 1), color_maps, scale).apply(descriptor, styles[*layer]);
      if (!good) return std::unexpected(good.error());
      if (key == "point-size" || key == "line-width") sized.push_back(*layer);
      if (key == "thin-when-dense") told.push_back(*layer);
      if (setting.size() == rest.size()) break;
      rest.remove_prefix(setting.size() + 1);
    }
  }
  for (const LayerIndex layer : sized)
    if (std::ranges::find(told, layer) == told.end()) styles[layer].thin_when_dense = false;
  return styles;
}

}  // namespace mes::cli
