// SPDX-License-Identifier: GPL-3.0-or-later
// The window program: owns everything, passes events on, draws frames when something changed and sleeps otherwise.
#pragma once

#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/model/computation_control.h"
#include "app/model/editor.h"
#include "app/model/evolution_player.h"
#include "app/model/layer_stack.h"
#include "app/model/messages.h"
#include "app/model/player.h"
#include "app/model/settings.h"
#include "app/model/surroundings.h"
#include "app/panels/ask_conflict.h"
#include "app/panels/ask_recover.h"
#include "app/panels/ask_unsaved.h"
#include "app/panels/bundles_panel.h"
#include "app/panels/details_panel.h"
#include "app/panels/layers_panel.h"
#include "app/panels/menu_bar.h"
#include "app/panels/provenance_card.h"
#include "app/panels/status_bar.h"
#include "app/panels/toolbar.h"
#include "app/picture/picture.h"
#include "app/recording/record_desk.h"
#include "app/store/autosave.h"
#include "app/store/background_loader.h"
#include "app/store/bundle_desk.h"
#include "app/store/file_desk.h"
#include "app/store/sample_shapes.h"
#include "app/system/termination.h"
#include "app/ui/file_browser.h"
#include "app/ui/frame_times.h"
#include "app/ui/glfw_window.h"
#include "app/ui/gui.h"
#include "app/window/run_window.h"
#include "core/engine/engine.h"

namespace mes {

/// The demo while it is played in the window.
struct LiveDemo {
  Session session;
  std::vector<PlayStep> steps;
  std::size_t next = 0;
  bool is_paused = false;
  double not_before = 0.0;     ///< seconds; the next step waits until then, and for the picture
  std::uint64_t document = 0;  ///< revision it left behind; another one means that somebody edits
  std::string caption{};
  LayerConfiguration layers_before{};
  ComputationSettings settings_before{};
};

/// What it guarantees:
///  1. The thread that draws never waits for the engine or for a file being read.
///  2. Unsaved work is not lost without a question, whichever way the window is left.
///  3. Nor by a crash: a journal of what no file holds is offered at the next start.
///  4. With nothing to show anew it sleeps and uses no processor time.
///
/// Threads: the main one. Members are destroyed in reverse order: panels and canvas first, then the engine with its
/// thread, then what needs OpenGL, the window last.
class App final : private WindowListener {
 public:
  App(std::unique_ptr<GlfwWindow> window, const WindowOptions& options, LoadedSettings loaded,
      const Termination& termination);
  ~App() override;

  void run();

 private:
  // app_events.cpp
  void on_pointer_moved(Vec2 px, Modifiers modifiers) override;
  void on_pointer_left() override;
  void on_button(PointerButton button, bool pressed, Modifiers modifiers) override;
  void on_wheel(double steps) override;
  void on_key(const KeyChord& chord, bool repeated) override;
  void on_typed(char32_t symbol, bool repeated) override;
  void on_space(bool held) override;
  void on_files_dropped(std::vector<std::string> files) override;
  void on_close_wanted() override;
  void on_anything() override;
  void deliver_events();
  void follow_pointer(Vec2 px, Modifiers modifiers);
  int dialog() const;
  bool close_top_dialog(const KeyChord& chord);
  void run_by_key(const KeyChord& chord, bool repeated);

  // app_actions.cpp
  void bind_actions();
  void bind_file_actions();
  void bind_edit_actions();
  void bind_view_actions();
  void bind_evolution_actions();
  void choose_precision(Precision precision);
  void advance_animation();
  void nudge(double x_px, double y_px);
  void report(const Error& error);
  Box2 fit_box() const;
  void fit_if_wanted();

  // app_bundles.cpp
  void bind_bundle_actions();
  void ask_export(std::optional<std::size_t> index);
  void import_bundles(const std::filesystem::path& file);
  std::vector<std::filesystem::path> without_bundles(const std::vector<std::string>& files);

  // app_files.cpp
  void open_first(const WindowOptions& options);
  void with_saved_work(std::function<void()> then);
  /// The picture, if any, is to be traced in what the files bring.
  void open_files(const std::vector<std::string>& files, const std::filesystem::path& picture = {});
  void open_shape(const SampleShape& shape);
  void save();
  void ask_save_as();
  void take_saved();
  void say_saved(const std::string& files);
  void take_read_file();
  void leave_document();
  void draw_dialogs();
  void draw_conflict();
  void remember_settings();

  // app_session.cpp
  Session session_now() const;
  void show_as_in(const Session& session);
  void keep_timeline();
  void look_for_left_work();
  void offer_left_work();
  void recover(LeftWork work);
  std::filesystem::path browse_folder() const;

  // app_demo.cpp
  void start_demo();
  void end_demo(bool restore);
  void advance_demo();
  Expected<void> perform(const TimelineEntry& entry);
  void draw_caption(ImVec2 middle, float width);
  // app_image.cpp
  void ask_picture();
  void trace_picture(const std::filesystem::path& file);
  void follow_picture();
  // app_record.cpp
  void bind_record_actions();
  ShownState shown_state() const;
  AtRest at_rest() const;
  bool holds_input() const;
  void tell_of_memory();
  void note_if_complete();
  RecordDesk::Drawn drawn_now() const;
  void follow_recording();

  // app.cpp
  void frame();
  MenuBar menu_bar();
  StatusBar status_bar();
  Toolbar toolbar();
  void draw_panels();
  void draw_pointer_marks();
  bool waits_for_room();
  void follow_demand();
  void show_first_ball();
  void follow_evolution();
  void update_title();
  double next_wait() const;

  const Termination& termination_;
  Settings settings_;
  Settings settings_at_start_;
  std::filesystem::path settings_path_;
  Messages messages_;
  std::unique_ptr<GlfwWindow> window_;
  std::filesystem::path assets_;
  std::vector<SampleShape> shapes_;
  Gui gui_;
  Picture picture_;
  RecordDesk record_;
  FrameTimes times_;
  ProvenanceCard provenance_;
  Engine engine_;
  ComputationControl computation_{engine_};
  LayerStack layers_;
  BundleDesk bundles_;
  Editor editor_;
  EvolutionPlayer evolution_;
  FileDesk files_;
  ToolContext tool_context_;
  Canvas canvas_;
  ActionBindings actions_;
  BundlesPanel bundles_panel_;
  LayersPanel layers_panel_;
  DetailsPanel details_panel_;
  std::optional<LiveDemo> demo_;
  BackgroundLoader background_{[] { GlfwWindow::wake(); }};
  FileBrowser browser_;
  AskUnsaved ask_unsaved_;
  AskConflict ask_conflict_;
  AskRecover ask_recover_;
  SurroundingsNotes notes_;
  Autosave autosave_;
  std::future<FoundWork> left_work_;
  std::function<void(const std::filesystem::path&)> when_chosen_;  // instead of opening or saving
  std::function<void()> after_save_;                               // what waits for a save under a new name
  bool show_help_ = false;
  bool show_panels_ = true;
  enum class Fit : std::uint8_t { none, glide, at_once };
  Vec2 legend_size_;            // with its margin, in framebuffer pixels
  std::optional<Box2> fit_to_;  // instead of everything
  /// What was fitted and into what. While nobody moves the view and the drawing stays about as large, it is fitted
  /// again when panels come and go.
  struct Room {
    int width = 0;
    int height = 0;
    Insets panels{};
    friend bool operator==(const Room&, const Room&) = default;
  };
  struct Fitted {
    Box2 box;
    Room room;
  };
  bool wants_fit_again(const Room& room) const;
  std::optional<Fitted> fitted_;
  Fit fit_wanted_ = Fit::none;              // done in the next frame, when the panels are where they will be
  std::filesystem::path traced_with_next_;  // when what is being read is there
  bool had_first_file_ = false;
  bool is_closing_ = false;
  std::optional<std::uint64_t> memory_told_at_;  // revision of the document
  int frames_wanted_ = 3;                        // the panels need a few frames to settle after an event
  std::uint64_t demand_seen_ = 0;
  bool demands_nothing_ = false;                     // the picture was lost
  std::pair<std::uint64_t, std::uint64_t> lost_at_;  // revisions of demand and document then
  bool had_balls_ = false;
  struct Event {
    bool is_move = false;
    std::function<void()> run;
  };
  std::deque<Event> events_;  // not yet acted on
  Vec2 pointer_px_{-1, -1};
};

}  // namespace mes
