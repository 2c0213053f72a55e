// SPDX-License-Identifier: GPL-3.0-or-later
// The demo in the window: the same script as the video, computed live. Whoever edits takes over.
#include "app/model/demo.h"

#include <algorithm>
#include <utility>

#include "app/ui/icons.h"
#include "app/ui/widgets.h"
#include "app/window/app.h"
#include "core/io/format.h"

namespace mes {
namespace {

constexpr double kShortestStep = 1.0 / 12.0;  // seconds

}  // namespace

void App::start_demo() {
  end_demo(true);
  if (shapes_.empty()) {
    messages_.problem("The demo needs the sample shapes, and they are missing");
    return;
  }
  const auto shape = read_sample_file(shapes_.front().file);
  auto session = shape ? demo_session(shape->data) : std::unexpected(shape.error());
  if (!session) {
    report(session.error());
    return;
  }
  files_.start_empty();
  leave_document();
  std::vector<PlayStep> steps = steps_of(session->entries);
  demo_ = LiveDemo{.session = std::move(*session),
                   .steps = std::move(steps),
                   .document = editor_.document().revision(),
                   .layers_before = layers_.configuration(),
                   .settings_before = computation_.settings()};
  // What was selected or clicked belongs to another document.
  provenance_.clear();
  on_anything();
}

void App::end_demo(bool restore) {
  if (!demo_) return;
  const LiveDemo demo = *std::exchange(demo_, std::nullopt);
  if (!restore) return;
  // Nobody wants to be asked whether to save what a demo made.
  editor_.mark_saved();
  layers_.set_configuration(demo.layers_before);
  computation_.set(demo.settings_before);
}

Expected<void> App::perform(const TimelineEntry& entry) {
  if (const auto* edit = std::get_if<TimelineEdit>(&entry)) return editor_.perform(*edit);
  if (const auto* change = std::get_if<LayersChanged>(&entry)) {
    LayerConfiguration configuration = layers_.configuration();
    apply(*change, configuration);
    layers_.set_configuration(configuration);
  } else if (const auto* settings = std::get_if<SettingsChanged>(&entry)) {
    computation_.set(settings->settings);
  } else if (const auto* view = std::get_if<ViewChanged>(&entry)) {
    fit_to_ = view->visible;
    fit_wanted_ = Fit::glide;
  } else if (const auto* caption = std::get_if<Captioned>(&entry)) {
    demo_->caption = caption->text;
  }
  return {};
}

void App::advance_demo() {
  if (!demo_) return;
  if (editor_.document().revision() != demo_->document) {
    end_demo(false);
    messages_.remark("The demo has ended: you are editing its drawing now");
    return;
  }
  const double now = ImGui::GetTime();
  if (demo_->is_paused || now < demo_->not_before || engine_.status().busy || holds_input()) return;
  if (demo_->next == demo_->steps.size()) {
    end_demo(true);
    messages_.remark("The demo has ended");
    return;
  }
  const PlayStep& step = demo_->steps[demo_->next++];
  for (std::size_t i = step.first_entry; i < step.end_entry; ++i) {
    if (const auto done = perform(demo_->session.entries[i]); !done) {
      report(done.error());
      end_demo(true);
      return;
    }
  }
  demo_->document = editor_.document().revision();
  demo_->not_before = now + std::max(kShortestStep, step.seconds);
  editor_.mark_saved();
  on_anything();
}

void App::draw_caption(ImVec2 middle, float width) {
  if (!demo_) return;
  const float unit = gui_.unit();
  ImGui::PushFont(gui_.bold());
  const float button = 1.5F * ImGui::GetTextLineHeight();
  const float text = ImGui::CalcTextSize(demo_->caption.c_str(), nullptr, false, width - 120 * unit).x;
  const float wanted = std::min(width - 20 * unit, std::max(text, 200 * unit) + 2 * button + 44 * unit);
  ImGui::SetNextWindowPos({middle.x, middle.y - 14 * unit}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::Begin("##caption", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(wanted - 2 * button - 24 * unit);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(demo_->caption.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::SameLine(wanted - 2 * button - 14 * unit);
  if (icon_button("pause", demo_->is_paused ? Icon::play : Icon::pause, button)) demo_->is_paused = !demo_->is_paused;
  tooltip(gui_, demo_->is_paused ? "Go on" : "Pause, to look around");
  ImGui::SameLine(0, 2 * unit);
  const bool ends = icon_button("end", Icon::close, button);
  tooltip(gui_, "End the demo (Esc); layers and number type are then as before");
  ImGui::End();
  if (ends) end_demo(true);
}

}  // namespace mes
