// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/dialogs/sample_maker.h"

#include <fmt/core.h>
#include <array>
#include <utility>

#include "app/editing/selection.h"
#include "app/panels/dialogs/sampling_controls.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {

void SampleMaker::set_uses(Make make, Waker wake) {
  make_ = std::move(make);
  making_.emplace(std::move(wake));
}

void SampleMaker::draw_facts(const Gui& gui) const {
  const SampleMaking::Made* made = making_->made();
  if (made != nullptr && made->data) {
    const std::size_t balls = made->data->balls.size();
    const std::size_t samples = made->data->positions.size();
    quiet_paragraph(counted(samples, balls));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  if (made != nullptr) {
    if (!made->data) paragraph(made->data.error().text);
    for (const std::string& remark : made->remarks) paragraph(remark);
  }
  ImGui::PopStyleColor();
}

DialogFoot SampleMaker::foot(const Gui& gui, const std::string& name, const char* explanation,
                             std::function<void()> close) {
  static constexpr std::array kButtons{"Make", "Cancel"};
  return {kButtons, [this, &gui, name, explanation, close = std::move(close)](ButtonRows& buttons) {
            if (draw_buttons(gui, buttons, name, explanation)) close();
          }};
}

// Returns true when the dialog should close.
bool SampleMaker::draw_buttons(const Gui& gui, ButtonRows& buttons, const std::string& name,
                               const char* explanation) {
  ImGui::BeginDisabled(!making_->is_possible() || making_->is_accepted());
  // A click after a refused number has no effect: the previous number is not used and the message stays.
  if (buttons.next(true) && refused_number().empty()) making_->accept();
  ImGui::EndDisabled();
  tooltip(gui, explanation);
  if (buttons.next()) return true;
  if (!making_->is_accepted_and_ready()) return false;
  make_(*making_->made()->data, name);
  return true;
}

void SampleMaker::draw_preview(const Gui& gui) const {
  const SampleMaking::Made* made = making_->made();
  draw_sample_preview(gui, made != nullptr && made->data ? &*made->data : nullptr);
}

}  // namespace mes
