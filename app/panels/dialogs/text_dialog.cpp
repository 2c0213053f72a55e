// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/text_dialog.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/ui/dialogs/large_dialog.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/lower_case.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kTextDialogWidth = 1040.0F;  // logical pixels
constexpr float kTextDialogHeight = 600.0F;
constexpr float kFontListWidth = 230.0F;
constexpr float kTextSettingsWidth = 300.0F;
constexpr float kTextLines = 4.0F;
constexpr const char* kTextDialogId = "##text";
constexpr double kLeastTextSize = 1.0;
constexpr double kMostTextSize = 10'000.0;
constexpr double kMostLineSpacing = 4.0;

}  // namespace

void TextDialog::open() {
  is_open_ = true;
  takes_keyboard_ = true;
  families_ = font_families();
  if (!own_font_ && wish_.family.empty() && !families_.empty()) wish_.family = families_.front();
}

void TextDialog::press(const KeyChord& chord) {
  // Dear ImGui misses a Ctrl that is released in the same frame.
  if (chord.symbol == key::enter && !chord.modifiers.ctrl && (writes_ || !ImGui::IsAnyItemActive())) maker_.accept();
}

void TextDialog::draw_fonts(const Gui& gui) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##filter", "Find a font", &filter_);
  tooltip(gui, "Part of the name of the font family");
  ImGui::BeginChild("families", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  const std::string wanted = lower_case(filter_);
  const auto row = [&](const std::string& family, const std::string& shown) {
    if (!lower_case(shown).contains(wanted)) return;
    if (ImGui::Selectable(fmt::format("{}##{}", shown, family).c_str(), wish_.family == family))
      wish_.family = family;
  };
  if (own_font_) row({}, fmt::format("{}, built in", own_font_->name));
  for (const std::string& family : families_) row(family, family);
  ImGui::EndChild();
}

void TextDialog::draw_settings(const Gui& gui) {
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TextUnformatted("Text");
  if (takes_keyboard_) ImGui::SetKeyboardFocusHere();
  // The first letters that are typed replace the text before.
  const auto select_all = [](ImGuiInputTextCallbackData* field) {
    if (std::exchange(*static_cast<bool*>(field->UserData), false)) field->SelectAll();
    return 0;
  };
  ImGui::InputTextMultiline("##words", &wish_.request.text, {width, kTextLines * ImGui::GetTextLineHeight()},
                            ImGuiInputTextFlags_CtrlEnterForNewLine | ImGuiInputTextFlags_CallbackAlways, select_all,
                            &takes_keyboard_);
  writes_ = ImGui::IsItemActive();
  tooltip(gui, "Ctrl+Enter begins a new line");
  ImGui::BeginDisabled(wish_.family.empty());
  checkbox("Bold", &wish_.is_bold);
  ImGui::SameLine();
  checkbox("Italic", &wish_.is_italic);
  ImGui::EndDisabled();
  ImGui::SameLine();
  checkbox("Kerning", &wish_.request.has_kerning);
  tooltip(gui, "Letters move together where the font defines it, such as A and V");
  ImGui::TextUnformatted("Size");
  slider(gui, "##size", wish_.request.size, kLeastTextSize, kMostTextSize,
         {.format = "%.4g", .is_logarithmic = true, .width = width});
  tooltip(gui, "Height of an em, in units of the samples");
  ImGui::TextUnformatted("Line spacing");
  slider(gui, "##line-spacing", wish_.request.line_spacing, 0.0, kMostLineSpacing,
         {.format = "%.2f", .width = width});
  tooltip(gui, "Distance of lines, as a multiple of the font's own");
  ImGui::Dummy({1, 2 * gui.unit()});
  sampling_.draw(gui);
}

void TextDialog::follow_wish() {
  wish_.sampling = sampling_.sampling();
  if (wished_for_ == wish_) return;
  wished_for_ = wish_;
  maker_.want([wish = wish_, own = own_font_](JobControl& job) -> SampleMaking::Made {
    auto font = wish.family.empty() && own ? Expected<FontFile>(*own)
                                           : find_font(font_name(wish.family, wish.is_bold, wish.is_italic));
    if (!font) return {std::unexpected(std::move(font.error()))};
    TextRequest request = wish.request;
    request.font = *std::move(font);
    auto outlines = outlines_of_text(request, &job);
    if (!outlines) return {std::unexpected(std::move(outlines.error()))};
    job.checkpoint();
    return {sample_curves(outlines->curves, wish.sampling, &job), std::move(outlines->remarks)};
  });
}

void TextDialog::draw(const Gui& gui) {
  large_dialog(gui, kTextDialogId, is_open_, {kTextDialogWidth, kTextDialogHeight}, DialogKeys::controls,
               [&](ImVec2) {
                 const DialogColumn columns[] = {{"fonts", kFontListWidth, [&] { draw_fonts(gui); }},
                                                 {"settings", kTextSettingsWidth,
                                                  [&] {
                                                    heading(gui, "Write a text");
                                                    ImGui::Dummy({1, 2 * gui.unit()});
                                                    draw_settings(gui);
                                                    follow_wish();
                                                    maker_.draw_facts(gui);
                                                  }},
                                                 {"preview", 0, [&] { maker_.draw_preview(gui); }}};
                 dialog_columns(gui, columns,
                                maker_.foot(gui, "Text", "The text becomes a new document", [this] { cancel(); }));
               });
}

}  // namespace mes
