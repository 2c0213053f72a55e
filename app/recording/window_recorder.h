// SPDX-License-Identifier: GPL-3.0-or-later
// Makes recordings, snapshots and videos of the window.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/actions/messages.h"
#include "app/panes/view_motion.h"
#include "app/picture/paper/pane_sheet.h"
#include "app/picture/picture.h"
#include "app/recording/frame_writer.h"
#include "app/recording/recorder.h"
#include "app/recording/video.h"
#include "app/settings/record_settings.h"
#include "app/system/background_job.h"
#include "core/io/session/session.h"
#include "render/frame_capture.h"

namespace mes {

/// Guarantees:
///  1. Those of Recorder and FrameWriter: one frame per change, each frame complete.
///  2. No call but `end` waits for a disk or for another program.
///  3. All frames of a take have the size of the first one, even if the window is resized meanwhile. Frames of the
///     drawing alone show the area between the panels as it was when the take began.
///  4. If several panes are on screen, frames show all of them, as snapshots do, or the main one, as the settings
///     say.
///
/// Smallest use, each turn of the window's loop:
///     if (!recorder.holds_input(now, rest, is_cancelled)) deliver_events();
///     recorder.note_complete(...); take_results(); draw_picture();
///     recorder.picture_drawn(what); draw_panels(); recorder.panels_drawn(what); recorder.follow();
///
/// Threads: the window's, with its OpenGL context current; `wake` is called from others.
class WindowRecorder {
 public:
  WindowRecorder(Picture& picture, Messages& messages, std::shared_ptr<const PaperFonts> fonts,
                 std::function<void()> wake);

  /// Sets the source of the session that a snapshot carries (core/io/carried_session.h); without it snapshots carry
  /// none.
  void set_source(std::function<Session()> source) { source_ = std::move(source); }
  /// The same for the session in the manifest of a take, taken when it ends.
  void set_take_source(std::function<Session()> source) { take_source_ = std::move(source); }
  bool is_recording() const { return writer_ != nullptr; }
  /// The window to record.
  struct Window {
    int width = 0;  ///< pixels
    int height = 0;
    Insets panels{};          ///< taken by panels at its sides; the rest is divided into panes
    const PanePlaces& panes;  ///< empty: there is only the main pane
    double content_scale = 1.0;
  };
  void start(const RecordSettings& settings, const Window& window, const ShownState& now);
  /// Ends the take. Captured pictures are written in the background.
  void stop();
  /// Ends the take, and waits until everything is written.
  void end();
  /// Saves one picture into the folder for pictures as soon as the display is complete.
  void snapshot(const RecordSettings& settings);
  /// Copies the same picture, with default settings otherwise, to the clipboard.
  void copy(bool all_panes);

  /// True if the screen content is going to be kept as a picture.
  bool wants_exact_picture() const { return is_recording() || snapshot_.has_value(); }

  void note_complete(const std::optional<ShownState>& state);
  bool holds_input(const ShownState& now, const AtRest& rest, bool is_cancelled) const;
  /// True while a gliding view must wait, because some of its steps would get no frame.
  bool holds_motion(const ShownState& now) const;

  /// The contents of the panes beside the main one.
  struct DrawnPanes {
    const PanePlaces& places;  ///< empty: there is only the main pane
    std::vector<Picture::Pane> beside{};
    std::vector<std::string> labels;  ///< labels of all panes, as on the sheet
  };
  struct Drawn {
    const render::Camera& camera;
    Insets panels{};
    const LayerStack& layers;
    DrawnPanes panes;
    const Editor& editor;
    double content_scale = 1.0;
    ShownState state{};
    AtRest rest{};
    bool is_cancelled = false;
    MarkPlaces marks{};  ///< where a snapshot has them, too; frames of a recording keep theirs in one place
  };
  /// Call it when the window shows the drawing and nothing else yet.
  void picture_drawn(const Drawn& drawn);
  /// Call it when the window shows everything.
  void panels_drawn(const Drawn& drawn);
  /// Takes pictures from the graphics card, and reports finished work. Returns true if there was something to report.
  bool follow();
  /// True if work under way needs the next turn soon.
  bool wants_turn() const { return capture_.pending() != 0 || snapshot_.has_value(); }

  std::size_t frames() const { return frames_; }
  std::size_t unwritten() const { return writer_ ? capture_.pending() + writer_->pending() : 0; }
  bool is_waiting_for_disk() const { return writer_ && !has_room(); }
  bool is_finishing() const { return finished_.is_under_way(); }

  /// Refers to the last take, if it has frames.
  bool can_make_video() const {
    return !last_take_.empty() && !is_recording() && !is_finishing() && !video_.is_running();
  }
  void start_video(const RecordSettings& settings);
  bool is_making_video() const { return video_.is_running(); }
  void cancel_video() { video_.cancel(); }

 private:
  struct Finished {
    std::filesystem::path folder;
    std::size_t frames = 0;
    Expected<void> result{};
  };
  /// The use of a captured picture: a frame, or a snapshot.
  enum class Use : std::uint8_t { frame, snapshot, copy };
  /// The destination of a requested picture.
  struct Purpose {
    Use use = Use::frame;
    FrameInfo info{};
    std::filesystem::path folder{};    ///< folder of a snapshot
    std::optional<Session> session{};  ///< the session that it carries
  };
  /// Pixels on their way from the graphics card.
  struct Asked {
    /// The overlay of a picture with these pixels; null: none.
    std::function<PictureOverlay(const render::RawImage&)> overlay{};
    std::shared_ptr<CapturedPicture> picture{};  ///< the picture that they are part of
    std::shared_ptr<const Purpose> purpose{};
  };
  bool has_room() const;
  bool is_frame_due(const Drawn& drawn) const;
  bool is_snapshot_due(const Drawn& drawn) const;
  Purpose frame_purpose(const Drawn& drawn) const;
  Purpose snapshot_purpose() const;
  void note_frame(const Drawn& drawn);
  /// Requests the drawing with these settings. Returns false, with a message, if that is impossible.
  bool ask(const Drawn& drawn, const RecordSettings& settings, const Insets& panels, Purpose purpose);
  bool ask_one(const Drawn& drawn, const RecordSettings& settings, const Insets& panels, Purpose purpose);
  /// Requests all panes.
  bool ask_sheet(const Drawn& drawn, const RecordSettings& settings, Purpose purpose);
  bool ask_window(const render::PixelRect& all, Purpose purpose);
  bool refuse(const Purpose& purpose, const std::string& reason);
  void hand_on(render::RawImage raw);
  void tell_lost(const Asked& asked, const render::RawImage& raw);
  void write_snapshot(std::shared_ptr<CapturedPicture> picture, const std::shared_ptr<const Purpose>& purpose);
  void write_copy(std::shared_ptr<CapturedPicture> picture);
  Use use_of_snapshot() const { return is_copy_ ? Use::copy : Use::snapshot; }
  bool take_results();
  void tell_end(const Finished& done);
  void tell_snapshot(const Expected<std::filesystem::path>& file);
  void tell_copy(const Expected<void>& done);

  Picture& picture_;
  Messages& messages_;
  std::shared_ptr<const PaperFonts> fonts_;  // null: no legend, no caption
  std::function<void()> wake_;
  std::function<Session()> source_;
  std::function<Session()> take_source_;
  render::FrameCapture capture_;
  std::deque<Asked> asked_;
  std::shared_ptr<CapturedPicture> lost_{};  // the last picture that lost a part for lack of memory
  bool has_lost_frame_ = false;              // a frame was lost, so the take ends before it
  std::optional<ShownState> complete_{};

  RecordSettings settings_{};  // settings of the take
  Insets panels_{};            // those at the beginning of the take, so that its frames do not jump
  std::optional<Recorder> recorder_{};
  std::unique_ptr<FrameWriter> writer_;
  std::size_t frames_ = 0;
  std::chrono::steady_clock::time_point began_{};
  BackgroundJob<Finished> finished_;
  std::filesystem::path last_take_;

  std::optional<RecordSettings> snapshot_{};  // requested
  bool is_copy_ = false;                      // the requested picture is for the clipboard
  BackgroundJob<Expected<std::filesystem::path>> written_snapshot_;
  BackgroundJob<Expected<void>> written_copy_;
  VideoJob video_;
};

}  // namespace mes
