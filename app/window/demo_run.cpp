// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/demo_run.h"

#include <algorithm>
#include <utility>

#include "app/ui/icons.h"
#include "app/ui/widgets.h"

namespace mes {

void DemoRun::start(const Session& session) {
  run_ = Run{.playback = Playback(session.entries),
             .document = work_.document().revision(),
             .layers_before = work_.layers().configuration(),
             .settings_before = work_.computation().settings()};
}

void DemoRun::end(bool restore) {
  if (!run_) return;
  const Run run = *std::exchange(run_, std::nullopt);
  if (!restore) return;
  work_.editor().mark_saved();
  work_.layers().set_configuration(run.layers_before);
  work_.computation().set(run.settings_before);
}

std::optional<double> DemoRun::next_due(double now) const {
  return run_ && !run_->is_paused ? std::optional(run_->not_before - now) : std::nullopt;
}

Expected<void> DemoRun::change_document(const TimelineEntry& entry) {
  const auto* edit = std::get_if<TimelineEdit>(&entry);
  return edit == nullptr ? Expected<void>() : work_.editor().perform(*edit);
}

void DemoRun::change_layers(const LayersChanged& change) {
  LayerConfiguration configuration = work_.layers().configuration();
  apply(change, configuration);
  work_.layers().set_configuration(configuration);
}

void DemoRun::change_settings(const ComputationSettings& settings) {
  work_.computation().set(settings);
}

void DemoRun::look_at(const Box2& box) {
  fitter_.set_target(box);
  fitter_.want(ViewFitter::How::glide);
}

bool DemoRun::advance(double now, bool may_step) {
  if (!run_) return false;
  if (work_.document().revision() != run_->document) {
    end(false);
    messages_.remark("The demo has ended: you are editing its drawing now");
    return false;
  }
  if (run_->is_paused || now < run_->not_before || !may_step) return false;
  if (run_->next == run_->playback.steps().size()) {
    end(true);
    messages_.remark("The demo has ended");
    return false;
  }
  return take_step(now);
}

bool DemoRun::take_step(double now) {
  constexpr double kShortest = 1.0 / 12.0;  // seconds
  const PlayStep step = run_->playback.steps()[run_->next++];
  if (const auto done = run_->playback.perform(step, *this); !done) {
    messages_.problem(done.error().message());
    end(true);
    return false;
  }
  run_->document = work_.document().revision();
  run_->not_before = now + std::max(kShortest, step.seconds);
  work_.editor().mark_saved();
  return true;
}

void DemoRun::draw(const Gui& gui, ImVec2 middle, float width) {
  if (!run_) return;
  const std::string& caption = run_->playback.caption();
  const float unit = gui.unit();
  ImGui::PushFont(gui.bold());
  const float button = 1.5F * ImGui::GetTextLineHeight();
  const float text = ImGui::CalcTextSize(caption.c_str(), nullptr, false, width - 120 * unit).x;
  const float wanted = std::min(width - 20 * unit, std::max(text, 200 * unit) + 2 * button + 44 * unit);
  ImGui::SetNextWindowPos({middle.x, middle.y - 14 * unit}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::Begin("##caption", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PushTextWrapPos(wanted - 2 * button - 24 * unit);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(caption.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::SameLine(wanted - 2 * button - 14 * unit);
  if (icon_button("pause", run_->is_paused ? Icon::play : Icon::pause, button)) run_->is_paused = !run_->is_paused;
  tooltip(gui, run_->is_paused ? "Go on" : "Pause, to look around");
  ImGui::SameLine(0, 2 * unit);
  const bool ends = icon_button("end", Icon::close, button);
  tooltip(gui, "End the demo (Esc); layers and number type are then as before");
  ImGui::End();
  if (ends) end(true);
}

}  // namespace mes
