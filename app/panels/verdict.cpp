// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/verdict.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/ui/theme.h"
#include "app/ui/widgets.h"
#include "core/engine/theorem_light.h"

namespace mes {
namespace {

struct LightLook {
  ImU32 color;
  const char* word;
  const char* meaning;
};

LightLook look_of(const ThemeColors& colors, TheoremLight light) {
  switch (light) {
    case TheoremLight::green:
      return {
          colors.good, "Proved",
          "The one-step axis is the medial axis of the union of the inner balls: proved exactly for these samples"};
    case TheoremLight::yellow:
      return {colors.doubtful, "In doubt",
              "Computed exactly, but the samples are not dense enough everywhere. Click for the places"};
    case TheoremLight::red:
      return {colors.wrong, "Wrong", "The chosen number type gave a wrong or inconsistent result. Click to see what"};
    case TheoremLight::none: break;
  }
  return {colors.border, "Open", "There is nothing inside to judge"};
}

LightLook look_of(const Verdict& verdict) {
  const TheoremLight light = light_of(verdict.picture.nodes());
  if (light == TheoremLight::none && verdict.picture.lacks_memory()) {
    return {verdict.gui.colors().warning, "No memory",
            "Nothing can be said: there is not enough memory. Undo, hide layers or open a smaller file"};
  }
  return look_of(verdict.gui.colors(), light);
}

constexpr float kChoiceWidth = 118;
constexpr float kLightWidth = 92;

void draw_choice(const Verdict& verdict) {
  const float unit = verdict.gui.unit();
  const PrecisionDescriptor& now = kPrecisionDescriptors[static_cast<std::size_t>(verdict.computation.precision)];
  ImGui::SetNextItemWidth(kChoiceWidth * unit);
  if (ImGui::BeginCombo("##precision", now.name.data(), ImGuiComboFlags_HeightLarge)) {
    for (std::size_t i = 0; i < kPrecisions; ++i) {
      const PrecisionDescriptor& descriptor = kPrecisionDescriptors[i];
      const auto id = static_cast<ActionId>(static_cast<std::size_t>(ActionId::precision_naive) + i);
      if (ImGui::Selectable(descriptor.name.data(), descriptor.precision == now.precision)) verdict.actions.run(id);
      tooltip(verdict.gui, std::string(descriptor.explanation));
    }
    ImGui::EndCombo();
  } else {
    tooltip(verdict.gui, "Number type: " + std::string(now.explanation));
  }
}

// A square around the place, a twenty-fifth of the data wide.
void show_place(const Verdict& verdict, Vec2 place) {
  const Box2 box = verdict.document.bounding_box();
  const double half = 0.02 * std::max({box.width(), box.height(), 1e-300});
  verdict.canvas.view().fit({{place.x - half, place.y - half}, {place.x + half, place.y + half}}, 0.0);
}

void draw_reasons(const Verdict& verdict) {
  const float unit = verdict.gui.unit();
  static constexpr float kWidth = 380;
  bool any = false;
  for (const NodeReport& node : verdict.picture.nodes()) {
    if (node.state == NodeState::failed) {
      any = true;
      ImGui::PushTextWrapPos(kWidth * unit);
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(verdict.gui.colors().warning), "%s failed: %s",
                         node.structure.c_str(), node.reason.c_str());
      ImGui::PopTextWrapPos();
    }
    for (std::size_t i = 0; i < node.findings.size(); ++i) {
      const Finding& finding = node.findings[i];
      any = true;
      ImGui::PushID(node.structure.c_str());
      ImGui::PushID(static_cast<int>(i));
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const TheoremLight light = finding.level == FindingLevel::wrong ? TheoremLight::red : TheoremLight::yellow;
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 5 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()},
                                                  4 * unit, look_of(verdict.gui.colors(), light).color);
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
      ImGui::PushTextWrapPos(kWidth * unit);
      ImGui::TextUnformatted(fmt::format("{} {}", finding.count, finding.text).c_str());
      ImGui::PopTextWrapPos();
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
      constexpr std::size_t kShown = 8;
      for (std::size_t k = 0; k < std::min(finding.places.size(), kShown); ++k) {
        if (k > 0) ImGui::SameLine(0, 4 * unit);
        if (ImGui::SmallButton(std::to_string(k + 1).c_str())) show_place(verdict, finding.places[k]);
        tooltip(verdict.gui, "Show this place");
      }
      if (static_cast<std::size_t>(finding.count) > std::min(finding.places.size(), kShown) &&
          !finding.places.empty()) {
        ImGui::SameLine();
        ImGui::TextDisabled("and more");
      }
      ImGui::PopID();
      ImGui::PopID();
      ImGui::Dummy({0, 2 * unit});
    }
  }
  if (!any) ImGui::TextUnformatted(look_of(verdict).meaning);
}

}  // namespace

float Verdict::width() const {
  return (kChoiceWidth + kLightWidth + 12) * gui.unit();
}

void Verdict::draw() const {
  const float unit = gui.unit();
  draw_choice(*this);
  ImGui::SameLine(0, 10 * unit);
  const LightLook look = look_of(*this);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  if (ImGui::InvisibleButton("##light", {kLightWidth * unit, height})) ImGui::OpenPopup("##reasons");
  if (ImGui::IsItemHovered()) {
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + kLightWidth * unit, at.y + height},
                                              gui.colors().accent_soft, 4 * unit);
  }
  tooltip(gui, look.meaning);
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 9 * unit, at.y + 0.5F * height}, 5 * unit, look.color);
  ImGui::GetWindowDrawList()->AddText({at.x + 20 * unit, at.y + 0.5F * (height - ImGui::GetTextLineHeight())},
                                      gui.colors().text, look.word);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 8 * unit});
  if (ImGui::BeginPopup("##reasons")) {
    draw_reasons(*this);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace mes
