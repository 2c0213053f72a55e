// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/persistence_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <ranges>
#include <unordered_set>

#include "app/layers/words/length_words.h"
#include "app/panels/on_canvas/marks/shape_pen.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/color.h"
#include "core/base/counted.h"

namespace mes {
namespace {

constexpr float kLeastDiagram = 180.0F;  // logical pixels
constexpr float kSmallDot = 2.5F;        // half the width of a dot
constexpr float kLargeDot = 4.0F;
constexpr float kReach = 6.0F;
constexpr int kLinesOfWords = 2;
constexpr const char* kPropose = "Propose";
constexpr std::size_t kMostDiagramSegments = 20'000;

Rgb pair_color(const PersistenceRow& row) {
  return row.is_hole ? palette::purple : palette::green;
}

void draw_dot(ImDrawList& list, ImVec2 at, bool is_hole, float half, double opacity) {
  const ImU32 color = to_imgui(is_hole ? palette::purple : palette::green, opacity);
  if (is_hole)
    list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, color);
  else
    list.AddCircleFilled(at, half, color);
}

/// The font of a program without its files lacks the sign.
std::string infinity_word() {
  constexpr ImWchar kInfinity = 0x221E;
  return ImGui::GetFont()->FindGlyphNoFallback(kInfinity) != nullptr ? "\u221E" : "inf";
}

}  // namespace

void PersistencePanel::draw() {
  draw_in(small_);
}

void PersistencePanel::draw_large() {
  draw_in(large_);
}

void PersistencePanel::step(std::ptrdiff_t pairs) {
  if (uses_.latest.table() == nullptr || !uses_.latest.is_current()) return;
  const std::vector<PersistenceRow>& rows = uses_.latest.table()->rows;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].is_hole ? shows_holes_ : shows_components_) shown.push_back(i);
  if (shown.empty()) return;
  const auto chosen = uses_.latest.chosen();
  const auto at = chosen ? std::ranges::find(shown, *chosen) : shown.end();
  uses_.latest.choose(at == shown.end() ? shown.front() : shown[row_beside(at - shown.begin(), pairs, shown.size())]);
}

void PersistencePanel::draw_in(View& view) {
  const Document& document = uses_.editor.document();
  draw_growths();
  uses_.latest.follow(document, uses_.computation.settings());
  draw_choices();
  const PersistenceTable* const table = uses_.latest.table();
  if (table == nullptr || (!uses_.latest.is_current() && !uses_.latest.problem().empty())) {
    quiet_paragraph(uses_.latest.problem().empty() ? "Computing births and deaths" : uses_.latest.problem());
    return;
  }
  if (table->rows.empty()) {
    ImGui::TextDisabled("%s",
                        uses_.latest.growth() == GrowthOf::samples ? "There are no samples" : "There are no balls");
    return;
  }
  pointed_at_.reset();
  draw_words();
  draw_diagram(view);
  draw_chosen();
  if (!uses_.latest.is_current()) return;
  if (const auto chosen = uses_.latest.chosen()) draw_places(*chosen, true);
  if (pointed_at_ && pointed_at_ != uses_.latest.chosen()) draw_places(*pointed_at_, false);
}

void PersistencePanel::draw_growths() {
  const Document& document = uses_.editor.document();
  // Without samples only own balls can grow.
  const bool has_only_balls = document.sample_count() == 0 && document.ball_count() != 0;
  if (has_only_balls != had_only_balls_)
    uses_.latest.choose_growth(has_only_balls ? GrowthOf::own : GrowthOf::samples);
  had_only_balls_ = has_only_balls;
  const GrowthOf now = uses_.latest.growth();
  const float gap = 8 * uses_.gui.unit();
  const float button = ImGui::CalcTextSize(kPropose).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - gap);
  if (ImGui::BeginCombo("##growth", std::string(title_of(now)).c_str())) {
    for (const GrowthOf of : kGrowths)
      if (ImGui::Selectable(std::string(title_of(of)).c_str(), of == now)) {
        uses_.latest.choose(std::nullopt);
        uses_.latest.choose_growth(of);
      }
    ImGui::EndCombo();
  }
  tooltip(uses_.gui,
          "What grows: disks around the samples from radius 0, or the balls of a family, from radius r to sqrt(r^2 + "
          "alpha-radius^2)");
  ImGui::SameLine(0, gap);
  draw_proposal();
}

void PersistencePanel::draw_choices() {
  const float unit = uses_.gui.unit();
  checkbox("Components", &shows_components_);
  tooltip(uses_.gui,
          "Show components, which are born at samples or balls and die where an edge joins them to older ones");
  ImGui::SameLine(0, 8 * unit);
  checkbox("Holes", &shows_holes_);
  tooltip(uses_.gui, "Show holes, which an edge closes and a triangle fills");
  ImGui::SameLine(0, 8 * unit);
  ImGui::BeginDisabled(!uses_.latest.is_current() || !uses_.export_csv);
  if (ImGui::Button("Export...")) uses_.export_csv(persistence_as_csv(*uses_.latest.table()));
  ImGui::EndDisabled();
  tooltip(uses_.gui, "Write all births and deaths to a file as CSV, as mesecina persistence does");
}

void PersistencePanel::draw_proposal() {
  if (gap_of_ != uses_.latest.shared_table()) {
    gap_of_ = uses_.latest.shared_table();
    gap_ = gap_of_ ? widest_gap(*gap_of_) : std::nullopt;
  }
  const bool is_known = uses_.latest.is_current() && gap_;
  ImGui::BeginDisabled(!is_known);
  if (ImGui::Button(kPropose)) {
    ComputationSettings settings = uses_.computation.settings();
    settings[Parameter::alpha_radius] = gap_->middle();
    uses_.computation.set(settings);
  }
  ImGui::EndDisabled();
  std::string words = "Set the radius to the middle of the widest gap, in which nothing is joined, closed or filled";
  if (is_known)
    words += fmt::format(": from {} to {}", length_words(gap_->begin, gap_of_->map),
                         length_words(gap_->end, gap_of_->map));
  tooltip(uses_.gui, words);
}

void PersistencePanel::draw_words() {
  const PersistenceTable& table = *uses_.latest.table();
  const double radius = uses_.computation.settings()[Parameter::alpha_radius];
  if (alive_.table != uses_.latest.shared_table() || alive_.radius != radius) {
    alive_ = {uses_.latest.shared_table(), radius, 0, 0};
    const std::uint32_t ranks = table.ranks_within(radius);
    for (const PersistenceRow& row : table.rows)
      if (row.is_alive(ranks)) ++(row.is_hole ? alive_.holes : alive_.components);
  }
  quiet_paragraph(fmt::format("Radius {}: {}, {}{}", length_words(radius, table.map),
                              counted(alive_.components, "component"), counted(alive_.holes, "hole"),
                              uses_.latest.is_current() ? "" : "; computing"));
}

// Drawn below the diagram, which would otherwise move under the pointer when the text takes another line.
void PersistencePanel::draw_chosen() {
  const auto chosen = uses_.latest.chosen();
  paragraph(chosen ? in_words(uses_.latest.table()->rows[*chosen], uses_.latest.table()->map)
                   : "Click a point to read its birth and death; the keys Up and Down go to the next ones");
}

void PersistencePanel::place_dots(View& view, const Scale& scale) {
  if (scale == view.scale) return;
  view.scale = {};
  view.dots.clear();
  std::unordered_set<std::uint64_t> drawn;
  const auto place = [&](double value, float length) {
    return length * static_cast<float>(std::min(1.0, (value - scale.begin) / (scale.end - scale.begin)));
  };
  for (std::size_t i = 0; i < scale.table->rows.size(); ++i) {
    const PersistenceRow& row = scale.table->rows[i];
    if (!(row.is_hole ? scale.has_holes : scale.has_components)) continue;
    const float death = std::isinf(row.death) ? scale.never : place(row.death, scale.height);
    const Dot dot{place(row.birth, scale.width), death, i, row.is_hole};
    const auto pixel = (static_cast<std::uint64_t>(dot.x) << 33U) | (static_cast<std::uint64_t>(dot.y) << 1U) |
                       (row.is_hole ? 1U : 0U);
    if (drawn.insert(pixel).second) view.dots.push_back(dot);
  }
  view.scale = scale;
}

// Draws the meaning of the dots below the diagonal, where there are none.
void PersistencePanel::draw_key(const Plot& plot) const {
  const float unit = uses_.gui.unit();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const char* const words[] = {"component", "hole"};
  const bool is_shown[] = {shows_components_, shows_holes_};
  const PanelArea& inside = plot.inside();
  const float width = ImGui::CalcTextSize(words[0]).x;
  ImVec2 at(inside.at.x + inside.size.x - width - 12 * unit, inside.at.y + inside.size.y - 2.5F * line);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < 2; ++i) {
    if (!is_shown[i]) continue;
    draw_dot(list, {at.x - 12 * unit, at.y + 0.5F * ImGui::GetTextLineHeight()}, i == 1, kLargeDot * unit, 1.0);
    list.AddText(at, Plot::kInk, words[i]);
    at.y += line;
  }
}

void PersistencePanel::draw_diagram(View& view) {
  const float unit = uses_.gui.unit();
  const PersistenceTable& table = *uses_.latest.table();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  // Room for the text about the chosen pair below.
  const float below = kLinesOfWords * ImGui::GetTextLineHeightWithSpacing();
  const float least = kLeastDiagram * unit;
  const ImVec2 size(std::max(least, room.x), std::max(least, std::min(room.x, room.y - below)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  hit_area("diagram", size);
  const bool is_hovered = ImGui::IsItemHovered();
  const bool is_pressed = ImGui::IsItemActivated();
  const bool is_active = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();

  // Pairs that never die are on a line of their own above the others.
  const double begin = 1.05 * table.least_birth;
  const double end = table.largest_death > 0.0 ? 1.05 * table.largest_death : (begin < 0.0 ? -begin : 1.0);
  const Plot plot(uses_.gui, {at, size}, {begin, end, with_unit("birth", table.map)},
                  {.low = begin, .high = end, .title = with_unit("death", table.map), .above = infinity_word()},
                  view.is_large);
  plot.draw_frame(list);
  const ImVec2 low = plot.inside().at;
  const ImVec2 high(low.x + plot.inside().size.x, low.y + plot.inside().size.y);
  ComputationSettings settings = uses_.computation.settings();
  double& radius = settings[Parameter::alpha_radius];
  // The area left of and above the radius contains the pairs alive at it.
  list.AddRectFilled({low.x, plot.top()}, {plot.x_of(radius), plot.y_of(radius)},
                     (Plot::kInk & ~IM_COL32_A_MASK) | 0x12U << 24U);
  list.AddLine({low.x, high.y}, {high.x, low.y}, Plot::kQuietInk, unit);
  if (begin < 0.0) {
    list.AddLine({plot.x_of(0.0), low.y}, {plot.x_of(0.0), high.y}, Plot::kQuietInk, unit);
    list.AddLine({low.x, plot.y_of(0.0)}, {high.x, plot.y_of(0.0)}, Plot::kQuietInk, unit);
  }

  const ImVec2 mouse = ImGui::GetIO().MousePos;
  float nearest = kReach * unit;
  place_dots(view, {uses_.latest.shared_table(), plot.inside().size.x, plot.inside().size.y, high.y - plot.above(),
                    begin, end, shows_components_, shows_holes_});
  const double opacity = uses_.latest.is_current() ? 0.9 : 0.4;
  const float half = (view.is_large ? kLargeDot : kSmallDot) * unit;
  // Drawn in reverse, because the longest are first and must be on top.
  for (const Dot& dot : view.dots | std::views::reverse) {
    const ImVec2 p{low.x + dot.x, high.y - dot.y};
    const float away = std::hypot(p.x - mouse.x, p.y - mouse.y);
    if (is_hovered && away <= nearest) {
      nearest = away;
      pointed_at_ = dot.row;
    }
    draw_dot(list, p, dot.is_hole, half, opacity);
  }
  if (view.is_large) draw_key(plot);
  const auto mark = [&](std::size_t i, float width) {
    const PersistenceRow& row = table.rows[i];
    const float death = std::isinf(row.death) ? plot.above() : plot.y_of(row.death);
    list.AddCircle({plot.x_of(row.birth), death}, half + 3.5F * unit, Plot::kInk, 0, width);
  };
  if (const auto chosen = uses_.latest.chosen()) mark(*chosen, 2 * unit);
  if (pointed_at_) mark(*pointed_at_, unit);

  if (is_pressed) {
    view.is_dragging = !pointed_at_;
    if (pointed_at_) {
      uses_.latest.choose(uses_.latest.chosen() == pointed_at_ ? std::nullopt : pointed_at_);
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        uses_.latest.choose(pointed_at_);
        show(*pointed_at_);
      }
    }
  }
  if (is_active && view.is_dragging) {
    radius = std::max(0.0, plot.x_at(mouse.x));
    if (settings != uses_.computation.settings()) uses_.computation.set(settings);
  }
  list.AddLine({plot.x_of(radius), plot.top()}, {plot.x_of(radius), plot.y_of(radius)}, Plot::kInk, 2 * unit);
  list.AddLine({low.x, plot.y_of(radius)}, {plot.x_of(radius), plot.y_of(radius)}, Plot::kInk, unit);
  if (is_hovered && !pointed_at_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (is_hovered && !is_active) {
    if (pointed_at_)
      ImGui::SetTooltip("%s", in_words(table.rows[*pointed_at_], table.map).c_str());
    else
      tooltip(uses_.gui,
              std::string("Birth to the right, death upwards; drag to set the radius of the alpha complex") +
                  (begin < 0.0 ? ". Left of the line at 0 are births before the balls grow" : ""));
  }
}

void PersistencePanel::show(std::size_t row) const {
  constexpr double kMarginPx = 120.0;
  const PersistenceRow& one = uses_.latest.table()->rows[row];
  Box2 box;
  box.add(one.place);
  if (one.has_edge)
    for (const Vec2 p : one.edge) box.add(p);
  for (const auto& side : outline_of(*uses_.latest.table(), one)) box.add(side[0]);
  uses_.canvas.view().fit(box, kMarginPx * uses_.canvas.content_scale());
}

void PersistencePanel::draw_places(std::size_t row, bool is_chosen) {
  const float unit = uses_.gui.unit();
  const PersistenceTable& table = *uses_.latest.table();
  const PersistenceRow& one = table.rows[row];
  if (outline_of_ != uses_.latest.shared_table() || outline_row_ != row) {
    outline_of_ = uses_.latest.shared_table();
    outline_row_ = row;
    outline_ = outline_of(table, one);
  }
  const auto pen_of = [&](Rgb color, float width) {
    return ShapePen(uses_.gui, {uses_.canvas.view().camera()}, uses_.canvas.content_scale(),
                    {to_imgui(color, is_chosen ? 1.0 : 0.6), width * unit, PenMark::ring});
  };
  const ShapePen pen = pen_of(pair_color(one), is_chosen ? 4.0F : 3.0F);
  const auto segment = [](const ShapePen& with, Vec2 a, Vec2 b) {
    with.draw({PrimitiveKind::segment, {a.x, a.y, b.x, b.y}});
  };
  for (std::size_t i = 0; i < std::min(outline_.size(), kMostDiagramSegments); ++i)
    segment(pen, outline_[i][0], outline_[i][1]);
  if (one.is_hole) {
    const auto& corner = table.triangles[one.triangle].corner;
    const ShapePen fills = pen_of(palette::blue, 2.0F);
    for (std::size_t i = 0; i < 3; ++i) segment(fills, corner[i], corner[(i + 1) % 3]);
  }
  if (one.has_edge) segment(pen_of(palette::orange, is_chosen ? 5.0F : 4.0F), one.edge[0], one.edge[1]);
  pen.draw({PrimitiveKind::point, {one.place.x, one.place.y}});
}

}  // namespace mes
