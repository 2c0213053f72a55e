// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/verdict.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/editing/places/neighborhood.h"
#include "app/picture/shown_verdict.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

ImU32 mood_color(const ThemeColors& colors, VerdictWord::Mood mood) {
  switch (mood) {
    case VerdictWord::Mood::good: return colors.good;
    case VerdictWord::Mood::doubtful: return colors.doubtful;
    case VerdictWord::Mood::wrong: return colors.wrong;
    case VerdictWord::Mood::warning: return colors.warning;
    case VerdictWord::Mood::quiet: break;
  }
  return colors.text_faint;
}

constexpr float kChoiceWidth = 118;
constexpr float kLightWidth = 134;
// The width of an epsilon in words is rounded up to a multiple of this, so that nothing moves while the number changes.
constexpr float kEpsilonWidth = 104;

float epsilon_width(const Gui& gui, std::string_view epsilon) {
  if (epsilon.empty()) return 0.0F;
  const float width = ImGui::CalcTextSize(epsilon.data(), epsilon.data() + epsilon.size()).x / gui.unit();
  return kEpsilonWidth * std::ceil(width / kEpsilonWidth);
}

float width_with(const Gui& gui, std::string_view epsilon) {
  return (kChoiceWidth + kLightWidth + epsilon_width(gui, epsilon) + 12) * gui.unit();
}

/// Empty if it has no room beside the light and a message.
std::string epsilon_of(const Verdict& verdict, float room) {
  const auto epsilon = sampling_verdict(verdict.picture.nodes()).epsilon;
  const std::string text = epsilon ? epsilon->text() : std::string();
  constexpr float kMostOfRoom = 0.6F;
  return width_with(verdict.gui, text) > kMostOfRoom * room ? std::string() : text;
}

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

void show_place(const Verdict& verdict, Vec2 place) {
  verdict.canvas.view().fit(neighborhood_of(verdict.document, place), 0.0);
}

void draw_reasons(const Verdict& verdict) {
  const float unit = verdict.gui.unit();
  static constexpr float kWidth = 380;
  const VerdictWord look = shown_verdict(verdict.engine, verdict.picture);
  paragraph(look.text, kWidth * unit);
  ImGui::Dummy({0, 2 * unit});
  bool gives_reasons = false;
  for (const NodeReport& node : verdict.picture.nodes()) {
    if (node.state == NodeState::failed) {
      gives_reasons = true;
      ImGui::PushStyleColor(ImGuiCol_Text, verdict.gui.colors().warning);
      paragraph(fmt::format("Failed: {}. {}", structure_name(node.structure), node.reason), kWidth * unit);
      ImGui::PopStyleColor();
    }
    for (std::size_t i = 0; i < node.findings.size(); ++i) {
      const Finding& finding = node.findings[i];
      gives_reasons = gives_reasons || finding.level != FindingLevel::note;
      ImGui::PushID(node.structure.c_str());
      ImGui::PushID(static_cast<int>(i));
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 5 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()},
                                                  4 * unit, mood_color(verdict.gui.colors(), mood_of(finding.level)));
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
      paragraph(text_of(finding, node.structure), kWidth * unit);
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 16 * unit);
      constexpr std::size_t kShown = 8;
      for (std::size_t k = 0; k < std::min(finding.places.size(), kShown); ++k) {
        if (k > 0) ImGui::SameLine(0, 4 * unit);
        if (ImGui::SmallButton(std::to_string(k + 1).c_str())) show_place(verdict, finding.places[k]);
        tooltip(verdict.gui, "Show this position");
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
  if (gives_reasons || look.meaning == look.text) return;
  paragraph(look.meaning, kWidth * unit);
}

}  // namespace

float Verdict::width(float room) const {
  return width_with(gui, epsilon_of(*this, room));
}

void Verdict::draw(float room) const {
  const float unit = gui.unit();
  draw_choice(*this);
  ImGui::SameLine(0, 10 * unit);
  const VerdictWord look = shown_verdict(engine, picture);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  const std::string epsilon = epsilon_of(*this, room);
  const float light_width = (kLightWidth + epsilon_width(gui, epsilon)) * unit;
  if (hit_area("##light", {light_width, height})) ImGui::OpenPopup("##reasons");
  if (ImGui::IsItemHovered()) {
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + light_width, at.y + height}, gui.colors().accent_soft,
                                              4 * unit);
  }
  tooltip(gui, look.meaning == look.text ? look.text : look.text + ". " + std::string(look.meaning));
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 9 * unit, at.y + 0.5F * height}, 5 * unit,
                                              mood_color(gui.colors(), look.mood));
  ImGui::GetWindowDrawList()->AddText({at.x + 20 * unit, at.y + 0.5F * (height - ImGui::GetTextLineHeight())},
                                      gui.colors().text, look.word.data(), look.word.data() + look.word.size());
  ImGui::GetWindowDrawList()->AddText(
      {at.x + kLightWidth * unit, at.y + 0.5F * (height - ImGui::GetTextLineHeight())}, gui.colors().text,
      epsilon.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 8 * unit});
  if (begin_popup(gui, "##reasons")) {
    draw_reasons(*this);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace mes
