// SPDX-License-Identifier: GPL-3.0-or-later
// A field for prose: its lines end at its edge.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "imgui.h"

namespace mes {

/// A field of several lines that breaks lines where they would leave it, as a paragraph does. The text has only the line
/// breaks that were typed. Undo and redo are its own while it has the keyboard. Cost: per change O(length). Threads: the
/// window's.
class WrappedField {
 public:
  /// Draws the field; `flags` are those of ImGui::InputTextMultiline. Returns true when the text has changed, or with
  /// ImGuiInputTextFlags_EnterReturnsTrue when Enter was pressed.
  bool draw(const char* id, std::string& text, ImVec2 size, ImGuiInputTextFlags flags = 0);

 private:
  struct Written {
    std::string text{};
    std::size_t cursor = 0;
  };
  void follow(ImGuiInputTextCallbackData& data);
  Written edited(std::string_view now, std::size_t cursor) const;
  void remember(const Written& next);
  bool take_back(std::vector<Written>& from, std::vector<Written>& to);
  void show(ImGuiInputTextCallbackData& data);
  void leave_break(ImGuiInputTextCallbackData& data) const;

  float width_ = 0.0F;
  std::string shown_;         // what Dear ImGui edits: the text with breaks that it shows and the text lacks
  bool is_followed_ = false;  // the members below are those of the writing under way
  float shown_width_ = 0.0F;  // `width_` when the breaks were made
  std::string last_;          // `shown_` as the last frame left it
  std::size_t last_cursor_ = 0;
  bool has_selection_ = false;
  Written written_;
  bool is_typing_ = false;  // the last change was typed, and the next letter belongs to it
  std::vector<Written> past_;
  std::vector<Written> future_;
};

}  // namespace mes
