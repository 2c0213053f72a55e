// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/file_desk.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

bool is_ball_file(const fs::path& file) {
  return lower_case_extension(file) == ".wpoff";
}

bool is_session_file(const fs::path& file) {
  return lower_case_extension(file) == ".json";
}

/// However the file was named. Links are not followed: one that leads elsewhere now holds something else.
fs::path key_of(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  return (error ? file : absolute).lexically_normal();
}

}  // namespace

FileDesk::FileDesk(Editor& editor, std::function<Session()> session_now, std::function<void()> wake)
    : editor_(editor), session_now_(std::move(session_now)), wake_(std::move(wake)) {
  note_all_as_saved();
}
FileDesk::~FileDesk() = default;

void FileDesk::read(Reading& reading, const std::stop_token& stop) {
  for (const fs::path& file : reading.files) {
    try {
      reading.results.push_back(read_sample_file(file, {}, stop));
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
  reading_->thread = std::jthread([reading = reading_.get(), wake = wake_](const std::stop_token& stop) {
    read(*reading, stop);
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
  if (!reading_) return;
  reading_->thread.request_stop();
  given_up_.push_back(std::move(reading_));
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
    held_.file = held_.session_file = out.file;
    note_known(first.sources);
    note_all_as_saved();
    held_.title = out.file.filename().string();
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
  held_.sample_file = out.is_shape ? fs::path() : sample_file;
  held_.ball_file = out.is_shape ? fs::path() : ball_file;
  for (const auto& loaded : reading->results) note_known(loaded->sources);
  held_.file = held_.sample_file.empty() ? held_.ball_file : held_.sample_file;
  note_all_as_saved();
  held_.title = out.is_shape ? reading->title : out.file.filename().string();
  return out;
}

void FileDesk::start_empty() {
  cancel_reading();
  if (editor_.load({})) {
    forget_files();
    note_all_as_saved();
    held_.title = "Untitled";
  }
}

void FileDesk::note_known(std::span<const SourceFile> files) {
  for (const SourceFile& file : files) held_.known[key_of(file.path)] = file.fingerprint;
}

void FileDesk::forget_files() {
  contested_.reset();
  held_ = {.samples = held_.samples, .balls = held_.balls, .title = held_.title};
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
  held_.samples = Document().sample_digest();
  held_.balls = Document().ball_digest();
  editor_.mark_unsaved();
  held_.title = session.title.empty() ? "Untitled" : session.title;
  return {};
}

void FileDesk::note_all_as_saved() {
  held_.samples = editor_.document().sample_digest();
  held_.balls = editor_.document().ball_digest();
}

FileDesk::Unsaved FileDesk::unsaved() const {
  if (has_session_file()) return {editor_.is_modified(), false};
  return {editor_.document().sample_digest() != held_.samples, editor_.document().ball_digest() != held_.balls};
}

void FileDesk::save() {
  begin_saving(held_);
}

void FileDesk::save_as(const fs::path& file) {
  Held after = held_;
  after.title = file.filename().string();
  if (is_session_file(file)) {
    after.sample_file.clear();
    after.ball_file.clear();
    after.session_file = file;
  } else {
    after.session_file.clear();
    (is_ball_file(file) ? after.ball_file : after.sample_file) = file;
  }
  after.file = file;
  begin_saving(std::move(after));
}

void FileDesk::overwrite(const FileConflict& conflict) {
  if (!contested_) return;
  Held after = std::move(*contested_);
  const fs::path key = key_of(conflict.file);
  if (conflict.found)
    after.known[key] = *conflict.found;
  else
    after.known.erase(key);
  begin_saving(std::move(after));
}

// `after` says which files there are; of them those are written that are new, or all if none is.
void FileDesk::begin_saving(Held after) {
  finish_saving();
  contested_.reset();
  saving_ = std::make_unique<Saving>();
  Saving& saving = *saving_;
  const Document& now = editor_.document();
  saving.of = editor_.timeline().data();
  saving.revision = now.revision();
  saving.document = std::make_shared<const Document>(now);
  const bool is_new = after.file != held_.file || after.sample_file != held_.sample_file ||
                      after.ball_file != held_.ball_file || after.session_file != held_.session_file;
  const auto add = [&](const fs::path& file, std::function<std::string()> text) {
    const auto known = after.known.find(key_of(file));
    saving.parts.push_back(
        {file, std::move(text), known == after.known.end() ? std::nullopt : std::optional(known->second)});
  };
  if (!after.session_file.empty()) {
    saving.session = std::make_shared<const Session>(session_now_());
    add(after.session_file, [session = saving.session] { return write_session(*session); });
    after.samples = now.sample_digest();
    after.balls = now.ball_digest();
    saving.is_whole = true;
  } else {
    const auto is_wanted = [&](const fs::path& file) { return !file.empty() && (!is_new || file == after.file); };
    if (is_wanted(after.sample_file)) {
      add(after.sample_file, [document = saving.document] { return write_poff(*document); });
      after.samples = now.sample_digest();
    }
    if (is_wanted(after.ball_file)) {
      add(after.ball_file, [document = saving.document] { return write_wpoff(*document); });
      after.balls = now.ball_digest();
    }
    saving.is_whole = after.samples == now.sample_digest() && after.balls == now.ball_digest();
  }
  saving.after = std::move(after);
  saving.thread = std::jthread([&saving, wake = wake_] {
    write(saving);
    saving.is_done = true;
    if (wake) wake();
  });
}

// False: there is an error or a conflict.
bool FileDesk::write_part(Saving& saving, const Part& part) {
  const std::string text = part.text();
  if (part.expected) {
    const auto written = replace_file(part.file, text, *part.expected);
    if (!written) saving.error = written.error();
    if (written == Replaced::changed) saving.conflict = look_into(part.file, *saving.document, saving.session.get());
  } else if (const auto written = write_file_atomically(part.file, text); !written) {
    saving.error = written.error();
  }
  if (saving.error || saving.conflict) return false;
  // What went into a pipe is not there to be compared with.
  std::error_code error;
  if (fs::is_regular_file(part.file, error)) saving.written.push_back({part.file, fingerprint_of(text)});
  return true;
}

void FileDesk::write(Saving& saving) {
  const fs::path* at = nullptr;
  try {
    // Of two files none is written while there is a question about the other.
    for (const Part& part : saving.parts) {
      at = &part.file;
      if (!part.expected || is_as_expected(part.file, *part.expected)) continue;
      saving.conflict = look_into(part.file, *saving.document, saving.session.get());
      return;
    }
    for (const Part& part : saving.parts) {
      at = &part.file;
      if (!write_part(saving, part)) return;
    }
  } catch (const std::bad_alloc&) {
    saving.error = Error{ErrorCode::out_of_memory, "there is not enough memory to write it", at->string()};
  }
}

std::string FileDesk::saving_name() const {
  return saving_ ? saving_->after.file.filename().string() : std::string();
}

std::optional<FileDesk::Saved> FileDesk::poll_saved() {
  return saving_ && saving_->is_done ? finish_saving() : std::nullopt;
}

std::optional<FileDesk::Saved> FileDesk::finish_saving() {
  if (!saving_) return std::nullopt;
  const std::unique_ptr<Saving> saving = std::move(saving_);
  saving->thread.join();
  Saved out{{}, std::move(saving->error), std::move(saving->conflict)};
  for (const Part& part : saving->parts) out.files.push_back(part.file);
  // Something else may have been opened meanwhile.
  if (saving->of != editor_.timeline().data()) return out;
  if (out.conflict) contested_ = std::move(saving->after);
  if (!out.error && !out.conflict) held_ = std::move(saving->after);
  note_known(saving->written);
  if (out.error || out.conflict) return out;
  if (saving->is_whole) editor_.mark_saved(saving->revision);
  editor_.set_saved_layers(saving->session ? std::optional(saving->session->layers) : std::nullopt);
  return out;
}

}  // namespace mes
