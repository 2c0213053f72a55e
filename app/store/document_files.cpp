// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/document_files.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/files/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

bool is_ball_file(const fs::path& file) {
  return lower_case_extension(file) == ".wpoff";
}

bool is_session_file(const fs::path& file) {
  return lower_case_extension(file) == ".json";
}

/// One key however the file was named. Links are not followed: a link that changes its target has other contents.
fs::path key_of(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  return (error ? file : absolute).lexically_normal();
}

/// Reads; exceptions become errors.
template <class Read>
Expected<LoadedFile> guarded(const std::string& name, Read read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory for it", name});
  } catch (const std::exception& error) {
    return std::unexpected(Error{ErrorCode::bad_input, error.what(), name});
  }
}

}  // namespace

void name_briefly(std::vector<std::string>& messages, const fs::path& file) {
  const std::string whole = file.string();
  const std::string name = file.filename().string();
  bool is_named = false;
  for (std::string& message : messages) {
    if (!message.starts_with(whole)) continue;
    const bool has_no_line = message.substr(whole.size()).starts_with(": ");
    if (has_no_line && is_named)
      message.erase(0, whole.size() + 2);
    else
      message.replace(0, whole.size(), name);
    is_named = true;
  }
}

DocumentFiles::DocumentFiles(LiveRegistry registry, Editor& editor, std::function<Session()> session_now, Waker wake)
    : registry_(std::move(registry)),
      editor_(editor),
      session_now_(std::move(session_now)),
      reading_(wake),
      writing_(std::move(wake)) {
  note_all_as_saved();
}
DocumentFiles::~DocumentFiles() = default;

Expected<LoadedFile> DocumentFiles::read(const fs::path& file, const ReadRequest& request, JobControl& control) {
  return guarded(file.string(), [&] { return read_sample_file(file, {}, &control, request); });
}

void DocumentFiles::read(const Asked& asked, Reading& reading, ReadFiles& out) {
  if (asked.recovered) {
    out.outcome.file = "recovered work";
    out.outcome.is_recovered = true;
    out.outcome.session = asked.recovered;
    out.data = asked.recovered->data;
    return prepare(reading, out);
  }
  if (asked.made) {
    out.outcome.file = asked.title;
    out.outcome.is_made = true;
    out.outcome.remark = asked.remark;
    out.data = asked.made;
    return prepare(reading, out);
  }
  if (asked.text) return read_text(asked, reading, out);
  out.outcome.is_shape = !asked.title.empty();
  std::vector<LoadedFile> files;
  for (const fs::path& file : asked.files) {
    out.outcome.file = file;
    auto loaded =
        read(file, {.degrees = asked.degrees, .system = asked.system, .formats = &asked.registry->formats()},
             reading.control);
    if (!loaded) {
      out.outcome.error = std::move(loaded.error());
      return;
    }
    files.push_back(std::move(*loaded));
    reading.next_part();
  }
  join(asked, std::move(files), out);
  prepare(reading, out);
}

void DocumentFiles::read_text(const Asked& asked, Reading& reading, ReadFiles& out) {
  Outcome& outcome = out.outcome;
  outcome.file = asked.title;
  outcome.is_made = true;
  auto loaded = guarded(asked.title, [&] {
    return read_sample_bytes(*asked.text, asked.title, {},
                             {.degrees = asked.degrees, .formats = &asked.registry->formats()}, &reading.control);
  });
  if (!loaded) {
    outcome.error = std::move(loaded.error());
    return;
  }
  outcome.format = loaded->format;
  outcome.session = loaded->session;
  outcome.degrees = loaded->degrees;
  outcome.has_added_samples = loaded->has_added_samples;
  outcome.warnings = std::move(loaded->warnings);
  out.data = outcome.session ? outcome.session->data : std::make_shared<const SampleData>(std::move(loaded->data));
  prepare(reading, out);
}

void DocumentFiles::join(const Asked& asked, std::vector<LoadedFile> files, ReadFiles& out) {
  Outcome& outcome = out.outcome;
  outcome.format = files.front().format;
  outcome.system = asked.system;
  if (LoadedFile& first = files.front(); first.session) {
    outcome.file = asked.files.front();
    outcome.session = first.session;
    outcome.files = {outcome.file};
    outcome.left_out = asked.files.size() - 1;
    out.data = first.session->data;
    // Saving must not overwrite a picture, nor a file that comes with the program.
    if (!first.is_carried && !outcome.is_shape) out.session_file = outcome.file;
    out.sources = std::move(first.sources);
    outcome.warnings = std::move(first.warnings);
    return;
  }
  SampleData data;
  for (std::size_t i = 0; i < files.size(); ++i) {
    LoadedFile& loaded = files[i];
    std::ranges::move(loaded.sources, std::back_inserter(out.sources));
    const bool brings_known = (!loaded.data.positions.empty() && !data.positions.empty()) ||
                              (!loaded.data.balls.empty() && !data.balls.empty());
    if (i != 0 && (brings_known || (loaded.data.positions.empty() && loaded.data.balls.empty()))) {
      ++outcome.left_out;
      continue;
    }
    outcome.files.push_back(asked.files[i]);
    if (!loaded.data.positions.empty()) {
      data.positions = std::move(loaded.data.positions);
      data.contours = std::move(loaded.data.contours);
      data.source = std::move(loaded.data.source);
      data.map = loaded.data.map;
      outcome.degrees = loaded.degrees;
      outcome.has_added_samples = loaded.has_added_samples;
    }
    if (!loaded.data.balls.empty()) data.balls = std::move(loaded.data.balls);
    std::ranges::move(loaded.warnings, std::back_inserter(outcome.warnings));
    // Other formats are read-only: saving asks for a POFF file beside them.
    if (outcome.is_shape) continue;
    if (loaded.format == "poff") out.sample_file = asked.files[i];
    if (loaded.format == "wpoff") out.ball_file = asked.files[i];
  }
  outcome.file = outcome.files.front();
  out.data = std::make_shared<const SampleData>(std::move(data));
}

void DocumentFiles::prepare(Reading& reading, ReadFiles& out) {
  const auto blame = [&out](Error error) {
    error.file = out.outcome.file.string();
    out.outcome.error = std::move(error);
  };
  try {
    DocumentReplay replay(out.start);
    const Session* const session = out.outcome.session.get();
    const auto done = session != nullptr
                          ? replay_session(*session, replay, out.outcome.file.string(), &reading.control)
                          : replay.begin(*out.data);
    if (!done) return blame(done.error());
    reading.next_part();
    out.document = std::make_unique<PreparedDocument>(
        std::move(replay), out.data, session != nullptr ? session->entries : TimelineLog(),
        session != nullptr ? session->lesson : Lesson(), &reading.control);
  } catch (const std::bad_alloc&) {
    blame({ErrorCode::out_of_memory, "there is not enough memory for it", {}});
  } catch (const Cancelled&) {
    blame({ErrorCode::cancelled, "stopped", {}});
  } catch (const std::exception& error) {
    blame({ErrorCode::bad_input, error.what(), {}});
  }
}

void DocumentFiles::begin(Asked asked) {
  cancel_reading();
  note_work(asked);
  asked.registry = registry_.share();
  attempts_ = 0;
  asked_ = std::move(asked);
  progress_ = std::make_shared<Reading>();
  reading_.begin([asked = asked_, start = start(), reading = progress_](const std::stop_token& stop) {
    reading->control.set_token(stop);
    auto out = std::make_shared<ReadFiles>(ReadFiles{.start = start});
    read(asked, *reading, *out);
    return out;
  });
}

void DocumentFiles::note_work(Asked& asked) const {
  asked.work = editor_.work();
  asked.was_modified = editor_.is_modified();
}

// Leaves so many ids free that edits by hand meanwhile, or an evolution that moves samples, cannot use them up. One
// that adds samples can, so each attempt leaves more, up to a number that takes longer to add than the file takes to
// read.
Document DocumentFiles::start() const {
  const unsigned bits = std::min(16U + 4U * attempts_, 24U);
  return successor_of(editor_.document(), {.revisions = std::uint64_t{1} << 32U, .ids = std::uint32_t{1} << bits});
}

void DocumentFiles::open(const std::vector<fs::path>& files, MapDegrees degrees, const std::string& system) {
  if (!files.empty()) begin({.files = files, .degrees = degrees, .system = system});
}

void DocumentFiles::open_shape(const fs::path& file, const std::string& title) {
  begin({.files = {file}, .title = title});
}

void DocumentFiles::open_made(std::shared_ptr<const SampleData> made, const std::string& title,
                              const std::string& remark) {
  begin({.title = title, .made = std::move(made), .remark = remark});
}

void DocumentFiles::open_text(std::string text, const std::string& title, MapDegrees degrees) {
  begin({.title = title, .text = std::make_shared<const std::string>(std::move(text)), .degrees = degrees});
}

void DocumentFiles::recover(std::shared_ptr<const Session> work, const std::optional<SourceFile>& file) {
  begin({.recovered = std::move(work), .kept_in = file});
}

void DocumentFiles::cancel_reading() {
  reading_.give_up();
  if (held_back_) drop(std::exchange(held_back_, nullptr));
}

std::string DocumentFiles::reading_name() const {
  if (!is_reading()) return {};
  if (asked_.recovered) return "work that was left";
  return asked_.title.empty() ? asked_.files.front().filename().string() : asked_.title;
}

double DocumentFiles::reading_progress() const {
  if (!is_reading()) return 0.0;
  constexpr double kReplayed = 0.5;  // share of the work after reading
  const double read = asked_.files.empty() ? 0.0 : 0.9;
  const auto files = static_cast<double>(asked_.files.size());
  const auto part = static_cast<double>(progress_->part);
  const double done = std::min(progress_->control.progress(), 1.0);
  double all = 0.0;
  if (part < files)
    all = read * (part + done) / files;
  else if (part == files)
    all = read + (1.0 - read) * kReplayed * done;
  else
    all = read + (1.0 - read) * (kReplayed + (1.0 - kReplayed) * done);
  return progress_->shown = std::max(progress_->shown, all);
}

bool DocumentFiles::would_lose_work() const {
  if (!held_back_ || held_back_->outcome.error || !editor_.is_modified()) return false;
  return !asked_.was_modified || editor_.work() != asked_.work;
}

std::optional<DocumentFiles::Outcome> DocumentFiles::poll() {
  if (auto ended = reading_.poll()) held_back_ = std::move(*ended);
  if (!held_back_ || would_lose_work()) return std::nullopt;
  ReadFilesPointer read = std::exchange(held_back_, nullptr);
  if (!read->outcome.error && !editor_.fits(read->start)) {
    prepare_again(std::move(read));
    return std::nullopt;
  }
  Outcome out = take_over(*read);
  drop(std::move(read));
  return out;
}

void DocumentFiles::prepare_again(ReadFilesPointer read) {
  ++attempts_;
  read->start = start();
  reading_.begin([read = std::move(read), reading = progress_](const std::stop_token& stop) {
    reading->control.set_token(stop);
    read->document.reset();
    prepare(*reading, *read);
    return read;
  });
}

DocumentFiles::Outcome DocumentFiles::take_over(ReadFiles& read) {
  const Asked asked = std::exchange(asked_, {});
  Outcome& out = read.outcome;
  if (out.error) return std::move(out);
  // Steps that allocate come first, so that either everything is taken over or nothing.
  try {
    out.samples = read.document->document().sample_count();
    out.balls = read.document->document().ball_count();
    Held after = held_by_read_files(read, asked.title);
    if (out.is_recovered && asked.kept_in) {
      keep_in(asked.kept_in->path, after);
      after.known[key_of(asked.kept_in->path)] = asked.kept_in->fingerprint;
    }
    if (out.session)
      editor_.restore(*read.document);
    else
      editor_.load(*read.document);
    if (out.is_recovered || out.is_made) editor_.mark_unsaved();
    contested_.reset();
    std::swap(held_, after);
  } catch (const std::bad_alloc&) {
    out.error = Error{ErrorCode::out_of_memory, "there is not enough memory for it", {}};
  }
  return std::move(out);
}

void DocumentFiles::drop(ReadFilesPointer read) {
  try {
    dropping_.begin([what = std::move(read)](const std::stop_token&) mutable {
      what.reset();
      return true;
    });
  } catch (const std::exception&) {
    // The failed call has already destroyed the data.
  }
}

DocumentFiles::Held DocumentFiles::held_by_files_of(const Document& document) {
  return {
      .samples = document.sample_digest(), .balls = document.ball_digest(), .annotations = document.annotations()};
}

DocumentFiles::Held DocumentFiles::held_by_read_files(const ReadFiles& read, const std::string& title) {
  const Outcome& out = read.outcome;
  if (out.is_recovered || out.is_made) {
    Held none = held_by_files_of(Document());
    const std::string& named = out.is_made ? title : out.session->title;
    if (!named.empty()) none.title = named;
    return none;
  }
  Held after = held_by_files_of(read.document->document());
  after.sample_file = read.sample_file;
  after.ball_file = read.ball_file;
  after.session_file = read.session_file;
  after.file = out.session ? after.session_file : (after.sample_file.empty() ? after.ball_file : after.sample_file);
  for (const SourceFile& file : read.sources) after.known[key_of(file.path)] = file.fingerprint;
  after.title = out.is_shape ? title : out.file.filename().string();
  return after;
}

void DocumentFiles::start_empty() {
  cancel_reading();
  Held after = held_by_files_of(Document());
  if (!editor_.load({})) return;
  contested_.reset();
  std::swap(held_, after);
}

void DocumentFiles::note_known(std::span<const SourceFile> files) {
  for (const SourceFile& file : files) held_.known[key_of(file.path)] = file.fingerprint;
}

void DocumentFiles::note_all_as_saved() {
  held_.samples = editor_.document().sample_digest();
  held_.balls = editor_.document().ball_digest();
  held_.annotations = editor_.document().annotations();
}

DocumentFiles::Unsaved DocumentFiles::unsaved() const {
  if (has_session_file()) return {.samples = editor_.is_modified()};
  const Document& now = editor_.document();
  return {now.sample_digest() != held_.samples, now.ball_digest() != held_.balls,
          *now.annotations() != *held_.annotations, editor_.is_lesson_modified()};
}

void DocumentFiles::save() {
  begin_saving(held_);
}

std::optional<SourceFile> DocumentFiles::kept_in() const {
  const auto known = held_.known.find(key_of(held_.file));
  if (held_.file.empty() || known == held_.known.end()) return std::nullopt;
  Held again;
  keep_in(held_.file, again);
  if (again.session_file != held_.session_file || again.sample_file != held_.sample_file ||
      again.ball_file != held_.ball_file)
    return std::nullopt;
  std::error_code error;
  const fs::path whole = fs::absolute(held_.file, error);
  return SourceFile{error ? held_.file : whole, known->second};
}

void DocumentFiles::keep_in(const fs::path& file, Held& after) {
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
}

void DocumentFiles::save_as(const fs::path& file) {
  Held after = held_;
  keep_in(file, after);
  begin_saving(std::move(after));
}

void DocumentFiles::overwrite(const FileConflict& conflict) {
  if (!contested_) return;
  Held after = std::move(*contested_);
  const fs::path key = key_of(conflict.file);
  if (conflict.found)
    after.known[key] = *conflict.found;
  else
    after.known.erase(key);
  begin_saving(std::move(after));
}

// Writes the files of `after` that are new, or all of them if none is new.
void DocumentFiles::begin_saving(Held after) {
  finish_saving();
  contested_.reset();
  Saving saving;
  saving.registry = registry_.share();
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
    saving.lesson_revision = editor_.timeline().lesson_revision();
    add(after.session_file, [session = saving.session] { return write_session(*session); });
    after.samples = now.sample_digest();
    after.balls = now.ball_digest();
    after.annotations = now.annotations();
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
    saving.is_whole = after.samples == now.sample_digest() && after.balls == now.ball_digest() &&
                      *after.annotations == *now.annotations();
  }
  saving.after = std::move(after);
  saving_ = std::make_shared<const Saving>(std::move(saving));
  // The write ignores its stop token, so it is always completed.
  writing_.begin([what = saving_](const std::stop_token&) { return write(*what); });
}

void DocumentFiles::write_part(const Saving& saving, const Part& part, Written& out) {
  const std::string text = part.text();
  if (part.expected) {
    const auto written = replace_file(part.file, text, *part.expected);
    if (!written) out.error = written.error();
    if (written == Replaced::changed)
      out.conflict = look_into(part.file, *saving.document, saving.session.get(), saving.registry->formats());
  } else if (const auto written = write_file_atomically(part.file, text); !written) {
    out.error = written.error();
  }
  // Only a regular file can be compared later; a pipe cannot.
  std::error_code error;
  if (out.is_good() && fs::is_regular_file(part.file, error)) out.files.push_back({part.file, fingerprint_of(text)});
}

DocumentFiles::Written DocumentFiles::write(const Saving& saving) {
  Written out;
  const fs::path* at = nullptr;
  try {
    // If one of two files is in conflict, neither is written.
    for (const Part& part : saving.parts) {
      at = &part.file;
      if (!part.expected || is_as_expected(part.file, *part.expected)) continue;
      out.conflict = look_into(part.file, *saving.document, saving.session.get(), saving.registry->formats());
      return out;
    }
    for (const Part& part : saving.parts) {
      at = &part.file;
      write_part(saving, part, out);
      if (!out.is_good()) break;
    }
  } catch (const std::bad_alloc&) {
    out.error = Error{ErrorCode::out_of_memory, "there is not enough memory to write it", at->string()};
  }
  return out;
}

std::string DocumentFiles::saving_name() const {
  return is_saving() ? saving_->after.file.filename().string() : std::string();
}

std::optional<DocumentFiles::Saved> DocumentFiles::poll_saved() {
  auto written = writing_.poll();
  return written ? std::optional(saved(std::move(*written))) : std::nullopt;
}

std::optional<DocumentFiles::Saved> DocumentFiles::finish_saving() {
  auto written = writing_.finish();
  return written ? std::optional(saved(std::move(*written))) : std::nullopt;
}

DocumentFiles::Saved DocumentFiles::saved(Written written) {
  const std::shared_ptr<const Saving> saving = std::move(saving_);
  Saved out{{}, std::move(written.error), std::move(written.conflict)};
  for (const Part& part : saving->parts) out.files.push_back(part.file);
  // Another document may have been opened meanwhile.
  if (saving->of != editor_.timeline().data()) return out;
  if (out.conflict) contested_ = saving->after;
  if (!out.error && !out.conflict) held_ = saving->after;
  note_known(written.files);
  if (out.error || out.conflict) return out;
  if (saving->is_whole) editor_.mark_saved(saving->revision);
  if (saving->session) editor_.mark_lesson_saved(saving->lesson_revision);
  editor_.set_saved_layers(saving->session ? std::optional(saving->session->layers) : std::nullopt);
  return out;
}

}  // namespace mes
