// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/questions/ask_experiment.h"

#include <array>
#include <utility>

#include "app/ui/widgets/paragraph.h"

namespace mes {
namespace {
constexpr const char* kExperimentTitle = "##ask-experiment";
}

void AskExperiment::ask(std::filesystem::path file, std::function<void()> run) {
  is_open_ = true;
  file_ = std::move(file);
  run_ = std::move(run);
}

void AskExperiment::cancel() {
  is_open_ = false;
  run_ = {};
}

void AskExperiment::draw(const Gui& gui) {
  static constexpr std::array kAnswers{"Run it", "Cancel"};
  const auto answer =
      draw_question(gui, kExperimentTitle, kAnswers, 1, file_.filename().string() + " is a program", [](float width) {
        paragraph(
            "An experiment is code that runs with your rights: it may read and change your files. Run it only if you "
            "know where it is from.",
            width);
      });
  if (!answer) return;
  const std::function<void()> run = std::exchange(run_, {});
  cancel();
  if (*answer == 0) run();
}

}  // namespace mes
