// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/window_recorder.h"

#include <fmt/core.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/recording/frame_view.h"
#include "app/recording/picture_clipboard.h"
#include "core/base/counted.h"
#include "core/io/session/session.h"
#include "render/image/png.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

/// Writes a picture with its session, which is left out if it is too long for a picture.
Expected<fs::path> write_picture(const render::Image& image, const fs::path& folder,
                                 const std::optional<Session>& session) {
  const auto png =
      render::encode_png(image, render::kPngSmall, session ? packed_session(*session).value_or("") : std::string());
  if (!png) return std::unexpected(png.error());
  const auto file = claim_file(folder, "mesecina", "png");
  if (!file) return std::unexpected(file.error());
  if (auto done = write_file_atomically(*file, {reinterpret_cast<const char*>(png->data()), png->size()}); !done) {
    std::error_code ignored;
    fs::remove(*file, ignored);
    return std::unexpected(done.error());
  }
  return *file;
}

// A free name beside the take. A dangling link occupies its name, too.
fs::path video_name(const fs::path& take) {
  std::error_code error;
  fs::path out = take.string() + ".mp4";
  for (int twin = 2; fs::exists(fs::symlink_status(out, error)); ++twin)
    out = fmt::format("{}-{}.mp4", take.string(), twin);
  return out;
}

/// Marks without a position of their own are where the window shows them.
void keep_places(OverlayContent& content, const MarkPlaces& shown) {
  if (shown.bar) content.marks.bar_at = shown.bar;
  if (shown.legend) content.legend_at = shown.legend;
}

}  // namespace

WindowRecorder::WindowRecorder(Picture& picture, Messages& messages, std::shared_ptr<const PaperFonts> fonts,
                               std::function<void()> wake)
    : picture_(picture),
      messages_(messages),
      fonts_(std::move(fonts)),
      wake_(std::move(wake)),
      capture_(picture.device()),
      finished_(wake_),
      written_snapshot_(wake_),
      written_copy_(wake_),
      video_(wake_) {}

namespace {

/// Arranges the panes as in the window, or on a picture of the requested size.
PaneSheet sheet_for(const PanePlaces& panes, double content_scale, const RecordSettings& settings) {
  const PanePlace& main = panes.places().front();
  const std::size_t count = panes.places().size();
  const auto columns = static_cast<std::size_t>(std::ranges::count(panes.places(), main.top, &PanePlace::top));
  PaneSheet out{.scale = content_scale,
                .grid = lay_out_panes_of(main.width, main.height, count, columns, content_scale)};
  const Vec2 natural = out.grid.extent();
  out.width = static_cast<int>(std::ceil(natural.x));
  out.height = static_cast<int>(std::ceil(natural.y));
  if (settings.width == 0 || (settings.width == out.width && settings.height == out.height)) return out;
  out.width = settings.width;
  out.height = settings.height;
  out.scale *= std::min(out.width / natural.x, out.height / natural.y);
  out.grid = lay_out(count, out.width, out.height, static_cast<double>(main.height) / main.width, out.scale);
  return out;
}

bool shows_panes(const RecordSettings& settings, const PanePlaces& panes) {
  return settings.all_panes && !panes.is_empty();
}

/// Sets the size of the drawing on screen, for a drawing without its panels.
void take_size_of(const WindowRecorder::Window& window, RecordSettings& settings) {
  if (shows_panes(settings, window.panes)) {
    const PaneSheet sheet = sheet_for(window.panes, window.content_scale, settings);
    settings.width = sheet.width;
    settings.height = sheet.height;
    return;
  }
  const WindowPart part = part_between(window.panels, window.width, window.height);
  settings.width = part.width;
  settings.height = part.height;
}

}  // namespace

void WindowRecorder::start(const RecordSettings& settings, const Window& window, const ShownState& now) {
  if (is_recording()) return;
  const auto refuse = [this](const Error& error) { messages_.problem("Cannot record: " + error.message()); };
  if (const auto good = check(settings); !good) return refuse(good.error());
  const fs::path folder = folder_of(settings);
  if (folder.empty())
    return refuse({ErrorCode::cannot_write, "the home folder is not known; choose a folder for pictures"});
  settings_ = settings;
  panels_ = window.panels;
  if (settings.with_panels) {
    settings_.width = window.width;
    settings_.height = window.height;
  } else if (settings.width == 0) {
    take_size_of(window, settings_);
  }
  auto take = begin_take(folder, {settings_.width, settings_.height, settings.fps});
  if (!take) return refuse(take.error());
  messages_.remark("Recording into " + take->folder.string());
  writer_ = std::make_unique<FrameWriter>(std::move(*take), FrameWriterOptions{.wake = wake_});
  has_lost_frame_ = false;
  recorder_.emplace(now, settings.each_motion);
  recorder_->note_complete(complete_);
  frames_ = 0;
  began_ = std::chrono::steady_clock::now();
}

void WindowRecorder::stop() {
  if (!is_recording()) return;
  while (auto raw = capture_.wait()) hand_on(std::move(*raw));
  recorder_.reset();
  // If two takes follow each other quickly, waits for the first one.
  if (const auto done = finished_.finish()) tell_end(*done);
  std::optional<Session> session;
  if (settings_.with_source && take_source_) session = take_source_();
  finished_.begin([writer = std::shared_ptr<FrameWriter>(std::move(writer_)),
                   session = std::move(session)](const std::stop_token&) {
    if (session) writer->carry(packed_session(*session).value_or(""));
    Finished out{writer->take().folder, 0, writer->finish()};
    out.frames = writer->written();
    if (out.frames == 0) {
      std::error_code ignored;
      fs::remove(out.folder / kManifestName, ignored);
      fs::remove(out.folder, ignored);
    }
    return out;
  });
}

void WindowRecorder::end() {
  stop();
  while (auto raw = capture_.wait()) hand_on(std::move(*raw));
  if (const auto done = finished_.finish()) tell_end(*done);
  if (const auto file = written_snapshot_.finish()) tell_snapshot(*file);
}

void WindowRecorder::snapshot(const RecordSettings& settings) {
  if (const auto good = check(settings); !good)
    messages_.problem("No snapshot: " + good.error().message());
  else {
    snapshot_ = settings;
    is_copy_ = false;
  }
}

void WindowRecorder::copy(bool all_panes) {
  snapshot_ = RecordSettings{};
  snapshot_->all_panes = all_panes;
  is_copy_ = true;
}

void WindowRecorder::note_complete(const std::optional<ShownState>& state) {
  complete_ = state;
  if (recorder_) recorder_->note_complete(state);
}

bool WindowRecorder::holds_input(const ShownState& now, const AtRest& rest, bool is_cancelled) const {
  return recorder_ && recorder_->holds_input(now, rest, is_cancelled);
}

bool WindowRecorder::holds_motion(const ShownState& now) const {
  return recorder_ && settings_.each_motion && recorder_->change(now) != Change::none;
}

bool WindowRecorder::has_room() const {
  const auto bytes = 4 * static_cast<std::size_t>(settings_.width) * static_cast<std::size_t>(settings_.height);
  const std::size_t wanted = capture_.pending() + 1;
  return writer_->has_room(wanted, wanted * bytes) || (capture_.pending() == 0 && writer_->pending() == 0);
}

bool WindowRecorder::is_frame_due(const Drawn& drawn) const {
  return recorder_ && recorder_->is_due(drawn.state, drawn.rest) && has_room();
}

bool WindowRecorder::is_snapshot_due(const Drawn& drawn) const {
  return snapshot_ && (complete_ == drawn.state || drawn.is_cancelled);
}

WindowRecorder::Purpose WindowRecorder::frame_purpose(const Drawn& drawn) const {
  return {.use = Use::frame,
          .info = {name_of(recorder_->change(drawn.state), drawn.editor.timeline().entries()),
                   drawn.editor.document().digest(),
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count()}};
}

WindowRecorder::Purpose WindowRecorder::snapshot_purpose() const {
  Purpose out{.use = use_of_snapshot(), .folder = folder_of(*snapshot_)};
  if (out.use == Use::snapshot && snapshot_->with_source && source_) out.session = source_();
  return out;
}

void WindowRecorder::note_frame(const Drawn& drawn) {
  recorder_->note_captured(drawn.state);
  ++frames_;
}

bool WindowRecorder::ask(const Drawn& drawn, const RecordSettings& settings, const Insets& panels, Purpose purpose) {
  return shows_panes(settings, drawn.panes.places) && fonts_ ? ask_sheet(drawn, settings, std::move(purpose))
                                                             : ask_one(drawn, settings, panels, std::move(purpose));
}

bool WindowRecorder::refuse(const Purpose& purpose, const std::string& reason) {
  messages_.problem((purpose.use == Use::frame ? "Recording ended: " : "No snapshot: ") + reason);
  return false;
}

bool WindowRecorder::ask_sheet(const Drawn& drawn, const RecordSettings& settings, Purpose purpose) {
  const PanePlace& main = drawn.panes.places.places().front();
  PaneSheet sheet = sheet_for(drawn.panes.places, drawn.content_scale, settings);
  if (sheet.pane_width() < 1 || sheet.pane_height() < 1)
    return refuse(purpose, "the picture is too small for its panes");
  const Rgb background = settings.background.value_or(picture_.canvas());
  sheet.background = settings.transparent ? std::nullopt : std::optional(background);
  sheet.labels = drawn.panes.labels;
  const RecordSettings pane_size{.width = sheet.pane_width(), .height = sheet.pane_height()};
  const ShownPanes::Layers main_layers = visible_layers(drawn.layers);
  std::vector<Picture::Pane> panes{{main_layers}};
  std::vector<ShownPanes::Layers> layers{main_layers};
  for (const Picture::Pane& pane : drawn.panes.beside) {
    panes.push_back(pane);
    layers.push_back(pane.layers);
  }
  const bool is_explained_once = are_alike(layers);
  const std::optional<Rgb> behind = sheet.background;
  const auto picture = std::make_shared<CapturedPicture>(std::move(sheet), fonts_);
  const auto shared = std::make_shared<const Purpose>(std::move(purpose));
  for (std::size_t i = 0; i < panes.size(); ++i) {
    ScaleMarks marks = drawn.state.marks;
    // If all panes have the same scale, one bar is enough.
    marks.bar = marks.bar && (i == 0 || panes[i].camera != nullptr);
    const FrameView view = frame_view(panes[i].camera != nullptr ? *panes[i].camera : drawn.camera,
                                      {main.left, main.top, main.width, main.height}, drawn.content_scale, pane_size);
    const Document& document = panes[i].version != nullptr ? *panes[i].version : drawn.editor.document();
    const LegendScope legend = i == 0 || !is_explained_once ? drawn.state.legend : LegendScope::none;
    OverlayContent content{picture_.legend(layers[i], legend),
                           i == 0 ? drawn.state.caption : std::string(),
                           marks,
                           drawn.state.annotations ? place(document) : PlacedAnnotations{},
                           {},
                           drawn.state.legend_at,
                           unit_of_lengths(document)};
    const bool is_frame = shared->use == Use::frame;
    if (i == 0 && !is_frame) keep_places(content, drawn.marks);
    auto overlay = [content = std::move(content), fonts = fonts_, is_frame,
                    target = OverlayTarget{view.camera, view.content_scale, behind}](const render::RawImage& raw) {
      if (is_frame) return picture_overlay_of(content, fonts, target);
      const InkMap ink(raw, target.camera, target.background);
      return picture_overlay_of(content, fonts, target, &ink);
    };
    const render::CaptureOptions options{
        .background = behind, .content_scale = view.content_scale, .supersampling = settings.supersampling};
    if (const auto done = picture_.capture(capture_, view.camera, panes[i], drawn.editor, options, true); !done)
      return refuse(*shared, done.error().message());
    asked_.push_back({std::move(overlay), picture, shared});
  }
  return true;
}

bool WindowRecorder::ask_one(const Drawn& drawn, const RecordSettings& settings, const Insets& panels,
                             Purpose purpose) {
  const WindowPart part = part_between(panels, drawn.camera.width(), drawn.camera.height());
  const FrameView view = frame_view(drawn.camera, part, drawn.content_scale, settings);
  const Rgb background = settings.background.value_or(picture_.canvas());
  const std::optional<Rgb> behind = settings.transparent ? std::nullopt : std::optional<Rgb>(background);
  OverlayContent content{picture_.legend(visible_layers(drawn.layers), drawn.state.legend),
                         drawn.state.caption,
                         drawn.state.marks,
                         drawn.state.annotations ? place(drawn.editor.document()) : PlacedAnnotations{},
                         {},
                         drawn.state.legend_at,
                         unit_of_lengths(drawn.editor.document())};
  if (purpose.use != Use::frame) keep_places(content, drawn.marks);
  const PictureOverlay overlay =
      picture_overlay_of(std::move(content), fonts_, {view.camera, view.content_scale, behind});
  const bool is_on_screen = view.camera.width() == part.width && view.camera.height() == part.height &&
                            view.content_scale == drawn.content_scale && settings.supersampling == 1 &&
                            !settings.transparent && background == picture_.canvas() && picture_.every() == 1 &&
                            !picture_.is_painting() && drawn.panes.places.is_empty();
  if (is_on_screen) {
    const render::PixelRect area{part.left, drawn.camera.height() - part.top - part.height, part.width, part.height};
    if (const auto done = capture_.take({}, area); !done) return refuse(purpose, done.error().message());
  } else {
    const render::CaptureOptions options{
        .background = behind, .content_scale = view.content_scale, .supersampling = settings.supersampling};
    const ShownPanes::Layers layers = visible_layers(drawn.layers);
    if (const auto done = picture_.capture(capture_, view.camera, {layers}, drawn.editor, options); !done)
      return refuse(purpose, done.error().message());
  }
  asked_.push_back({[overlay](const render::RawImage&) { return overlay; }, std::make_shared<CapturedPicture>(),
                    std::make_shared<const Purpose>(std::move(purpose))});
  return true;
}

bool WindowRecorder::ask_window(const render::PixelRect& all, Purpose purpose) {
  if (const auto done = capture_.take({}, all); !done) return refuse(purpose, done.error().message());
  asked_.push_back({{}, std::make_shared<CapturedPicture>(), std::make_shared<const Purpose>(std::move(purpose))});
  return true;
}

void WindowRecorder::picture_drawn(const Drawn& drawn) {
  if (is_snapshot_due(drawn) && !snapshot_->with_panels) {
    static_cast<void>(ask(drawn, *snapshot_, drawn.panels, snapshot_purpose()));
    snapshot_.reset();
  }
  if (!is_frame_due(drawn) || settings_.with_panels) return;
  if (ask(drawn, settings_, panels_, frame_purpose(drawn)))
    note_frame(drawn);
  else
    stop();
}

void WindowRecorder::panels_drawn(const Drawn& drawn) {
  const render::PixelRect all{0, 0, drawn.camera.width(), drawn.camera.height()};
  // More disks may still be on their way to the window.
  if (picture_.is_refining()) return;
  if (is_snapshot_due(drawn)) {
    static_cast<void>(ask_window(all, snapshot_purpose()));
    snapshot_.reset();
  }
  if (!settings_.with_panels || !is_frame_due(drawn)) return;
  if (all.width != settings_.width || all.height != settings_.height) {
    stop();
    messages_.problem("Recording ended: the window has another size now, and its panels cannot be scaled");
    return;
  }
  if (ask_window(all, frame_purpose(drawn)))
    note_frame(drawn);
  else
    stop();
}

void WindowRecorder::hand_on(render::RawImage raw) {
  Asked asked = std::move(asked_.front());
  asked_.pop_front();
  if (raw.rgba.empty()) return tell_lost(asked, raw);
  PictureOverlay overlay = asked.overlay ? asked.overlay(raw) : PictureOverlay{};
  asked.picture->add(std::move(raw), std::move(overlay));
  if (!asked.picture->is_whole()) return;
  switch (asked.purpose->use) {
    case Use::frame:
      if (writer_ && !has_lost_frame_) writer_->push({std::move(*asked.picture), asked.purpose->info});
      break;
    case Use::snapshot: write_snapshot(std::move(asked.picture), asked.purpose); break;
    case Use::copy: write_copy(std::move(asked.picture)); break;
  }
}

// Reports a picture of several panes once.
void WindowRecorder::tell_lost(const Asked& asked, const render::RawImage& raw) {
  if (lost_ == asked.picture || (asked.purpose->use == Use::frame && has_lost_frame_)) return;
  lost_ = asked.picture;
  has_lost_frame_ = has_lost_frame_ || asked.purpose->use == Use::frame;
  refuse(*asked.purpose, fmt::format("not enough memory for a picture of {}x{} pixels", raw.width, raw.height));
}

void WindowRecorder::write_snapshot(std::shared_ptr<CapturedPicture> picture,
                                    const std::shared_ptr<const Purpose>& purpose) {
  if (purpose->folder.empty()) {
    messages_.problem("No snapshot: the home folder is not known; choose a folder for pictures");
    return;
  }
  if (const auto file = written_snapshot_.finish()) tell_snapshot(*file);
  written_snapshot_.begin([picture = std::move(picture), purpose](const std::stop_token&) {
    return write_picture(std::move(*picture).image(), purpose->folder, purpose->session);
  });
}

void WindowRecorder::write_copy(std::shared_ptr<CapturedPicture> picture) {
  written_copy_.begin([picture = std::move(picture)](const std::stop_token& stop) -> Expected<void> {
    const auto png = render::encode_png(std::move(*picture).image(), render::kPngSmall, {});
    if (!png) return std::unexpected(png.error());
    return copy_png(*png, stop);
  });
}

void WindowRecorder::tell_copy(const Expected<void>& done) {
  if (done)
    messages_.remark("The picture is on the clipboard");
  else
    messages_.problem("Not copied: " + done.error().message());
}

bool WindowRecorder::follow() {
  while (auto raw = capture_.poll()) hand_on(std::move(*raw));
  if (writer_ && (writer_->problem() || has_lost_frame_)) stop();
  return take_results();
}

void WindowRecorder::tell_end(const Finished& done) {
  if (done.frames != 0) last_take_ = done.folder;
  if (!done.result)
    messages_.problem("Recording stopped after " + counted(done.frames, "frame") + ": " +
                      done.result.error().message());
  else if (done.frames == 0)
    messages_.remark("Nothing was recorded");
  else
    messages_.remark("Recorded " + counted(done.frames, "frame") + " in " + done.folder.string());
}

void WindowRecorder::tell_snapshot(const Expected<fs::path>& file) {
  if (file)
    messages_.remark("Snapshot in " + file->string());
  else
    messages_.problem("No snapshot: " + file.error().message());
}

bool WindowRecorder::take_results() {
  bool has_news = false;
  if (const auto done = finished_.poll()) {
    has_news = true;
    tell_end(*done);
  }
  if (const auto file = written_snapshot_.poll()) {
    has_news = true;
    tell_snapshot(*file);
  }
  if (const auto done = written_copy_.poll()) {
    has_news = true;
    tell_copy(*done);
  }
  if (const auto done = video_.take_result()) {
    has_news = true;
    if (done->has_value())
      messages_.remark("Video in " + video_.output().string());
    else if (done->error().code == ErrorCode::cancelled)
      messages_.remark("The video was cancelled");
    else
      messages_.problem(done->error().message());
  }
  return has_news;
}

void WindowRecorder::start_video(const RecordSettings& settings) {
  const VideoPace pace = settings.real_time ? VideoPace::real_time : VideoPace::steady;
  if (can_make_video()) video_.start(last_take_, settings.fps, video_name(last_take_), pace);
}

}  // namespace mes
