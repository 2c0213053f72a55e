// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/file_desk.h"

#include <exception>

#include "core/io/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

FileDesk::FileDesk(Editor& editor, std::function<void()> wake) : editor_(editor), wake_(std::move(wake)) {}
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
  out.warnings = loaded.warnings;
  // Other formats are read only: saving them means choosing a POFF file beside them.
  file_ = !out.is_shape && loaded.format == "poff" ? reading->file : fs::path();
  title_ = out.is_shape ? reading->title : reading->file.filename().string();
  return out;
}

void FileDesk::start_empty() {
  cancel_reading();
  if (editor_.load({})) {
    file_.clear();
    title_ = "Untitled";
  }
}

Expected<void> FileDesk::save_as(const fs::path& file) {
  auto written = write_file_atomically(file, write_poff(editor_.document()));
  if (!written) return written;
  editor_.mark_saved();
  file_ = file;
  title_ = file.filename().string();
  return {};
}

}  // namespace mes
