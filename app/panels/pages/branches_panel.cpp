// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/branches_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/layers/words/length_words.h"
#include "app/panels/on_canvas/marks/shape_pen.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/plot.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/color.h"
#include "core/base/counted.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

struct Column {
  BranchColumn column;
  const char* title;
  const char* explanation;
};
constexpr std::array<Column, kBranchColumns> kColumns{
    {{BranchColumn::number, "#", "Number: 1 is the longest branch"},
     {BranchColumn::from, "from", "Where it begins: a leaf, a junction of three or more, or a cut of the filter"},
     {BranchColumn::to, "to", "Where it ends"},
     {BranchColumn::length, "length", "Length of the branch"},
     {BranchColumn::radius_least, "r min", "Least radius of the balls along it"},
     {BranchColumn::radius_mean, "r mean", "Radius of the balls along it, averaged over its length"},
     {BranchColumn::radius_largest, "r max", "Largest radius of the balls along it"},
     {BranchColumn::lambda, "lambda", "Largest lambda along it"},
     {BranchColumn::angle, "angle", "Largest object angle along it, in degrees"}}};

constexpr std::array<const char*, kBranchAxes.size()> kAxes{"Whole axis", "Lambda axis", "Angle axis", "Cover axis"};
constexpr std::size_t kBins = 96;
constexpr float kLeastHistogram = 140.0F;  // logical pixels
constexpr float kHistogramShare = 0.35F;
constexpr float kLeastTable = 150.0F;
constexpr std::size_t kMostBranchSegments = 20'000;

std::string cell_text(const AxisBranch& branch, std::size_t row, BranchColumn column) {
  switch (column) {
    case BranchColumn::number: return std::to_string(row + 1);
    case BranchColumn::from: return std::string(name_of(branch.from.kind));
    case BranchColumn::to: return std::string(name_of(branch.to.kind));
    default: return fmt::format("{:.4g}", number_in(branch, row, column));
  }
}

/// Draws words beside a vertical line of the plot, above what is plotted.
void draw_above(const Gui& gui, const Plot& plot, float x, const std::string& words) {
  const float gap = 4 * gui.unit();
  const float width = ImGui::CalcTextSize(words.c_str()).x;
  const bool fits = x + gap + width <= plot.inside().at.x + plot.inside().size.x;
  ImGui::GetWindowDrawList()->AddText(
      {fits ? x + gap : x - gap - width, plot.above() - 0.5F * ImGui::GetTextLineHeight()}, Plot::kInk,
      words.c_str());
}

}  // namespace

void BranchesPanel::refresh_rows() {
  rows_of_ = uses_.latest.table();
  rows_ =
      rows_of_ != nullptr ? mes::rows_of(*rows_of_, filter_, sorted_by_, is_descending_) : std::vector<std::size_t>{};
}

bool BranchesPanel::draw_head() {
  const Document& document = uses_.editor.document();
  const bool is_new = uses_.latest.follow({document.revision(), uses_.computation.settings(), axis_, measures_area_},
                                          [&document] { return data_of(document); });
  if (is_new || rows_of_ != uses_.latest.table()) {
    histogram_table_ = nullptr;
    refresh_rows();
  }
  draw_choices();
  if (uses_.latest.table() == nullptr) {
    ImGui::TextDisabled("%s",
                        uses_.latest.problem().empty() ? "Computing the branches" : uses_.latest.problem().c_str());
    return false;
  }
  if (!uses_.latest.problem().empty()) {
    paragraph(uses_.latest.problem());
    return false;
  }
  return true;
}

void BranchesPanel::draw() {
  if (!draw_head()) return;
  pointed_at_.reset();
  // In a low panel the table keeps some rows, and histogram and table scroll together.
  if (ImGui::BeginChild("##branches")) {
    draw_diagram(std::max(kLeastHistogram * uses_.gui.unit(), kHistogramShare * ImGui::GetContentRegionAvail().y),
                 false);
    draw_table();
  }
  ImGui::EndChild();
  if (!uses_.latest.is_current()) return;
  if (const auto chosen = uses_.latest.chosen()) draw_branch(*chosen, true);
  if (pointed_at_ && pointed_at_ != uses_.latest.chosen()) draw_branch(*pointed_at_, false);
}

void BranchesPanel::draw_choices() {
  const float unit = uses_.gui.unit();
  ImGui::SetNextItemWidth(110 * unit);
  if (ImGui::BeginCombo("##axis", kAxes[static_cast<std::size_t>(axis_)])) {
    for (const BranchAxis axis : kBranchAxes)
      if (ImGui::Selectable(kAxes[static_cast<std::size_t>(axis)], axis == axis_)) axis_ = axis;
    ImGui::EndCombo();
  }
  tooltip(uses_.gui, "The axis whose branches are listed; the limits of the filters are among the parameters");
  ImGui::SameLine(0, 4 * unit);
  const char* const export_label = "Export...";
  const float button = ImGui::CalcTextSize(export_label).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(std::max(50 * unit, ImGui::GetContentRegionAvail().x - button - 4 * unit));
  if (ImGui::InputTextWithHint("##filter", "Filter: length>1 leaf", &filter_text_)) {
    const auto parsed = BranchFilter::parse(filter_text_);
    filter_problem_ = parsed ? std::string() : parsed.error().message();
    filter_ = parsed ? *parsed : BranchFilter();
    refresh_rows();
  }
  tooltip(uses_.gui,
          filter_problem_.empty()
              ? "Only branches that meet all of these: length, radius (mean), least, largest, lambda, angle "
                "with <, <=, >, >= and a number; leaf, junction, cut or none for the kind of an end"
              : filter_problem_);
  ImGui::SameLine(0, 4 * unit);
  ImGui::BeginDisabled(!uses_.latest.is_current() || !uses_.export_csv);
  if (ImGui::Button(export_label)) uses_.export_csv(branches_as_csv(*uses_.latest.table()));
  ImGui::EndDisabled();
  tooltip(uses_.gui, "Write all branches to a file as CSV, as mesecina branches does");
  if (!filter_problem_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, uses_.gui.colors().warning);
    paragraph(filter_problem_);
    ImGui::PopStyleColor();
  }
  checkbox("Share of the shape", &measures_area_);
  tooltip(uses_.gui,
          "Share of the shape, the union of the inside triangles, covered by the balls along the kept axis. Their "
          "union takes much longer than the table");
}

// A large diagram fills the room.
void BranchesPanel::draw_diagram(float height, bool is_large) {
  const float unit = uses_.gui.unit();
  const auto choice = [&](const char* label, Diagram diagram, const char* explanation) {
    if (radio_button(label, diagram_ == diagram)) diagram_ = diagram;
    tooltip(uses_.gui, explanation);
  };
  choice("Lambda", Diagram::lambda,
         "Length of the whole axis by its lambda; drag the line to set the limit of the lambda medial axis, which is "
         "then shown");
  ImGui::SameLine(0, 8 * unit);
  choice("Radius", Diagram::radius, "Length of the whole axis by the radius of its balls");
  ImGui::SameLine(0, 8 * unit);
  choice("Width", Diagram::width,
         "Width of the shape along its centre line; drag along it to move the transect in the drawing");
  const float room = is_large ? ImGui::GetContentRegionAvail().y : height;
  if (diagram_ == Diagram::width)
    draw_widths(std::max(kLeastHistogram * unit, room), is_large);
  else
    draw_histogram(std::max(kLeastHistogram * unit, room), is_large);
}

void BranchesPanel::draw_widths(float height, bool is_large) {
  const float unit = uses_.gui.unit();
  const BranchTable& table = *uses_.latest.table();
  if (table.stations.empty()) {
    paragraph("There is no centre line: the pruned axis of every shape is a point");
    return;
  }
  line_ = std::min(line_, table.stations.size() - 1);
  if (table.stations.size() > 1) {
    double number = static_cast<double>(line_ + 1);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    slider(uses_.gui, "##line", number, 1.0, static_cast<double>(table.stations.size()),
           {.format = "Line %.0f", .is_whole = true, .width = ImGui::GetContentRegionAvail().x});
    tooltip(uses_.gui, "Centre line whose width is shown; the longest shape is first");
    line_ = static_cast<std::size_t>(number) - 1;
  }
  const std::vector<Station>& stations = table.stations[line_];
  const std::optional<MapPlane>& map = uses_.editor.document().map();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(40 * unit, ImGui::GetContentRegionAvail().x), height};
  hit_area("widths", size);
  const double length = stations.back().along > 0.0 ? stations.back().along : 1.0;
  const double widest = std::ranges::max(stations, {}, &Station::width).width;
  const Plot plot(uses_.gui, {at, size}, {0.0, length, with_unit("station", map)},
                  {.high = 1.1 * widest, .title = with_unit("width", map), .above = ""}, is_large);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  plot.draw_frame(list);
  std::vector<ImVec2> line;
  for (const Station& station : stations) line.emplace_back(plot.x_of(station.along), plot.y_of(station.width));
  polyline(list, line, to_imgui(palette::vermilion), false, 1.5F * unit);
  if (ImGui::IsItemActive()) station_ = plot.x_at(ImGui::GetIO().MousePos.x) / length;
  const auto last = static_cast<double>(stations.size() - 1);
  const Station& here = stations[static_cast<std::size_t>(std::lround(std::clamp(station_, 0.0, 1.0) * last))];
  const float x = plot.x_of(here.along);
  list.AddLine({x, plot.top()}, {x, plot.y_of(0.0)}, to_imgui(palette::blue), 2 * unit);
  draw_above(uses_.gui, plot, x,
             fmt::format("{} at {}", length_words(here.width, map), length_words(here.along, map)));
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (uses_.latest.is_current()) draw_transect(here);
}

void BranchesPanel::draw_transect(const Station& at) const {
  const ShapePen pen(uses_.gui, {uses_.canvas.view().camera()}, uses_.canvas.content_scale(),
                     {to_imgui(palette::blue), 3 * uses_.gui.unit(), PenMark::ring});
  for (const Vec2 bank : {at.left, at.right})
    pen.draw({PrimitiveKind::segment, {bank.x, bank.y, at.axis.x, at.axis.y}});
  pen.draw({PrimitiveKind::point, {at.place.x, at.place.y}});
}

// Bar heights show lengths of the axis. The limit of lambda is a line that can be dragged.
void BranchesPanel::draw_histogram(float height, bool is_large) {
  const float unit = uses_.gui.unit();
  const BranchTable& table = *uses_.latest.table();
  const bool shows_lambda = diagram_ == Diagram::lambda;
  if (histogram_table_ != &table || histogram_is_of_lambda_ != shows_lambda) {
    histogram_table_ = &table;
    histogram_is_of_lambda_ = shows_lambda;
    histogram_ = histogram_of(shows_lambda ? table.lambdas : table.radii, kBins);
  }
  if (histogram_.lengths.empty()) return;

  const std::optional<MapPlane>& map = uses_.editor.document().map();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(40 * unit, ImGui::GetContentRegionAvail().x), height};
  hit_area("histogram", size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double most = *std::ranges::max_element(histogram_.lengths);
  // Square roots keep short parts, such as spurious branches, visible beside long ones.
  const Plot plot(uses_.gui, {at, size}, {0.0, histogram_.high, with_unit(shows_lambda ? "lambda" : "radius", map)},
                  {.high = most,
                   .title = "length of the axis (scale of square roots)",
                   .is_root = true,
                   .above = shows_lambda ? std::optional<std::string>("") : std::nullopt},
                  is_large);
  plot.draw_frame(list);
  ComputationSettings settings = uses_.computation.settings();
  double& limit = settings[Parameter::lambda_limit];
  const double bin = histogram_.high / static_cast<double>(histogram_.lengths.size());
  const float bottom = plot.y_of(0.0);
  for (std::size_t i = 0; i < histogram_.lengths.size(); ++i) {
    if (!(histogram_.lengths[i] > 0.0)) continue;
    const float top = std::min(plot.y_of(histogram_.lengths[i]), bottom - unit);
    const float left = plot.x_of(bin * static_cast<double>(i));
    const float right = plot.x_of(bin * static_cast<double>(i + 1));
    const bool is_below = shows_lambda && bin * static_cast<double>(i + 1) <= limit;
    list.AddRectFilled({left, top}, {std::max(left + 1.0F, right - 1.0F), bottom},
                       to_imgui(palette::vermilion, is_below ? 0.3 : 0.85));
  }
  const float mouse = ImGui::GetIO().MousePos.x;
  if (shows_lambda) {
    // The limit has no effect on what is hidden.
    if (ImGui::IsItemActivated())
      if (const LayerIndex layer = uses_.layers.find("lambda-medial-axis"); layer != kNoLayer)
        uses_.layers.set_visible(layer, true);
    if (ImGui::IsItemActive()) {
      limit = plot.x_at(mouse);
      if (settings != uses_.computation.settings()) uses_.computation.set(settings);
    }
    const float x = plot.x_of(limit);
    list.AddLine({x, plot.top()}, {x, bottom}, Plot::kInk, 2 * unit);
    draw_above(uses_.gui, plot, x, "limit " + length_words(limit, map));
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
    const auto i = std::min(histogram_.lengths.size() - 1, static_cast<std::size_t>(plot.x_at(mouse) / bin));
    const std::string words =
        fmt::format("{} {:.4g} to {}: length {}", shows_lambda ? "lambda" : "radius", bin * static_cast<double>(i),
                    length_words(bin * static_cast<double>(i + 1), map), length_words(histogram_.lengths[i], map));
    ImGui::SetTooltip("%s", words.c_str());
  }
}

void BranchesPanel::draw_large() {
  if (draw_head()) draw_diagram(0.0F, true);
}

void BranchesPanel::draw_table() {
  const BranchTable& table = *uses_.latest.table();
  const bool is_current = uses_.latest.is_current();
  if (table.branches.empty()) {
    quiet_paragraph("No branch: " + table.reason);
    return;
  }
  quiet_paragraph(fmt::format("Kept: {}{}", kept_in_words(table), is_current ? "" : "; computing"));
  if (rows_.size() != table.branches.size())
    ImGui::TextDisabled(
        "%s",
        fmt::format("{} of {} branches are listed", grouped(rows_.size()), grouped(table.branches.size())).c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * (is_current ? 1.0F : 0.5F));
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollX |
                                     ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit |
                                     ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_Resizable;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (ImGui::BeginTable("branches", static_cast<int>(kColumns.size()), kFlags,
                        {0.0F, std::max(room.y, kLeastTable * uses_.gui.unit())})) {
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : kColumns) {
      ImGuiTableColumnFlags flags = ImGuiTableColumnFlags_None;
      if (column.column == BranchColumn::length)
        flags |= ImGuiTableColumnFlags_DefaultSort | ImGuiTableColumnFlags_PreferSortDescending;
      ImGui::TableSetupColumn(column.title, flags);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      ImGui::TableSetColumnIndex(static_cast<int>(i));
      ImGui::TableHeader(kColumns[i].title);
      const bool is_length = kColumns[i].column >= BranchColumn::length && kColumns[i].column <= BranchColumn::lambda;
      tooltip(uses_.gui, is_length ? with_unit(kColumns[i].explanation, uses_.editor.document().map())
                                   : kColumns[i].explanation);
    }
    ImGuiTableSortSpecs* const specs = ImGui::TableGetSortSpecs();
    if (specs != nullptr && specs->SpecsDirty && specs->SpecsCount > 0) {
      sorted_by_ = kColumns[static_cast<std::size_t>(specs->Specs[0].ColumnIndex)].column;
      is_descending_ = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
      specs->SpecsDirty = false;
      refresh_rows();
    }
    // Scrolls to a branch that was chosen on the canvas.
    const auto chosen = uses_.latest.chosen();
    if (chosen != shown_chosen_) {
      shown_chosen_ = chosen;
      const auto at = chosen ? std::ranges::find(rows_, *chosen) : rows_.end();
      if (at != rows_.end())
        ImGui::SetScrollY(
            std::max(0.0F, ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(at - rows_.begin()) -
                               0.5F * ImGui::GetWindowHeight()));
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw_row(rows_[static_cast<std::size_t>(i)]);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

void BranchesPanel::step(std::ptrdiff_t rows) {
  if (rows_.empty() || !uses_.latest.is_current()) return;
  const auto chosen = uses_.latest.chosen();
  const auto at = chosen ? std::ranges::find(rows_, *chosen) : rows_.end();
  uses_.latest.choose(at == rows_.end() ? rows_.front() : rows_[row_beside(at - rows_.begin(), rows, rows_.size())]);
}

void BranchesPanel::draw_row(std::size_t row) {
  const BranchTable& table = *uses_.latest.table();
  const AxisBranch& branch = table.branches[row];
  ImGui::TableNextRow();
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    ImGui::TableSetColumnIndex(static_cast<int>(i));
    const std::string text = cell_text(branch, row, kColumns[i].column);
    if (i != 0) {
      ImGui::TextUnformatted(text.c_str());
      continue;
    }
    const bool is_chosen = uses_.latest.chosen() == row;
    // Keeps the look of the chosen row even under the pointer.
    if (is_chosen) ImGui::PushStyleColor(ImGuiCol_HeaderHovered, uses_.gui.colors().accent_soft);
    const bool is_clicked = ImGui::Selectable(
        text.c_str(), is_chosen, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick);
    if (is_chosen) ImGui::PopStyleColor();
    if (is_clicked) {
      const bool is_double = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      uses_.latest.choose(is_chosen && !is_double ? std::nullopt : std::optional(row));
      shown_chosen_ = uses_.latest.chosen();
      if (is_double) {
        constexpr double kMarginPx = 120.0;
        Box2 box;
        for (const Vec2 p : table.lines[row]) box.add(p);
        uses_.canvas.view().fit(box, kMarginPx * uses_.canvas.content_scale());
      }
    }
    if (ImGui::IsItemHovered()) pointed_at_ = row;
  }
}

void BranchesPanel::draw_branch(std::size_t row, bool is_chosen) const {
  const float unit = uses_.gui.unit();
  const std::vector<Vec2>& line = uses_.latest.table()->lines[row];
  const ShapePen pen(
      uses_.gui, {uses_.canvas.view().camera()}, uses_.canvas.content_scale(),
      {to_imgui(palette::blue, is_chosen ? 1.0 : 0.55), (is_chosen ? 5.0F : 4.0F) * unit, PenMark::ring});
  // Draws a longer branch with every other point, or fewer.
  const std::size_t stride = line.size() / kMostBranchSegments + 1;
  Vec2 from = line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (i % stride != 0 && i + 1 != line.size()) continue;
    pen.draw({PrimitiveKind::segment, {from.x, from.y, line[i].x, line[i].y}});
    from = line[i];
  }
  for (const Vec2 end : {line.front(), line.back()}) pen.draw({PrimitiveKind::point, {end.x, end.y}});
}

}  // namespace mes
