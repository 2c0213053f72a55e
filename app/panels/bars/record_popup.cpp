// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/record_popup.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "app/settings/record_settings.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "imgui_stdlib.h"
#include "render/device/convert.h"

namespace mes {
namespace {

constexpr RecordSettings kFirstSize{.width = 1920, .height = 1080};

void row_name(const char* text, float column) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(column);
}

void draw_size(const Gui& gui, RecordSettings& record, float column) {
  row_name("Size", column);
  const bool is_canvas = record.width == 0 && record.height == 0;
  if (choice_button("Canvas", is_canvas)) record.width = record.height = 0;
  tooltip(gui, "As large as the canvas between the panels when the recording begins");
  ImGui::SameLine();
  if (choice_button("Custom", !is_canvas) && is_canvas) {
    record.width = kFirstSize.width;
    record.height = kFirstSize.height;
  }
  tooltip(gui, "Any size, independent of the window; the frame shows everything between the panels");
  if (is_canvas) return;
  ImGui::Dummy({1, 1});
  ImGui::SameLine(column);
  ImGui::SetNextItemWidth(70 * gui.unit());
  number_field("##width", record.width);
  tooltip(gui, "Width in pixels");
  ImGui::SameLine();
  ImGui::TextUnformatted("x");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(70 * gui.unit());
  number_field("##height", record.height);
  tooltip(gui, "Height in pixels");
}

void draw_supersampling(const Gui& gui, RecordSettings& record, float column) {
  row_name("Supersampling", column);
  for (const int factor : {1, 2, 4}) {
    if (choice_button(fmt::format("{}x", factor).c_str(), record.supersampling == factor))
      record.supersampling = factor;
    tooltip(gui, factor == 1 ? "As on screen; edges are smooth already"
                             : "Drawn larger and averaged: finer edges, slower");
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

void draw_background(const RecordPopup& popup, RecordSettings& record, float column) {
  const Gui& gui = popup.gui;
  row_name("Background", column);
  const bool is_canvas = !record.transparent && !record.background;
  if (choice_button("Canvas", is_canvas)) {
    record.transparent = false;
    record.background.reset();
  }
  tooltip(gui, "The background colour of the canvas");
  ImGui::SameLine();
  if (choice_button("Transparent", record.transparent)) record.transparent = true;
  tooltip(gui, "Nothing behind the drawing");
  ImGui::SameLine();
  if (choice_button("Custom##background", !record.transparent && record.background)) {
    record.transparent = false;
    if (!record.background) record.background = popup.picture.canvas();
  }
  tooltip(gui, "A custom colour");
  if (record.transparent || !record.background) return;
  ImGui::SameLine();
  glm::vec3 color = render::to_vec3(*record.background);
  if (ImGui::ColorEdit3("##background", glm::value_ptr(color),
                        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip))
    record.background = render::to_rgb(color);
  tooltip(gui, "Colour behind the drawing");
}

void draw_panes(const Gui& gui, RecordSettings& record, float column) {
  row_name("Panes", column);
  if (choice_button("All", record.all_panes)) record.all_panes = true;
  tooltip(gui, "Frames, snapshots and copied pictures show all panes, each with its letter");
  ImGui::SameLine();
  if (choice_button("Main one", !record.all_panes)) record.all_panes = false;
  tooltip(gui, "The first pane alone");
}

void draw_contents(const RecordPopup& popup) {
  const Gui& gui = popup.gui;
  const float unit = gui.unit();
  const float column = 118 * unit;
  RecordSettings& record = popup.settings;
  ImGui::BeginDisabled(popup.record.is_recording());
  row_name("Show", column);
  if (choice_button("Drawing", !record.with_panels)) record.with_panels = false;
  tooltip(gui, "The drawing alone");
  ImGui::SameLine();
  if (choice_button("Whole window", record.with_panels)) record.with_panels = true;
  tooltip(gui, "The window with its panels, as it is");
  ImGui::BeginDisabled(record.with_panels);
  draw_size(gui, record, column);
  draw_supersampling(gui, record, column);
  draw_background(popup, record, column);
  draw_panes(gui, record, column);
  ImGui::EndDisabled();
  row_name("Pan and zoom", column);
  if (choice_button("Last frame", !record.each_motion)) record.each_motion = false;
  tooltip(gui, "One frame at the end of a motion");
  ImGui::SameLine();
  if (choice_button("All frames", record.each_motion)) record.each_motion = true;
  tooltip(gui, "Every frame of a motion");
  row_name("Folder", column);
  ImGui::SetNextItemWidth(230 * unit);
  ImGui::InputTextWithHint("##folder", takes_folder().c_str(), &record.folder);
  tooltip(gui, "Snapshots go here, and each recording to a new folder in it");
  row_name("Source", column);
  checkbox("Document in snapshots and takes", &record.with_source);
  tooltip(gui,
          "A snapshot holds samples, balls, view and layers, without the history; the manifest of a recording holds "
          "the session, with its history. Either opens here again as the document");
  ImGui::EndDisabled();
  row_name("Pace of video", column);
  if (choice_button("Constant", !record.real_time)) record.real_time = false;
  tooltip(gui, "Every frame is shown equally long");
  ImGui::SameLine();
  if (choice_button("As recorded", record.real_time)) record.real_time = true;
  tooltip(gui, "Each frame is shown as long as it was during the recording");
  row_name("Video", column);
  slider(gui, "##fps", record.fps, 1.0, 60.0, {.format = "%.0f fps", .is_whole = true, .width = 170 * unit});
  tooltip(gui, "Frames per second");
  ImGui::SameLine();
  ImGui::BeginDisabled(!popup.actions.is_enabled(ActionId::make_video));
  if (ImGui::Button("Make video")) popup.actions.run(ActionId::make_video);
  ImGui::EndDisabled();
  tooltip(gui, popup.actions.tooltip_of(ActionId::make_video));
  if (const auto good = check(record); !good) {
    ImGui::PushStyleColor(ImGuiCol_Text, popup.gui.colors().warning);
    paragraph(good.error().message(), column + 230 * unit);
    ImGui::PopStyleColor();
  }
}

}  // namespace

void RecordPopup::draw(float size) const {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (icon_button("record-options", Icon::more, size)) ImGui::OpenPopup("##record");
  tooltip(gui, "How frames and snapshots are made");
  ImGui::SetNextWindowPos({at.x + size + 10 * unit, at.y + size}, ImGuiCond_Appearing, {0.0F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6 * unit, 6 * unit});
  if (begin_popup(gui, "##record")) {
    draw_contents(*this);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace mes
