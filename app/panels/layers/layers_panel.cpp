// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/layers/layers_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cfloat>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <utility>

#include "app/editing/curves/sample_spacing.h"
#include "app/layers/words/parameter_words.h"
#include "app/picture/paper/canvas_look.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/counted.h"
#include "imgui_stdlib.h"
#include "render/device/convert.h"

namespace mes {
namespace {

constexpr const char* kLayerDragKind = "mesecina-layer";
constexpr const char* kSampleText = "12";

bool has_kind(const LayerDescriptor& descriptor, std::initializer_list<PrimitiveKind> kinds) {
  return std::ranges::any_of(kinds,
                             [&](PrimitiveKind kind) { return std::ranges::count(descriptor.kinds, kind) > 0; });
}
bool has_points(const LayerDescriptor& descriptor) {
  return descriptor.points_as == PointsAs::dots && has_kind(descriptor, {PrimitiveKind::point});
}
bool has_strokes(const LayerDescriptor& descriptor) {
  return has_kind(descriptor, {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line, PrimitiveKind::circle,
                               PrimitiveKind::arc, PrimitiveKind::parabola});
}

bool is_failed(NodeState state) {
  return state == NodeState::failed || state == NodeState::blocked;
}

// Rows are close together; popups opened from them have more spacing.
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

// Chooses a colour from the palette, or any other.
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
  // In a low window the sliders below it need room, too.
  ImGui::SetNextItemWidth(std::min(230 * unit, 0.3F * ImGui::GetIO().DisplaySize.y));
  if (ImGui::ColorPicker3(
          "##picker", glm::value_ptr(rgb),
          ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview | ImGuiColorEditFlags_DisplayHex))
    style.color = render::to_rgb(rgb);
}

/// Below the switch of families the headings of unions do not repeat what they are of.
std::string heading_of(const LayerSection& section) {
  const std::size_t colon = section.title.find(": ");
  if (!section.is_of_union || colon == std::string::npos) return section.title;
  std::string out = section.title.substr(colon + 2);
  // A v-point is written with a small letter.
  if (!out.starts_with("v-")) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

std::string milliseconds(double ms) {
  return fmt::format("{:.{}f} ms", ms, ms < 10.0 ? 2 : 0);
}

}  // namespace

std::string LayersPanel::explanation(LayerIndex layer) const {
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  std::string out = std::string(descriptor.name) + '\n' + with_titles(descriptor.tooltip);
  // The picture to trace has no computed content.
  if (layers_.descriptor(layer).kinds.empty()) return out;
  const LayerReport* report = picture_.report(layer);
  if (report == nullptr || !layers_.is_visible(layer)) return out;
  if (is_failed(report->state)) return out + "\n\nNot up to date: " + report->reason;
  if (report->state == NodeState::computing) return out + "\n\nBeing computed";
  if (is_without_content(layer)) return out + "\n\nEmpty in this document";
  return out + "\n\nUp to date; drawing data prepared in " + milliseconds(report->emit_ms);
}

// True if the layer is up to date and has nothing to draw.
bool LayersPanel::is_without_content(LayerIndex layer) const {
  return count_of(layer) == std::size_t{0};
}

void LayersPanel::draw_head() {
  const float unit = gui_.unit();
  draw_search();
  if (choice_button("Subject", !options_.by_order)) options_.by_order = false;
  tooltip(gui_, "List favourites and shown layers first, then all layers by subject");
  ImGui::SameLine(0, 2 * unit);
  if (choice_button("Order", options_.by_order)) options_.by_order = true;
  tooltip(gui_, "List the layers in drawing order, topmost first");
  const float gap = 10 * unit;
  const float check =
      ImGui::CalcTextSize("Only shown").x + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SameLine(0, gap);
  if (ImGui::GetContentRegionAvail().x < check) ImGui::NewLine();
  checkbox("Only shown", &options_.only_shown);
  tooltip(gui_, "List only the layers that are shown");
  if (layers_.soloed() != kNoLayer) {
    if (ImGui::Button("End solo")) layers_.end_solo();
    tooltip(gui_, "Show the other layers again");
  }
  ImGui::Dummy({0, 1 * unit});
}

void LayersPanel::draw_search() {
  const float button = ImGui::GetFrameHeight();
  const bool is_empty = options_.search.empty();
  const float width = std::max(button, ImGui::GetContentRegionAvail().x - button);
  const char* const hint = width > 220 * gui_.unit() ? "Search names, ids and other words" : "Search";
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint("##search", hint, &options_.search);
  // Dear ImGui restores the old text on Esc; we want it empty.
  if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) options_.search.clear();
  ImGui::SameLine(0, 0);
  if (is_empty) {
    ImGui::Dummy({button, button});
  } else {
    if (icon_button("clear", Icon::close, button)) options_.search.clear();
    tooltip(gui_, "Clear the search (Esc)");
  }
}

// Chooses the family whose layers follow.
void LayersPanel::draw_families() const {
  const float unit = gui_.unit();
  constexpr std::array<const char*, kBallFamilies.size()> kWords{"Inner", "Polar", "Own"};
  ImGui::Dummy({0, 3 * unit});
  ImGui::AlignTextToFramePadding();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 4 * unit);
  ImGui::PushFont(gui_.small());
  ImGui::TextDisabled("Union of balls");
  ImGui::PopFont();
  for (const FamilyKind family : kBallFamilies) {
    const auto place = static_cast<std::size_t>(family);
    const ActionId id = nth(ActionId::balls_inner, place);
    ImGui::SameLine(0, (place == 0 ? 8 : 2) * unit);
    if (choice_button(kWords[place], actions_.is_checked(id))) actions_.run(id);
    tooltip(gui_, actions_.tooltip_of(id));
  }
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
    // Draws a sun above a hill.
    const ImU32 ink = to_imgui(palette::grey, layers_.image().file.empty() ? 0.5 : 1.0);
    list.AddCircleFilled({at.x + 0.3F * size.x, at.y + 0.35F * size.y}, 0.14F * size.y, ink);
    list.AddTriangleFilled({at.x + 0.25F * size.x, end.y - 3 * unit}, {at.x + 0.6F * size.x, at.y + 0.3F * size.y},
                           {end.x - 2 * unit, end.y - 3 * unit}, ink);
  } else if (descriptor.points_as != PointsAs::dots) {
    const float letters = std::clamp(static_cast<float>(style.point_size_px) * unit, 7 * unit, size.y);
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(letters, FLT_MAX, 0.0F, kSampleText);
    list.AddText(ImGui::GetFont(), letters, {middle.x - 0.5F * extent.x, middle.y - 0.5F * extent.y}, color,
                 kSampleText);
  } else if (is_mapped) {
    // A layer with a colour map shows its colours; that is enough.
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
  const ThemeColors& colors = gui_.colors();
  const bool needs_outline = !is_mapped && is_faint(style.color, style.opacity, canvas, to_rgb(colors.panel));
  list.AddRect(at, end, needs_outline ? colors.text_faint : colors.border, 3 * unit);
}

void LayersPanel::draw_style_popup(LayerIndex layer) {
  const float unit = gui_.unit();
  const PopupSpacing spacing(unit);
  if (!begin_popup(gui_, "style")) return;
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  LayerStyle style = layers_.style(layer);
  ImGui::PushFont(gui_.bold());
  ImGui::TextUnformatted(descriptor.name.data(), descriptor.name.data() + descriptor.name.size());
  ImGui::PopFont();

  const bool is_picture = descriptor.kinds.empty();
  if (is_picture) image_.draw();
  color_maps_.draw(layer, style);
  // The plain colour counts only without a colour map.
  if (style.color_map.empty() && !is_picture) draw_color_choice(unit, style);
  const float width = 230 * unit;
  double percent = 100.0 * style.opacity;
  if (slider(gui_, "Opacity", percent, 0.0, 100.0, {.format = "%.0f %%", .width = width}))
    style.opacity = percent / 100.0;
  const SliderLook in_pixels{.format = "%.1f px", .is_logarithmic = true, .width = width};
  if (has_points(descriptor)) slider(gui_, "Point size", style.point_size_px, 0.5, 64.0, in_pixels);
  if (descriptor.points_as != PointsAs::dots) slider(gui_, "Letters", style.point_size_px, 4.0, 64.0, in_pixels);
  if (has_strokes(descriptor)) {
    slider(gui_, "Line width", style.line_width_px, 0.1, 64.0, in_pixels);
    checkbox("Dashed", &style.dashed);
  }
  if (is_made_of_samples(descriptor) && (has_points(descriptor) || has_strokes(descriptor))) {
    checkbox("Thinner where dense", &style.thin_when_dense);
    tooltip(gui_,
            "Where samples are closer than two pixels, dots and lines are drawn finer than set here, so that they do "
            "not merge; dots of samples in their default size are kept apart earlier");
  }
  // Letters do not overlap, so they have no such option.
  const bool may_overlap = !is_picture && descriptor.points_as == PointsAs::dots;
  if (may_overlap) checkbox("Merge overlaps", &style.flat);
  if (may_overlap)
    tooltip(gui_, "Overlapping parts of this layer do not darken each other: a union of disks is one even area");
  layers_.set_style(layer, style);
  ImGui::BeginDisabled(layers_.has_default_style(layer));
  if (ImGui::Button("Reset style")) layers_.reset_style(layer);
  ImGui::EndDisabled();
  ImGui::EndPopup();
}

void LayersPanel::draw_context_menu(LayerIndex layer) {
  const PopupSpacing spacing(gui_.unit());
  if (!begin_context_popup(gui_, "menu")) return;
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
  if (ImGui::MenuItem("Copy style")) copied_ = {layer, layers_.style(layer)};
  if (ImGui::MenuItem("Paste style", nullptr, false, copied_.has_value()))
    layers_.set_style(layer,
                      style_for(layers_.descriptor(layer), layers_.descriptor(copied_->layer), copied_->style));
  if (ImGui::MenuItem("Reset style", nullptr, false, !layers_.has_default_style(layer))) layers_.reset_style(layer);
  ImGui::Separator();
  draw_export_menu(layer);
  ImGui::EndPopup();
}

void LayersPanel::draw_export_menu(LayerIndex layer) const {
  const auto formats = layer_text_formats();
  const auto holds = [this, layer](const LayerTextFormat& format) { return format.holds(layers_.descriptor(layer)); };
  if (!ImGui::BeginMenu("Export geometry", std::ranges::any_of(formats, holds))) return;
  for (const LayerTextFormat& format : formats) {
    if (!holds(format)) continue;
    if (ImGui::MenuItem(std::string(format.title).c_str())) ask_export_(layer, format);
    tooltip(gui_, std::string(format.help));
  }
  ImGui::EndMenu();
}

void LayersPanel::draw_drop_target(LayerIndex layer, ImVec2 at, ImVec2 end) {
  if (!ImGui::BeginDragDropTarget()) return;
  const bool above = ImGui::GetIO().MousePos.y < 0.5F * (at.y + end.y);
  const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(
      kLayerDragKind, ImGuiDragDropFlags_AcceptBeforeDelivery | ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
  if (payload != nullptr) {
    const float y = above ? at.y : end.y;
    ImGui::GetWindowDrawList()->AddLine({at.x, y}, {end.x, y}, gui_.colors().accent, 2 * gui_.unit());
    if (payload->IsDelivery()) layers_.move(*static_cast<const LayerIndex*>(payload->Data), layer, above);
  }
  ImGui::EndDragDropTarget();
}

std::optional<std::size_t> LayersPanel::count_of(LayerIndex layer) const {
  const auto& kinds = layers_.descriptor(layer).kinds;
  if (kinds.empty()) return std::nullopt;
  if (!layers_.is_visible(layer)) return counts_.of(layer);
  if (picture_.state(layer) != NodeState::up_to_date) return std::nullopt;
  std::size_t count = 0;
  for (const PrimitiveKind kind : kinds) count += picture_.scene().instances(layer, kind);
  return count - picture_.scene().zero_length_segments(layer);
}

void LayersPanel::note_counts() {
  if (!follow_counts_(counts_)) return;
  for (const LayerIndex layer : layers_.visible_layers())
    if (const auto count = count_of(layer)) counts_.note(layer, *count);
}

// A star that is off appears on the row under the pointer only.
void LayersPanel::draw_star(LayerIndex layer, ImVec2 at, float size, bool is_row_hovered) {
  ImGui::SetCursorScreenPos(at);
  if (hit_area("star", {size, size})) toggle_favorite(layers_, favorites_, layer);
  const bool is_hovered = ImGui::IsItemHovered();
  const bool is_on = is_favorite(layers_, favorites_, layer);
  tooltip(gui_, is_on ? "Remove from the favourites" : "Add to the favourites, which are listed first");
  if (!is_on && !is_hovered && !is_row_hovered) return;
  const ThemeColors& colors = gui_.colors();
  draw_icon(*ImGui::GetWindowDrawList(), is_on ? Icon::star_on : Icon::star, at, size,
            is_on || is_hovered ? colors.accent : colors.text_faint);
}

void LayersPanel::draw_row_text(LayerIndex layer, const LayerSection& section, ImVec2 at, ImVec2 end) const {
  const float unit = gui_.unit();
  const ThemeColors& colors = gui_.colors();
  const bool visible = layers_.is_visible(layer);
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float icon = 18 * unit;
  const float middle = 0.5F * (at.y + end.y);
  draw_icon(list, visible ? Icon::eye : Icon::eye_closed, {at.x + 2 * unit, middle - 0.5F * icon}, icon,
            visible ? colors.text : colors.text_faint);
  ImU32 color = visible ? colors.text : colors.text_quiet;
  if (is_without_content(layer)) color = colors.text_faint;
  if (visible && is_failed(picture_.state(layer))) color = colors.warning;
  const float text_at = at.x + 27 * unit;
  // Layers of another family than the heading's keep its name.
  const bool is_short = section.is_of_union && family_of(descriptor) == options_.family;
  const std::string name = is_short ? short_name(descriptor) : std::string(descriptor.name);
  // In a narrow panel the name needs the room.
  constexpr float kLeastRoom = 135.0F;
  const auto count = end.x - text_at > kLeastRoom * unit ? count_of(layer) : std::nullopt;
  if (count) {
    ImGui::PushFont(gui_.small());
    const std::string words = grouped(*count);
    end.x -= ImGui::CalcTextSize(words.c_str()).x;
    list.AddText({end.x, middle - 0.5F * ImGui::GetFontSize()}, colors.text_quiet, words.c_str());
    ImGui::PopFont();
    end.x -= 6 * unit;
  }
  list.AddText({text_at, middle - 0.5F * ImGui::GetFontSize()}, color, elided(name, end.x - text_at).c_str());
  if (visible && picture_.state(layer) == NodeState::computing)
    list.AddCircleFilled({end.x - 4 * unit, middle}, 3 * unit, colors.accent);
}

void LayersPanel::draw_row(LayerIndex layer, const LayerSection& section) {
  const float unit = gui_.unit();
  const LayerDescriptor& descriptor = layers_.descriptor(layer);
  const float height = 27 * unit;
  ImGui::PushID(static_cast<int>(layer));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 swatch_size(30 * unit, 18 * unit);
  const ImVec2 swatch_at(at.x + width - swatch_size.x - 2 * unit, at.y + 0.5F * (height - swatch_size.y));

  // The swatch lies on the row, so it is tested first.
  ImGui::SetCursorScreenPos(swatch_at);
  if (hit_area("swatch", swatch_size)) ImGui::OpenPopup("style");
  tooltip(gui_, descriptor.scalar.empty() ? "Colour, opacity, sizes" : "Colour, colour map, opacity, sizes");
  draw_style_popup(layer);

  const float star = 16 * unit;
  const ImVec2 star_at(swatch_at.x - star - 6 * unit, at.y + 0.5F * (height - star));
  const ImVec2 row_end(at.x + width, at.y + height);
  const bool is_under_pointer = is_pointer_on_rows_ && ImGui::IsMouseHoveringRect(at, row_end);
  draw_star(layer, star_at, star, is_under_pointer);

  ImGui::SetCursorScreenPos(at);
  const bool clicked = hit_area("row", {star_at.x - at.x - 2 * unit, height});
  if (ImGui::IsItemHovered())
    ImGui::GetWindowDrawList()->AddRectFilled(at, row_end, gui_.colors().accent_faint, 4 * unit);
  if (revealed_ && revealed_->layer == layer && revealed_->section == section.title) {
    ImGui::GetWindowDrawList()->AddRectFilled(at, row_end, gui_.colors().accent_soft, 4 * unit);
    if (std::exchange(scrolls_, false)) ImGui::SetScrollHereY();
  }
  tooltip(gui_, explanation(layer));
  draw_context_menu(layer);
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kLayerDragKind, &layer, sizeof layer);
    ImGui::TextUnformatted(descriptor.name.data(), descriptor.name.data() + descriptor.name.size());
    ImGui::EndDragDropSource();
  }
  // In other sections the rows are not in drawing order, so dropping between two of them is meaningless.
  if (section.kind == LayerSectionKind::order || section.kind == LayerSectionKind::shown)
    draw_drop_target(layer, at, row_end);
  draw_row_text(layer, section, at, {star_at.x - 4 * unit, at.y + height});
  draw_swatch(layer, swatch_at, swatch_size);
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  ImGui::PopID();
  if (!clicked) return;
  layers_.set_visible(layer, !layers_.is_visible(layer));
  clicked_at_ = layers_.revision();
}

// Hides the visible layers of the section, or shows them again.
void LayersPanel::toggle_group(const LayerSection& section) {
  std::vector<LayerIndex>& hidden = hidden_[section.title];
  std::vector<LayerIndex> shown;
  std::ranges::copy_if(section.members, std::back_inserter(shown),
                       [this](LayerIndex layer) { return layers_.is_visible(layer); });
  const bool is_shown_again = shown.empty();
  if (!is_shown_again) hidden = std::move(shown);
  for (const LayerIndex layer : hidden) layers_.set_visible(layer, is_shown_again);
  if (is_shown_again) hidden.clear();
  clicked_at_ = layers_.revision();
}

// A search shows what it finds.
bool LayersPanel::is_folded(const LayerSection& section) const {
  return !section.title.empty() && !is_filtered() && std::ranges::count(unfolded_, section.title) == 0;
}

void LayersPanel::set_folded(const LayerSection& section, bool is_folded) {
  std::erase(unfolded_, section.title);
  if (!is_folded) unfolded_.push_back(section.title);
}

bool LayersPanel::draw_heading(std::size_t index) {
  const LayerSection& section = listing_.sections[index];
  if (section.title.empty()) return true;
  const float unit = gui_.unit();
  const ThemeColors& colors = gui_.colors();
  const float height = 26 * unit;
  const float eye = 18 * unit;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool was_folded = is_folded(section);
  const bool is_topic = section.kind == LayerSectionKind::topic;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 eye_at(at.x + width - eye - 8 * unit, at.y + 0.5F * (height - eye));
  // Counted again, because the list may be older than the last click.
  const auto shown = static_cast<std::size_t>(
      std::ranges::count_if(section.members, [this](LayerIndex layer) { return layers_.is_visible(layer); }));
  if (is_topic) {
    const bool is_possible = shown != 0 || !hidden_[section.title].empty();
    ImGui::SetCursorScreenPos(eye_at);
    ImGui::BeginDisabled(!is_possible);
    if (hit_area("eye", {eye, eye})) toggle_group(section);
    const bool is_eye_hovered = ImGui::IsItemHovered();
    ImGui::EndDisabled();
    tooltip(gui_, shown != 0    ? "Hide the shown layers of this group"
                  : is_possible ? "Show the hidden layers of this group again"
                                : "No layer of this group is shown");
    const ImU32 quiet = is_eye_hovered ? colors.accent : colors.text_quiet;
    draw_icon(list, shown != 0 ? Icon::eye : Icon::eye_closed, eye_at, eye, is_possible ? quiet : colors.text_faint);
  }
  ImGui::SetCursorScreenPos(at);
  if (hit_area("fold", {width - eye - 12 * unit, height})) set_folded(section, !was_folded);
  if (ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, colors.accent_faint, 4 * unit);
  tooltip(gui_, is_filtered() ? "" : was_folded ? "Unfold" : "Fold away");
  draw_fold(list, {at.x + 11 * unit, at.y + 0.5F * height}, 4 * unit, !was_folded, colors.text_quiet);
  ImGui::PushFont(gui_.small());
  const float text_y = at.y + 0.5F * (height - ImGui::GetFontSize());
  const std::string count =
      is_topic ? fmt::format("{} of {} shown", shown, section.members.size()) : std::to_string(section.rows.size());
  const float count_at = eye_at.x - 6 * unit - ImGui::CalcTextSize(count.c_str()).x;
  const std::string title = elided(heading_of(section), count_at - at.x - 32 * unit);
  list.AddText({at.x + 27 * unit, text_y}, shown != 0 && is_topic ? colors.text : colors.text_quiet, title.c_str());
  list.AddText({count_at, text_y}, colors.text_faint, count.c_str());
  ImGui::PopFont();
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  return !is_folded(section);
}

void LayersPanel::draw_section(std::size_t index) {
  const LayerSection& section = listing_.sections[index];
  if (section.is_of_union && (index == 0 || !listing_.sections[index - 1].is_of_union)) draw_families();
  ImGui::PushID(section.title.c_str());
  if (draw_heading(index))
    for (const LayerIndex layer : section.rows) draw_row(layer, section);
  ImGui::PopID();
}

void LayersPanel::draw_filter_note() {
  if (listing_.left_out == 0 || (options_.search.empty() && !options_.only_shown)) return;
  const float unit = gui_.unit();
  ImGui::Dummy({0, 4 * unit});
  ImGui::PushFont(gui_.small());
  const std::string text = listing_.listed == 0 ? "No layer matches"
                                                : "Listed: " + std::to_string(listing_.listed) + " of " +
                                                      std::to_string(layers_.order().size());
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text.c_str());
  ImGui::SameLine(0, 8 * unit);
  if (ImGui::Button("List all")) {
    options_.search.clear();
    options_.only_shown = false;
  }
  ImGui::PopFont();
}

void LayersPanel::follow() {
  options_.family = FamilyKind::inner;
  for (const FamilyKind family : kBallFamilies)
    if (actions_.is_checked(nth(ActionId::balls_inner, static_cast<std::size_t>(family)))) options_.family = family;
  options_.favorites = favorites_;
  if (reveal_) {
    options_.search.clear();
    options_.only_shown = false;
  }
  const bool is_held = is_pointer_on_rows_ && clicked_at_ == layers_.revision() && options_ == listed_options_;
  if (is_held && !reveal_) return;
  listing_ = list_layers(layers_, options_);
  listed_options_ = options_;
  if (reveal_) find_revealed();
}

// The row among those of its subject is preferred, because it stays where it is.
void LayersPanel::find_revealed() {
  const LayerIndex layer = *std::exchange(reveal_, std::nullopt);
  revealed_.reset();
  for (const LayerSection& section : listing_.sections)
    if (std::ranges::count(section.rows, layer) != 0) revealed_ = {section.title, layer};
  if (!revealed_) return;
  scrolls_ = true;
  if (!revealed_->section.empty() && std::ranges::count(unfolded_, revealed_->section) == 0)
    unfolded_.push_back(revealed_->section);
}

void LayersPanel::draw() {
  note_counts();
  draw_head();
  follow();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("rows");
  is_pointer_on_rows_ = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (is_pointer_on_rows_ && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) revealed_.reset();
  for (std::size_t index = 0; index < listing_.sections.size(); ++index) draw_section(index);
  draw_filter_note();
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace mes
