// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/manual_page.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "app/ui/dialogs/large_dialog.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

// Logical pixels.
constexpr float kWidth = 1140.0F;
constexpr float kHeight = 720.0F;
constexpr float kListWidth = 230.0F;
constexpr float kListShare = 0.28F;  // at most, of the width
constexpr float kListRow = 24.0F;
constexpr const char* kManualTitle = "Manual";
constexpr float kFieldWidth = 300.0F;
constexpr float kLeastField = 120.0F;  // beside the title
constexpr float kCountWidth = 92.0F;
constexpr double kTitlePx = 22.0;
constexpr double kSubtitlePx = 17.0;
constexpr double kLineHeight = 1.3;     // of the letters
constexpr double kAboveJump = 6.0;      // between the upper edge of the view and a heading that was jumped to
constexpr double kLongestLine = 900.0;  // longer lines are hard to follow

struct Letters {
  ImFont* font;
  float size;
};

Letters letters_of(const Gui& gui, ManualStyle style) {
  const float usual = ImGui::GetFontSize();
  switch (style) {
    case ManualStyle::strong: return {gui.bold(), usual};
    case ManualStyle::emphasis: return {gui.letters(Gui::Look::italic, 0.0), usual};
    case ManualStyle::title:
      return {gui.letters(Gui::Look::bold, kTitlePx), static_cast<float>(kTitlePx) * gui.unit()};
    case ManualStyle::subtitle:
      return {gui.letters(Gui::Look::bold, kSubtitlePx), static_cast<float>(kSubtitlePx) * gui.unit()};
    case ManualStyle::plain:
    case ManualStyle::code: break;
  }
  return {gui.letters(Gui::Look::plain, 0.0), usual};
}

double width_of(const Gui& gui, std::string_view text, ManualStyle style) {
  const Letters letters = letters_of(gui, style);
  constexpr float kUnlimited = 1e9F;
  return static_cast<double>(
      letters.font->CalcTextSizeA(letters.size, kUnlimited, 0.0F, text.data(), text.data() + text.size()).x);
}

double line_height(const Gui& gui, ManualStyle style) {
  return kLineHeight * static_cast<double>(letters_of(gui, style).size);
}

float to_float(double value) {
  return static_cast<float>(value);
}

}  // namespace

void ManualPage::refresh() {
  if (!source_ || !registry_) return;
  if (shown_registry_ == registry_->share()) return;
  shown_registry_ = registry_->share();
  text_ = read_manual(source_(*shown_registry_));
  headings_ = headings_of(text_);
  laid_out_width_ = 0.0;
  searched_.clear();
  finds_.clear();
  listed_.reset();
}

const std::vector<ManualHeading>& ManualPage::headings() {
  refresh();
  return headings_;
}

void ManualPage::toggle() {
  is_open_ = !is_open_;
  if (!is_open_) return;
  refresh();
  field_.focus();
  steps_ = lines_ = pages_ = sections_ = 0;
}

void ManualPage::open_at(const std::string& section, const std::string& name) {
  is_open_ = false;
  toggle();
  const auto found = std::ranges::find_if(
      headings_, [&](const ManualHeading& one) { return one.name == name && one.section == section; });
  if (found == headings_.end()) return;
  query_.clear();
  jump_to_ = found->block;
}

bool ManualPage::is_cancelled_by(const KeyChord& chord) const {
  return Dialog::is_cancelled_by(chord) || keymap_->find(chord, false) == ActionId::manual;
}

// Keys are acted on when the page is drawn, after the field has taken the letters typed before them.
void ManualPage::press(const KeyChord& chord) {
  const bool is_section = chord.modifiers.ctrl;
  switch (chord.symbol) {
    case key::enter: steps_ += chord.modifiers.shift ? -1 : 1; return;
    case key::down: ++lines_; return;
    case key::up: --lines_; return;
    case key::page_down: ++(is_section ? sections_ : pages_); return;
    case key::page_up: --(is_section ? sections_ : pages_); return;
    case key::home:
      if (query_.empty() || chord.modifiers.ctrl) scroll_to_ = 0.0;
      return;
    case key::end:
      if (query_.empty() || chord.modifiers.ctrl) scroll_to_ = layout_.height;
      return;
    default: return;
  }
}

void ManualPage::search() {
  if (query_ == searched_) return;
  // The search goes on from the present place, so that further letters of the same word do not lead away from it.
  const ManualFind from = present_find_ < finds_.size() ? finds_[present_find_]
                                                        : ManualFind{layout_.blocks_between(scroll_, scroll_).first};
  searched_ = query_;
  finds_ = find_in(text_, query_);
  const auto next = std::ranges::lower_bound(finds_, ManualFind{from.block, from.cell, from.begin, 0});
  present_find_ = next == finds_.end() ? 0 : static_cast<std::size_t>(next - finds_.begin());
  shows_find_ = !finds_.empty();
}

void ManualPage::step(int finds) {
  if (finds_.empty() || finds == 0) return;
  const auto count = static_cast<std::ptrdiff_t>(finds_.size());
  const std::ptrdiff_t next = (static_cast<std::ptrdiff_t>(present_find_) + finds) % count;
  present_find_ = static_cast<std::size_t>(next < 0 ? next + count : next);
  shows_find_ = true;
}

void ManualPage::draw_head(const Gui& gui, float width) {
  const float unit = gui.unit();
  const float size = ImGui::GetFrameHeight();
  const float right = ImGui::GetCursorPosX() + width;
  ImGui::PushFont(gui.bold());
  const float title = ImGui::CalcTextSize(kManualTitle).x + 24 * unit;
  const float buttons = kCountWidth * unit + 3 * size + 24 * unit;
  // The field needs its room first.
  const bool has_title = width - buttons - title >= kLeastField * unit;
  if (has_title) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(kManualTitle);
    ImGui::SameLine();
  }
  ImGui::PopFont();
  const float field = std::clamp(width - buttons - (has_title ? title : 0.0F), 40 * unit, kFieldWidth * unit);
  ImGui::SetCursorPosX(right - buttons - field);
  ImGui::SetNextItemWidth(field);
  // The page handles Enter itself, in `press`.
  if (field_.draw("##find", "Find in the manual", query_)) field_.focus();
  search();
  step(std::exchange(steps_, 0));
  ImGui::SameLine(0, 8 * unit);
  const float count_at = ImGui::GetCursorPosX();
  if (!finds_.empty())
    ImGui::TextDisabled("%s", fmt::format("{} of {}", present_find_ + 1, finds_.size()).c_str());
  else
    ImGui::TextDisabled("%s", searched_.empty() ? "" : "Not found");
  ImGui::SameLine(count_at + kCountWidth * unit);
  ImGui::BeginDisabled(finds_.empty());
  if (ImGui::ArrowButton("##before", ImGuiDir_Up)) step(-1);
  tooltip(gui, "The place before (Shift+Enter)");
  ImGui::SameLine(0, 4 * unit);
  if (ImGui::ArrowButton("##next", ImGuiDir_Down)) step(1);
  tooltip(gui, "The next place (Enter)");
  ImGui::EndDisabled();
  ImGui::SameLine(right - size);
  if (icon_button("close", Icon::close, size)) is_open_ = false;
  tooltip(gui, "Close (Esc)");
}

std::size_t ManualPage::present_heading() const {
  const double edge = scroll_ + 2.0 * kAboveJump * laid_out_unit_;
  const auto above = std::ranges::partition_point(
      headings_, [&](const ManualHeading& one) { return layout_.blocks[one.block].top <= edge; });
  return above == headings_.begin() ? 0 : static_cast<std::size_t>(above - headings_.begin()) - 1;
}

void ManualPage::jump_to_heading(std::size_t index) {
  if (index < headings_.size()) jump_to_ = headings_[index].block;
}

void ManualPage::draw_headings(const Gui& gui, float width) {
  const float unit = gui.unit();
  const float row = kListRow * unit;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("headings", {width, 0});
  const std::size_t present = laid_out_width_ > 0.0 && !headings_.empty() ? present_heading() : 0;
  if (listed_ != present) {
    listed_ = present;
    const float top = row * static_cast<float>(present);
    const float shown = ImGui::GetWindowHeight();
    if (top < ImGui::GetScrollY() || top + row > ImGui::GetScrollY() + shown) ImGui::SetScrollY(top - 0.3F * shown);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(headings_.size()), row);
  while (clipper.Step())
    for (int line = clipper.DisplayStart; line < clipper.DisplayEnd; ++line) {
      const auto index = static_cast<std::size_t>(line);
      const ManualHeading& heading = headings_[index];
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float room = ImGui::GetContentRegionAvail().x;
      ImGui::PushID(line);
      if (hit_area("heading", {room, row})) jump_to_heading(index);
      ImGui::PopID();
      ImDrawList& list = *ImGui::GetWindowDrawList();
      const bool is_hovered = ImGui::IsItemHovered();
      if (index == present || is_hovered)
        list.AddRectFilled(at, {at.x + room, at.y + row},
                           index == present ? gui.colors().accent_soft : gui.colors().accent_faint, 4 * unit);
      const bool is_section = heading.section.empty();
      const float indent = (is_section ? 6 : 20) * unit;
      if (is_section) ImGui::PushFont(gui.bold());
      list.AddText({at.x + indent, at.y + 0.5F * (row - ImGui::GetFontSize())},
                   is_section ? gui.colors().text : gui.colors().text_quiet,
                   elided(heading.name, room - indent - 4 * unit).c_str());
      if (is_section) ImGui::PopFont();
    }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

// Keeps the text at the upper edge of the view in its place when the page gets another width or other letters.
void ManualPage::fit_layout(const Gui& gui, double width) {
  const double unit = static_cast<double>(gui.unit());
  // The letters of titles are loaded with the frame after they were first asked for.
  static_cast<void>(letters_of(gui, ManualStyle::title));
  const bool has_letters = !gui.lacks_letters();
  if (width == laid_out_width_ && unit == laid_out_unit_ && has_letters == had_letters_) return;
  const bool is_again = laid_out_width_ > 0.0;
  const std::size_t first = is_again ? layout_.blocks_between(scroll_, scroll_).first : 0;
  const double below = is_again ? (layout_.blocks[first].top - scroll_) / laid_out_unit_ : 0.0;
  layout_ = lay_out(
      text_, {.width = width,
              .unit = unit,
              .measure = [&gui](std::string_view text, ManualStyle style) { return width_of(gui, text, style); },
              .line = [&gui](ManualStyle style) { return line_height(gui, style); }});
  laid_out_width_ = width;
  laid_out_unit_ = unit;
  had_letters_ = has_letters;
  if (is_again && !scroll_to_ && !jump_to_) scroll_to_ = layout_.blocks[first].top - below * unit;
}

void ManualPage::follow_keys(const Gui& gui) {
  const double line = line_height(gui, ManualStyle::plain);
  const double height = static_cast<double>(ImGui::GetWindowHeight());
  const double unit = static_cast<double>(gui.unit());
  if (lines_ != 0 || pages_ != 0)
    scroll_to_ = scroll_ + 3.0 * line * std::exchange(lines_, 0) + (height - 2.0 * line) * std::exchange(pages_, 0);
  if (const int by = std::exchange(sections_, 0); by != 0 && !headings_.empty()) {
    const auto present = static_cast<std::ptrdiff_t>(present_heading());
    jump_to_heading(static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(present + by, 0, static_cast<std::ptrdiff_t>(headings_.size()) - 1)));
  }
  if (const auto block = std::exchange(jump_to_, std::nullopt))
    scroll_to_ = layout_.blocks[*block].top - kAboveJump * unit;
  if (std::exchange(shows_find_, false) && present_find_ < finds_.size()) {
    const ManualPiece& piece = layout_.piece_of(finds_[present_find_]);
    const bool is_seen = piece.y >= scroll_ && piece.y + 2.0 * line <= scroll_ + height;
    if (!is_seen) scroll_to_ = piece.y - 0.3 * height;
  }
  if (scroll_to_) {
    const double most = std::max(0.0, layout_.height - height);
    scroll_ = std::clamp(*std::exchange(scroll_to_, std::nullopt), 0.0, most);
    ImGui::SetScrollY(to_float(scroll_));
  } else {
    scroll_ = static_cast<double>(ImGui::GetScrollY());
  }
}

void ManualPage::draw_finds(const Gui& gui, std::size_t block, ImVec2 corner) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  auto find = std::ranges::lower_bound(finds_, ManualFind{block});
  for (; find != finds_.end() && find->block == block; ++find) {
    const bool is_present = static_cast<std::size_t>(find - finds_.begin()) == present_find_;
    for (std::size_t i = layout_.blocks[block].first_piece; i < layout_.blocks[block + 1].first_piece; ++i) {
      const ManualPiece& piece = layout_.pieces[i];
      if (piece.block != block) continue;
      const std::size_t begin = std::max(piece.begin, find->begin);
      const std::size_t end = std::min(piece.end, find->end);
      if (piece.cell != find->cell || begin >= end) continue;
      const std::string_view text = text_.blocks[block].cells[piece.cell].text;
      const double left = piece.x + width_of(gui, text.substr(piece.begin, begin - piece.begin), piece.style);
      const double right = left + width_of(gui, text.substr(begin, end - begin), piece.style);
      const ImVec2 low(corner.x + to_float(left), corner.y + to_float(piece.y));
      const ImVec2 high(corner.x + to_float(right), low.y + to_float(line_height(gui, piece.style)));
      list.AddRectFilled(low, high, gui.colors().accent_soft, 2 * gui.unit());
      if (is_present) list.AddRect(low, high, gui.colors().accent, 2 * gui.unit(), 0, 2 * gui.unit());
    }
  }
}

void ManualPage::draw_block(const Gui& gui, std::size_t block, ImVec2 corner) const {
  const ThemeColors& colors = gui.colors();
  const float unit = gui.unit();
  const ManualBlock& source = text_.blocks[block];
  const ManualLayout::Block& place = layout_.blocks[block];
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float right = corner.x + to_float(laid_out_width_);
  const float top = corner.y + to_float(place.top);
  const float bottom = corner.y + to_float(place.bottom);
  if (source.kind == ManualBlockKind::code) {
    const float margin = 6 * unit;
    const bool is_first = block == 0 || text_.blocks[block - 1].kind != ManualBlockKind::code;
    const bool is_last = block + 1 == text_.blocks.size() || text_.blocks[block + 1].kind != ManualBlockKind::code;
    list.AddRectFilled({corner.x, top - (is_first ? margin : 0)}, {right, bottom + (is_last ? margin : 0)},
                       colors.field);
  }
  if (source.kind == ManualBlockKind::head || source.kind == ManualBlockKind::row)
    list.AddLine({corner.x, bottom}, {right, bottom}, colors.border, unit);
  if (source.kind == ManualBlockKind::heading && source.level <= 2)
    list.AddLine({corner.x, bottom + 2 * unit}, {right, bottom + 2 * unit}, colors.border, unit);
  for (std::size_t i = place.first_piece; i < layout_.blocks[block + 1].first_piece; ++i) {
    const ManualPiece& piece = layout_.pieces[i];
    if (piece.style != ManualStyle::code) continue;
    const ImVec2 low(corner.x + to_float(piece.x) - unit, corner.y + to_float(piece.y) + unit);
    list.AddRectFilled(
        low, {low.x + to_float(piece.width) + 2 * unit, low.y + to_float(line_height(gui, piece.style)) - 2 * unit},
        colors.field, 3 * unit);
  }
  draw_finds(gui, block, corner);
  for (std::size_t i = place.first_piece; i < layout_.blocks[block + 1].first_piece; ++i) {
    const ManualPiece& piece = layout_.pieces[i];
    const Letters letters = letters_of(gui, piece.style);
    const std::string_view text = std::string_view(text_.blocks[piece.block].cells[piece.cell].text)
                                      .substr(piece.begin, piece.end - piece.begin);
    const float height = to_float(line_height(gui, piece.style));
    const ImVec2 at(corner.x + to_float(piece.x), corner.y + to_float(piece.y));
    list.AddText(letters.font, letters.size, {at.x, at.y + 0.5F * (height - letters.size)}, colors.text, text.data(),
                 text.data() + text.size());
  }
}

void ManualPage::draw_text(const Gui& gui) {
  const float unit = gui.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::BeginChild("text", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);
  const float margin = 14 * unit;
  const double room = static_cast<double>(ImGui::GetContentRegionAvail().x - 2 * margin);
  fit_layout(gui, std::clamp(room, 40.0 * static_cast<double>(unit), kLongestLine * static_cast<double>(unit)));
  follow_keys(gui);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const ImVec2 corner(start.x + margin, start.y);
  // The position of the window's content is that of this frame, which a new position of the scrollbar follows in the
  // next one.
  const double top = static_cast<double>(ImGui::GetScrollY());
  const auto [first, last] = layout_.blocks_between(top, top + static_cast<double>(ImGui::GetWindowHeight()));
  for (std::size_t block = first; block < last; ++block) draw_block(gui, block, corner);
  ImGui::Dummy({1, to_float(layout_.height) + 20 * unit});
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void ManualPage::draw(const Gui& gui) {
  large_dialog(gui, "##manual", is_open_, {kWidth, kHeight}, DialogKeys::own, [&](ImVec2 size) {
    const float unit = gui.unit();
    const float width = ImGui::GetContentRegionAvail().x;
    draw_head(gui, width);
    ImGui::Dummy({0, 2 * unit});
    draw_headings(gui, std::min(kListWidth * unit, kListShare * size.x));
    ImGui::SameLine(0, 8 * unit);
    draw_text(gui);
    // A click leaves the field, where letters typed next belong.
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive()) field_.focus();
    constexpr ImGuiHoveredFlags kAnywhere =
        ImGuiHoveredFlags_RootAndChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem;
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(kAnywhere);
    if (beside) is_open_ = false;
  });
}

}  // namespace mes
