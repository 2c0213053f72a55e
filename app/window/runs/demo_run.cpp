// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/runs/demo_run.h"

#include <algorithm>
#include <utility>

#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/paragraph.h"
#include "app/ui/widgets/widgets.h"

namespace mes {

void DemoRun::start(const Session& session) {
  is_finished_ = false;
  run_ = Run{.playback = Playback(session.entries),
             .document = work_.document().revision(),
             .layers_before = work_.layers().configuration(),
             .settings_before = work_.computation().settings()};
}

void DemoRun::end(bool restore) {
  if (!run_) return;
  const Run run = *std::exchange(run_, std::nullopt);
  if (!restore || run.is_interrupted) return;
  work_.editor().mark_saved();
  work_.layers().set_configuration(run.layers_before);
  work_.computation().set(run.settings_before);
}

void DemoRun::finish() {
  is_finished_ = is_running();
  end(true);
}

std::optional<double> DemoRun::next_due(double now) const {
  return is_running() && !run_->is_paused ? std::optional(run_->not_before - now) : std::nullopt;
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
  if (!is_running()) return false;
  if (work_.document().revision() != run_->document) {
    run_->is_interrupted = true;
    return false;
  }
  if (run_->is_paused || now < run_->not_before || !may_step) return false;
  if (run_->next == run_->playback.steps().size()) {
    finish();
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

// Layer changes made meanwhile are undone, too.
void DemoRun::go_on() {
  while (work_.document().revision() != run_->document && work_.editor().can_undo()) work_.editor().undo();
  if (work_.document().revision() != run_->document) {
    end(false);
    messages_.remark("The demo cannot go on from here: Help > Demo begins it again");
    return;
  }
  work_.editor().mark_saved();
  messages_.clear_remark();  // the remark is about an edit that was undone
  run_->is_interrupted = false;
  run_->is_paused = false;
}

bool DemoRun::draw(const Gui& gui, ImVec2 middle, float width) {
  if (!run_) return false;
  constexpr float kWidth = 640;  // logical pixels: the buttons keep their position whatever the caption
  const bool is_interrupted = run_->is_interrupted;
  const std::string caption = is_interrupted ? "You are editing the drawing of the demo" : run_->playback.caption();
  const float unit = gui.unit();
  const float button = 1.5F * ImGui::GetTextLineHeight();
  const float padding = ImGui::GetStyle().FramePadding.x;
  const float words = ImGui::CalcTextSize("Go onStart again").x + 4 * padding + 4 * unit;
  const float buttons = (is_interrupted ? words + button : 2 * button) + 14 * unit;
  const float wanted = std::min(width - 20 * unit, kWidth * unit);
  ImGui::SetNextWindowPos({middle.x, middle.y - 14 * unit}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::Begin("##caption", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  // A font must be popped in the window where it was pushed: another window would lose its texture.
  ImGui::PushFont(gui.bold());
  ImGui::AlignTextToFramePadding();
  paragraph(caption, wanted - buttons - 10 * unit - ImGui::GetCursorPosX());
  ImGui::PopFont();
  // Put at the bottom, which does not move when a caption has more lines.
  ImGui::SetCursorPosY(std::max(ImGui::GetStyle().WindowPadding.y, ImGui::GetCursorPosY() - button - 4 * unit));
  ImGui::SetCursorPosX(wanted - buttons);
  bool begins_again = false;
  bool goes_on = false;
  if (is_interrupted) {
    goes_on = ImGui::Button("Go on");
    tooltip(gui, "Take your edits back, and go on with the demo where it was");
    ImGui::SameLine(0, 4 * unit);
    begins_again = ImGui::Button("Start again");
    tooltip(gui, "Start the demo from its beginning");
  } else {
    if (icon_button("pause", run_->is_paused ? Icon::play : Icon::pause, button)) run_->is_paused = !run_->is_paused;
    tooltip(gui, run_->is_paused ? "Go on" : "Pause, to look around");
  }
  ImGui::SameLine(0, 2 * unit);
  const bool ends = icon_button("end", Icon::close, button);
  tooltip(gui,
          is_interrupted ? "Keep the drawing, and forget the demo" : "End the demo (Esc); your document comes back");
  ImGui::End();
  if (goes_on) go_on();
  if (ends) finish();
  return begins_again;
}

}  // namespace mes
