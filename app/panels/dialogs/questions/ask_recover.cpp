// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/questions/ask_recover.h"

#include <fmt/core.h>
#include <array>

#include "app/ui/widgets/paragraph.h"
#include "core/base/counted.h"

namespace mes {

std::optional<LeftWork> AskRecover::take() {
  if (works_.empty()) return std::nullopt;
  LeftWork out = std::move(works_.front());
  works_.erase(works_.begin());
  return out;
}

void AskRecover::offer(std::vector<LeftWork> works, std::function<void()> recover) {
  works_ = std::move(works);
  recover_ = std::move(recover);
}

void AskRecover::draw(const Gui& gui) {
  static constexpr std::array kAnswers{"Recover", "Discard", "Not now"};
  const auto answer = draw_question(gui, "##ask-recover", kAnswers, 0, "Work was left unsaved when Mesecina ended",
                                    [this, &gui](float width) {
                                      if (!is_open()) return;
                                      const LeftWork& work = works_.front();
                                      const std::string title = work.name();
                                      ImGui::Dummy({1, 2 * gui.unit()});
                                      paragraph(fmt::format("{}, {}, {}at {}", title, counted(work.edits(), "change"),
                                                            work.edits() == 1 ? "" : "the last ", work.when()),
                                                width);
                                      if (works_.size() > 1)
                                        ImGui::TextDisabled("%zu more after this one", works_.size() - 1);
                                    });
  if (!answer) return;
  switch (*answer) {
    case 0: recover_(); return;
    case 1:
      if (auto work = take()) work->remove();
      return;
    default: cancel(); return;
  }
}

}  // namespace mes
