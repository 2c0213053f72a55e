// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/trace_dialog.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/ui/dialogs/large_dialog.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"

namespace mes {
namespace {

constexpr float kTraceDialogWidth = 900.0F;  // logical pixels
constexpr float kTraceDialogHeight = 560.0F;
constexpr float kChoices = 300.0F;
constexpr const char* kTraceDialogId = "##trace";
constexpr double kMostSpecks = 1e6;

struct SideWord {
  FigureSide side;
  const char* word;
  const char* explanation;
};
constexpr std::array kSides{
    SideWord{FigureSide::found, "Found", "Trace dark or light: the one that covers less of the edge of the picture"},
    SideWord{FigureSide::dark, "Dark", "Pixels of the threshold's grey value or darker"},
    SideWord{FigureSide::light, "Light", "Pixels lighter than the threshold's grey value"},
};

/// The position of a picture with this many pixels, as large as fits the room.
struct Placed {
  ImVec2 at;
  float scale;
};
Placed placed(ImVec2 at, ImVec2 room, const GrayImage& image) {
  const auto width = static_cast<float>(image.width);
  const auto height = static_cast<float>(image.height);
  const float scale = std::min(room.x / width, room.y / height);
  return {{at.x + 0.5F * (room.x - scale * width), at.y + 0.5F * (room.y - scale * height)}, scale};
}

void draw_outlines(const CurveSet& curves, const Placed& place, int height, ImU32 color, float thickness) {
  std::vector<ImVec2> points;
  for (const PlaneCurve& curve : curves.curves) {
    points.clear();
    const auto add = [&](Vec2 p) {
      points.emplace_back(place.at.x + place.scale * static_cast<float>(p.x),
                          place.at.y + place.scale * static_cast<float>(height - p.y));
    };
    curve.for_each_piece([&](const Piece& piece) {
      // Arcs are up to half an ellipse; cubics bend little.
      const int parts = piece.kind == PieceKind::arc ? 64 : piece.kind == PieceKind::line ? 1 : 2;
      for (int i = 1; i < parts; ++i) add(piece.at(static_cast<double>(i) / parts));
      add(piece.to());
    });
    polyline(*ImGui::GetWindowDrawList(), points, color, true, thickness);
  }
}

}  // namespace

void TraceDialog::open() {
  is_open_ = true;
  is_accepted_ = false;
}

void TraceDialog::cancel() {
  if (!is_open_) return;
  is_open_ = false;
  uses_->closed();
}

void TraceDialog::press(const KeyChord& chord) {
  if (chord.symbol == key::enter && !ImGui::IsAnyItemActive()) is_accepted_ = true;
}

void TraceDialog::begin_choices() {
  const TracePreview* const preview = uses_->job.preview();
  if (preview == nullptr || chosen_for_ == uses_->job.preview_number()) return;
  chosen_for_ = uses_->job.preview_number();
  threshold_ = preview->level.value_or(Level{}).below;
  specks_ = preview->specks;
  side_ = FigureSide::found;
}

TraceRequest TraceDialog::request() const {
  return {.threshold = static_cast<int>(std::lround(threshold_)), .specks = specks_, .figure = side_};
}

void TraceDialog::draw_choices(const Gui& gui) {
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TextUnformatted("Threshold");
  slider(gui, "##threshold", threshold_, 0.0, 254.0, {.format = "%.0f", .is_whole = true, .width = width});
  tooltip(gui, "Grey value, from black (0) to white (255): the largest one on the dark side");
  ImGui::TextUnformatted("Leave out specks below");
  slider(gui, "##specks", specks_, 1.0, kMostSpecks,
         {.format = "%.0f px", .is_logarithmic = true, .is_whole = true, .width = width});
  tooltip(gui, "Outlines and holes of less than this many square pixels are left out");
  ImGui::TextUnformatted("Figure");
  bool is_first = true;
  for (const SideWord& side : kSides) {
    if (!is_first) ImGui::SameLine();
    is_first = false;
    if (choice_button(side.word, side_ == side.side)) side_ = side.side;
    tooltip(gui, side.explanation);
  }
}

void TraceDialog::draw_facts(const Gui& gui) {
  if (uses_->job.preview() == nullptr) {
    ImGui::TextDisabled("Reading the picture...");
    return;
  }
  const Expected<Tracing>& outlines = uses_->job.outlines(request());
  if (outlines) {
    if (const auto counts = uses_->job.counts(request())) {
      paragraph(counted(counts->outlines, "outline"));
      if (const std::string left_out = left_out_text(*counts); !left_out.empty())
        quiet_paragraph("Left out: " + left_out);
    } else {
      ImGui::TextDisabled("Counting outlines...");
    }
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
    paragraph(outlines.error().text);
    ImGui::PopStyleColor();
  }
}

void TraceDialog::draw_buttons(const Gui& gui, ButtonRows& buttons) {
  const bool is_read = uses_->job.preview() != nullptr && !uses_->job.is_tracing();
  const bool is_possible = is_read && uses_->job.outlines(request()).has_value();
  ImGui::BeginDisabled(!is_possible);
  const bool is_clicked = buttons.next(true);
  ImGui::EndDisabled();
  tooltip(gui, "The sampled outlines become a new document");
  if ((is_clicked || is_accepted_) && is_possible) uses_->trace(request());
  is_accepted_ = false;
  if (buttons.next()) uses_->lay_underneath();
  tooltip(gui, "Show the picture below the drawing, to place samples along it by hand");
  if (buttons.next()) cancel();
}

void TraceDialog::draw_preview(const Gui& gui) {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, gui.colors().field, 4 * unit);
  const TracePreview* const preview = uses_->job.preview();
  const ImTextureID texture = uses_->texture();
  if (preview == nullptr || texture == nullptr) return;
  const float margin = 12 * unit;
  const Placed place =
      placed({at.x + margin, at.y + margin}, {room.x - 2 * margin, room.y - 2 * margin}, preview->image);
  const ImVec2 end(place.at.x + place.scale * static_cast<float>(preview->image.width),
                   place.at.y + place.scale * static_cast<float>(preview->image.height));
  list.AddImage(texture, place.at, end);
  list.AddRect({place.at.x - 1, place.at.y - 1}, {end.x + 1, end.y + 1}, gui.colors().border);
  constexpr ImU32 kOutline = IM_COL32(230, 60, 20, 255);
  if (const auto& outlines = uses_->job.outlines(request()); outlines)
    draw_outlines(outlines->curves, place, preview->image.height, kOutline, 2 * unit);
}

void TraceDialog::draw(const Gui& gui) {
  static constexpr std::array kButtons{"Trace into samples", "Lay underneath", "Cancel"};
  large_dialog(gui, kTraceDialogId, is_open_, {kTraceDialogWidth, kTraceDialogHeight}, DialogKeys::controls,
               [&](ImVec2) {
                 begin_choices();
                 const DialogColumn columns[] = {
                     {"settings", kChoices,
                      [&] {
                        heading(gui, "Trace a picture");
                        const std::string name = uses_->job.file().filename().string();
                        ImGui::TextUnformatted(elided(name, ImGui::GetContentRegionAvail().x).c_str());
                        ImGui::Dummy({1, 2 * gui.unit()});
                        draw_choices(gui);
                        ImGui::Dummy({1, 2 * gui.unit()});
                        draw_facts(gui);
                      }},
                     {"preview", 0, [&] { draw_preview(gui); }}};
                 dialog_columns(gui, columns, {kButtons, [&](ButtonRows& buttons) { draw_buttons(gui, buttons); }});
               });
}

}  // namespace mes
