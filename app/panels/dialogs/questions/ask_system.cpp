// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/questions/ask_system.h"

#include <array>
#include <utility>

#include "app/ui/screen/theme.h"
#include "app/ui/widgets/paragraph.h"

namespace mes {
namespace {
constexpr const char* kSystemTitle = "##ask-system";
}

void AskSystem::ask(std::string file, std::string present, Read read) {
  is_open_ = true;
  file_ = std::move(file);
  text_ = std::move(present);
  trouble_.clear();
  read_ = std::move(read);
  field_.focus();
}

void AskSystem::cancel() {
  is_open_ = false;
  read_ = {};
}

void AskSystem::press(const KeyChord& chord) {
  if (chord.symbol == key::enter || chord.symbol == key::tab) Question::press(chord);
}

void AskSystem::draw(const Gui& gui) {
  static constexpr std::array kAnswers{"Read it again", "Cancel"};
  const auto answer = draw_question(
      gui, kSystemTitle, kAnswers, 0, "Coordinate system of the positions in " + file_, [&](float width) {
        paragraph(
            "A code such as EPSG:25832, well-known text, or a string of PROJ. Empty: that which the file names.",
            width);
        ImGui::SetNextItemWidth(width);
        field_.draw("##system", "EPSG:25832", text_);
        if (trouble_.empty()) return;
        ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
        paragraph(trouble_, width);
        ImGui::PopStyleColor();
      });
  if (!answer) return;
  if (*answer == 0) {
    if (const auto done = read_(text_); !done) {
      trouble_ = done.error().message();
      return field_.focus();
    }
  }
  cancel();
}

}  // namespace mes
