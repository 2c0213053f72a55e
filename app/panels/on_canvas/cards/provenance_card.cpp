// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/cards/provenance_card.h"

#include <algorithm>

#include "app/panels/on_canvas/marks/shape_pen.h"
#include "app/picture/annotations/highlight_drawing.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/draw/primitive_values.h"

namespace mes {
namespace {

constexpr double kReachPx = 7.0;
constexpr std::size_t kMostShapes = 4000;
constexpr double kMarginPx = 160.0;  // margin around an element shown by a click on its row

struct Look {
  Rgb color;
  float width;
  const char* heading;
};
Look look_of(ProvenanceRole role) {
  const Rgb color = highlight_color(role);
  switch (role) {
    case ProvenanceRole::itself: return {color, 3.5F, ""};
    case ProvenanceRole::origin: return {color, 2.5F, "comes from"};
    case ProvenanceRole::product: return {color, 2.0F, "leads to"};
  }
  return {color, 1.0F, ""};
}

// For an unbounded shape, the box of its beginning.
Box2 box_of(const ProvenanceShape& shape) {
  const auto& v = shape.values;
  Box2 out;
  switch (shape.kind) {
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: return bounding_box_of(Disk{{v[0], v[1]}, v[2]});
    case PrimitiveKind::arc:
      out.add(Vec2{v[3], v[4]});
      out.add(Vec2{v[5], v[6]});
      return out;
    case PrimitiveKind::parabola: return bounding_box_of(parabola_of(v.data()));
    case PrimitiveKind::triangle: out.add(Vec2{v[4], v[5]}); [[fallthrough]];
    case PrimitiveKind::segment: out.add(Vec2{v[2], v[3]}); [[fallthrough]];
    case PrimitiveKind::point:
    case PrimitiveKind::ray:
    case PrimitiveKind::line: out.add(Vec2{v[0], v[1]});
  }
  return out;
}

PenLook pen_look(const Gui& gui, ProvenanceRole role, bool is_dim) {
  const Look look = look_of(role);
  const PenMark mark = role == ProvenanceRole::itself   ? PenMark::dot
                       : role == ProvenanceRole::origin ? PenMark::ring
                                                        : PenMark::square;
  return {to_imgui(look.color, is_dim ? 0.25 : 1.0), look.width * gui.unit(), mark};
}

}  // namespace

ProvenanceQuestion question_at(const Pointer& pointer, const LayerStack& layers) {
  ProvenanceQuestion out{0, pointer.world, kReachPx * pointer.units_per_px, main_layers(layers.visible_layers())};
  std::ranges::reverse(out.layers);
  return out;
}

void ProvenanceCard::ask(Engine& engine, const LayerStack& layers, ProvenanceQuestion question,
                         const Editor& editor) {
  question.ticket = ++ticket_;
  is_asking_ = true;
  wants_beneath_ = false;
  beneath_ = Beneath::unknown;
  beneath_answer_.reset();
  question_ = question;
  layers_ = main_layers(layers.visible_layers());
  std::ranges::reverse(layers_);
  document_revision_ = editor.document().revision();
  selection_revision_ = editor.selection().revision();
  answer_.reset();
  engine.ask(std::move(question));
}

void ProvenanceCard::take(Provenance answer) {
  if (answer.ticket != ticket_) return;
  is_asking_ = false;
  std::optional<Provenance> found;
  if (!answer.lines.empty()) found = std::move(answer);
  if (beneath_ == Beneath::asked) {
    beneath_answer_ = std::move(found);
    beneath_ = Beneath::known;
    return;
  }
  answer_ = std::move(found);
  pointed_at_ = 0;
  frames_to_place_ = 3;
}

std::vector<VariantLayer> ProvenanceCard::layers_beneath() const {
  const auto found = std::ranges::find(layers_, answer_->layer);
  return found == layers_.end() ? std::vector<VariantLayer>() : std::vector<VariantLayer>(found + 1, layers_.end());
}

void ProvenanceCard::look_beneath(Engine& engine) {
  if (std::exchange(wants_beneath_, false) && beneath_answer_) {
    answer_ = std::exchange(beneath_answer_, {});
    beneath_ = Beneath::unknown;
    pointed_at_ = 0;
  }
  if (!answer_ || beneath_ != Beneath::unknown || is_asking_) return;
  question_.layers = layers_beneath();
  beneath_ = question_.layers.empty() ? Beneath::known : Beneath::asked;
  if (question_.layers.empty()) return;
  question_.ticket = ++ticket_;
  is_asking_ = true;
  engine.ask(question_);
}

bool ProvenanceCard::clear() {
  ++ticket_;  // makes an answer under way outdated
  is_asking_ = false;
  beneath_answer_.reset();
  beneath_ = Beneath::unknown;
  return std::exchange(answer_, {}).has_value();
}

void ProvenanceCard::draw_shapes(const Gui& gui, const Canvas& canvas) const {
  std::size_t shapes = 0;
  // Draws the element itself last, on top of the others.
  for (std::size_t i = answer_->lines.size(); i-- > 0;) {
    const ProvenanceLine& line = answer_->lines[i];
    const ShapePen pen(gui, {canvas.view().camera()}, canvas.content_scale(),
                       pen_look(gui, line.role, pointed_at_ != 0 && pointed_at_ != i + 1));
    for (const ProvenanceShape& shape : line.shapes)
      if (++shapes <= kMostShapes) pen.draw(shape);
  }
}

ProvenanceCard::HeadClicks ProvenanceCard::draw_head(const Gui& gui, const LayerStack& layers, float width,
                                                     const std::string& keep_key) {
  const float unit = gui.unit();
  const ImVec2 at = ImGui::GetCursorPos();
  const float keep_width = ImGui::CalcTextSize("Keep").x + 8 * unit;
  hit_area("head", {width - 48 * unit - keep_width, ImGui::GetTextLineHeight()});
  if (ImGui::IsItemActive()) {
    is_dragged_ = is_dragged_ || ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1.0F);
    moved_.x += ImGui::GetIO().MouseDelta.x;
    moved_.y += ImGui::GetIO().MouseDelta.y;
  }
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  const std::string& name = layers.descriptor(answer_->layer.layer).name;
  tooltip(gui, name + "\nDrag to move this card");
  ImGui::SetCursorPos(at);
  ImGui::TextDisabled("%s", elided(name, width - 48 * unit - keep_width).c_str());
  HeadClicks out;
  ImGui::SameLine(width - 38 * unit - keep_width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4 * unit, 0.0F});
  out.kept = ImGui::Button("Keep");
  ImGui::PopStyleVar();
  tooltip(gui, "Keep all of this highlighted, as an annotation" + (keep_key.empty() ? "" : " (" + keep_key + ')') +
                   "; Shift+click on a row keeps it alone");
  ImGui::SameLine(width - 30 * unit);
  out.closed = icon_button("close", Icon::close, ImGui::GetTextLineHeight());
  tooltip(gui, "Close (Esc)");
  return out;
}

std::optional<std::size_t> ProvenanceCard::draw_lines(const Gui& gui, float width) {
  const float unit = gui.unit();
  std::optional<std::size_t> clicked;
  std::size_t pointed_at = 0;
  ProvenanceRole heading = ProvenanceRole::itself;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < answer_->lines.size(); ++i) {
    const ProvenanceLine& line = answer_->lines[i];
    const Look look = look_of(line.role);
    if (line.role != heading) {
      heading = line.role;
      ImGui::Dummy({0, 2 * unit});
      ImGui::TextDisabled("%s", look.heading);
    }
    const float wrap = width - 40 * unit;
    const std::string text = broken_lines(line.text, wrap);
    const float height = ImGui::CalcTextSize(text.c_str()).y;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    const bool is_clicked = hit_area("line", {width - 20 * unit, height});
    ImGui::PopID();
    if (ImGui::IsItemHovered()) {
      pointed_at = i + 1;
      if (!line.shapes.empty())
        list.AddRectFilled({at.x, at.y - 1 * unit}, {at.x + width - 20 * unit, at.y + height + 1 * unit},
                           gui.colors().accent_faint, 3 * unit);
    }
    if (!line.shapes.empty()) tooltip(gui, "Click to show where it is; Shift+click to keep it highlighted");
    if (is_clicked && !line.shapes.empty()) clicked = i;
    const float r = 4.0F * unit;
    const ImVec2 mark{at.x + 6 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()};
    const ImU32 color = to_imgui(look.color);
    if (line.role == ProvenanceRole::itself) list.AddCircleFilled(mark, r, color);
    if (line.role == ProvenanceRole::origin) list.AddCircle(mark, r, color, 0, 2 * unit);
    if (line.role == ProvenanceRole::product)
      list.AddRect({mark.x - r, mark.y - r}, {mark.x + r, mark.y + r}, color, 0.0F, 0, 2 * unit);
    list.AddText({at.x + 18 * unit, at.y}, gui.colors().text, text.c_str());
  }
  pointed_at_ = pointed_at;
  return clicked;
}

void ProvenanceCard::draw_rows(const Gui& gui, float width) {
  if (answer_->rows.empty()) return;
  const float unit = gui.unit();
  const auto title = [](const ProvenanceRow& row) { return "Row " + std::to_string(row.row) + " of " + row.table; };
  ImGui::Dummy({0, 2 * unit});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  if (hit_area("rows", {width - 20 * unit, height})) shows_rows_ = !shows_rows_;
  tooltip(gui, shows_rows_ ? "Fold the row away" : "Show the table values of this element");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_fold(list, {at.x + 6 * unit, at.y + 0.5F * height}, 4 * unit, shows_rows_, gui.colors().text_quiet);
  list.AddText({at.x + 18 * unit, at.y}, gui.colors().text_quiet, title(answer_->rows.front()).c_str());
  if (!shows_rows_) return;
  ImGui::Indent(18 * unit);
  for (const ProvenanceRow& row : answer_->rows) {
    if (&row != &answer_->rows.front()) ImGui::TextDisabled("%s", title(row).c_str());
    ImGui::Indent(12 * unit);
    for (const ProvenanceRow::Value& value : row.values) {
      ImGui::TextDisabled("%s", value.name.c_str());
      tooltip(gui, value.description);
      ImGui::SameLine(150 * unit);
      paragraph(value.text, width - 10 * unit - ImGui::GetCursorPosX());
    }
    ImGui::Unindent(12 * unit);
  }
  ImGui::Unindent(18 * unit);
}

void ProvenanceCard::draw_foot(const Gui& gui, const LayerStack& layers, float width) {
  if (ImGui::SmallButton("Select the samples")) wants_sources_ = true;
  tooltip(gui, "Select the samples or balls from which this derives");
  if (!beneath_answer_) return;
  ImGui::SameLine();
  const float room = width - ImGui::GetCursorPosX() - 16 * gui.unit();
  const std::string text = "Beneath: " + std::string(layers.descriptor(beneath_answer_->layer.layer).name);
  if (ImGui::SmallButton(elided(text, room).c_str())) wants_beneath_ = true;
  tooltip(gui, "Show this instead: " + beneath_answer_->lines.front().text);
}

bool ProvenanceCard::is_of(const Editor& editor) const {
  return editor.document().revision() == document_revision_ && editor.selection().revision() == selection_revision_;
}

void ProvenanceCard::choose_corner(const PanelArea& room, ImVec2 size,
                                   const std::function<std::size_t(const Box2&)>& hides) {
  if (frames_to_place_ == 0 || is_dragged_) return;
  --frames_to_place_;
  std::optional<std::size_t> least;
  for (const auto& [is_right, is_top] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
    const Vec2 low{is_right ? room.at.x + room.size.x - size.x : room.at.x,
                   is_top ? room.at.y : room.at.y + room.size.y - size.y};
    const Box2 box{low, low + Vec2{size.x, size.y}};
    // The clicked element is below the pointer while the card opens.
    constexpr std::size_t kClicked = 64;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const std::size_t hidden = hides(box) + (box.contains({pointer.x, pointer.y}) ? kClicked : 0U);
    if (least && hidden >= *least) continue;
    least = hidden;
    is_right_ = is_right;
    is_top_ = is_top;
  }
}

std::optional<ProvenanceCard::Keep> ProvenanceCard::draw(const Gui& gui, Canvas& canvas, const Editor& editor,
                                                         const LayerStack& layers, const PanelArea& room,
                                                         const std::function<std::size_t(const Box2&)>& hides,
                                                         const std::string& keep_key) {
  if (answer_ && !is_of(editor)) clear();
  if (!answer_) return std::nullopt;
  draw_shapes(gui, canvas);
  const float unit = gui.unit();
  const float width = std::min(390 * unit, room.size.x);
  const float most = 0.6F * room.size.y;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  choose_corner(room, {width, height_}, hides);
  const ImVec2 corner(is_right_ ? room.at.x + room.size.x - width : room.at.x,
                      is_top_ ? room.at.y : room.at.y + room.size.y);
  // The header must stay in the window.
  moved_.x = std::clamp(moved_.x, -corner.x, std::max(-corner.x, screen.x - width - corner.x));
  const float least_y = (is_top_ ? 0.0F : 60 * unit) - corner.y;
  const float most_y = screen.y - (is_top_ ? 60 * unit : 0.0F) - corner.y;
  moved_.y = std::clamp(moved_.y, least_y, std::max(least_y, most_y));
  ImGui::SetNextWindowPos({corner.x + moved_.x, corner.y + moved_.y}, ImGuiCond_Always,
                          {0.0F, is_top_ ? 0.0F : 1.0F});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, most});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 8 * unit});
  ImGui::Begin("##provenance", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  const float inside = width - (ImGui::GetScrollMaxY() > 0.0F ? ImGui::GetStyle().ScrollbarSize : 0.0F);
  const HeadClicks head = draw_head(gui, layers, inside, keep_key);
  const std::optional<std::size_t> clicked = draw_lines(gui, inside);
  draw_rows(gui, inside);
  draw_foot(gui, layers, inside);
  height_ = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar();
  if (head.kept) return Keep{};
  if (clicked && ImGui::GetIO().KeyShift) return Keep{clicked};
  if (clicked) {
    Box2 box;
    for (const ProvenanceShape& shape : answer_->lines[*clicked].shapes) box.add(box_of(shape));
    canvas.view().fit(box, kMarginPx * canvas.content_scale());
  }
  if (head.closed) clear();
  return std::nullopt;
}

}  // namespace mes
