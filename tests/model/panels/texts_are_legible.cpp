// SPDX-License-Identifier: GPL-3.0-or-later
// Texts and icons stand out from what they are drawn on, by the contrast ratio of WCAG 2.2.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "app/picture/paper/canvas_look.h"
#include "app/ui/screen/theme.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

using Channels = std::array<double, 3>;

Channels channels_of(ImU32 color) {
  const ImVec4 parts = ImGui::ColorConvertU32ToFloat4(color);
  return {static_cast<double>(parts.x), static_cast<double>(parts.y), static_cast<double>(parts.z)};
}

double alpha_of(ImU32 color) {
  return static_cast<double>(ImGui::ColorConvertU32ToFloat4(color).w);
}

Channels laid_over(ImU32 color, double alpha, const Channels& below) {
  Channels out = channels_of(color);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = alpha * out[i] + (1.0 - alpha) * below[i];
  return out;
}

// https://www.w3.org/TR/WCAG22/#dfn-relative-luminance
double luminance_of(const Channels& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

double contrast(const Channels& a, const Channels& b) {
  const auto [dark, light] = std::minmax({luminance_of(a), luminance_of(b)});
  return (light + 0.05) / (dark + 0.05);
}

struct Ground {
  std::string name;
  Channels color;
};

struct Looks {
  std::string name;
  ThemeColors colors;
};

std::vector<Looks> all_looks() {
  std::vector<Looks> out;
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const bool for_projector : {false, true})
      out.push_back({std::string(theme == Theme::dark ? "dark" : "light") + (for_projector ? ", projector" : ""),
                     theme_colors(theme, for_projector)});
  return out;
}

// Panels and popups, plain and with a row of theirs under the pointer.
std::vector<Ground> pages(const ThemeColors& theme) {
  std::vector<Ground> out;
  for (const auto& [name, color] : {std::pair{"panel", theme.panel}, std::pair{"popup", theme.raised}}) {
    const Channels below = channels_of(color);
    out.push_back({name, below});
    out.push_back({std::string("pointed row of a ") + name,
                   laid_over(theme.accent_faint, alpha_of(theme.accent_faint), below)});
  }
  return out;
}

// The same, and the chosen rows there.
std::vector<Ground> pages_and_choices(const ThemeColors& theme) {
  std::vector<Ground> out = pages(theme);
  for (const auto& [name, color] : {std::pair{"panel", theme.panel}, std::pair{"popup", theme.raised}})
    out.push_back({std::string("chosen row of a ") + name,
                   laid_over(theme.accent_soft, alpha_of(theme.accent_soft), channels_of(color))});
  return out;
}

void add(std::vector<Ground>& grounds, const std::string& name, ImU32 color) {
  grounds.push_back({name, channels_of(color)});
}

void expect(const std::string& look, const std::string& style, ImU32 color, const std::vector<Ground>& grounds,
            double least) {
  for (const Ground& ground : grounds) {
    INFO(look << ": " << style << " on " << ground.name);
    CHECK(contrast(channels_of(color), ground.color) >= least);
  }
}

constexpr double kText = 4.5;
constexpr double kIcon = 3.0;

}  // namespace

TEST_CASE("the contrast ratio is that of the standard") {
  CHECK(contrast({1, 1, 1}, {0, 0, 0}) == Approx(21.0));
  CHECK(contrast({1, 1, 1}, {1, 1, 1}) == Approx(1.0));
  // #777777 on white is the well-known grey that just fails.
  const double grey = 0x77 / 255.0;
  CHECK(contrast({grey, grey, grey}, {1, 1, 1}) == Approx(4.48).margin(0.005));
}

TEST_CASE("texts of the panels are legible in every theme") {
  for (const auto& [name, theme] : all_looks()) {
    std::vector<Ground> controls = pages_and_choices(theme);
    add(controls, "a field", theme.field);
    add(controls, "a field under the pointer", theme.field_hovered);
    std::vector<Ground> buttons = controls;
    add(buttons, "a button", theme.button);
    add(buttons, "a button under the pointer", theme.button_hovered);
    std::vector<Ground> everything = buttons;
    add(everything, "a field in use", theme.field_active);
    add(everything, "a button that is held", theme.button_active);
    add(everything, "a message", theme.warning_soft);
    std::vector<Ground> messages = controls;
    add(messages, "a message", theme.warning_soft);
    expect(name, "text", theme.text, everything, kText);
    expect(name, "quiet text", theme.text_quiet, buttons, kText);
    expect(name, "faint text", theme.text_faint, pages(theme), kText);
    expect(name, "accent", theme.accent, buttons, kText);
    expect(name, "warning", theme.warning, messages, kText);
  }
}

TEST_CASE("icons and lights are seen in every theme, and so is what cannot be used now") {
  for (const auto& [name, theme] : all_looks()) {
    const std::vector<Ground> grounds = pages(theme);
    for (const auto& [icon, color] : {std::pair{"recording", theme.recording}, std::pair{"good", theme.good},
                                      std::pair{"doubtful", theme.doubtful}, std::pair{"wrong", theme.wrong}})
      expect(name, icon, color, {{"panel", channels_of(theme.panel)}, {"popup", channels_of(theme.raised)}}, kIcon);
    // The icon of the chosen tool has the colour of the panel.
    CHECK(contrast(channels_of(theme.panel), channels_of(theme.accent)) >= kIcon);
    ImGuiStyle style;
    apply_theme(style, theme, 1.0F);
    for (const Ground& ground : grounds) {
      INFO(name << ": disabled on " << ground.name);
      const auto alpha = static_cast<double>(style.DisabledAlpha);
      CHECK(contrast(laid_over(theme.text, alpha, ground.color), ground.color) >= kIcon);
    }
  }
}

// Sliders print no text on their grips: the number has a field of its own.
TEST_CASE("grips of sliders and rims of boxes are seen in every theme") {
  for (const auto& [name, theme] : all_looks()) {
    std::vector<Ground> rails;
    add(rails, "the rail of a slider", theme.field);
    add(rails, "the rail of a slider under the pointer", theme.field_hovered);
    expect(name, "grip", theme.grab, rails, kIcon);
    add(rails, "the rail of a slider in use", theme.field_active);
    expect(name, "grip that is held", theme.grab_active, rails, kIcon);
    // The rim of a check box or a radio button has the colour of quiet text.
    expect(name, "rim", theme.text_quiet, pages(theme), kIcon);
  }
}

// Their track is what they lie on: a panel, a popup or a field of several lines.
TEST_CASE("grips of scroll bars are seen in every theme, and stand out more while they are held") {
  for (const auto& [name, theme] : all_looks()) {
    std::vector<Ground> tracks{{"panel", channels_of(theme.panel)}, {"popup", channels_of(theme.raised)}};
    add(tracks, "a field", theme.field);
    ImGuiStyle style;
    apply_theme(style, theme, 1.0F);
    CHECK(style.Colors[ImGuiCol_ScrollbarBg].w == 0.0F);
    double before = 0.0;
    for (const auto& [grip, at] : {std::pair{"scroll bar", ImGuiCol_ScrollbarGrab},
                                   std::pair{"scroll bar under the pointer", ImGuiCol_ScrollbarGrabHovered},
                                   std::pair{"scroll bar that is held", ImGuiCol_ScrollbarGrabActive}}) {
      const ImU32 color = ImGui::ColorConvertFloat4ToU32(style.Colors[at]);
      CHECK(alpha_of(color) == 1.0);
      expect(name, grip, color, tracks, kIcon);
      const double now = contrast(channels_of(color), channels_of(theme.panel));
      CHECK(now > before);
      before = now;
    }
  }
}

TEST_CASE("hints on the empty canvas are legible on every canvas that is offered") {
  for (const Rgb canvas : {kWhiteCanvas, kLightGreyCanvas, kDarkCanvas, kBlackCanvas})
    CHECK(contrast(channels_of(to_imgui(mark_color(canvas))), channels_of(to_imgui(canvas))) >= kText);
}

TEST_CASE("the sample of a layer's style has an outline where its colour is not seen by itself") {
  int with_outline = 0;
  int without_outline = 0;
  for (const auto& [name, theme] : all_looks())
    for (const Rgb canvas : {kWhiteCanvas, kLightGreyCanvas, kDarkCanvas, kBlackCanvas})
      for (const LayerDescriptor& layer : layer_descriptors()) {
        INFO(name << ": " << layer.id);
        const LayerStyle style = drawn_on(layer.style, canvas);
        const Channels below = channels_of(to_imgui(canvas));
        const Channels panel = channels_of(theme.panel);
        const Channels seen = laid_over(to_imgui(style.color), style.opacity, below);
        const double least = std::min(contrast(seen, below), contrast(seen, panel));
        // The colours on the screen are rounded to 8 bits.
        constexpr double kRounding = 0.05;
        const bool outline = is_faint(style.color, style.opacity, canvas, to_rgb(theme.panel));
        if (least < kIcon - kRounding) CHECK(outline);
        if (least > kIcon + kRounding) CHECK_FALSE(outline);
        (outline ? with_outline : without_outline) += 1;
      }
  CHECK(with_outline > 0);
  CHECK(without_outline > 0);
  // The pale grey edges that cannot be told from a light panel.
  CHECK(is_faint(palette::grey, 0.6, kWhiteCanvas, to_rgb(theme_colors(Theme::light, false).panel)));
}
