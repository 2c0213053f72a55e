// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work/drawing_board.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/editing/hidden_additions.h"
#include "app/editing/kept_highlight.h"
#include "app/layers/clicked_layers.h"
#include "app/panels/on_canvas/marks/pointer_marks.h"
#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/store/looks/color_maps.h"
#include "app/ui/screen/theme.h"

namespace mes {
namespace {

// Distance in logical pixels within which the pointer picks an entry of a table.
constexpr double kListedReach = 7.0;
// The same for an annotation.
constexpr double kAnnotationReach = 6.0;

}  // namespace

DrawingBoard::DrawingBoard(Workspace& work, const Settings& settings, Messages& messages, Screen& screen,
                           const std::filesystem::path& assets, Waker wake)
    : work_(work),
      settings_(settings),
      messages_(messages),
      screen_(screen),
      picture_(work.live_registry()),
      values_(work.editor()),
      snapper_(work.editor(), work.annotations(), settings.snap,
               [this] {
                 const double units = canvas_.pointer().units_per_px;
                 return Snapper::Steps{grid_step(units), pixel_step(units)};
               }),
      frame_(work.editor()),
      tool_context_{work.editor(),
                    work.annotations(),
                    settings.spray_spacing_px,
                    [this](const Error& error) { messages_.problem(error.message()); },
                    [this](const Pointer& pointer) {
                      if (!may_ask()) return;
                      provenance_.ask(work_.engine(), work_.layers(), pointer, work_.editor());
                      if (settings_.panels.is_in_use(PanelPage::branches))
                        work_.insight().branches.pick(pointer.world, kListedReach * pointer.units_per_px);
                      choose_class(pointer, pointer.world);
                    },
                    [this](Vec2 px) { return annotation_at(annotations_, px, kAnnotationReach); },
                    &snapper_,
                    &settings.brush,
                    &frame_,
                    &settings.show_handles,
                    [this](const Pointer& pointer, const ChosenThing& chosen) {
                      choose_class(pointer, chosen.place);
                      ask_beside(pointer, chosen);
                    }},
      canvas_(tool_context_),
      fitter_(canvas_.view()),
      traced_(work.editor(), work.layers(), picture_, messages, wake),
      differences_(std::move(wake)) {
  LoadedColorMaps maps = load_color_maps(assets, user_color_map_folder());
  picture_.set_color_maps(std::move(maps.maps));
  // Captions and annotations of pictures use the same fonts (LiveRecording).
  if (auto fonts = PaperFonts::read(assets)) picture_.set_letters(fonts->plain);
  if (!maps.problems.empty()) messages_.problem("A colour map is left out: " + maps.problems.front().message());
}

void DrawingBoard::bind(ActionBindings& actions) {
  bind_nudges(actions);
  bind_view(actions);
  const auto bind_tool = [&](ActionId id, ToolId tool) {
    actions.bind(id, {[this, tool] {
                        // An annotation being written belongs to its tool.
                        if (tool != ToolId::annotate) work_.annotations().close();
                        canvas_.choose_tool(tool);
                      },
                      {},
                      [this, tool] { return canvas_.tool_id() == tool; }});
  };
  bind_tool(ActionId::tool_select, ToolId::select);
  bind_tool(ActionId::tool_insert, ToolId::insert);
  bind_tool(ActionId::tool_spray, ToolId::spray);
  bind_tool(ActionId::tool_ball, ToolId::ball);
  bind_tool(ActionId::tool_measure, ToolId::measure);
  bind_tool(ActionId::tool_annotate, ToolId::annotate);
  actions.bind(ActionId::canvas_menu, {[this] { open_menu(); }});
  actions.bind(ActionId::select_sources,
               {[this] { select_sources(); },
                {[this] { return provenance_.shown() != nullptr; }, "click a drawn element first"}});
  actions.bind(ActionId::keep_measurement,
               {[this] { keep_measurement(); },
                {[this] { return canvas_.tool().measurement().has_value(); }, "nothing is measured"}});
  actions.bind(ActionId::center_line_between, {[this] {
                                                 if (auto ends = two_ends()) add_center_line(*std::move(ends));
                                               },
                                               {[this] { return two_ends().has_value(); },
                                                "neither two points are measured nor two samples selected"}});
  actions.bind(ActionId::keep_highlight, {[this] { keep_highlight(); },
                                          {[this] { return provenance_.can_be_kept(work_.editor()); },
                                           "nothing that can be kept highlighted was clicked"}});
}

void DrawingBoard::bind_nudges(ActionBindings& actions) {
  constexpr std::array<Vec2, kNudges / 2> kDirections{{{-1, 0}, {1, 0}, {0, 1}, {0, -1}}};
  constexpr double kFar = 10.0;  // pixels
  for (std::size_t i = 0; i < kNudges; ++i) {
    const Vec2 px = (i < kDirections.size() ? 1.0 : kFar) * kDirections[i % kDirections.size()];
    actions.bind(nth(ActionId::first_nudge, i),
                 {[this, px] { nudge(px); },
                  {[this] { return !work_.editor().selection().is_empty(); }, "nothing is selected"}});
  }
}

void DrawingBoard::bind_view(ActionBindings& actions) {
  constexpr double kKeyZoom = 1.4;
  actions.bind(ActionId::zoom_in, {[this] { canvas_.view_at_pointer().zoom_at(canvas_.zoom_center(), kKeyZoom); }});
  actions.bind(ActionId::zoom_out,
               {[this] { canvas_.view_at_pointer().zoom_at(canvas_.zoom_center(), 1.0 / kKeyZoom); }});
  actions.bind(ActionId::fit, {[this] { fit_all(); }});
  actions.bind(ActionId::fit_selection,
               {[this] { fit_selection(); },
                {[this] { return !work_.editor().selection().is_empty(); }, "nothing is selected"}});
  actions.bind(ActionId::previous_view,
               {[this] { canvas_.view_at_pointer().back(); },
                {[this] { return canvas_.view_at_pointer().can_go_back(); }, "there is no view before this one"}});
}

void DrawingBoard::nudge(Vec2 px) {
  const Expected<void> done =
      work_.editor().nudge_selection(canvas_.view_at_pointer().camera().units_per_pixel() * px);
  if (!done) messages_.problem(done.error().message());
}

// The main pane is fitted later, when the panels have their positions; the other panes have theirs already.
void DrawingBoard::fit_all() {
  const std::size_t pane = canvas_.pane();
  if (!canvas_.views().is_own(pane)) return fitter_.want(ViewFitter::How::glide);
  fit_pane(pane, work_.document_of_pane(pane - 1).bounding_box(), ViewFitter::kMargin * canvas_.content_scale());
}

void DrawingBoard::fit_pane(std::size_t pane, const Box2& box, double margin_px, bool at_once) {
  if (!box.is_empty()) canvas_.views().of(pane).fit(box, margin_px, at_once);
}

void DrawingBoard::fit_selection() {
  const Document& document = work_.document();
  Box2 box;
  for (const SampleSlot slot : work_.editor().selection().slots()) box.add(document.position(slot));
  for (const BallSlot slot : work_.editor().selection().ball_slots()) box.add(bounding_box_of(document.disk(slot)));
  canvas_.view_at_pointer().fit(box, ViewFitter::kMargin * canvas_.content_scale());
}

bool DrawingBoard::is_at_rest() const {
  return !canvas_.views().is_moving() && !canvas_.has_pointer() && !fitter_.is_wanted();
}

void DrawingBoard::take_results() {
  // Taken first: later results wait for the next turn, and those of a picture on its way for its end.
  has_all_results_ = work_.is_complete() && !picture_.is_painting();
  if (picture_.take_from(work_.engine())) watch_memory();
  for (Provenance& answer : work_.engine().take_answers()) take_answer(std::move(answer));
  if (provenance_.wants_sources()) select_sources();
  provenance_.look_beneath(work_.engine());
}

void DrawingBoard::take_answer(Provenance answer) {
  if (pointed_.take(answer) || preview_.take(answer)) return;
  if (menu_.take(answer)) return screen_.clock.settle();
  if (const auto selected = values_.take(answer)) {
    if (!selected->empty()) messages_.remark(*selected);
    return;
  }
  provenance_.take(std::move(answer));
  screen_.clock.settle();  // a new card must be measured first
}

// The engine would answer for the document that it knows.
bool DrawingBoard::may_ask() {
  if (work_.hold().waiting().empty()) return true;
  messages_.problem("Release the held update first: the structures are behind the samples");
  return false;
}

// Elements drawn over a clicked sample or ball, or beside it under the pointer, get their cards too.
void DrawingBoard::ask_beside(const Pointer& pointer, const ChosenThing& chosen) {
  constexpr double kReach = 4.0;  // logical pixels: radius of a dot of usual size
  const auto layers =
      layers_of_click(work_.layers(), {chosen.is_ball, chosen.distance <= kReach * pointer.units_per_px});
  // A larger dot is meant wherever it is seen.
  double reach = kReach;
  for (const LayerIndex layer : layers)
    if (std::ranges::find(work_.layers().descriptor(layer).kinds, PrimitiveKind::point) !=
        work_.layers().descriptor(layer).kinds.end())
      reach = std::max(reach, 0.5 * work_.layers().style(layer).point_size_px + 1.0);
  ProvenanceQuestion question{
      .at = pointer.world, .reach = reach * pointer.units_per_px, .layers = main_layers(layers)};
  if (question.layers.empty() || !work_.hold().waiting().empty()) return;
  provenance_.ask(work_.engine(), work_.layers(), std::move(question), work_.editor());
}

// A component is born at a sample or ball, so a click there chooses it; a click elsewhere chooses a hole.
void DrawingBoard::choose_class(const Pointer& pointer, Vec2 place) {
  if (settings_.panels.is_in_use(PanelPage::persistence))
    work_.insight().persistence.pick(place, kListedReach * pointer.units_per_px);
}

void DrawingBoard::open_menu() {
  const Pointer pointer = canvas_.pointer_for_keys();
  const Document& document = work_.document();
  Selection& selection = work_.editor().selection();
  CanvasMenu::Target target{.pointer = pointer, .document = document.revision()};
  const double ratio = screen_.window->pixel_ratio();
  const Vec2 px = canvas_.zoom_center() + canvas_.pane_shift();
  target.at = {static_cast<float>(px.x / ratio), static_cast<float>(px.y / ratio)};
  if (shows_annotations()) target.annotation = annotation_at(annotations_, pointer.px, kAnnotationReach);
  const PickedThing thing =
      seen_thing_at(work_.editor(), work_.layers(), pointer.world, kPickRadiusPx * pointer.units_per_px);
  if (!target.annotation && thing.is_any()) {
    const bool is_ball = thing.ball != kNoSlot;
    if (!(is_ball ? selection.contains_ball(thing.ball) : selection.contains(thing.sample))) {
      selection.clear();
      if (is_ball)
        selection.add_ball(thing.ball);
      else
        selection.add(thing.sample);
    }
    target.selected = counted(selection.sample_count(), selection.ball_count());
    target.has_samples = selection.sample_count() != 0;
  }
  menu_.open(work_.engine(), work_.layers(), std::move(target), work_.hold().waiting().empty());
}

void DrawingBoard::insert_at(const Pointer& pointer) {
  const auto snap = snapper_.at(pointer.world, kSnapReachPx * pointer.units_per_px, {});
  const std::array<Vec2, 1> place{snap ? snap->place : pointer.world};
  if (const auto done = work_.editor().insert(place, "Insert sample"); !done)
    messages_.problem(done.error().message());
}

void DrawingBoard::draw_menu(const ActionBindings& actions) {
  const CanvasMenu::Choice choice = menu_.draw(screen_.gui, actions, work_.layers(), work_.engine());
  const CanvasMenu::Target& target = menu_.target();
  LayerStack& layers = work_.layers();
  AnnotationEditor& annotations = work_.annotations();
  // Another program may have edited the document while the menu was open.
  const bool is_same = target.document == work_.document().revision();
  switch (choice) {
    case CanvasMenu::Choice::none: return;
    case CanvasMenu::Choice::edit_annotation:
      if (!is_same) return;
      annotations.select(*target.annotation);
      canvas_.choose_tool(ToolId::annotate);
      return;
    case CanvasMenu::Choice::delete_annotation:
      if (!is_same) return;
      annotations.select(*target.annotation);
      actions.run(ActionId::delete_selection);
      return;
    case CanvasMenu::Choice::show_card:
      if (may_ask()) provenance_.ask(work_.engine(), layers, target.pointer, work_.editor());
      return;
    case CanvasMenu::Choice::hide_layer:
      work_.editor().change_layers("Hide " + layers.descriptor(menu_.layer()).name,
                                   [&] { layers.set_visible(menu_.layer(), false); });
      return;
    case CanvasMenu::Choice::show_layer_alone: layers.solo(menu_.layer()); return;
    case CanvasMenu::Choice::end_solo: layers.end_solo(); return;
    case CanvasMenu::Choice::insert_sample: insert_at(target.pointer); return;
    case CanvasMenu::Choice::annotate:
      keep({.kind = AnnotationKind::text, .anchors = {{.at = target.pointer.world}}});
      return;
  }
}

void DrawingBoard::select_values(LayerIndex layer, double low, double high) {
  if (may_ask()) values_.ask(work_.engine(), layer, low, high);
}

void DrawingBoard::select_sources() {
  const Provenance* const shown = provenance_.shown();
  if (shown == nullptr) return;
  const std::size_t count = mes::select_sources(work_.editor(), *shown);
  provenance_.keep_for(work_.editor());
  const Selection& selection = work_.editor().selection();
  if (count == 0)
    messages_.problem("It derives from no sample or ball of the document");
  else
    messages_.remark("Selected " + counted(selection.sample_count(), selection.ball_count()));
}

void DrawingBoard::watch_memory() {
  if (memory_.follow(picture_.lacks_memory(), work_.document(), messages_)) screen_.clock.settle();
}

void DrawingBoard::note_new_document() {
  canvas_.clear_all_tools();
  picture_.expect(work_.document().revision());
  memory_.forget();
  watch_memory();
}

void DrawingBoard::begin_frame(int width, int height) {
  picture_.set_canvas(canvas_background(settings_));
  canvas_.set_content_scale(static_cast<double>(screen_.gui.unit()) * screen_.window->pixel_ratio());
  canvas_.views().follow(work_.panes().keys(), work_.panes().has_free_cameras());
  canvas_.views().set_viewport(width, height);
  dim_outdated();
}

// Dims a drawing of the previous document, so that nobody takes it for this one, but not for a moment, which would
// flicker.
void DrawingBoard::dim_outdated() {
  constexpr double kMoment = 100.0;  // milliseconds
  constexpr double kVeil = 0.75;
  const EngineStatus status = work_.engine().status();
  if (!picture_.is_outdated() || (status.busy && status.busy_ms < kMoment)) return;
  ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize,
                                                to_imgui(picture_.canvas(), kVeil));
}

void DrawingBoard::follow() {
  if (work_.follow_layers(picture_.is_lost(), settings_.show_annotations))
    picture_.follow_demand(work_.shown_panes());
  if (traced_.follow(view().free_box())) screen_.clock.settle();
  follow_differences();
}

bool DrawingBoard::shows_differences() const {
  return settings_.show_differences && !work_.panes().is_empty();
}

std::optional<DifferenceMarks::State> DrawingBoard::compared_state() const {
  if (!shows_differences()) return std::nullopt;
  return DifferenceMarks::State{work_.document().revision(),
                                work_.editor().revision_before_last_edit(),
                                work_.evolution().beginning_revision(),
                                work_.layers().revision(),
                                work_.panes().revision(),
                                work_.computation().settings(),
                                {work_.evolution().choice(), work_.evolution().first_value()}};
}

void DrawingBoard::follow_differences() {
  if (!picture_.keep_instances(shows_differences())) work_.ask_again_for_layers();
  const bool is_complete = is_up_to_date() && picture_.instances() != nullptr;
  differences_.follow(
      is_complete ? compared_state() : std::nullopt, shows_differences(), work_.panes().revision(),
      [this] {
        Box2 all;
        for (std::size_t i = 0; i <= work_.shown_panes().panes.size(); ++i)
          if (const Box2 box = (i == 0 ? work_.document() : work_.document_of_pane(i - 1)).bounding_box();
              !box.is_empty())
            all.add(box);
        DifferenceMarks::Panes out{work_.live_registry().share(), comparison_of(work_.shown_panes(), work_.layers()),
                                   picture_.instances(), all.is_empty() ? 0.0 : std::max(all.width(), all.height())};
        // A failed layer shows an earlier state, so comparing it would show false differences.
        if (const LayerReport* const failed = picture_.first_failed())
          out.problem = Error{ErrorCode::cannot_compute,
                              fmt::format("the layer {} failed: {}",
                                          work_.layers().descriptor(failed->layer.layer).id, failed->reason),
                              {},
                              0,
                              0};
        return out;
      },
      picture_);
  if (const auto problem = differences_.take_problem())
    messages_.problem("The panes cannot be compared: " + problem->message());
}

bool DrawingBoard::has_place() {
  constexpr int kFramesBefore = 2;
  return ImGui::GetFrameCount() > kFramesBefore;
}

void DrawingBoard::fit(Vec2 legend) {
  if (!has_place()) return;
  const render::Camera before = view().camera();
  fitter_.follow(work_.document(), {legend, canvas_.content_scale(), canvas_.has_pointer()});
  const std::vector<Box2> views = std::exchange(wanted_pane_views_, {});
  for (std::size_t i = 0; i < views.size(); ++i)
    if (canvas_.views().is_own(i + 1))
      fit_pane(i + 1, views[i].is_empty() ? work_.document_of_pane(i).bounding_box() : views[i],
               views[i].is_empty() ? ViewFitter::kMargin * canvas_.content_scale() : 0.0, true);
  // Axes, scale bar and status bar were drawn for the previous view.
  if (view().camera() != before) screen_.clock.want(1);
}

void DrawingBoard::draw(const Frame& frame) {
  if (!has_place()) {
    screen_.clock.want(1);
    return picture_.clear(view().camera());
  }
  if (canvas_.views().is_moving()) screen_.clock.want(1);
  draw_pointer(frame);
  const std::uint32_t share = picture_.every();
  const bool was_refining = picture_.is_refining();
  const bool awaited_ink = picture_.awaits_ink();
  screen_.times.begin_drawing();
  picture_.draw(view().camera(), work_.layers(), work_.editor(), screen_.gui.drawing_scale(), frame.is_kept,
                canvas_.panes(), panes_beside());
  screen_.times.end_drawing();
  // The status bar shows the drawn share, and was drawn before it was known. Results may have waited for the picture.
  if (was_refining || picture_.is_refining() || picture_.every() != share) screen_.clock.want(2);
  // Legend and scale bar may move once it is known where the picture leaves paper free.
  if (awaited_ink || picture_.awaits_ink()) screen_.clock.want(2);
}

std::vector<Picture::Pane> DrawingBoard::panes_beside() const {
  std::vector<Picture::Pane> out;
  const ShownPanes& shown = work_.shown_panes();
  for (std::size_t i = 0; i < shown.panes.size(); ++i) {
    const Document& document = work_.document_of_pane(i);
    out.push_back({shown.panes[i], &document != &work_.document() ? &document : nullptr, i + 1,
                   canvas_.views().is_own(i + 1) ? &canvas_.views().of(i + 1).camera() : nullptr});
  }
  return out;
}

std::vector<Box2> DrawingBoard::pane_views() const {
  std::vector<Box2> out;
  for (std::size_t i = 1; canvas_.views().is_own(i); ++i) out.push_back(canvas_.views().of(i).free_box());
  return out;
}

void DrawingBoard::draw_pointer(const Frame& frame) {
  const bool over_canvas =
      canvas_.has_pointer() || (canvas_.is_hovered() && !screen_.gui.wants_pointer(frame.pointer_px));
  const bool is_hidden = ImGui::GetMouseCursor() == ImGuiMouseCursor_None;
  if (over_canvas && !is_hidden)
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  else
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NoMouseCursorChange;
  if (!is_hidden) screen_.window->set_pointer_shape(over_canvas ? canvas_.pointer_shape() : PointerShape::arrow);
  const bool is_marked = over_canvas && !frame.hides_pointer;
  const bool may_ask = !provenance_.is_asking() && work_.hold().waiting().empty();
  pointed_.follow(work_.engine(), {canvas_, work_.editor(), work_.layers(), is_marked, may_ask});
  preview_.follow(work_.engine(), canvas_, work_.editor(),
                  is_marked && settings_.show_insertion_preview && canvas_.tool_id() == ToolId::insert && may_ask);
  draw_marks_in_panes(is_marked);
  if (screen_.gui.lacks_letters()) screen_.clock.want(1);
}

void DrawingBoard::draw_marks_in_panes(bool is_marked) {
  annotations_ = {};
  if (shows_annotations())
    annotations_ = annotations_in(work_.document(), {canvas_.view_at_pointer().camera()}).layout();
  const std::vector<PanePlace>& places = canvas_.panes().places();
  if (places.empty()) return draw_marks(0, {view().camera()}, is_marked);
  const double ratio = screen_.window->pixel_ratio();
  const auto on_screen = [ratio](double x, double y) {
    return ImVec2(static_cast<float>(x / ratio), static_cast<float>(y / ratio));
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PanePlace& place = places[i];
    ImGui::GetBackgroundDrawList()->PushClipRect(on_screen(place.left, place.top),
                                                 on_screen(place.left + place.width, place.top + place.height), true);
    const Vec2 shift = canvas_.panes().shift(i);
    draw_marks(i, {canvas_.views().of(i).camera(), on_screen(shift.x, shift.y)}, is_marked);
    ImGui::GetBackgroundDrawList()->PopClipRect();
  }
}

CanvasAnnotations DrawingBoard::annotations_in(const Document& document, const PanePart& pane) const {
  return {screen_.gui, canvas_.content_scale(), document, work_.annotations(), picture_.canvas(), pane};
}

void DrawingBoard::draw_marks(std::size_t number, const PanePart& pane, bool is_marked) {
  const Document& document = number == 0 ? work_.document() : work_.document_of_pane(number - 1);
  const bool is_main_document = &document == &work_.document();
  // The pointed element belongs to the main computation, and the pointer to one pane.
  const bool is_pointed_in = canvas_.views().is_own(canvas_.pane()) ? number == canvas_.pane() : number == 0;
  if (is_pointed_in && is_main_document) pointed_.draw(screen_.gui, pane, canvas_.content_scale());
  if (is_main_document) preview_.draw(screen_.gui, pane, canvas_.content_scale());
  if (shows_annotations()) {
    const CanvasAnnotations shown = annotations_in(document, pane);
    const bool is_laid_out = is_main_document && pane.camera == canvas_.view_at_pointer().camera();
    const AnnotationDrawing drawn = is_laid_out ? annotations_ : shown.layout();
    shown.draw(drawn);
    if (is_main_document) shown.draw_frames(drawn, is_marked ? canvas_.tool().feedback().annotation : std::nullopt);
  }
  const PointerMarks marks{screen_.gui,       canvas_, work_.document(), mark_color(picture_.canvas()),
                           picture_.canvas(), pane};
  if (is_marked) marks.draw();
  if (is_main_document) marks.draw_waiting(work_.hold());
  if (is_main_document && !canvas_.tool().feedback().annotation) marks.draw_frame();
  marks.draw_measurement();
  if (is_pointed_in && is_main_document) preview_.draw_words(screen_.gui, pane, canvas_);
}

// The tool that writes annotations always shows them.
bool DrawingBoard::shows_annotations() const {
  return settings_.show_annotations || canvas_.tool_id() == ToolId::annotate;
}

std::size_t DrawingBoard::hidden_by(const Box2& on_screen) const {
  constexpr std::size_t kWords = 64;  // words count as much as an area that is drawn on everywhere
  const double ratio = screen_.window->pixel_ratio();
  const Box2 px{ratio * on_screen.low, ratio * on_screen.high};
  const double scale = canvas_.content_scale();
  const auto lies_on = [&](const Box2& words) {
    return !words.is_empty() && scale * words.low.x < px.high.x && px.low.x < scale * words.high.x &&
           scale * words.low.y < px.high.y && px.low.y < scale * words.high.y;
  };
  return picture_.ink().parts_below(px, view().camera()) +
         (std::ranges::any_of(annotations_.words, lies_on) ? kWords : 0U);
}

void DrawingBoard::keep_measurement() {
  auto measured = canvas_.tool().measurement();
  if (measured) static_cast<void>(keep(std::move(*measured)));
}

std::optional<Annotation> DrawingBoard::two_ends() const {
  if (auto measured = canvas_.tool().measurement(); measured && measured->anchors.size() == 2) {
    measured->kind = AnnotationKind::center_line;
    return measured;
  }
  const Selection& selection = work_.editor().selection();
  if (selection.size() != 2 || selection.sample_count() != 2) return std::nullopt;
  const Document& document = work_.document();
  Annotation out{.kind = AnnotationKind::center_line};
  for (const SampleSlot slot : selection.slots())
    out.anchors.push_back({document.position(slot), {document.id(slot).value - document.first_id().value}});
  return out;
}

void DrawingBoard::add_center_line(Annotation ends) {
  work_.editor().note_layers();
  if (!keep(std::move(ends))) return;
  LayerStack& layers = work_.layers();
  if (const LayerIndex layer = layers.find("center-lines"); layer != kNoLayer) layers.set_visible(layer, true);
  work_.editor().join_layers();
}

void DrawingBoard::keep_highlight(std::optional<std::size_t> line) {
  if (!provenance_.can_be_kept(work_.editor())) return;
  KeptHighlight kept = highlight_of(*provenance_.shown(), work_.document(), line);
  if (kept.annotation.elements.empty()) return messages_.remark("This element has no highlights that can be kept");
  if (!keep(std::move(kept.annotation))) return;
  if (kept.left_out != 0)
    messages_.remark(
        fmt::format("{} of its shapes are not kept: there are too many, or they are too far away", kept.left_out));
  provenance_.clear();
}

bool DrawingBoard::keep(Annotation annotation) {
  if (const auto done = work_.annotations().begin(std::move(annotation)); !done) {
    messages_.problem(done.error().message());
    return false;
  }
  canvas_.clear_tool();
  canvas_.choose_tool(ToolId::annotate);
  return true;
}

}  // namespace mes
