// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/side_column.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/ui/widgets/button_columns.h"

namespace mes {
namespace {

// Logical pixels.
constexpr float kRailPadding = 4.0F;
constexpr float kRoomForTwo = 460.0F;
constexpr float kLeastPanel = 180.0F;  // height in which the panel of layers shows its first rows
constexpr double kLeastWidth = 240.0;
constexpr double kMostWidth = 1200.0;
constexpr float kLeastRest = 160.0F;  // toolbar and drawing beside the panels
constexpr float kLargeSide = 640.0F;
constexpr float kLargeShareOfWidth = 0.6F;  // of the canvas, at most
constexpr float kLargeShareOfHeight = 0.7F;
constexpr float kLargeEdge = 8.0F;
constexpr float kLeastLargeWidth = 240.0F;
constexpr float kLeastLargeHeight = 200.0F;
constexpr float kUsualWidth = 300.0F;
// Maximal share of the window for the panels, and where they would be narrower than usual.
constexpr float kMostOfScreen = 0.45F;
constexpr float kMostOfSmallScreen = 0.7F;

}  // namespace

const SidePage& SideColumn::page_of(PanelPage page) const {
  return *std::ranges::find(pages_, page, &SidePage::page);
}

float SideColumn::draw(float top, float height) {
  pointed_at_.reset();
  PanelChoice& panels = settings_.panels;
  const float unit = gui_.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float rail = draw_rail(top, height);
  const float free = screen.x - rail;
  const bool has_room = free >= (static_cast<float>(kLeastWidth) + kLeastRest) * unit;
  panels.set_room(!has_room ? 0 : height < kRoomForTwo * unit ? 1 : 2);
  panels_width_ = 0.0F;
  // A copy, because a panel may close itself while it is drawn.
  const std::vector<PanelPage> shown(panels.shown().begin(), panels.shown().end());
  if (shown.empty()) return rail;
  const float wanted = static_cast<float>(settings_.column_width) * unit;
  const float usual = std::min(kUsualWidth * unit, kMostOfSmallScreen * free);
  // Windows begin at whole pixels, so fractions would leave a slit between them.
  const float width = std::max(1.0F, std::floor(std::min(wanted, std::max(usual, kMostOfScreen * free))));
  panels_width_ = width;
  const PanelArea column{{screen.x - rail - width, top}, {width, height}};
  const bool has_two = shown.size() == 2;
  const float least_height = std::min(kLeastPanel * unit, 0.5F * height);
  const float shared = (1.0F - static_cast<float>(settings_.lower_panel_share)) * height;
  const float upper = has_two ? std::floor(std::clamp(shared, least_height, height - least_height)) : 0.0F;
  if (has_two) draw_panel(page_of(shown.front()), {column.at, {width, upper}});
  draw_panel(page_of(shown.back()), {{column.at.x, top + upper}, {width, height - upper}});
  draw_splitters(column, upper);
  return rail + width;
}

// Draws the icons, and returns the width of the rail.
float SideColumn::draw_rail(float top, float height) {
  const float unit = gui_.unit();
  const float padding = kRailPadding * unit;
  const float room = height - 2 * padding;
  const auto groups = static_cast<std::size_t>(std::ranges::count(pages_, true, &SidePage::begins_group));
  const float size = column_button_size(pages_.size(), groups, room / unit) * unit;
  ButtonColumns measure({}, size, unit, room);
  for (const SidePage& page : pages_) measure.advance(page.begins_group);
  const float width = std::ceil(measure.width() + 2 * padding);
  const float left = ImGui::GetIO().DisplaySize.x - width;
  const PanelArea with_panels{{left - panels_width_, top}, {panels_width_ + width, height}};
  if (begin_panel("##rail", {{left, top}, {width, height}},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    ButtonColumns columns({padding, padding}, size, unit, room);
    for (const SidePage& page : pages_) {
      columns.next(page.begins_group);
      const ButtonLook look = actions_.is_checked(page.toggle) ? ButtonLook::on : ButtonLook::plain;
      if (icon_button(page.title, page.icon, size, look)) actions_.run(page.toggle);
      tooltip(gui_, actions_.tooltip_of(page.toggle), with_panels);
    }
  }
  ImGui::End();
  return width;
}

bool SideColumn::step(std::ptrdiff_t rows) {
  if (!pointed_at_) return false;
  const SidePage& page = page_of(*pointed_at_);
  if (page.step) page.step(rows);
  return static_cast<bool>(page.step);
}

void SideColumn::draw_panel(const SidePage& page, const PanelArea& area) {
  const std::string name = "##panel-" + std::string(id_of(page.page));
  if (begin_panel(name.c_str(), area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    draw_title(page);
    ImGui::BeginChild("##content");
    page.draw();
    ImGui::EndChild();
    if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) pointed_at_ = page.page;
  }
  ImGui::End();
}

// Draws the name of the panel and its buttons.
void SideColumn::draw_title(const SidePage& page) {
  PanelChoice& panels = settings_.panels;
  const float unit = gui_.unit();
  const float size = ImGui::GetFrameHeight();
  const float gap = 2 * unit;
  ImGui::PushFont(gui_.bold());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(page.title);
  ImGui::PopFont();
  const int buttons = page.large ? 3 : 2;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - static_cast<float>(buttons) * (size + gap) + gap);
  if (page.large) {
    const bool is_large = panels.large() == page.page;
    if (icon_button("large", Icon::enlarge, size, is_large ? ButtonLook::on : ButtonLook::plain))
      panels.set_large(is_large ? std::nullopt : std::optional(page.page));
    tooltip(gui_, "Show the diagram large over the drawing (Esc closes it)");
    ImGui::SameLine(0, gap);
  }
  const bool is_pinned = panels.pinned() == page.page;
  if (icon_button("pin", is_pinned ? Icon::pinned : Icon::pin, size, is_pinned ? ButtonLook::on : ButtonLook::plain))
    panels.toggle_pin(page.page);
  tooltip(gui_, is_pinned ? "Unpin: the next panel that opens takes the place of this one"
                          : "Pin: this panel stays when another one opens, which is then below it");
  ImGui::SameLine(0, gap);
  if (icon_button("close", Icon::close, size)) panels.close(page.page);
  tooltip(gui_, "Hide this panel");
}

// `upper`: the height of the upper of two panels; 0: there is one.
void SideColumn::draw_splitters(const PanelArea& column, float upper) {
  const SplitterMove side = splitter(gui_, "##column-side", {column.at, {0.0F, column.size.y}});
  const double width = static_cast<double>((column.at.x + column.size.x - side.to.x) / gui_.unit());
  if (side.is_dragged) settings_.column_width = std::clamp(width, kLeastWidth, kMostWidth);
  if (side.is_reset) settings_.column_width = kUsualColumnWidth;
  if (upper <= 0.0F) return;
  const SplitterMove line =
      splitter(gui_, "##lower-begin", {{column.at.x, column.at.y + upper}, {column.size.x, 0.0F}});
  const double share = static_cast<double>(1.0F - (line.to.y - column.at.y) / column.size.y);
  if (line.is_dragged) settings_.lower_panel_share = std::clamp(share, 0.1, 0.9);
  if (line.is_reset) settings_.lower_panel_share = kUsualLowerShare;
}

// Where it was put last, or else in the corner of the canvas where it hides the least.
PanelArea SideColumn::large_area(const PanelArea& room, const Hides& hides) const {
  const float unit = gui_.unit();
  const ImVec2 most(room.size.x / unit - 2 * kLargeEdge, room.size.y / unit - 2 * kLargeEdge);
  const auto length = [](double wanted, float least, float limit) {
    return std::max(1.0F, std::min(std::max(static_cast<float>(wanted), least), limit));
  };
  const bool is_known = settings_.diagram.at.has_value();
  const ImVec2 size(length(is_known ? settings_.diagram.width : std::min(kLargeSide, kLargeShareOfWidth * most.x),
                           kLeastLargeWidth, most.x),
                    length(is_known ? settings_.diagram.height : std::min(kLargeSide, kLargeShareOfHeight * most.y),
                           kLeastLargeHeight, most.y));
  const auto in_units = [unit](float pixels) { return static_cast<double>(pixels / unit); };
  const Vec2 extent{size.x, size.y};
  const Vec2 low{in_units(room.at.x), in_units(room.at.y)};
  const Box2 area{low, low + Vec2{in_units(room.size.x), in_units(room.size.y)}};
  const auto on_screen = [unit](Vec2 p) {
    return Vec2{p.x * static_cast<double>(unit), p.y * static_cast<double>(unit)};
  };
  std::optional<Vec2> at;
  if (is_known) {
    at = placed(*settings_.diagram.at, extent, area);
  } else {
    std::size_t least = 0;
    for (const PaperCorner corner :
         {PaperCorner::bottom_right, PaperCorner::top_right, PaperCorner::bottom_left, PaperCorner::top_left}) {
      const Vec2 here = placed({.corner = corner}, extent, area);
      const std::size_t hidden = hides({on_screen(here), on_screen(here + extent)});
      if (at && hidden >= least) continue;
      at = here;
      least = hidden;
    }
  }
  const Vec2 corner = on_screen(*at);
  return {{std::floor(static_cast<float>(corner.x)), std::floor(static_cast<float>(corner.y))},
          {std::floor(size.x * unit), std::floor(size.y * unit)}};
}

void SideColumn::draw_large(const PanelArea& room, const Hides& hides) {
  const std::optional<PanelPage> before = std::exchange(large_, settings_.panels.large());
  if (!large_) return;
  const SidePage& page = page_of(*large_);
  const float unit = gui_.unit();
  if (before != large_) {
    const PanelArea area = large_area(room, hides);
    ImGui::SetNextWindowPos(area.at);
    ImGui::SetNextWindowSize(area.size);
  }
  ImGui::SetNextWindowSizeConstraints({kLeastLargeWidth * unit, kLeastLargeHeight * unit},
                                      ImGui::GetIO().DisplaySize);
  bool is_open = true;
  const std::string name = descriptor_of(page.toggle).name + "##large";
  if (ImGui::Begin(name.c_str(), &is_open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings))
    page.large();
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) pointed_at_ = page.page;
  const PanelArea now{ImGui::GetWindowPos(), ImGui::GetWindowSize()};
  ImGui::End();
  const bool has_moved = now.at.x != large_at_.at.x || now.at.y != large_at_.at.y || now.size.x != large_at_.size.x ||
                         now.size.y != large_at_.size.y;
  large_at_ = now;
  // A window that becomes smaller moves it, too.
  if (before == large_ && has_moved && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0F)) {
    const auto in_units = [unit](ImVec2 p) {
      return Vec2{static_cast<double>(p.x / unit), static_cast<double>(p.y / unit)};
    };
    const Vec2 low = in_units(room.at);
    const Vec2 size = in_units(now.size);
    settings_.diagram = {place_of(in_units(now.at), size, {low, low + in_units(room.size)}), size.x, size.y};
  }
  if (!is_open) settings_.panels.set_large(std::nullopt);
}

}  // namespace mes
