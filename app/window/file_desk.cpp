// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/file_desk.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <utility>

#include "core/io/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

bool is_ball_file(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".wpoff";
}

}  // namespace

FileDesk::FileDesk(Editor& editor, std::function<void()> wake) : editor_(editor), wake_(std::move(wake)) {
  note_all_as_saved();
}
FileDesk::~FileDesk() = default;

void FileDesk::begin(const fs::path& file, const std::string& shape_title) {
  cancel_reading();
  std::erase_if(given_up_, [](const auto& reading) { return reading->is_done.load(); });
  reading_ = std::make_unique<Reading>();
  reading_->file = file;
  reading_->title = shape_title;
  reading_->thread = std::jthread([reading = reading_.get(), wake = wake_] {
    try {
      reading->result = read_sample_file(reading->file);
    } catch (const std::bad_alloc&) {
      reading->result = std::unexpected(
          Error{ErrorCode::out_of_memory, "there is not enough memory for it", reading->file.string()});
    } catch (const std::exception& error) {
      reading->result = std::unexpected(Error{ErrorCode::bad_input, error.what(), reading->file.string()});
    }
    reading->is_done = true;
    if (wake) wake();
  });
}

void FileDesk::open(const fs::path& file) {
  begin(file, {});
}

void FileDesk::open_shape(const fs::path& file, const std::string& title) {
  begin(file, title);
}

void FileDesk::cancel_reading() {
  if (reading_) given_up_.push_back(std::move(reading_));
}

std::string FileDesk::reading_name() const {
  if (!reading_) return {};
  return reading_->title.empty() ? reading_->file.filename().string() : reading_->title;
}

std::optional<FileDesk::Outcome> FileDesk::poll() {
  if (!reading_ || !reading_->is_done) return std::nullopt;
  const std::unique_ptr<Reading> reading = std::move(reading_);
  reading->thread.join();
  Outcome out;
  out.file = reading->file;
  out.is_shape = !reading->title.empty();
  if (!reading->result) {
    out.error = reading->result.error();
    return out;
  }
  const LoadedFile& loaded = *reading->result;
  if (auto done = editor_.load(loaded.data); !done) {
    out.error = done.error();
    out.error->file = reading->file.string();
    return out;
  }
  out.format = loaded.format;
  out.samples = loaded.data.positions.size();
  out.balls = loaded.data.balls.size();
  out.warnings = loaded.warnings;
  // Other formats are read only: saving them means choosing a POFF file beside them.
  sample_file_ = !out.is_shape && loaded.format == "poff" ? reading->file : fs::path();
  ball_file_ = !out.is_shape && loaded.format == "wpoff" ? reading->file : fs::path();
  file_ = sample_file_.empty() ? ball_file_ : sample_file_;
  note_all_as_saved();
  title_ = out.is_shape ? reading->title : reading->file.filename().string();
  return out;
}

void FileDesk::start_empty() {
  cancel_reading();
  if (editor_.load({})) {
    file_.clear();
    sample_file_.clear();
    ball_file_.clear();
    note_all_as_saved();
    title_ = "Untitled";
  }
}

void FileDesk::note_all_as_saved() {
  saved_samples_ = editor_.document().sample_digest();
  saved_balls_ = editor_.document().ball_digest();
}

FileDesk::Unsaved FileDesk::unsaved() const {
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

Expected<void> FileDesk::save() {
  if (!sample_file_.empty())
    if (auto written = write_samples(); !written) return written;
  if (!ball_file_.empty())
    if (auto written = write_balls(); !written) return written;
  if (const Unsaved rest = unsaved(); !rest.samples && !rest.balls) editor_.mark_saved();
  return {};
}

Expected<void> FileDesk::save_as(const fs::path& file) {
  fs::path& target = is_ball_file(file) ? ball_file_ : sample_file_;
  const fs::path before = std::exchange(target, file);
  if (auto written = is_ball_file(file) ? write_balls() : write_samples(); !written) {
    target = before;
    return written;
  }
  if (const Unsaved rest = unsaved(); !rest.samples && !rest.balls) editor_.mark_saved();
  file_ = file;
  title_ = file.filename().string();
  return {};
}

}  // namespace mes
