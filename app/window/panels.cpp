// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/panels/bars/evolution_strip.h"
#include "app/panels/on_canvas/empty_hint.h"
#include "app/panels/on_canvas/empty_view_note.h"
#include "app/panels/on_canvas/pane_headers.h"
#include "app/panels/on_canvas/refusal_note.h"
#include "app/window/palette_entries.h"

namespace mes {
namespace {

constexpr float kMargin = 10.0F;

}  // namespace

Panels::Panels(const Uses& uses)
    : uses_(uses),
      menu_bar_{uses.screen.gui,
                uses.actions,
                uses.settings,
                uses.work.editor(),
                uses.work.layers(),
                uses.work.evolution(),
                uses.documents.shapes(),
                [&flow = uses.documents](const std::string& file) { flow.open({file}); },
                [&flow = uses.documents](const SampleShape& shape) { flow.open_shape(shape); },
                uses.documents.lessons(),
                [&flow = uses.documents](const ShippedLesson& lesson) { flow.open_lesson(lesson); },
                [&flow = uses.documents, &layers = uses.work.layers()](const LayerTextFormat& format) {
                  flow.figures().ask_geometry(layers.visible_layers(), format);
                }},
      status_bar_{
          uses.screen.gui,
          uses.work.editor(),
          uses.board.canvas(),
          uses.board.picture(),
          uses.work.computation(),
          uses.messages,
          {uses.screen.gui, uses.actions, uses.work.engine(), uses.documents.files(), uses.recording.recorder(),
           uses.documents.figures().lesson(), uses.work.hold(), uses.work.insight().sweep, uses.experiments.list()},
          {uses.screen.gui, uses.actions, uses.work.engine(), uses.work.document(),
           uses.work.computation().settings(), uses.board.picture(), uses.board.canvas()}},
      toolbar_{
          uses.screen.gui,
          uses.actions,
          uses.board.canvas(),
          uses.settings,
          {uses.screen.gui, uses.actions, uses.recording.recorder(), uses.board.picture(), uses.settings.record}},
      bundles_panel_({uses.screen.gui, uses.actions, uses.work.bundles(), uses.messages,
                      [&work = uses.work](std::size_t bundle) { work.choose_bundle(bundle); },
                      [&flow = uses.documents](std::size_t bundle) { flow.ask_export(bundle); }}),
      layers_panel_(uses.screen.gui, uses.actions, uses.work.layers(), uses.board.picture(),
                    {uses.screen.gui, uses.actions, uses.work.layers(), uses.board.picture(), uses.board.canvas()},
                    uses.settings.favorite_layers, uses.settings.unfolded_layers),
      statistics_panel_{uses.screen.gui, uses.board.picture(), uses.screen.times},
      parameters_panel_(uses.screen.gui, uses.work.computation(), uses.board.picture(), uses.work.editor(),
                        uses.work.layers(), uses.work.insight().scale_events, uses.work.insight().critical_values,
                        uses.work.insight().persistence, uses.work.insight().sweep, uses.messages),
      log_panel_{uses.screen.gui, uses.messages},
      lesson_panel_(uses.screen.gui, uses.actions, uses.lesson.lesson_editor(), uses.lesson.presenter(),
                    [&uses = uses_](std::size_t step) {
                      if (!uses.lesson.is_running()) uses.actions.run(ActionId::present_lesson);
                      uses.lesson.go_to(step);
                    }),
      selection_panel_(uses.screen.gui, uses.actions, uses.work.selection_commands(), uses.board.canvas(),
                       uses.messages),
      curves_panel_(uses.screen.gui, uses.actions, uses.work.curve_sampler()),
      branches_panel_(
          {uses.screen.gui, uses.work.insight().branches, uses.board.canvas(), uses.work.editor(), uses.work.layers(),
           uses.work.computation(),
           [&flow = uses.documents](Expected<std::string> csv) { flow.ask_table("branches", std::move(csv)); }}),
      persistence_panel_(
          {uses.screen.gui, uses.work.insight().persistence, uses.board.canvas(), uses.work.editor(),
           uses.work.computation(),
           [&flow = uses.documents](Expected<std::string> csv) { flow.ask_table("persistence", std::move(csv)); }}),
      sampling_panel_({uses.screen.gui, uses.actions, uses.work.resampling(), uses.board.canvas(),
                       uses.work.document(), uses.work.engine(), uses.board.picture(), uses.messages}),
      experiments_panel_({uses.screen.gui, uses.experiments.list(), uses.experiments.examples(),
                          uses.settings.recent_experiments, uses.settings.compiler,
                          [&run = uses.experiments] { run.ask_file(); },
                          [&run = uses.experiments](const std::filesystem::path& file) { run.add(file); },
                          [&run = uses.experiments](const std::filesystem::path& file, std::uint64_t line) {
                            run.edit(file, line);
                          }}),
      column_(uses.screen.gui, uses.actions, uses.settings, pages()),
      step_events_({uses.work.evolution(), uses.work.editor(), uses.work.layers(), uses.work.computation(),
                    uses.work.insight().persistence, uses.work.insight().scale_events}),
      marks_({uses.screen, uses.work, uses.board, uses.settings, uses.messages}) {
  layers_panel_.set_select(
      [&board = uses.board](LayerIndex layer, double low, double high) { board.select_values(layer, low, high); });
  layers_panel_.set_export([&flow = uses.documents](LayerIndex layer, const LayerTextFormat& format) {
    flow.figures().ask_geometry({layer}, format);
  });
  layers_panel_.set_follow_counts([&work = uses.work, &board = uses.board](LayerCounts& counts) {
    counts.follow(work.document().revision(), work.computation().settings(), work.live_registry().share());
    return board.is_up_to_date();
  });
}

std::vector<SidePage> Panels::pages() {
  using enum PanelPage;
  return {
      {layers, "Layers", Icon::layers, ActionId::toggle_layers, false, [this] { layers_panel_.draw(); }},
      {bundles, "Bundles", Icon::bundles, ActionId::toggle_bundles, false, [this] { bundles_panel_.draw(); }},
      {selection, "Selection", Icon::selection, ActionId::toggle_selection, true,
       [this] { selection_panel_.draw(); }},
      {curves, "Curves", Icon::curves, ActionId::toggle_curves, false, [this] { curves_panel_.draw(); }},
      {sampling, "Sampling", Icon::sampling, ActionId::toggle_sampling, false, [this] { sampling_panel_.draw(); }},
      {branches, "Branches", Icon::branches, ActionId::toggle_branches, true, [this] { branches_panel_.draw(); },
       [this] { branches_panel_.draw_large(); }, [this](std::ptrdiff_t rows) { branches_panel_.step(rows); }},
      {persistence, "Persistence", Icon::persistence, ActionId::toggle_persistence, false,
       [this] { persistence_panel_.draw(); }, [this] { persistence_panel_.draw_large(); },
       [this](std::ptrdiff_t rows) { persistence_panel_.step(rows); }},
      {statistics, "Statistics", Icon::statistics, ActionId::toggle_statistics, false,
       [this] { statistics_panel_.draw(); }},
      {parameters, "Parameters", Icon::parameters, ActionId::toggle_parameters, true,
       [this] { parameters_panel_.draw(); }},
      {experiments, "Experiments", Icon::experiments, ActionId::toggle_experiments, false,
       [this] { experiments_panel_.draw(); }},
      {lesson,
       "Lesson",
       Icon::lesson,
       ActionId::toggle_lesson,
       true,
       [this] { lesson_panel_.draw(); },
       {},
       [this](std::ptrdiff_t rows) { lesson_panel_.step(rows); }},
      {log, "Log", Icon::log, ActionId::toggle_log, false, [this] { log_panel_.draw(); }},
  };
}

std::vector<PaletteEntry> Panels::palette_entries() {
  Uses uses = uses_;
  uses.show_parameter = [this](const std::string& name) {
    are_shown_ = true;
    uses_.settings.panels.open(PanelPage::parameters);
    parameters_panel_.search(name);
  };
  uses.show_layer = [this](LayerIndex layer) {
    if (is_seen(PanelPage::layers)) layers_panel_.reveal(layer);
  };
  uses.show_swatches = [this] {
    are_shown_ = true;
    uses_.settings.panels.open(PanelPage::layers);
    const std::vector<LayerIndex> shown = uses_.work.layers().visible_layers();
    if (!shown.empty()) layers_panel_.reveal(shown.back());
  };
  return mes::palette_entries(uses, column_.pages());
}

void Panels::bind(ActionBindings& actions) {
  bind_shown(actions);
  bind_look(actions);
  bind_brush(actions);
}

void Panels::bind_brush(ActionBindings& actions) {
  const auto take = [this](BrushMode mode) {
    // An annotation being written belongs to its tool.
    uses_.work.annotations().close();
    uses_.settings.brush.mode = mode;
    uses_.board.canvas().choose_tool(ToolId::brush);
  };
  const auto has_brush = [this] { return uses_.board.canvas().tool_id() == ToolId::brush; };
  actions.bind(ActionId::tool_brush, {[this, take, has_brush] {
                                        const auto mode = static_cast<std::size_t>(uses_.settings.brush.mode);
                                        const std::size_t next = has_brush() ? (mode + 1) % kBrushModes : mode;
                                        take(static_cast<BrushMode>(next));
                                      },
                                      {},
                                      has_brush});
  const auto bind_mode = [&](ActionId id, BrushMode mode) {
    actions.bind(id, {[take, mode] { take(mode); },
                      {},
                      [this, mode, has_brush] { return has_brush() && uses_.settings.brush.mode == mode; }});
  };
  bind_mode(ActionId::brush_erase, BrushMode::erase);
  bind_mode(ActionId::brush_thin, BrushMode::thin);
  bind_mode(ActionId::brush_refine, BrushMode::refine);
}

// A panel that is asked for is shown even if all panels were hidden.
void Panels::toggle(PanelPage page) {
  if (are_shown_)
    uses_.settings.panels.toggle(page);
  else
    uses_.settings.panels.open(page);
  are_shown_ = true;
}

bool Panels::close_large() {
  const bool was_open = are_shown_ && uses_.settings.panels.large();
  if (was_open) uses_.settings.panels.set_large(std::nullopt);
  return was_open;
}

void Panels::bind_shown(ActionBindings& actions) {
  Settings& settings = uses_.settings;
  const auto bind_toggle = [&](ActionId id, bool& value) {
    actions.bind(id, {[&value] { value = !value; }, {}, [&value] { return value; }});
  };
  bind_toggle(ActionId::toggle_evolution, settings.show_evolution);
  actions.bind(ActionId::toggle_panels,
               {[this] {
                  if (show_panels()) return;
                  are_shown_ = false;
                  const std::string key = uses_.actions.keymap().key_of(ActionId::toggle_panels);
                  uses_.messages.notice("The panels are hidden. " + (key.empty() ? "Esc" : key + " or Esc") +
                                        " shows them again.");
                },
                {},
                [this] { return are_shown_; }});
  bind_toggle(ActionId::toggle_legend, settings.show_legend);
  bind_toggle(ActionId::toggle_key, settings.show_key);
  bind_toggle(ActionId::toggle_scale_bar, settings.marks.bar);
  bind_toggle(ActionId::toggle_axes, settings.marks.axes);
  bind_toggle(ActionId::toggle_grid, settings.marks.grid);
  bind_toggle(ActionId::toggle_annotations, settings.show_annotations);
  actions.bind(ActionId::toggle_snap,
               {[&is_on = settings.snap.is_on, &messages = uses_.messages] {
                  is_on = !is_on;
                  messages.remark(is_on ? "Snapping is on; hold Ctrl to leave it off" : "Snapping is off");
                },
                {},
                [&is_on = settings.snap.is_on] { return is_on; }});
  bind_toggle(ActionId::toggle_handles, settings.show_handles);
  bind_toggle(ActionId::toggle_insertion_preview, settings.show_insertion_preview);
  actions.bind(ActionId::toggle_differences,
               {[&settings, &messages = uses_.messages] {
                  settings.show_differences = !settings.show_differences;
                  messages.remark(settings.show_differences ? "Differences between panes are marked, if there are any"
                                                            : "Differences between panes are not marked");
                },
                {[&work = uses_.work] { return !work.panes().is_empty(); }, "there is no second pane"},
                [&settings] { return settings.show_differences; }});
  actions.bind(ActionId::put_marks_back, {[&settings] {
                                            settings.legend_at.reset();
                                            settings.marks.bar_at.reset();
                                          },
                                          {[&settings] { return settings.legend_at || settings.marks.bar_at; },
                                           "legend and scale bar are where they were at first"}});
  for (const SidePage& page : column_.pages())
    actions.bind(page.toggle,
                 {[this, which = page.page] { toggle(which); },
                  {},
                  [this, which = page.page] { return are_shown_ && uses_.settings.panels.is_shown(which); }});
  actions.bind(ActionId::save_bundle, {[this, &settings] {
                 are_shown_ = true;
                 settings.panels.open(PanelPage::bundles);
                 bundles_panel_.ask_name();
               }});
}

void Panels::begin_presentation() {
  were_shown_ = are_shown_;
  are_shown_ = false;
  presenter_.set_on(true);
  was_full_screen_ = uses_.screen.window->is_full_screen();
  uses_.screen.window->set_full_screen(true);
}

bool Panels::end_presentation() {
  if (!presenter_.is_on()) return false;
  are_shown_ = were_shown_;
  presenter_.set_on(false);
  uses_.screen.window->set_full_screen(was_full_screen_);
  return true;
}

bool Panels::show_panels() {
  if (are_shown_) return false;
  are_shown_ = true;
  uses_.messages.clear_notice();
  return true;
}

bool Panels::close_messages() {
  if (presenter_.is_on()) return false;
  Messages& messages = uses_.messages;
  // The notice about hidden panels promises that Esc shows them, so it takes no press of its own.
  const bool is_any = !messages.problem().empty() || (are_shown_ && !messages.notice().empty());
  messages.clear_problem();
  messages.clear_notice();
  return hidden_additions_note().close() || is_any;
}

std::optional<double> Panels::next_due(double now) const {
  const auto mark = presenter_.next_due(now);
  const auto notice = problem_note_.next_due(now);
  return mark && notice ? std::min(mark, notice) : mark ? mark : notice;
}

void Panels::end_what_fades() {
  presenter_.end_marks();
  uses_.messages.clear_notice();
}

HiddenAdditionsNote Panels::hidden_additions_note() const {
  return {uses_.screen.gui,    uses_.work.hidden_additions(),   uses_.work.editor(),
          uses_.work.layers(), uses_.board.shows_annotations(), uses_.settings.show_annotations};
}

std::size_t Panels::hidden_by(const Box2& box) const {
  constexpr std::size_t kMark = 64;  // a legend or a scale bar counts as much as an area full of samples
  return uses_.board.hidden_by(box) + (marks_.are_hidden_by(box) ? kMark : 0U);
}

NoteRoom Panels::note_room(const Sides& sides) const {
  const float unit = uses_.screen.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Vec2 low{sides.left + 8 * unit, sides.top + 10 * unit};
  const Vec2 high{std::max(low.x + 1.0, static_cast<double>(screen.x - sides.right - 8 * unit)),
                  screen.y - sides.bottom - 10 * unit};
  return {{low, high}, [this](const Box2& box) { return hidden_by(box); }};
}

// The audience of a presentation sees no messages; those of problems appear after it.
void Panels::draw_messages(const Sides& sides, float width, const NoteRoom& room) {
  if (presenter_.is_on()) return problem_note_.wait();
  const Gui& gui = uses_.screen.gui;
  const float unit = gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = problem_note_.draw(gui, uses_.messages, room, ImGui::GetTime());
  const ImVec2 middle(sides.left + 0.5F * width, sides.top + 0.5F * (screen.y - sides.top - sides.bottom));
  if (!uses_.demo.is_running() &&
      !EmptyViewNote{gui, uses_.work.editor(), uses_.work.layers(), uses_.board.picture(), uses_.work.engine()}.draw(
          middle, width))
    hidden_additions_note().draw({middle.x, sides.top + 10 * unit + height});
  if (!are_shown_) RefusalNote{gui, uses_.messages}.draw({sides.left, screen.y - sides.bottom - 14 * unit}, width);
}

void Panels::follow_lesson() {
  const bool is_running = uses_.lesson.is_running();
  // Samples that a step of a lesson or of the demo brings are no additions of the user, nor is the document restored
  // at its end.
  if (is_running || presents_lesson_ || uses_.demo.is_running())
    uses_.work.hidden_additions().begin(uses_.work.document());
  if (is_running == presents_lesson_) return;
  presents_lesson_ = is_running;
  if (!is_running)
    end_presentation();
  else if (!presenter_.is_on())
    begin_presentation();
  uses_.lesson.fit_again();
}

// The number and name of the slide: "3 of 13: Crust".
std::string Panels::slide() const {
  if (uses_.lesson.is_running()) return uses_.lesson.place();
  const WindowBundles& bundles = uses_.work.bundles();
  const auto current = bundles.current();
  if (!current || bundles.is_changed()) return {};
  return fmt::format("{} of {}: {}", *current + 1, bundles.bundles().size(), bundles.bundles()[*current].name);
}

void Panels::bind_look(ActionBindings& actions) {
  Settings& settings = uses_.settings;
  actions.bind(ActionId::presenter_mode, {[this] {
                                            if (!end_presentation()) begin_presentation();
                                          },
                                          {},
                                          [this] { return presenter_.is_on(); }});
  GlfwWindow& window = *uses_.screen.window;
  actions.bind(ActionId::full_screen, {[&window] { window.set_full_screen(!window.is_full_screen()); },
                                       {},
                                       [&window] { return window.is_full_screen(); }});
  actions.bind(ActionId::open_menus, {[this] { opens_menus_ = true; },
                                      {[this] { return are_shown_; }, "the menus are hidden, with the panels"}});
  actions.bind(ActionId::projector_mode, {[&settings] { settings.for_projector = !settings.for_projector; },
                                          {},
                                          [&settings] { return settings.for_projector; }});
  actions.bind(ActionId::toggle_theme,
               {[&settings] { settings.theme = settings.theme == Theme::dark ? Theme::light : Theme::dark; },
                {},
                [&settings] { return settings.theme == Theme::dark; }});
}

Panels::Room Panels::draw() {
  follow_lesson();
  if (auto sweep = uses_.work.insight().sweep.poll()) {
    if (*sweep)
      uses_.documents.ask_table("sweep", **std::move(sweep));
    else
      uses_.messages.problem("The sweep: " + sweep->error().message());
  }
  Sides sides = are_shown_ ? draw_around() : Sides{};
  draw_lesson(sides);
  const Sides around = sides;
  draw_over(sides);
  divide(sides);
  draw_annotation_card(sides);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  marks_.draw({sides.left, sides.top}, {screen.x - sides.right, screen.y - sides.bottom});
  const float width = screen.x - sides.left - sides.right;
  const ImVec2 middle(sides.left + 0.5F * width, sides.top + 0.5F * (screen.y - sides.top - sides.bottom));
  const Gui& gui = uses_.screen.gui;
  EmptyHint{
      gui, uses_.actions, uses_.work.document(), uses_.documents.files(), uses_.board.picture(), uses_.board.canvas()}
      .draw(middle);
  if (uses_.demo.draw(gui, {middle.x, screen.y - sides.bottom}, width)) uses_.actions.run(ActionId::demo);
  if (are_shown_)
    column_.draw_large(
        {{around.left, around.top}, {screen.x - around.left - around.right, screen.y - around.top - around.bottom}},
        [this](const Box2& box) { return hidden_by(box); });
  const NoteRoom room = note_room(sides);
  presenter_.draw(gui, presenter_.shows_slide() ? slide() : std::string(), room, ImGui::GetTime());
  draw_messages(sides, width, room);
  uses_.work.insight().end_frame();
  const double ratio = uses_.screen.window->pixel_ratio();
  const auto in_pixels = [ratio](float length) { return static_cast<double>(length) * ratio; };
  // In a narrow window panels lie over the drawing, which would be a dot beside them.
  constexpr float kNarrow = 160.0F;
  if (are_shown_ && screen.x - around.left - around.right < kNarrow * gui.unit())
    sides.right -= column_.panels_width();
  return {{in_pixels(sides.left), in_pixels(sides.top), in_pixels(sides.right), in_pixels(sides.bottom)},
          marks_.legend_in_corner()};
}

void Panels::draw_lesson(Sides& sides) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  sides.bottom += uses_.lesson.draw(
      uses_.screen.gui, uses_.actions,
      {{sides.left, sides.top}, {screen.x - sides.left - sides.right, screen.y - sides.top - sides.bottom}});
}

// Draws the panels above, below, on the right and on the left.
Panels::Sides Panels::draw_around() {
  const float unit = uses_.screen.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  Sides out;
  out.top = menu_bar_.draw(std::exchange(opens_menus_, false));
  out.bottom = status_bar_.height();
  status_bar_.draw({{0, screen.y - out.bottom}, {screen.x, out.bottom}});
  const float height = screen.y - out.top - out.bottom;
  out.right = column_.draw(out.top, height);
  const float margin = kMargin * unit;
  out.left = margin + toolbar_.draw({margin, out.top + margin}, height - 2 * margin);
  return out;
}

// Draws the strip of evolutions, which takes room, and the card of clicked elements, which takes none.
void Panels::draw_over(Sides& sides) {
  const Gui& gui = uses_.screen.gui;
  const float margin = kMargin * gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = screen.x - sides.left - sides.right - 2 * margin;
  const auto corner = [&] { return ImVec2(sides.left + margin, screen.y - sides.bottom - margin); };
  if (are_shown_ && uses_.settings.show_evolution) {
    step_events_.follow();
    sides.bottom +=
        margin +
        EvolutionStrip{gui,          uses_.actions, uses_.work.evolution(), uses_.work.editor(), uses_.work.layers(),
                       step_events_, uses_.messages}
            .draw(corner(), width);
  }
  // Marks of the strip refer to the main pane.
  const std::vector<PanePlace>& places = uses_.board.canvas().panes().places();
  const double ratio = uses_.screen.window->pixel_ratio();
  const auto on_screen = [ratio](int x, int y) {
    return ImVec2(static_cast<float>(x / ratio), static_cast<float>(y / ratio));
  };
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  if (places.empty())
    list.PushClipRectFullScreen();
  else
    list.PushClipRect(on_screen(places[0].left, places[0].top),
                      on_screen(places[0].left + places[0].width, places[0].top + places[0].height), true);
  const auto keep = uses_.board.provenance().draw(
      gui, uses_.board.canvas(), uses_.work.editor(), uses_.work.layers(),
      {{sides.left + margin, sides.top + margin}, {width, screen.y - sides.top - sides.bottom - 2 * margin}},
      [this](const Box2& box) { return hidden_by(box); }, uses_.actions.keymap().key_of(ActionId::keep_highlight));
  list.PopClipRect();
  uses_.board.draw_menu(uses_.actions);
  if (keep) uses_.board.keep_highlight(keep->line);
}

void Panels::divide(Sides& sides) {
  constexpr int kGap = 2;  // logical pixels
  constexpr int kLeast = 120;
  const double ratio = uses_.screen.window->pixel_ratio();
  const auto size = uses_.screen.window->framebuffer_size();
  const auto in_pixels = [ratio](float length) { return static_cast<int>(std::lround(length * ratio)); };
  const double unit = uses_.board.canvas().content_scale();
  const PanePlace whole{in_pixels(sides.left), in_pixels(sides.top),
                        size.width - in_pixels(sides.left) - in_pixels(sides.right),
                        size.height - in_pixels(sides.top) - in_pixels(sides.bottom)};
  const auto places =
      PanePlaces::divide(whole, uses_.work.panes().panes().size() + 1, static_cast<int>(std::lround(kGap * unit)),
                         static_cast<int>(std::lround(kLeast * unit)));
  uses_.board.canvas().set_panes(places);
  if (places.is_empty()) return;
  const PanePlace& main = places.places().front();
  const auto on_screen = [ratio](int pixels) { return static_cast<float>(pixels / ratio); };
  const std::vector<std::string> words = uses_.work.words_of_panes();
  PaneHeaders{uses_.screen.gui,
              uses_.actions,
              uses_.work.panes(),
              uses_.work.bundles(),
              uses_.work.computation().parameters(),
              uses_.work.computation().settings(),
              words,
              uses_.work.evolution(),
              ratio}
      .draw(places);
  sides = {on_screen(main.left), on_screen(main.top), on_screen(size.width - main.left - main.width),
           on_screen(size.height - main.top - main.height)};
}

// Draws the card below its annotation.
void Panels::draw_annotation_card(const Sides& sides) {
  AnnotationEditor& annotations = uses_.work.annotations();
  const Annotation* const current = annotations.current();
  if (current == nullptr) return;
  const Canvas& canvas = uses_.board.canvas();
  const float unit = uses_.screen.gui.unit();
  const bool has_words_at_first = current->kind == AnnotationKind::highlight;
  const Anchor& anchor = has_words_at_first ? current->anchors.front() : current->anchors.back();
  const Vec2 place = canvas.view().camera().to_screen(uses_.work.document().place_of(anchor));
  const Vec2 px = (1.0 / canvas.content_scale()) * place + current->shift;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = kMargin * unit;
  const ImVec2 room[2] = {{sides.left + margin, sides.top + margin},
                          {screen.x - sides.right - margin, screen.y - sides.bottom - margin}};
  annotation_card_.draw(uses_.screen.gui, annotations,
                        {static_cast<float>(px.x) * unit, static_cast<float>(px.y) * unit}, room,
                        [this](const Error& error) { uses_.messages.problem(error.message()); });
}

}  // namespace mes
