// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/runs/live_recording.h"

#include <memory>
#include <utility>

namespace mes {
namespace {

// Without fonts, pictures lack legend and caption, which is better than no pictures.
std::shared_ptr<const PaperFonts> fonts_of_pictures(const std::filesystem::path& assets) {
  auto fonts = PaperFonts::read(assets);
  return fonts ? std::make_shared<const PaperFonts>(std::move(*fonts)) : nullptr;
}

}  // namespace

LiveRecording::LiveRecording(Uses uses, const std::filesystem::path& assets, std::function<void()> wake)
    : uses_(uses), recorder_(uses.board.picture(), uses.messages, fonts_of_pictures(assets), std::move(wake)) {
  recorder_.set_source(
      [this] { return uses_.work.session_for_picture({}, uses_.board.view().free_box(), uses_.board.pane_views()); });
}

void LiveRecording::bind(ActionBindings& actions) {
  const RecordSettings& settings = uses_.settings.record;
  actions.bind(ActionId::snapshot, {[this, &settings] { recorder_.snapshot(settings); }});
  actions.bind(ActionId::copy_picture, {[this, &settings] { recorder_.copy(settings.all_panes); }});
  actions.bind(ActionId::record, {[this, &settings] {
                                    if (recorder_.is_recording())
                                      recorder_.stop();
                                    else
                                      start(settings);
                                  },
                                  {},
                                  [this] { return recorder_.is_recording(); }});
  actions.bind(ActionId::make_video,
               {[this, &settings] { recorder_.start_video(settings); },
                {{[this] { return !recorder_.is_recording(); }, "a recording is under way"},
                 {[this] { return !recorder_.is_making_video(); }, "a video is being made"},
                 {[this] { return recorder_.can_make_video(); }, "there is no take to make it from"}}});
}

void LiveRecording::start(const RecordSettings& settings) {
  const auto size = uses_.screen.window->framebuffer_size();
  const PanePlaces& panes = uses_.board.canvas().panes();
  Insets panels = uses_.board.view().insets();
  // Marks of the view must not reach outside the main pane.
  if (!panes.is_empty()) {
    const PanePlace all = panes.all();
    panels = {static_cast<double>(all.left), static_cast<double>(all.top),
              static_cast<double>(size.width - all.left - all.width),
              static_cast<double>(size.height - all.top - all.height)};
  }
  recorder_.start(settings, {size.width, size.height, panels, panes, uses_.screen.gui.drawing_scale()},
                  shown_state());
}

ShownState LiveRecording::shown_state() const {
  const Workspace& work = uses_.work;
  ShownState out{.document = work.document().revision(),
                 .selection = work.editor().selection().revision(),
                 .layers = work.layers().revision(),
                 .solo = work.layers().soloed(),
                 .panes = work.panes().revision(),
                 .settings = work.computation().settings(),
                 .view = uses_.board.view().camera(),
                 .legend = legend_scope(uses_.settings.show_legend, uses_.settings.show_key),
                 .legend_at = uses_.settings.legend_at,
                 .marks = uses_.settings.marks,
                 .annotations = uses_.settings.show_annotations,
                 .caption = uses_.lesson.is_running() ? uses_.lesson.caption() : uses_.demo.caption()};
  if (!work.panes().is_empty()) {
    out.evolution = {work.evolution().choice(), work.evolution().first_value()};
    out.has_differences = uses_.settings.show_differences;
    for (const Picture::Pane& pane : uses_.board.panes_beside())
      if (pane.camera != nullptr) out.pane_views.push_back(*pane.camera);
  }
  return out;
}

AtRest LiveRecording::at_rest() const {
  return {.view = uses_.board.is_at_rest(), .controls = !ImGui::IsAnyItemActive()};
}

bool LiveRecording::holds_input() const {
  return recorder_.is_recording() &&
         recorder_.holds_input(shown_state(), at_rest(), uses_.work.engine().status().cancelled);
}

// A later request to the engine changes the state, or waits until this one is noted.
void LiveRecording::note_if_complete(bool is_reading) {
  const bool is_complete = uses_.work.is_complete() && uses_.board.has_differences() && !is_reading;
  recorder_.note_complete(is_complete ? std::optional<ShownState>(shown_state()) : std::nullopt);
}

std::vector<std::string> LiveRecording::labels_of_panes() const {
  if (uses_.board.canvas().panes().is_empty()) return {};
  std::vector<std::string> out = uses_.work.words_of_panes();
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = pane_label(i, out[i]);
  return out;
}

WindowRecorder::Drawn LiveRecording::drawn(const MarkPlaces& marks) const {
  const ViewMotion& view = uses_.board.view();
  return {view.camera(),
          view.insets(),
          uses_.work.layers(),
          {uses_.board.canvas().panes(), uses_.board.panes_beside(), labels_of_panes()},
          uses_.work.editor(),
          uses_.screen.gui.drawing_scale(),
          shown_state(),
          at_rest(),
          uses_.work.engine().status().cancelled,
          marks};
}

void LiveRecording::follow() {
  if (recorder_.follow()) uses_.screen.clock.settle();
  const bool waits = holds_input() && !recorder_.is_waiting_for_disk();
  if (!uses_.work.engine().status().busy && (waits || recorder_.wants_turn())) uses_.screen.clock.want(1);
}

}  // namespace mes
