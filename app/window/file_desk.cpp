// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/file_desk.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <iterator>
#include <utility>

#include "core/io/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_ball_file(const fs::path& file) {
  return extension_of(file) == ".wpoff";
}

bool is_session_file(const fs::path& file) {
  return extension_of(file) == ".json";
}

}  // namespace

FileDesk::FileDesk(Editor& editor, std::function<Session()> session_now, std::function<void()> wake)
    : editor_(editor), session_now_(std::move(session_now)), wake_(std::move(wake)) {
  note_all_as_saved();
}
FileDesk::~FileDesk() = default;

void FileDesk::read(Reading& reading) {
  for (const fs::path& file : reading.files) {
    try {
      reading.results.push_back(read_sample_file(file));
    } catch (const std::bad_alloc&) {
      reading.results.push_back(
          std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory for it", file.string()}));
    } catch (const std::exception& error) {
      reading.results.push_back(std::unexpected(Error{ErrorCode::bad_input, error.what(), file.string()}));
    }
    if (!reading.results.back()) return;
  }
}

void FileDesk::begin(const std::vector<fs::path>& files, const std::string& shape_title) {
  cancel_reading();
  std::erase_if(given_up_, [](const auto& reading) { return reading->is_done.load(); });
  reading_ = std::make_unique<Reading>();
  reading_->files = files;
  reading_->title = shape_title;
  reading_->thread = std::jthread([reading = reading_.get(), wake = wake_] {
    read(*reading);
    reading->is_done = true;
    if (wake) wake();
  });
}

void FileDesk::open(const std::vector<fs::path>& files) {
  if (!files.empty()) begin(files, {});
}

void FileDesk::open_shape(const fs::path& file, const std::string& title) {
  begin({file}, title);
}

void FileDesk::cancel_reading() {
  if (reading_) given_up_.push_back(std::move(reading_));
}

std::string FileDesk::reading_name() const {
  if (!reading_) return {};
  return reading_->title.empty() ? reading_->files.front().filename().string() : reading_->title;
}

std::optional<FileDesk::Outcome> FileDesk::poll() {
  if (!reading_ || !reading_->is_done) return std::nullopt;
  const std::unique_ptr<Reading> reading = std::move(reading_);
  reading->thread.join();
  Outcome out;
  out.is_shape = !reading->title.empty();
  out.file = reading->files[reading->results.size() - 1];
  if (!reading->results.back()) {
    out.error = reading->results.back().error();
    return out;
  }

  const auto blame = [&out](Expected<void> done) {
    if (done) return false;
    out.error = std::move(done.error());
    out.error->file = out.file.string();
    return true;
  };
  if (LoadedFile& first = *reading->results.front(); first.session) {
    out.file = reading->files.front();
    if (blame(take_over(*first.session, out.file.string()))) return out;
    out.session = first.session;
    out.format = first.format;
    out.files = {out.file};
    out.left_out = reading->files.size() - 1;
    out.samples = editor_.document().sample_count();
    out.balls = editor_.document().ball_count();
    forget_files();
    file_ = session_file_ = out.file;
    note_all_as_saved();
    title_ = out.file.filename().string();
    return out;
  }

  SampleData data;
  fs::path sample_file;
  fs::path ball_file;
  for (std::size_t i = 0; i < reading->results.size(); ++i) {
    LoadedFile& loaded = *reading->results[i];
    const bool brings_known = (!loaded.data.positions.empty() && !data.positions.empty()) ||
                              (!loaded.data.balls.empty() && !data.balls.empty());
    if (i != 0 && (brings_known || (loaded.data.positions.empty() && loaded.data.balls.empty()))) {
      ++out.left_out;
      continue;
    }
    out.files.push_back(reading->files[i]);
    if (!loaded.data.positions.empty()) {
      data.positions = std::move(loaded.data.positions);
      data.contours = std::move(loaded.data.contours);
    }
    if (!loaded.data.balls.empty()) data.balls = std::move(loaded.data.balls);
    std::ranges::move(loaded.warnings, std::back_inserter(out.warnings));
    // Other formats are read only: saving them means choosing a POFF file beside them.
    if (loaded.format == "poff") sample_file = reading->files[i];
    if (loaded.format == "wpoff") ball_file = reading->files[i];
  }
  out.file = out.files.front();
  if (blame(editor_.load(data))) return out;
  out.format = reading->results.front()->format;
  out.samples = data.positions.size();
  out.balls = data.balls.size();
  forget_files();
  sample_file_ = out.is_shape ? fs::path() : sample_file;
  ball_file_ = out.is_shape ? fs::path() : ball_file;
  file_ = sample_file_.empty() ? ball_file_ : sample_file_;
  note_all_as_saved();
  title_ = out.is_shape ? reading->title : out.file.filename().string();
  return out;
}

void FileDesk::start_empty() {
  cancel_reading();
  if (editor_.load({})) {
    forget_files();
    note_all_as_saved();
    title_ = "Untitled";
  }
}

void FileDesk::forget_files() {
  file_.clear();
  sample_file_.clear();
  ball_file_.clear();
  session_file_.clear();
}

Expected<void> FileDesk::take_over(const Session& session, const std::string& name) {
  DocumentReplay replay(editor_.document());
  if (auto done = replay_session(session, replay, name); !done) return done;
  editor_.restore(std::move(replay), session.data, session.entries);
  return {};
}

Expected<void> FileDesk::recover(const Session& session) {
  cancel_reading();
  if (auto done = take_over(session, "recovered work"); !done) return done;
  forget_files();
  saved_samples_ = Document().sample_digest();
  saved_balls_ = 0;
  editor_.mark_unsaved();
  title_ = session.title.empty() ? "Untitled" : session.title;
  return {};
}

void FileDesk::note_all_as_saved() {
  saved_samples_ = editor_.document().sample_digest();
  saved_balls_ = editor_.document().ball_digest();
}

FileDesk::Unsaved FileDesk::unsaved() const {
  if (has_session_file()) return {editor_.is_modified(), false};
  return {editor_.document().sample_digest() != saved_samples_, editor_.document().ball_digest() != saved_balls_};
}

Expected<void> FileDesk::write_samples() {
  auto written = write_file_atomically(sample_file_, write_poff(editor_.document()));
  if (written) saved_samples_ = editor_.document().sample_digest();
  return written;
}

Expected<void> FileDesk::write_balls() {
  auto written = write_file_atomically(ball_file_, write_wpoff(editor_.document()));
  if (written) saved_balls_ = editor_.document().ball_digest();
  return written;
}

Expected<void> FileDesk::write_session_file() {
  auto written = write_file_atomically(session_file_, write_session(session_now_()));
  if (!written) return written;
  note_all_as_saved();
  editor_.mark_saved();
  return {};
}

Expected<void> FileDesk::save() {
  if (has_session_file()) return write_session_file();
  if (!sample_file_.empty())
    if (auto written = write_samples(); !written) return written;
  if (!ball_file_.empty())
    if (auto written = write_balls(); !written) return written;
  if (const Unsaved rest = unsaved(); !rest.samples && !rest.balls) editor_.mark_saved();
  return {};
}

Expected<void> FileDesk::save_as(const fs::path& file) {
  const fs::path session_before = std::exchange(session_file_, is_session_file(file) ? file : fs::path());
  const std::string title_before = std::exchange(title_, file.filename().string());
  if (has_session_file()) {
    if (auto written = write_session_file(); !written) {
      session_file_ = session_before;
      title_ = title_before;
      return written;
    }
    forget_files();
    file_ = session_file_ = file;
    return {};
  }
  fs::path& target = is_ball_file(file) ? ball_file_ : sample_file_;
  const fs::path before = std::exchange(target, file);
  if (auto written = is_ball_file(file) ? write_balls() : write_samples(); !written) {
    target = before;
    session_file_ = session_before;
    title_ = title_before;
    return written;
  }
  if (const Unsaved rest = unsaved(); !rest.samples && !rest.balls) editor_.mark_saved();
  file_ = file;
  return {};
}

}  // namespace mes
