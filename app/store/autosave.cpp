// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/autosave.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <expected>
#include <utility>

#include "app/system/data_folder.h"
#include "core/io/files/file_lock.h"
#include "core/io/files/read_file.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".journal";

std::string local_time(std::time_t when, const char* format) {
  std::tm parts{};
  ::localtime_r(&when, &parts);
  std::array<char, 64> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), format, &parts);
  return {text.data(), length};
}

/// Renames the file to a free name, so that no file set aside before is lost. Empty: the file could not be renamed.
fs::path set_aside(const fs::path& file) {
  constexpr int kMostTwins = 10'000;
  for (int twin = 1; twin <= kMostTwins; ++twin) {
    fs::path aside = file.string() + (twin == 1 ? ".broken" : fmt::format(".broken-{}", twin));
    // The rename replaces this empty file, which no other program has made.
    const int reserved = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (reserved < 0 && errno == EEXIST) continue;
    if (reserved < 0) return {};
    ::close(reserved);
    if (::rename(file.c_str(), aside.c_str()) == 0) return aside;
    ::unlink(aside.c_str());
    return {};
  }
  return {};
}

/// Creates a new, locked file. If locking fails, no file is kept: another program would take it for left behind.
/// Error: errno.
std::expected<int, int> create_journal(const fs::path& folder, fs::path& file) {
  const std::string stem = fmt::format("{}-{}", local_time(std::time(nullptr), "%Y%m%d-%H%M%S"), ::getpid());
  for (int attempt = 0;; ++attempt) {
    file = folder / (stem + (attempt == 0 ? "" : fmt::format("-{}", attempt)) + kExtension);
    const auto created = create_locked(file, 0600);
    if (!created && created.error() == EEXIST) continue;
    if (!created) return std::unexpected(created.error());
    if (created->is_locked) return created->descriptor;
    ::unlink(file.c_str());
    ::close(created->descriptor);
    return std::unexpected(ENOLCK);
  }
}

/// Opens a journal and closes its descriptor at the end.
class OpenJournal {
 public:
  explicit OpenJournal(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenJournal() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenJournal(const OpenJournal&) = delete;
  OpenJournal& operator=(const OpenJournal&) = delete;

  /// True if the journal was left behind and no other program is offering it.
  bool is_left(const fs::path& file) const {
    return descriptor_ >= 0 && try_lock(descriptor_) == LockTry::locked && is_named(file, descriptor_);
  }
  Expected<std::string> text(const fs::path& file) const { return read_whole(descriptor_, file.string()); }
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

}  // namespace

/// The file being written. Text that could not be written is kept for the next attempt.
struct Autosave::Journal {
  int fd = -1;
  fs::path file;
  int superseded_fd = -1;  // descriptor of the previous journal, until this one is on the disk
  fs::path superseded;
  off_t length = 0;  // up to the last whole line
  std::string unwritten;
  bool is_wanted = false;

  Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal() {
    close();
    if (superseded_fd >= 0) ::close(superseded_fd);
  }

  void close() {
    if (fd >= 0) ::close(fd);
    fd = -1;
  }
  /// Keeps the file on the disk until its successor is there.
  void set_aside() {
    if (fd < 0) return;
    drop_superseded();
    superseded_fd = std::exchange(fd, -1);
    superseded = std::exchange(file, {});
  }
  void drop_superseded() {
    if (superseded_fd < 0) return;
    ::unlink(superseded.c_str());
    ::close(std::exchange(superseded_fd, -1));
  }
  void drop() {
    drop_superseded();
    if (fd >= 0) ::unlink(file.c_str());
    close();
    length = 0;
    unwritten.clear();
    is_wanted = false;
  }
  /// Writes the pending text. Returns errno, or 0 when all is written.
  int put(const fs::path& folder) {
    if (!is_wanted || unwritten.empty()) return 0;
    if (fd < 0) {
      std::error_code error;
      fs::create_directories(folder, error);
      const auto created = create_journal(folder, file);
      if (!created) return created.error();
      fd = *created;
    }
    std::size_t done = 0;
    while (done < unwritten.size()) {
      const ssize_t n =
          ::pwrite(fd, unwritten.data() + done, unwritten.size() - done, length + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) {
        const int error = n < 0 ? errno : ENOSPC;
        // If the first line does not fit, the journal is left empty: a part of it could not be read.
        return ::ftruncate(fd, length) == 0 ? error : errno;
      }
      done += static_cast<std::size_t>(n);
    }
    if (::fdatasync(fd) != 0) return errno;
    length += static_cast<off_t>(done);
    unwritten.clear();
    drop_superseded();
    return 0;
  }
};

Autosave::Autosave(fs::path folder, std::function<void()> wake, std::chrono::milliseconds gather)
    : folder_(std::move(folder)), wake_(std::move(wake)), gather_(gather) {
  if (!folder_.empty()) thread_ = std::jthread([this](const std::stop_token& stop) { write_on(stop); });
}

Autosave::~Autosave() = default;

void Autosave::follow(const Editor& editor, const std::function<Session()>& head,
                      const std::function<std::optional<SourceFile>()>& file) {
  if (folder_.empty()) return;
  const Timeline& timeline = editor.timeline();
  Work work;
  // The first line holds the lesson.
  const bool is_renewed = timeline.generation() == generation_ && timeline.lesson_revision() != lesson_revision_;
  lesson_revision_ = timeline.lesson_revision();
  if (timeline.generation() != generation_) {
    generation_ = timeline.generation();
    work.ends = std::exchange(has_journal_, false);
    told_ = 0;
    saved_ = 0;
  }
  if (!editor.is_modified()) saved_ = timeline.settled();
  if (has_journal_ && is_renewed) {
    work.renews = true;
    work.head = head();
    told_ = 0;
  }
  if (!has_journal_ && editor.is_modified() && (timeline.settled() > 0 || editor.is_lesson_modified())) {
    work.begins = has_journal_ = true;
    work.head = head();
    told_ = 0;
  }
  if (has_journal_ && told_ < timeline.settled()) {
    work.entries = timeline.entries().between(told_, timeline.settled());
    // These are the first entries of a new journal.
    if (told_ == 0) work.saved_entries = saved_;
    work.is_lesson_saved = !editor.is_lesson_modified();
    told_ = timeline.settled();
  }
  if (work.is_empty()) return;
  if ((work.begins || work.renews) && file) work.file = file();
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(work));
  }
  condition_.notify_all();
}

void Autosave::note_saved(const std::optional<SourceFile>& file) {
  if (!has_journal_) return;
  {
    const std::lock_guard lock(mutex_);
    Work& work = queue_.emplace_back();
    work.saved = true;
    work.file = file;
  }
  condition_.notify_all();
}

void Autosave::discard() {
  if (!has_journal_) return;
  has_journal_ = false;
  {
    const std::lock_guard lock(mutex_);
    queue_.emplace_back().ends = true;
  }
  flush();
}

std::string Autosave::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, {});
}

void Autosave::flush() {
  if (folder_.empty()) return;
  std::unique_lock lock(mutex_);
  hurry_ = true;
  condition_.notify_all();
  condition_.wait(lock, [this] { return queue_.empty() && !is_writing_; });
  hurry_ = false;
}

bool Autosave::holds_all() {
  if (!has_journal_) return false;
  const std::lock_guard lock(mutex_);
  const bool out = queue_.empty() && !is_writing_ && !has_failed_;
  is_awaited_ = !out;
  return out;
}

void Autosave::write(Work& work, Journal& journal) {
  if (work.ends) journal.drop();
  if (work.renews) {
    journal.set_aside();
    journal.length = 0;
    journal.unwritten = write_journal_head(work.head);
  }
  if (work.begins) {
    journal.drop();
    journal.is_wanted = true;
    journal.unwritten = write_journal_head(work.head);
  }
  if (work.file && !work.saved) journal.unwritten += write_journal_file(*work.file);
  for (std::size_t i = 0; i < work.entries.size(); ++i) {
    journal.unwritten += write_journal_line(work.entries[i]);
    if (i + 1 == work.saved_entries)
      journal.unwritten += work.is_lesson_saved ? write_journal_saved() : write_journal_edits_saved();
  }
  if (work.saved) journal.unwritten += write_journal_saved(work.file);
}

void Autosave::write_on(const std::stop_token& stop) {
  Journal journal;
  bool has_complained = false;
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested() || !queue_.empty()) {
    condition_.wait(lock, stop, [this] { return !queue_.empty(); });
    condition_.wait_for(lock, stop, gather_, [this] { return hurry_; });
    std::vector<Work> works = std::exchange(queue_, {});
    is_writing_ = true;
    lock.unlock();
    for (Work& work : works) write(work, journal);
    const int error = journal.put(folder_);
    lock.lock();
    is_writing_ = false;
    has_failed_ = error != 0;
    if (error == 0) {
      has_complained = false;
      if (std::exchange(is_awaited_, false) && wake_) wake_();
    } else if (!std::exchange(has_complained, true)) {
      problem_ = fmt::format("unsaved work is not protected against a crash: {}: {}", folder_.string(),
                             std::strerror(error));
      if (wake_) wake_();
    }
    condition_.notify_all();
  }
}

fs::path default_autosave_folder() {
  const fs::path folder = data_folder();
  return folder.empty() ? folder : folder / "autosave";
}

LeftWork::LeftWork(fs::path file, int lock, Journaled journal)
    : file_(std::move(file)),
      lock_(lock),
      session_(std::make_shared<const Session>(std::move(journal.session))),
      edits_(journal.unsaved_edits),
      kept_in_(std::move(journal.file)),
      is_partial_(!journal.complaint.empty()) {
  struct stat status {};
  if (::stat(file_.c_str(), &status) == 0) when_ = local_time(status.st_mtime, "%Y-%m-%d %H:%M");
}

LeftWork::~LeftWork() {
  if (lock_ >= 0) ::close(lock_);
}

LeftWork::LeftWork(LeftWork&& other) noexcept
    : file_(std::move(other.file_)),
      lock_(std::exchange(other.lock_, -1)),
      session_(std::move(other.session_)),
      edits_(other.edits_),
      kept_in_(std::move(other.kept_in_)),
      is_partial_(other.is_partial_),
      when_(std::move(other.when_)) {}

LeftWork& LeftWork::operator=(LeftWork&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(lock_, other.lock_);
  std::swap(session_, other.session_);
  std::swap(edits_, other.edits_);
  std::swap(kept_in_, other.kept_in_);
  std::swap(is_partial_, other.is_partial_);
  std::swap(when_, other.when_);
  return *this;
}

std::string LeftWork::name() const {
  if (kept_in_) return kept_in_->path.filename().string();
  return session_->title.empty() ? "Untitled" : session_->title;
}

void LeftWork::remove() {
  std::error_code error;
  if (is_partial_)
    set_aside(file_);
  else
    fs::remove(file_, error);
}

FoundWork find_left_work(const fs::path& folder, const std::stop_token& stop) {
  FoundWork out;
  JobControl job(stop);
  std::error_code error;
  std::vector<fs::path> files;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (entry->path().extension() == kExtension) files.push_back(entry->path());
  std::ranges::sort(files, std::ranges::greater());
  for (const fs::path& file : files) {
    OpenJournal open(file);
    if (!open.is_left(file)) continue;
    const auto text = open.text(file);
    // It may become readable later.
    if (!text) continue;
    auto journal = read_journal(*text, file.string(), &job);
    if (!journal && !text->empty()) {
      const fs::path aside = set_aside(file);
      out.message = fmt::format("work that was left unsaved cannot be read ({}); it is kept as {}",
                                journal.error().text, (aside.empty() ? file : aside).string());
    } else if (!journal || journal->unsaved_edits == 0) {
      ::unlink(file.c_str());
    } else {
      if (!journal->complaint.empty())
        out.message = "some of the work that was left unsaved cannot be read: " + journal->complaint;
      out.works.emplace_back(file, open.release(), std::move(*journal));
    }
  }
  return out;
}

}  // namespace mes
