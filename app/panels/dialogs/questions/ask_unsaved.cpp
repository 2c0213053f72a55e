// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/questions/ask_unsaved.h"

#include <array>
#include <utility>

#include "app/ui/widgets/paragraph.h"

namespace mes {
namespace {
constexpr const char* kUnsavedTitle = "##ask-unsaved";
}

void AskUnsaved::ask(std::string title, Answers answers, std::string reason) {
  is_open_ = true;
  title_ = std::move(title);
  reason_ = std::move(reason);
  answers_ = std::move(answers);
}

void AskUnsaved::cancel() {
  is_open_ = false;
  answers_ = {};
}

void AskUnsaved::draw(const Gui& gui) {
  static constexpr std::array kAnswers{"Save", "Don't save", "Cancel"};
  const auto answer =
      draw_question(gui, kUnsavedTitle, kAnswers, 0, title_ + " has changes that are not saved", [this](float width) {
        if (!reason_.empty()) paragraph(reason_, width);
      });
  if (!answer) return;
  const Answers answers = std::exchange(answers_, {});
  cancel();
  if (*answer == 0) answers.save();
  if (*answer == 1) answers.discard();
}

}  // namespace mes
