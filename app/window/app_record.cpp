// SPDX-License-Identifier: GPL-3.0-or-later
// Recording follows what is shown; see record_desk.h.
#include <algorithm>

#include "app/window/app.h"

namespace mes {

void App::bind_record_actions() {
  actions_.bind(ActionId::snapshot, {[this] { record_.snapshot(settings_.record); }});
  actions_.bind(ActionId::record, {[this] {
                                     const auto size = window_->framebuffer_size();
                                     if (record_.is_recording())
                                       record_.stop();
                                     else
                                       record_.start(settings_.record, size.width, size.height,
                                                     canvas_.view().insets(), shown_state());
                                   },
                                   {},
                                   [this] { return record_.is_recording(); }});
  actions_.bind(ActionId::make_video,
                {[this] { record_.start_video(settings_.record.fps); }, [this] { return record_.can_make_video(); }});
}

ShownState App::shown_state() const {
  return {editor_.document().revision(),
          editor_.selection().revision(),
          layers_.revision(),
          layers_.soloed(),
          computation_.settings(),
          canvas_.view().camera(),
          settings_.show_legend,
          demo_ ? demo_->caption : std::string()};
}

AtRest App::at_rest() const {
  return {.view = !canvas_.view().is_moving() && !canvas_.has_pointer() && fit_wanted_ == Fit::none,
          .controls = !ImGui::IsAnyItemActive()};
}

bool App::holds_input() const {
  return record_.is_recording() && record_.holds_input(shown_state(), at_rest(), engine_.status().cancelled);
}

// Whatever is asked of the engine from now on makes another state, or waits for the demand to be told.
void App::note_if_complete() {
  const EngineStatus status = engine_.status();
  const bool is_complete =
      !status.busy && !status.cancelled && demand_seen_ == layers_.demand_revision() && !files_.is_reading();
  record_.note_complete(is_complete ? std::optional<ShownState>(shown_state()) : std::nullopt);
}

RecordDesk::Drawn App::drawn_now() const {
  return {canvas_.view().camera(), canvas_.view().insets(), layers_,   editor_,
          gui_.drawing_scale(),    shown_state(),           at_rest(), engine_.status().cancelled};
}

void App::follow_recording() {
  if (record_.follow()) on_anything();
  const bool waits = holds_input() && !record_.is_waiting_for_disk();
  if (!engine_.status().busy && (waits || record_.wants_turn())) frames_wanted_ = std::max(frames_wanted_, 1);
}

}  // namespace mes
