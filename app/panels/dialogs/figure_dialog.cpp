// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/figure_dialog.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "app/ui/dialogs/large_dialog.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

constexpr float kFigureDialogWidth = 1080.0F;  // logical pixels
constexpr float kFigureDialogHeight = 640.0F;
constexpr float kSettings = 408.0F;
constexpr float kPointsField = 46.0F;
constexpr float kTitleWidth = 76.0F;
constexpr const char* kFigureDialogId = "##figure";

// In the order of `FigureExtent` and `FigurePaper`.
constexpr std::array kExtents{std::pair{"View", "What the window shows between its panels"},
                              std::pair{"All contents", "All samples and balls, and their structures"},
                              std::pair{"Cropped view", "The view, cropped to the drawing"}};
constexpr std::array kPapers{std::pair{"White", "White paper, with black kept black"},
                             std::pair{"Canvas", "The colour of the canvas"},
                             std::pair{"None", "Nothing behind the drawing"}};

// In the order of `page_presets`.
constexpr std::array kPresetTitles{"One column", "Two columns", "Slide", "Square"};

void row_title(const Gui& gui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kTitleWidth * gui.unit());
}

/// Continues on the same line if `label` and `more` beside it fit there, otherwise below, beside the titles.
void go_on(const Gui& gui, const std::string& label, float more = 0.0F) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2 * style.FramePadding.x + more;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right)
    ImGui::SameLine();
  else
    ImGui::SetCursorPosX(kTitleWidth * gui.unit());
}

/// Continues with a checkbox in the same way.
void checkbox_further_on(const Gui& gui, const char* label, bool* value) {
  go_on(gui, label, ImGui::GetFrameHeight());
  checkbox(label, value);
}

/// Draws a choice between several words; `chosen` is the index of the current one.
template <class Choice>
void choice(const Gui& gui, std::span<const std::pair<const char*, const char*>> words, Choice& chosen) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != 0) go_on(gui, words[i].first);
    if (choice_button(words[i].first, static_cast<std::size_t>(chosen) == i)) chosen = static_cast<Choice>(i);
    tooltip(gui, words[i].second);
  }
}

/// The short name of a format: "SVG", "PS", "TikZ".
std::string short_name(const figure::Format& format) {
  constexpr std::size_t kShort = 4;
  if (format.name.size() <= kShort) return std::string(format.name);
  std::string out(format.extension.substr(1));
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return out;
}

double unit_mm(const FigureSettings& settings) {
  return settings.in_inches ? figure::kMillimetersPerInch : 1.0;
}

/// Draws a field for a length on paper. Returns true when the length has changed.
bool length_field(const Gui& gui, const char* label, const FigureSettings& settings, double& mm) {
  double value = mm / unit_mm(settings);
  ImGui::SetNextItemWidth(62 * gui.unit());
  const NumberRange range{kLeastFigureSide / unit_mm(settings), kMostFigureSide / unit_mm(settings)};
  if (!number_field(label, value, settings.in_inches ? "%.3f" : "%.1f", range)) return false;
  mm = std::clamp(value * unit_mm(settings), kLeastFigureSide, kMostFigureSide);
  return true;
}

std::string size_text(std::size_t bytes) {
  const auto count = static_cast<double>(bytes);
  if (bytes < 100'000) return fmt::format("{:.1f} kB", 1e-3 * count);
  if (bytes < 1'000'000) return fmt::format("{:.0f} kB", 1e-3 * count);
  return fmt::format("{:.1f} MB", 1e-6 * count);
}

void draw_chequers(const Gui& gui, ImVec2 at, ImVec2 end) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, end, IM_COL32(255, 255, 255, 255));
  const float side = 8 * gui.unit();
  list.PushClipRect(at, end, true);
  int row = 0;
  for (float y = at.y; y < end.y; y += side, ++row)
    for (float x = at.x + (row % 2 == 0 ? 0.0F : side); x < end.x; x += 2 * side)
      list.AddRectFilled({x, y}, {x + side, y + side}, IM_COL32(226, 228, 231, 255));
  list.PopClipRect();
}

void warning(const Gui& gui, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  paragraph(text);
  ImGui::PopStyleColor();
}

}  // namespace

void FigureDialog::open() {
  is_open_ = true;
  is_accepted_ = false;
  rasterized_.clear();
}

void FigureDialog::close() {
  if (!is_open_) return;
  is_open_ = false;
  uses_->closed();
}

void FigureDialog::press(const KeyChord& chord) {
  if (chord.symbol == key::enter && !ImGui::IsAnyItemActive()) is_accepted_ = true;
}

void FigureDialog::draw_size(const Gui& gui) const {
  FigureSettings& settings = uses_->settings;
  row_title(gui, "Size");
  const auto presets = page_presets();
  for (std::size_t i = 0; i < presets.size() && i < kPresetTitles.size(); ++i) {
    if (i != 0) go_on(gui, kPresetTitles[i]);
    const auto size = parse_page_size(std::string(presets[i].name));
    constexpr double kMillimetersPerPoint = figure::kMillimetersPerInch / figure::kPointsPerInch;
    const double width = size ? kMillimetersPerPoint * size->width : 0.0;
    const double height = size ? kMillimetersPerPoint * size->height.value_or(0.0) : 0.0;
    constexpr double kEqual = 0.01;
    const bool is_chosen =
        std::abs(settings.width_mm - width) < kEqual && std::abs(settings.height_mm - height) < kEqual;
    if (choice_button(kPresetTitles[i], is_chosen) && size) {
      settings.width_mm = width;
      settings.height_mm = height;
      settings.letters_pt = FigureSettings().letters_pt * size->lettering;
    }
    tooltip(gui, std::string(presets[i].size));
  }
  row_title(gui, "");
  length_field(gui, "##width", settings, settings.width_mm);
  tooltip(gui, "Width of the page");
  ImGui::SameLine();
  ImGui::TextUnformatted("x");
  ImGui::SameLine();
  const FigurePreview* const preview = uses_->latest.preview();
  bool follows = settings.height_mm <= 0.0;
  double height = settings.height_mm;
  if (follows && preview != nullptr) height = preview->height * figure::kMillimetersPerInch / figure::kPointsPerInch;
  ImGui::BeginDisabled(follows);
  if (length_field(gui, "##height", settings, height)) settings.height_mm = height;
  ImGui::EndDisabled();
  tooltip(gui, "Height of the page");
  for (const bool inches : {false, true}) {
    go_on(gui, "mm");
    if (choice_button(inches ? "in" : "mm", settings.in_inches == inches)) settings.in_inches = inches;
  }
  constexpr const char* kFollows = "As needed";
  go_on(gui, kFollows, ImGui::GetFrameHeight());
  if (checkbox(kFollows, &follows))
    settings.height_mm = follows ? 0.0 : std::clamp(height, kLeastFigureSide, kMostFigureSide);
  tooltip(gui, "The height follows from the width");
}

// Draws nothing if the window shows only one pane.
void FigureDialog::draw_panes(const Gui& gui) const {
  if (!uses_->latest.has_panes()) return;
  FigureSettings& settings = uses_->settings;
  row_title(gui, "Panes");
  if (choice_button("All", settings.all_panes)) settings.all_panes = true;
  tooltip(gui, "All panes of the window at one scale, each with its letter");
  go_on(gui, "Main one");
  if (choice_button("Main one", !settings.all_panes)) settings.all_panes = false;
  tooltip(gui, "The first pane alone");
  ImGui::BeginDisabled(!settings.all_panes);
  checkbox_further_on(gui, "Differences", &settings.with_differences);
  ImGui::EndDisabled();
  tooltip(gui, "Mark what only some of the panes have");
}

void FigureDialog::draw_sizes(const Gui& gui) const {
  FigureSettings& settings = uses_->settings;
  row_title(gui, "Lines");
  if (choice_button("For print", !settings.as_on_screen)) settings.as_on_screen = false;
  tooltip(gui, "Letters of a size in points; lines and dots keep their proportion to them");
  go_on(gui, "As on screen");
  if (choice_button("As on screen", settings.as_on_screen)) settings.as_on_screen = true;
  tooltip(gui, "Letters, lines and dots in the same proportion to the page as to the canvas");
  if (settings.as_on_screen) return;
  row_title(gui, "");
  const auto field = [&](const char* id, const char* before, const char* after, double& points,
                         const NumberRange& range) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(before);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(kPointsField * gui.unit());
    number_field(id, points, "%.4g", range);
    tooltip(gui, after);
    ImGui::SameLine();
    ImGui::TextUnformatted("pt");
  };
  field("##letters", "Text", "Size of the letters of legend, scale bar and axes", settings.letters_pt,
        {kLeastLettersPt, kMostLettersPt});
  constexpr const char* kLeast = "Lines from";
  go_on(gui, kLeast, kPointsField * gui.unit() + ImGui::CalcTextSize(" pt").x);
  field("##least", kLeast, "Finer lines and smaller dots get this width", settings.least_line_pt,
        {0.0, kMostLeastLinePt});
}

void FigureDialog::draw_look(const Gui& gui) const {
  FigureSettings& settings = uses_->settings;
  draw_panes(gui);
  row_title(gui, "Show");
  // Panes have one size, so none can be cut to its drawing.
  const bool is_sheet = uses_->latest.has_panes() && settings.all_panes;
  FigureExtent extent = is_sheet && settings.extent == FigureExtent::ink ? FigureExtent::view : settings.extent;
  const FigureExtent before = extent;
  choice<FigureExtent>(gui, std::span(kExtents).first(is_sheet ? 2 : kExtents.size()), extent);
  if (extent != before) settings.extent = extent;
  row_title(gui, "Paper");
  choice<FigurePaper>(gui, kPapers, settings.paper);
  draw_sizes(gui);
  row_title(gui, "Title");
  ImGui::SetNextItemWidth(-1.0F);
  ImGui::InputTextWithHint("##title", "Text above the drawing", &settings.title);
  tooltip(
      gui,
      "Text and a little LaTeX, as in annotations: $x_i^2 \\le \\varepsilon$, \\textbf{...}, \\\\ for a new line");
  row_title(gui, "Legend");
  checkbox("Of colour maps", &settings.with_legend);
  tooltip(gui, "At its dragged position on the canvas, otherwise in the corner where it hides least");
  checkbox_further_on(gui, "Of all layers", &settings.with_key);
  tooltip(gui, "The names of the layers, with a sample of how each is drawn");
  row_title(gui, "Scale");
  checkbox("Bar", &settings.marks.bar);
  tooltip(gui, "A bar of a round length, labelled in units of the samples, at its dragged position on the canvas");
  checkbox_further_on(gui, "Axes", &settings.marks.axes);
  tooltip(gui, "Numbers along the bottom and left edges");
  checkbox_further_on(gui, "Grid", &settings.marks.grid);
  tooltip(gui, "Faint lines at the round numbers of the axes");
  row_title(gui, "Annotations");
  checkbox("Text, arrows, dimensions, highlights", &settings.with_annotations);
  tooltip(gui, "Annotations on the drawing, as a separate layer");
  row_title(gui, "Source");
  const figure::Format* const format = figure::format_for(settings.extension);
  const bool can_carry = format != nullptr && format->carries_session;
  bool carries = can_carry && settings.with_source;
  ImGui::BeginDisabled(!can_carry);
  if (checkbox("Document in the file", &carries)) settings.with_source = carries;
  ImGui::EndDisabled();
  tooltip(
      gui,
      can_carry
          ? "The file holds samples, balls, view and layers, without the history: it opens here again as the document"
          : "Files of this format cannot hold it");
}

void FigureDialog::draw_settings(const Gui& gui) const {
  FigureSettings& settings = uses_->settings;
  row_title(gui, "Format");
  bool is_first = true;
  for (const figure::Format& format : figure::formats()) {
    const std::string name = short_name(format);
    if (!is_first) go_on(gui, name);
    is_first = false;
    if (choice_button(name.c_str(), settings.extension == format.extension)) settings.extension = format.extension;
    tooltip(gui, fmt::format("{}, *{}", format.name, format.extension));
  }
  draw_size(gui);
  draw_look(gui);
}

void FigureDialog::draw_layers(const Gui& gui) {
  const float unit = gui.unit();
  FigureSettings& settings = uses_->settings;
  const figure::Format* const format = figure::format_for(settings.extension);
  const FigurePreview* const preview = uses_->latest.preview();
  if (preview == nullptr || format == nullptr || !format->has_images) return;
  ImGui::Dummy({1, 4 * unit});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Layers as pictures");
  tooltip(gui, "A picture instead of thousands of shapes makes a smaller file");
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 8 * unit);
  ImGui::SetNextItemWidth(58 * unit);
  double dots = settings.dots_per_inch;
  if (number_field("dpi", dots, "%.0f", NumberRange{kLeastDotsPerInch, kMostDotsPerInch}))
    settings.dots_per_inch = dots;
  tooltip(gui, "Resolution of these pictures");
  const float foot = 92 * unit;  // height of the messages below
  ImGui::BeginChild("layers", {0, std::max(96 * unit, ImGui::GetContentRegionAvail().y - foot)}, true,
                    ImGuiWindowFlags_NavFlattened);
  for (auto layer = preview->layers.rbegin(); layer != preview->layers.rend(); ++layer) {
    const auto chosen = std::ranges::find(rasterized_, layer->id);
    bool is_picture = chosen != rasterized_.end();
    if (layer->shapes == 0 && !is_picture) continue;
    if (checkbox(layer->title.c_str(), &is_picture)) {
      if (is_picture)
        rasterized_.push_back(layer->id);
      else
        rasterized_.erase(chosen);
    }
    const std::string count = layer->is_picture ? "picture" : grouped(layer->shapes);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x);
    ImGui::TextDisabled("%s", count.c_str());
  }
  ImGui::EndChild();
}

void FigureDialog::draw_facts(const Gui& gui) {
  const LatestFigure& latest = uses_->latest;
  const FigurePreview* const preview = latest.preview();
  if (latest.problem()) {
    warning(gui, latest.problem()->message());
    return;
  }
  if (preview == nullptr) {
    ImGui::TextDisabled("Computing the layers...");
    return;
  }
  std::string text = counted(preview->shapes, "shape");
  if (preview->widest > 0.0) {
    const std::string finest = fmt::format("{:.2f}", preview->finest);
    const std::string widest = fmt::format("{:.2f}", preview->widest);
    text += ", lines of " + (finest == widest ? widest : finest + " to " + widest) + " pt";
  }
  const std::string* const bytes = latest.bytes();
  text += bytes != nullptr ? ", " + size_text(bytes->size()) : latest.is_drawing() ? ", drawing..." : ", writing...";
  ImGui::TextUnformatted(text.c_str());
  for (const std::string& remark : preview->remarks) warning(gui, remark);
  if (const std::string memory = tex_warning(preview->shapes, uses_->settings.extension); !memory.empty())
    warning(gui, memory);
  if (bytes == nullptr || bytes->size() <= kLargeFigure) return;
  warning(gui, "Files of this size are slow to open and often too large for mail.");
  const auto largest = std::ranges::max_element(preview->layers, {}, &FigurePreview::Layer::shapes);
  const figure::Format* const format = figure::format_for(uses_->settings.extension);
  if (largest == preview->layers.end() || largest->shapes == 0 || format == nullptr || !format->has_images) return;
  if (ImGui::Button(fmt::format("Make a picture of \"{}\"", largest->title).c_str()))
    rasterized_.push_back(largest->id);
}

void FigureDialog::draw_buttons(const Gui& gui, ButtonRows& buttons) {
  const LatestFigure& latest = uses_->latest;
  const bool is_possible = latest.preview() != nullptr && !latest.problem() && !latest.is_saving();
  ImGui::BeginDisabled(!is_possible);
  const bool is_clicked = buttons.next(true);
  if ((is_clicked || is_accepted_) && is_possible) uses_->ask_file();
  ImGui::EndDisabled();
  is_accepted_ = false;
  const bool is_text = uses_->settings.extension == ".svg" || uses_->settings.extension == ".tex" ||
                       uses_->settings.extension == ".ipe";
  ImGui::BeginDisabled(!is_text || latest.bytes() == nullptr);
  if (buttons.next()) ImGui::SetClipboardText(latest.bytes()->c_str());
  ImGui::EndDisabled();
  tooltip(gui, "Copy the text of the file (SVG, Ipe or TikZ) to the clipboard");
  if (buttons.next()) close();
}

void FigureDialog::draw_preview(const Gui& gui) const {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, gui.colors().field, 4 * unit);
  const FigurePreview* const preview = uses_->latest.preview();
  const ImTextureID texture = uses_->texture();
  if (preview == nullptr || texture == nullptr) return;
  const float margin = 18 * unit;
  const auto width = static_cast<float>(preview->width);
  const auto height = static_cast<float>(preview->height);
  const float scale = is_at_real_size_ ? unit / static_cast<float>(figure::kPointsPerPixel)
                                       : std::min((room.x - 2 * margin) / width, (room.y - 2 * margin) / height);
  const ImVec2 size(std::round(width * scale), std::round(height * scale));
  // A page larger than the room is scrolled.
  const ImVec2 start(std::max(0.0F, std::round(0.5F * (room.x - size.x))),
                     std::max(0.0F, std::round(0.5F * (room.y - size.y))));
  const ImVec2 page(at.x + start.x, at.y + start.y);
  const ImVec2 end(page.x + size.x, page.y + size.y);
  if (uses_->settings.paper == FigurePaper::transparent) draw_chequers(gui, page, end);
  list.AddImage(texture, page, end);
  list.AddRect({page.x - 1, page.y - 1}, {end.x + 1, end.y + 1}, gui.colors().border);
  ImGui::Dummy({start.x + size.x, start.y + size.y});
}

void FigureDialog::draw(const Gui& gui) {
  static constexpr std::array kButtons{"Export...", "Copy", "Cancel"};
  large_dialog(gui, kFigureDialogId, is_open_ && !is_covered_, {kFigureDialogWidth, kFigureDialogHeight},
               DialogKeys::controls, [&](ImVec2) {
                 float longest = 0.0F;
                 const DialogColumn columns[] = {
                     {"settings", kSettings,
                      [&] {
                        heading(gui, "Export a figure");
                        ImGui::Dummy({1, 2 * gui.unit()});
                        draw_settings(gui);
                        draw_layers(gui);
                        draw_facts(gui);
                      }},
                     {"preview", 0, [&] {
                        const ImVec2 room = ImGui::GetContentRegionAvail();
                        const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
                        longest = std::max(room.x * scale.x, room.y * scale.y);
                        checkbox("Real size", &is_at_real_size_);
                        tooltip(gui,
                                "Show the page as large as on paper, if the screen has 96 pixels per inch at 100 %");
                        ImGui::BeginChild("page", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
                        draw_preview(gui);
                        ImGui::EndChild();
                      }}};
                 dialog_columns(gui, columns, {kButtons, [&](ButtonRows& buttons) { draw_buttons(gui, buttons); }});
                 uses_->latest.want(uses_->settings, rasterized_, static_cast<int>(longest));
               });
}

}  // namespace mes
