// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/wrapped_field.h"

#include <algorithm>
#include <utility>

#include "app/ui/widgets/paragraph.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

// Dear ImGui draws nothing for a carriage return, and no key or clipboard can enter one into a field.
constexpr std::string_view kSoftBreak = "\r\n";

bool is_soft(std::string_view shown, std::size_t i) {
  return shown[i] == '\r' || (shown[i] == '\n' && i > 0 && shown[i - 1] == '\r');
}

std::string without_soft_breaks(std::string_view shown) {
  std::string out;
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (!is_soft(shown, i)) out += shown[i];
  return out;
}

/// The text with soft breaks after the spaces at which `broken_lines` breaks it, and within words that are too long.
std::string with_soft_breaks(std::string_view text, float width) {
  std::string out;
  std::size_t i = 0;
  for (const char letter : broken_lines(text, width)) {
    const bool is_break = letter == '\n' && (i == text.size() || text[i] != '\n');
    if (!is_break || (i < text.size() && text[i] == ' ')) out += text[i++];
    if (is_break) out += kSoftBreak;
  }
  return out;
}

/// The position in the text for one in what is shown.
std::size_t in_text(std::string_view shown, std::size_t at) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < at; ++i) out += is_soft(shown, i) ? 0U : 1U;
  return out;
}

/// The last position in what is shown for one in the text: the beginning of a line instead of the end of the one above.
std::size_t in_shown(std::string_view shown, std::size_t at) {
  std::size_t i = 0;
  for (; i < shown.size(); ++i)
    if (!is_soft(shown, i) && at-- == 0) break;
  return i;
}

bool is_inner_byte(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

std::size_t before(std::string_view text, std::size_t at) {
  if (at == 0) return 0;
  do --at;
  while (at > 0 && is_inner_byte(text[at]));
  return at;
}

std::size_t after(std::string_view text, std::size_t at) {
  if (at == text.size()) return at;
  do ++at;
  while (at < text.size() && is_inner_byte(text[at]));
  return at;
}

bool is_key(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace

bool WrappedField::draw(const char* id, std::string& text, ImVec2 size, ImGuiInputTextFlags flags) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float outer = size.x > 0.0F ? size.x : ImGui::GetContentRegionAvail().x + size.x;
  width_ = std::max(1.0F, outer - 2 * style.FramePadding.x - style.ScrollbarSize);
  if (!is_followed_) shown_ = with_soft_breaks(text, width_);
  const bool had_selection = std::exchange(has_selection_, false);
  flags |=
      ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_NoUndoRedo | ImGuiInputTextFlags_NoHorizontalScroll;
  const auto callback = [](ImGuiInputTextCallbackData* data) {
    static_cast<WrappedField*>(data->UserData)->follow(*data);
    return 0;
  };
  const bool result = ImGui::InputTextMultiline(id, &shown_, size, flags, callback, this);
  const bool is_active = ImGui::IsItemActive();
  bool has_changed = false;
  if (is_active || ImGui::IsItemDeactivated()) {
    std::string now = without_soft_breaks(shown_);
    has_changed = now != text;
    text = std::move(now);
    const bool is_copied = ImGui::GetIO().KeyCtrl && (is_key(ImGuiKey_C) || is_key(ImGuiKey_X));
    const char* const copied = had_selection && is_copied ? ImGui::GetClipboardText() : nullptr;
    if (copied != nullptr) ImGui::SetClipboardText(without_soft_breaks(copied).c_str());
  }
  if (!is_active) is_followed_ = false;
  return (flags & ImGuiInputTextFlags_EnterReturnsTrue) != 0 ? result : has_changed;
}

// Dear ImGui has changed its buffer by the keys of this frame.
void WrappedField::follow(ImGuiInputTextCallbackData& data) {
  const std::string now(data.Buf, static_cast<std::size_t>(data.BufTextLen));
  const auto cursor = static_cast<std::size_t>(data.CursorPos);
  if (!std::exchange(is_followed_, true)) {
    written_ = {without_soft_breaks(now), in_text(now, cursor)};
    past_.clear();
    future_.clear();
    is_typing_ = false;
    shown_width_ = width_;
    last_ = now;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const bool is_undo = io.KeyCtrl && !io.KeyShift && is_key(ImGuiKey_Z);
  const bool is_redo = io.KeyCtrl && (is_key(ImGuiKey_Y) || (io.KeyShift && is_key(ImGuiKey_Z)));
  if (now != last_) {
    remember(edited(now, cursor));
    show(data);
  } else if (is_undo ? take_back(past_, future_) : is_redo && take_back(future_, past_)) {
    show(data);
  } else if (shown_width_ != width_) {
    written_.cursor = in_text(now, cursor);
    show(data);
  } else {
    leave_break(data);
  }
  last_.assign(data.Buf, static_cast<std::size_t>(data.BufTextLen));
  last_cursor_ = static_cast<std::size_t>(data.CursorPos);
  has_selection_ = data.HasSelection();
}

/// The text after the edit that led from `last_` to `now`. Where it removed a part of a soft break, a letter was meant.
WrappedField::Written WrappedField::edited(std::string_view now, std::size_t cursor) const {
  const auto same = [](auto a, auto b, std::size_t most) {
    std::size_t out = 0;
    while (out < most && a[static_cast<std::ptrdiff_t>(out)] == b[static_cast<std::ptrdiff_t>(out)]) ++out;
    return out;
  };
  // An edit leaves the text after the cursor alone, which tells equal letters apart.
  const std::size_t end = same(now.rbegin(), last_.rbegin(), std::min(now.size() - cursor, last_.size()));
  const std::size_t begin = same(now.begin(), last_.begin(), std::min(cursor, last_.size() - end));
  const std::string_view added = now.substr(begin, now.size() - end - begin);
  std::string text = without_soft_breaks(last_);
  std::size_t from = in_text(last_, begin);
  std::size_t to = in_text(last_, last_.size() - end);
  if (added.empty() && from == to) {
    if (last_cursor_ > begin)
      from = before(text, from);
    else
      to = after(text, to);
  }
  text.replace(from, to - from, added);
  return {std::move(text), from + added.size()};
}

// Letters that are typed one after the other, up to the end of a word, are undone together.
void WrappedField::remember(const Written& next) {
  const bool is_letter = after(next.text, written_.cursor) == next.cursor &&
                         next.text.size() == written_.text.size() + next.cursor - written_.cursor &&
                         next.cursor > written_.cursor;
  if (!is_typing_ || !is_letter) past_.push_back(written_);
  is_typing_ = is_letter && next.text[written_.cursor] != ' ';
  future_.clear();
  written_ = next;
}

bool WrappedField::take_back(std::vector<Written>& from, std::vector<Written>& to) {
  if (from.empty()) return false;
  to.push_back(std::exchange(written_, std::move(from.back())));
  from.pop_back();
  is_typing_ = false;
  return true;
}

void WrappedField::show(ImGuiInputTextCallbackData& data) {
  const std::string wrapped = with_soft_breaks(written_.text, width_);
  shown_width_ = width_;
  data.DeleteChars(0, data.BufTextLen);
  data.InsertChars(0, wrapped.c_str());
  data.CursorPos = static_cast<int>(in_shown(wrapped, written_.cursor));
  data.ClearSelection();
}

// A soft break is nothing that the cursor could be in or step over.
void WrappedField::leave_break(ImGuiInputTextCallbackData& data) const {
  const std::string_view now(data.Buf, static_cast<std::size_t>(data.BufTextLen));
  const auto cursor = static_cast<std::size_t>(data.CursorPos);
  std::size_t to = cursor;
  const bool is_before = cursor < now.size() && now[cursor] == '\r';
  const bool is_within = cursor > 0 && now[cursor - 1] == '\r';
  if (is_before && cursor != last_cursor_ && is_key(ImGuiKey_RightArrow))
    to = cursor + kSoftBreak.size();
  else if (is_within && is_key(ImGuiKey_RightArrow))
    to = after(now, cursor + 1);
  else if (is_within && is_key(ImGuiKey_LeftArrow))
    to = before(now, cursor - 1);
  else if (is_within)
    to = cursor - 1;
  if (to == cursor) return;
  const bool is_selecting = data.HasSelection();
  data.CursorPos = static_cast<int>(to);
  data.SelectionEnd = data.CursorPos;
  if (!is_selecting) data.SelectionStart = data.CursorPos;
}

}  // namespace mes
