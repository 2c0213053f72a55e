// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/app.h"

#include <algorithm>
#include <utility>

#include "app/model/memory_problem.h"
#include "app/panels/canvas_legend.h"
#include "app/panels/empty_hint.h"
#include "app/panels/evolution_strip.h"
#include "app/panels/help.h"
#include "app/panels/problem_note.h"
#include "app/picture/canvas_look.h"
#include "app/store/color_maps.h"
#include "app/ui/theme.h"

namespace mes {
namespace {

constexpr int kSettlingFrames = 2;
constexpr double kProgressInterval = 0.08;  // seconds between pictures while a progress bar may be on screen
constexpr float kMostOfBundles = 0.35F;     // of the height that bundles and layers share
constexpr float kLeastOfBundles = 62.0F;    // logical pixels: the head and a row
constexpr float kLeastOfLayers = 190.0F;
constexpr double kLargestCirclePx = 10'000.0;
constexpr double kLongestStep = 0.05;  // seconds; after a sleep a motion goes on from where it was

// Pictures without legend and caption are better than none.
std::shared_ptr<const LegendFonts> fonts_of_pictures(const std::filesystem::path& assets) {
  auto fonts = LegendFonts::read(assets);
  return fonts ? std::make_shared<const LegendFonts>(std::move(*fonts)) : nullptr;
}

}  // namespace

App::App(std::unique_ptr<GlfwWindow> window, const WindowOptions& options, LoadedSettings loaded,
         const Termination& termination)
    : termination_(termination),
      settings_(std::move(loaded.settings)),
      settings_at_start_(settings_),
      settings_path_(default_settings_path()),
      window_(std::move(window)),
      assets_(find_assets(options.executable)),
      shapes_(read_sample_shapes(assets_)),
      gui_(*window_, assets_),
      record_(picture_, messages_, fonts_of_pictures(assets_), [] { GlfwWindow::wake(); }),
      engine_({.wake = [] { GlfwWindow::wake(); }}),
      layers_(layer_descriptors()),
      bundles_(default_bundles_path(), assets_, layers_),
      editor_([this](std::shared_ptr<const DocumentDelta> delta) { engine_.post(std::move(delta)); }, &layers_),
      evolution_(editor_,
                 {[this](Parameter parameter) { return computation_.settings()[parameter]; },
                  [this](Parameter parameter, double value) { computation_.set(parameter, value); }},
                 [] { GlfwWindow::wake(); }),
      files_(
          editor_,
          [this] {
            editor_.note_layers();
            return session_now();
          },
          [] { GlfwWindow::wake(); }),
      tool_context_{editor_, settings_.spray_spacing_px, [this](const Error& error) { report(error); },
                    [this](const Pointer& pointer) {
                      provenance_.ask(engine_, layers_, pointer, editor_.document().revision());
                    }},
      canvas_(tool_context_),
      bundles_panel_({gui_, actions_, bundles_, editor_, messages_, settings_.show_bundles,
                      [this](std::size_t index) { ask_export(index); }}),
      layers_panel_(gui_, layers_, picture_, {gui_, actions_, layers_, picture_, canvas_}),
      details_panel_(gui_, settings_.details, {gui_, picture_, times_}, {gui_, computation_}, {gui_, messages_}),
      autosave_(default_autosave_folder(), [] { GlfwWindow::wake(); }) {
  if (!loaded.message.empty()) messages_.problem(loaded.message);
  LoadedColorMaps maps = load_color_maps(assets_, user_color_map_folder());
  picture_.set_color_maps(std::move(maps.maps));
  if (!maps.problems.empty()) messages_.problem("A colour map is left out: " + maps.problems.front().message());
  if (const std::string message = bundles_.take_message(); !message.empty()) messages_.problem(message);
  bind_actions();
  window_->set_listener(this);
  open_first(options);
  look_for_left_work();
}

App::~App() {
  window_->set_listener(nullptr);
}

double App::next_wait() const {
  const EngineStatus status = engine_.status();
  if (demo_ && !demo_->is_paused) return std::clamp(demo_->not_before - ImGui::GetTime(), 1e-3, kProgressInterval);
  if (const auto due = computation_.next_due(ImGui::GetTime())) return std::clamp(*due, 1e-3, kProgressInterval);
  if (const auto due = evolution_.next_due(ImGui::GetTime())) return std::clamp(*due, 1e-3, kProgressInterval);
  if (status.busy || evolution_.is_waiting() || files_.is_reading() || files_.is_saving() ||
      background_.is_reading() || gui_.is_about_to_rest())
    return kProgressInterval;
  return 0.0;
}

void App::run() {
  while (!is_closing_ && termination_.signal() == 0) {
    if (frames_wanted_ > 0 || canvas_.view().is_moving())
      window_->poll();
    else
      window_->wait(next_wait());
    times_.begin();
    deliver_events();
    take_read_file();
    take_saved();
    offer_left_work();
    note_if_complete();
    if (picture_.take_from(engine_)) tell_of_memory();
    provenance_.take(picture_.take_provenance());
    follow_evolution();
    const bool was_about_to_rest = gui_.is_about_to_rest();
    frame();
    frames_wanted_ = std::max(0, frames_wanted_ - 1);
    // A tooltip that comes up now is measured in its first frame and seen in its second.
    if (was_about_to_rest && !gui_.is_about_to_rest()) frames_wanted_ = kSettlingFrames;
    if (gui_.is_fading()) frames_wanted_ = std::max(frames_wanted_, 1);
  }
  // In order: what there was has been saved or given up on request. A signal makes no request; its journal stays, and
  // is complete before anything that may take longer than a signal waits.
  if (is_closing_) {
    autosave_.discard();
  } else {
    keep_timeline();
    autosave_.flush();
  }
  remember_settings();
  record_.end();
}

// The layers that are grey say nothing by themselves; this does, once for each state of the document, until there is
// room again.
void App::tell_of_memory() {
  if (!picture_.lacks_memory()) {
    if (std::exchange(memory_told_at_, std::nullopt) && is_memory_problem(messages_.problem()))
      messages_.clear_problem();
    return;
  }
  const Document& document = editor_.document();
  if (std::exchange(memory_told_at_, document.revision()) == document.revision()) return;
  messages_.problem(memory_problem(document.sample_count(), document.ball_count()));
  frames_wanted_ = std::max(frames_wanted_, kSettlingFrames);  // a new panel is measured first
}

// While memory is short and nothing changes, requests nothing; after a change it requests everything again.
bool App::waits_for_room() {
  if (!picture_.is_lost()) return false;
  const std::pair now{layers_.demand_revision(), editor_.document().revision()};
  if (engine_.status().busy) return true;
  if (!demands_nothing_) {
    demands_nothing_ = true;
    lost_at_ = now;
    engine_.set_demand({});
    return true;
  }
  return lost_at_ == now;
}

void App::follow_demand() {
  if (waits_for_room()) return;
  if (layers_.demand_revision() == demand_seen_ && !std::exchange(demands_nothing_, false)) return;
  demands_nothing_ = false;
  demand_seen_ = layers_.demand_revision();
  engine_.set_demand(layers_.visible_layers());
  picture_.forget_hidden(layers_);
}

// Whoever makes a first ball wants to see it, even after hiding the layers of a document that had none.
void App::show_first_ball() {
  const bool has_balls = editor_.document().ball_count() != 0;
  if (has_balls == std::exchange(had_balls_, has_balls) || !has_balls) return;
  // Undone work is brought back as it was looked at.
  if (editor_.can_redo()) return;
  std::vector<LayerIndex> layers;
  for (const std::string_view id : {"b-inner-disks", "b-inner-circles", "b-inner-centers"})
    layers.push_back(find_layer(id));
  if (layers_.soloed() != kNoSlot) return;
  if (std::ranges::any_of(layers, [this](LayerIndex layer) { return layers_.is_visible(layer); })) return;
  editor_.note_layers();
  for (const LayerIndex layer : layers) layers_.set_visible(layer, true);
  editor_.join_layers();
}

void App::follow_evolution() {
  const bool is_complete = picture_.document_revision() == editor_.document().revision() && !engine_.status().busy;
  evolution_.follow(is_complete, ImGui::GetTime());
  if (const auto problem = evolution_.take_problem()) report(*problem);
}

void App::update_title() {
  window_->set_title((editor_.is_modified() ? "* " : "") + files_.title() + " - Mesecina");
}

void App::frame() {
  const double now = ImGui::GetTime();
  if (window_->is_minimized()) return;
  const auto size = window_->framebuffer_size();
  if (size.width < 1 || size.height < 1) return;
  gui_.begin_frame(settings_);
  picture_.set_canvas(canvas_background(settings_));
  const double seconds = std::clamp(ImGui::GetTime() - now, 0.0, kLongestStep);
  canvas_.set_content_scale(static_cast<double>(gui_.unit()) * window_->pixel_ratio());
  canvas_.view().set_viewport(size.width, size.height);
  draw_panels();
  show_first_ball();
  bundles_.follow_layers();
  follow_demand();
  follow_picture();
  advance_animation();
  advance_demo();
  engine_.set_want_findings(show_panels_);
  engine_.set_want_statistics(settings_.details == DetailsPage::statistics && show_panels_);
  fit_if_wanted();
  if (!record_.holds_motion(shown_state())) canvas_.advance(seconds);
  if (canvas_.view().is_moving()) frames_wanted_ = std::max(frames_wanted_, 1);
  draw_pointer_marks();
  const std::uint32_t share = picture_.every();
  times_.begin_drawing();
  picture_.draw(canvas_.view().camera(), layers_, editor_, gui_.drawing_scale());
  times_.end_drawing();
  // The status bar tells the share; it was drawn before it was known.
  if (picture_.is_refining() || picture_.every() != share) frames_wanted_ = std::max(frames_wanted_, 2);
  keep_timeline();
  // Reading pixels back waits for what draws them, so it belongs to drawing.
  times_.begin_drawing();
  record_.picture_drawn(drawn_now());
  gui_.end_frame();
  record_.panels_drawn(drawn_now());
  times_.end_drawing();
  times_.end();
  window_->swap();
  update_title();
  follow_recording();
}

MenuBar App::menu_bar() {
  return {gui_,
          actions_,
          settings_,
          editor_,
          layers_,
          evolution_,
          shapes_,
          [this](const std::string& file) { open_files({file}); },
          [this](const SampleShape& shape) { open_shape(shape); }};
}

StatusBar App::status_bar() {
  return {gui_,
          editor_,
          canvas_,
          picture_,
          computation_,
          messages_,
          {gui_, actions_, engine_, files_, record_},
          {gui_, actions_, editor_.document(), computation_.settings(), picture_, canvas_}};
}

Toolbar App::toolbar() {
  return {gui_, actions_, canvas_, settings_, {gui_, actions_, record_, picture_, settings_.record}};
}

void App::draw_panels() {
  const float unit = gui_.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  float top = 0.0F;
  float left = 0.0F;
  float right = 0.0F;
  float bottom = 0.0F;
  if (show_panels_) {
    top = menu_bar().draw();
    const StatusBar status = status_bar();
    bottom = status.height();
    status.draw({{0, screen.y - bottom}, {screen.x, bottom}});
    const float height = screen.y - top - bottom;
    const float width = std::min(286 * unit, 0.45F * screen.x);
    const bool has_details = settings_.details != DetailsPage::none;
    const bool both = settings_.show_layers && has_details;
    if (settings_.show_layers || has_details) right = width;
    const float upper = both ? 0.6F * height : height;
    if (settings_.show_layers) {
      // In a low window the layers need the room, and bundles have their keys and their menu.
      const float most = std::min(kMostOfBundles * upper, upper - kLeastOfLayers * unit);
      const float bundles = most < kLeastOfBundles * unit ? 0.0F : bundles_panel_.height(most);
      if (bundles > 0.0F) bundles_panel_.draw({{screen.x - width, top}, {width, bundles}});
      layers_panel_.draw({{screen.x - width, top + bundles}, {width, upper - bundles}});
    }
    if (has_details) {
      const float from = both ? top + upper : top;
      details_panel_.draw({{screen.x - width, from}, {width, top + height - from}});
    }
    const float margin = 10 * unit;
    left = margin + toolbar().draw({margin, top + margin}, height - 2 * margin);
  }
  const float card_margin = 10 * unit;
  if (show_panels_ && settings_.show_evolution)
    bottom += card_margin +
              EvolutionStrip{gui_, actions_, evolution_}.draw({left + card_margin, screen.y - bottom - card_margin},
                                                              screen.x - left - right - 2 * card_margin);
  provenance_.draw(gui_, canvas_, editor_.document().revision(),
                   {left + card_margin, screen.y - bottom - card_margin},
                   {screen.x - left - right - 2 * card_margin, 0.6F * (screen.y - top - bottom)});
  legend_size_ = {};
  if (settings_.show_legend) {
    const ImVec2 legend = CanvasLegend{gui_, picture_, layers_}.draw(
        {screen.x - right - card_margin, screen.y - bottom - card_margin}, screen.y - top - bottom - 2 * card_margin);
    const double ratio = window_->pixel_ratio();
    if (legend.x > 0.0F)
      legend_size_ = {ratio * static_cast<double>(legend.x + card_margin),
                      ratio * static_cast<double>(legend.y + card_margin)};
  }
  EmptyHint{gui_, editor_.document(), files_, picture_, canvas_}.draw(
      {left + 0.5F * (screen.x - left - right), top + 0.5F * (screen.y - top - bottom)});
  draw_caption({left + 0.5F * (screen.x - left - right), screen.y - bottom}, screen.x - left - right);
  ProblemNote{gui_, messages_}.draw({left + 8 * unit, top + 10 * unit}, screen.x - left - right - 16 * unit);
  draw_dialogs();
  draw_help(gui_, &show_help_);
  const double ratio = window_->pixel_ratio();
  canvas_.view().set_insets({static_cast<double>(left) * ratio, static_cast<double>(top) * ratio,
                             static_cast<double>(right) * ratio, static_cast<double>(bottom) * ratio});
}

void App::draw_pointer_marks() {
  const ToolFeedback feedback = canvas_.tool().feedback();
  const bool over_canvas = canvas_.has_pointer() || (canvas_.is_hovered() && !gui_.wants_pointer(pointer_px_));
  if (over_canvas)
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  else
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NoMouseCursorChange;
  window_->set_pointer_shape(over_canvas ? canvas_.pointer_shape() : PointerShape::arrow);
  if (!over_canvas) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float unit = gui_.unit();
  const Rgb color = mark_color(picture_.canvas());
  const ImU32 mark = to_imgui(color);
  const Slot hovered = feedback.hovered;
  const auto at = [unit](Vec2 px) {
    return ImVec2(static_cast<float>(px.x) * unit, static_cast<float>(px.y) * unit);
  };
  if (hovered != kNoSlot && editor_.document().is_alive(hovered)) {
    const Vec2 px =
        (1.0 / canvas_.content_scale()) * canvas_.view().camera().to_screen(editor_.document().position(hovered));
    list.AddCircle(at(px), 9.0F * unit, mark, 0, 2.0F * unit);
  }
  const auto to_px = [this](Vec2 world) {
    return (1.0 / canvas_.content_scale()) * canvas_.view().camera().to_screen(world);
  };
  const auto circle = [&](const Disk& disk, float width) {
    const double radius = disk.radius / (canvas_.content_scale() * canvas_.view().camera().units_per_pixel());
    // ImGui draws circles as polygons of corners all around; a far too large one is left to its layer.
    if (radius < kLargestCirclePx)
      list.AddCircle(at(to_px(disk.center)), static_cast<float>(radius) * unit, mark, 0, width);
  };
  if (editor_.document().is_ball_alive(feedback.hovered_ball)) {
    const Disk& disk = editor_.document().disk(feedback.hovered_ball);
    circle(disk, 2.0F * unit);
    list.AddCircle(at(to_px(disk.center)), 9.0F * unit, mark, 0, 2.0F * unit);
  }
  if (feedback.ball) {
    circle(*feedback.ball, 1.5F * unit);
    list.AddCircleFilled(at(to_px(feedback.ball->center)), 3.0F * unit, mark);
    if (feedback.marker_px) list.AddLine(at(to_px(feedback.ball->center)), at(*feedback.marker_px), mark, unit);
  }
  if (feedback.box_px) {
    list.AddRectFilled(at(feedback.box_px->low), at(feedback.box_px->high), to_imgui(color, 0.13));
    list.AddRect(at(feedback.box_px->low), at(feedback.box_px->high), mark, 0.0F, 0, unit);
  }
  if (feedback.marker_px && feedback.ring_px > 0.0)
    list.AddCircle(at(*feedback.marker_px), static_cast<float>(feedback.ring_px) * unit, to_imgui(color, 0.56), 0,
                   1.2F * unit);
}

}  // namespace mes
