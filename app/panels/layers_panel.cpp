// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/layers_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "app/ui/icons.h"
#include "app/ui/theme.h"
#include "imgui_stdlib.h"
#include "render/convert.h"

namespace mes {
namespace {

constexpr const char* kDragKind = "mesecina-layer";

bool has_kind(const LayerDescriptor& descriptor, std::initializer_list<PrimitiveKind> kinds) {
  return std::ranges::any_of(kinds,
                             [&](PrimitiveKind kind) { return std::ranges::count(descriptor.kinds, kind) > 0; });
}
bool has_points(const LayerDescriptor& descriptor) {
  return has_kind(descriptor, {PrimitiveKind::point});
}
bool has_strokes(const LayerDescriptor& descriptor) {
  return has_kind(descriptor, {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line, PrimitiveKind::circle,
                               PrimitiveKind::arc});
}

bool is_failed(NodeState state) {
  return state == NodeState::failed || state == NodeState::blocked;
}

// Rows lie close together; what opens from them does not.
class PopupSpacing {
 public:
  explicit PopupSpacing(float unit) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 7 * unit});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  }
  ~PopupSpacing() { ImGui::PopStyleVar(2); }
  PopupSpacing(const PopupSpacing&) = delete;
  PopupSpacing& operator=(const PopupSpacing&) = delete;
};

// From the palette, or any.
void draw_color_choice(float unit, LayerStyle& style) {
  constexpr std::array<Rgb, 9> kPalette{palette::black,     palette::orange, palette::sky,
                                        palette::green,     palette::yellow, palette::blue,
                                        palette::vermilion, palette::purple, palette::grey};
  for (std::size_t i = 0; i < kPalette.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 4 * unit);
    ImGui::PushID(static_cast<int>(i));
    const ImVec4 color = ImGui::ColorConvertU32ToFloat4(to_imgui(kPalette[i]));
    if (ImGui::ColorButton("##color", color, ImGuiColorEditFlags_NoTooltip, {22 * unit, 22 * unit}))
      style.color = kPalette[i];
    ImGui::PopID();
  }
  glm::vec3 rgb = render::to_vec3(style.color);
  // In a low window the sliders below it shall have room, too.
  ImGui::SetNextItemWidth(std::min(230 * unit, 0.3F * ImGui::GetIO().DisplaySize.y));
  if (ImGui::ColorPicker3(
          "##picker", glm::value_ptr(rgb),
          ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_DisplayHex))
    style.color = render::to_rgb(rgb);
}

std::string milliseconds(double ms) {
  return fmt::format("{:.{}f} ms", ms, ms < 10.0 ? 2 : 0);
}

}  // namespace

std::string LayersPanel::explanation(LayerIndex layer) const {
  std::string out(layers_.descriptor(layer).tooltip);
  // Nothing is computed for the picture to trace.
  if (layers_.descriptor(layer).kinds.empty()) return out;
  const LayerReport* report = picture_.report(layer);
  if (report == nullptr || !layers_.is_visible(layer)) return out;
  if (is_failed(report->state)) return out + "\n\nNot up to date: " + report->reason;
  if (report->state == NodeState::computing) return out + "\n\nBeing computed";
  return out + "\n\nUp to date; drawn from the structures in " + milliseconds(report->emit_ms);
}

bool LayersPanel::is_listed(LayerIndex layer) const {
  return (!only_visible_ || layers_.is_visible(layer)) && matches_search(layers_.descriptor(layer), search_);
}

void LayersPanel::draw_head() {
  const float unit = gui_.unit();
  ImGui::PushFont(gui_.bold());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Layers");
  ImGui::PopFont();
  const float padding = ImGui::GetStyle().FramePadding.x;
  const float width = ImGui::CalcTextSize("SubjectOrder").x + 4 * padding + 2 * unit;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  if (choice_button("Subject", !by_order_)) by_order_ = false;
  tooltip(gui_, "List the layers by what they are about");
  ImGui::SameLine(0, 2 * unit);
  if (choice_button("Order", by_order_)) by_order_ = true;
  tooltip(gui_, "List the layers as they lie on each other, top first");
  ImGui::SetNextItemWidth(-ImGui::CalcTextSize("Only visible").x - ImGui::GetFrameHeight() - 14 * unit);
  ImGui::InputTextWithHint("##search", "Search", &search_);
  ImGui::SameLine();
  ImGui::Checkbox("Only visible", &only_visible_);
  tooltip(gui_, "List only the layers that are shown");
  if (layers_.soloed() != kNoLayer) {
    if (ImGui::SmallButton("End solo")) layers_.end_solo();
    tooltip(gui_, "Show the other layers again");
  }
  ImGui::Dummy({0, 1 * unit});
}

void LayersPanel::draw_swatch(LayerIndex layer, ImVec2 at, ImVec2 size) const {
  const Rgb canvas = picture_.canvas();
  const LayerStyle style = drawn_on(layers_.style(layer), canvas);
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  const float unit = gui_.unit();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  list.AddRectFilled(at, end, to_imgui(canvas), 3 * unit);
  list.PushClipRect(at, end, true);
  const auto& maps = picture_.scene().color_maps();
  const auto map = std::ranges::find(maps, style.color_map, &render::ColorMap::name);
  const bool is_mapped = map != maps.end() && !descriptor.scalar.empty();
  if (is_mapped) draw_color_map(list, *map, at, size, style.opacity);
  const ImU32 color = to_imgui(style.color, style.opacity);
  const ImVec2 middle(0.5F * (at.x + end.x), 0.5F * (at.y + end.y));
  const float width = std::clamp(static_cast<float>(style.line_width_px) * unit, 1.0F, 0.6F * size.y);
  if (descriptor.kinds.empty()) {
    // A sun above a hill.
    const ImU32 ink = to_imgui(palette::grey, layers_.image().file.empty() ? 0.5 : 1.0);
    list.AddCircleFilled({at.x + 0.3F * size.x, at.y + 0.35F * size.y}, 0.14F * size.y, ink);
    list.AddTriangleFilled({at.x + 0.25F * size.x, end.y - 3 * unit}, {at.x + 0.6F * size.x, at.y + 0.3F * size.y},
                           {end.x - 2 * unit, end.y - 3 * unit}, ink);
  } else if (is_mapped) {
    // Its colours say enough.
  } else if (has_kind(descriptor, {PrimitiveKind::disk, PrimitiveKind::triangle}))
    list.AddRectFilled(at, end, color, 3 * unit);
  else if (has_kind(descriptor, {PrimitiveKind::circle, PrimitiveKind::arc}))
    list.AddCircle(middle, 0.36F * size.y, color, 0, width);
  else if (has_strokes(descriptor))
    list.AddLine({at.x + 4 * unit, end.y - 4 * unit}, {end.x - 4 * unit, at.y + 4 * unit}, color, width);
  if (has_points(descriptor) && !is_mapped)
    list.AddCircleFilled(
        middle, std::clamp(0.5F * static_cast<float>(style.point_size_px) * unit, 1.5F, 0.42F * size.y), color);
  list.PopClipRect();
  list.AddRect(at, end, gui_.colors().border, 3 * unit);
}

void LayersPanel::draw_style_popup(LayerIndex layer) {
  const float unit = gui_.unit();
  const PopupSpacing spacing(unit);
  if (!ImGui::BeginPopup("style")) return;
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  LayerStyle style = layers_.style(layer);
  ImGui::PushFont(gui_.bold());
  ImGui::TextUnformatted(descriptor.name.data(), descriptor.name.data() + descriptor.name.size());
  ImGui::PopFont();

  const bool is_picture = descriptor.kinds.empty();
  if (is_picture) image_.draw();
  color_maps_.draw(layer, style);
  // The plain colour counts only without a map.
  if (style.color_map.empty() && !is_picture) draw_color_choice(unit, style);
  const auto slider = [&](const char* label, double& value, float low, float high, float factor, const char* format,
                          bool logarithmic) {
    auto shown = static_cast<float>(value) * factor;
    ImGui::SetNextItemWidth(150 * unit);
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    if (ImGui::SliderFloat(label, &shown, low, high, format, flags)) value = static_cast<double>(shown / factor);
  };
  slider("Opacity", style.opacity, 0.0F, 100.0F, 100.0F, "%.0f %%", false);
  if (has_points(descriptor)) slider("Point size", style.point_size_px, 0.5F, 64.0F, 1.0F, "%.1f px", true);
  if (has_strokes(descriptor)) {
    slider("Line width", style.line_width_px, 0.1F, 64.0F, 1.0F, "%.1f px", true);
    ImGui::Checkbox("Dashed", &style.dashed);
  }
  if (!is_picture) ImGui::Checkbox("Flat", &style.flat);
  if (!is_picture)
    tooltip(gui_, "Where parts of this layer overlap they do not add up: a union of disks is one even area");
  layers_.set_style(layer, style);
  ImGui::BeginDisabled(layers_.has_default_style(layer));
  if (ImGui::Button("Reset style")) layers_.reset_style(layer);
  ImGui::EndDisabled();
  ImGui::EndPopup();
}

// A colour map goes along, but not to a layer that has nothing to show by it.
void LayersPanel::paste_style(LayerIndex layer) const {
  LayerStyle style = *copied_;
  if (layers_.descriptor(layer).scalar.empty()) style.color_map.clear();
  layers_.set_style(layer, style);
}

void LayersPanel::draw_context_menu(LayerIndex layer) {
  const PopupSpacing spacing(gui_.unit());
  if (!ImGui::BeginPopupContextItem("menu")) return;
  if (layers_.soloed() == layer) {
    if (ImGui::MenuItem("End solo")) layers_.end_solo();
  } else if (ImGui::MenuItem("Solo")) {
    layers_.solo(layer);
  }
  tooltip(gui_, "Show this layer alone");
  ImGui::Separator();
  if (ImGui::MenuItem("Bring to front")) layers_.move(layer, layers_.order().back(), true);
  if (ImGui::MenuItem("Send to back")) layers_.move(layer, layers_.order().front(), false);
  ImGui::Separator();
  if (ImGui::MenuItem("Copy style")) copied_ = layers_.style(layer);
  if (ImGui::MenuItem("Paste style", nullptr, false, copied_.has_value())) paste_style(layer);
  if (ImGui::MenuItem("Reset style", nullptr, false, !layers_.has_default_style(layer))) layers_.reset_style(layer);
  ImGui::EndPopup();
}

void LayersPanel::draw_row(LayerIndex layer) {
  const float unit = gui_.unit();
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  const bool visible = layers_.is_visible(layer);
  const NodeState state = picture_.state(layer);
  const float height = 27 * unit;
  ImGui::PushID(static_cast<int>(layer));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 swatch_size(30 * unit, 18 * unit);
  const ImVec2 swatch_at(at.x + width - swatch_size.x - 2 * unit, at.y + 0.5F * (height - swatch_size.y));

  // The swatch lies on the row and is asked first.
  ImGui::SetCursorScreenPos(swatch_at);
  if (ImGui::InvisibleButton("swatch", swatch_size)) ImGui::OpenPopup("style");
  tooltip(gui_, descriptor.scalar.empty() ? "Colour, opacity, sizes" : "Colour, colour map, opacity, sizes");
  draw_style_popup(layer);

  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton("row", {std::max(1.0F, width - swatch_size.x - 6 * unit), height});
  const bool hovered = ImGui::IsItemHovered();
  if (clicked) layers_.set_visible(layer, !visible);
  tooltip(gui_, explanation(layer));
  draw_context_menu(layer);
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kDragKind, &layer, sizeof layer);
    ImGui::TextUnformatted(descriptor.name.data(), descriptor.name.data() + descriptor.name.size());
    ImGui::EndDragDropSource();
  }
  if (ImGui::BeginDragDropTarget()) {
    const bool above = ImGui::GetIO().MousePos.y < at.y + 0.5F * height;
    const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(
        kDragKind, ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    if (payload != nullptr) {
      const float y = above ? at.y : at.y + height;
      list.AddLine({at.x, y}, {at.x + width, y}, gui_.colors().accent, 2 * unit);
      if (payload->IsDelivery()) layers_.move(*static_cast<const LayerIndex*>(payload->Data), layer, above);
    }
    ImGui::EndDragDropTarget();
  }

  if (hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, gui_.colors().accent_faint, 4 * unit);
  const float icon = 18 * unit;
  const bool failed = visible && is_failed(state);
  draw_icon(list, visible ? Icon::eye : Icon::eye_closed, {at.x + 2 * unit, at.y + 0.5F * (height - icon)}, icon,
            visible ? gui_.colors().text : gui_.colors().text_faint);
  const float text_y = at.y + 0.5F * (height - ImGui::GetFontSize());
  list.PushClipRect(at, {swatch_at.x - 6 * unit, at.y + height}, true);
  list.AddText({at.x + 27 * unit, text_y},
               failed    ? gui_.colors().warning
               : visible ? gui_.colors().text
                         : gui_.colors().text_quiet,
               descriptor.name.data(), descriptor.name.data() + descriptor.name.size());
  list.PopClipRect();
  if (visible && state == NodeState::computing)
    list.AddCircleFilled({swatch_at.x - 10 * unit, at.y + 0.5F * height}, 3 * unit, gui_.colors().accent);
  draw_swatch(layer, swatch_at, swatch_size);
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  ImGui::PopID();
}

void LayersPanel::draw(const PanelArea& area) {
  if (begin_panel("##layers", area)) {
    draw_head();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("rows");
    // A row may change the order while it is drawn.
    const std::vector<LayerIndex> order(layers_.order().begin(), layers_.order().end());
    const bool flat_list = by_order_ || !search_.empty();
    std::size_t listed = 0;
    for (const LayerGroup group :
         {LayerGroup::samples, LayerGroup::delaunay_voronoi, LayerGroup::crust_axis, LayerGroup::poles,
          LayerGroup::union_a, LayerGroup::union_p, LayerGroup::union_b, LayerGroup::diagnostics}) {
      const auto belongs = [&](LayerIndex layer) {
        return is_listed(layer) && (flat_list || layers_.descriptor(layer).group == group);
      };
      const auto count = static_cast<std::size_t>(std::ranges::count_if(order, belongs));
      listed += count;
      if (count == 0) continue;
      if (!flat_list) {
        const std::string title(title_of(group));
        ImGui::PushFont(gui_.small());
        ImGui::PushStyleColor(ImGuiCol_Text, gui_.colors().text_quiet);
        ImGui::PushStyleColor(ImGuiCol_Header, 0);
        const bool open = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        ImGui::PopStyleColor(2);
        ImGui::PopFont();
        if (!open) continue;
      }
      for (auto layer = order.rbegin(); layer != order.rend(); ++layer)
        if (belongs(*layer)) draw_row(*layer);
      if (flat_list) break;
    }
    if (listed == 0) ImGui::TextDisabled("No layer matches");
    ImGui::EndChild();
    ImGui::PopStyleVar();
  }
  ImGui::End();
}

}  // namespace mes
