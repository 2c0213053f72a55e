// SPDX-License-Identifier: GPL-3.0-or-later
// Which file the document belongs to; reading and writing it.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/editor.h"
#include "app/editing/prepared_document.h"
#include "app/store/file_conflict.h"
#include "app/system/background_job.h"
#include "core/base/job_control.h"
#include "core/graph/live_registry.h"
#include "core/io/format.h"
#include "core/io/session.h"

namespace mes {

/// What it guarantees:
///  1. Reading happens on a thread of its own, and so does the making of the document from what was read; until both end
///     well the document stays as it is, and a file that cannot be read leaves it so for good. `poll` takes over what
///     was made in O(1). The document may be edited meanwhile; what no file holds of that is not lost unasked:
///     where `would_lose_work`, `poll` waits for `give_up_work` or `cancel_reading`.
///  2. Saving is atomic, and writes a session, POFF or WPOFF, whatever was read. A session holds everything. A POFF
///     file holds samples and a WPOFF file balls, so a document of both has two files; until each holds what the
///     document holds, it counts as modified.
///  3. Writing happens on a thread of its own too, and saves the document as it was when that began. A file that
///     cannot be written leaves names and marks as they were. Whatever was begun is written before the object ends.
///  4. What is made in the program, and what a picture is traced into, is a document of its own, never the content of the
///     file that was open.
///  5. A file that something else has written to since it was opened or saved here is not overwritten: saving ends
///     with a conflict, and `overwrite` is the answer to it.
///
/// Smallest use:
///     desk.open("a.poff");
///     ... each frame: if (auto outcome = desk.poll()) show(*outcome);
///
/// Threads: the window's; `wake` is called from the reader's.
class FileDesk {
 public:
  /// `session_now` gives what a session file is to hold. Files are read by the formats of the registry.
  FileDesk(LiveRegistry registry, Editor& editor, std::function<Session()> session_now, Waker wake);
  ~FileDesk();

  /// Begins to read; a reading under way is given up. Of several files those are opened together that bring something
  /// else each: a file of samples and a file of balls are one document again. `degrees` of maps among them.
  void open(const std::vector<std::filesystem::path>& files, MapDegrees degrees = MapDegrees::projected);
  void open(const std::filesystem::path& file) { open(std::vector{file}); }
  /// The same for a built-in shape: it has a title, but saving asks for a file.
  void open_shape(const std::filesystem::path& file, const std::string& title);
  void cancel_reading();
  /// From `open` until `poll` says what became of it.
  bool is_reading() const { return reading_.is_under_way() || held_back_; }
  /// The thread that reads has ended.
  bool has_read() const { return reading_.has_ended() || held_back_; }
  /// Something was read, and in the document in its place something was done since `open` that no file holds.
  bool would_lose_work() const;
  /// That it is lost is wanted. What is done after this call is not meant.
  void give_up_work() { note_work(asked_); }
  std::string reading_name() const;
  /// Share of what is to be read, from 0 to 1, by bytes of the present file; 0 where nothing is read. Never goes
  /// back during a reading.
  double reading_progress() const;

  struct Outcome {
    std::filesystem::path file;                ///< the first one, or the one to blame
    std::vector<std::filesystem::path> files;  ///< that were opened
    std::size_t left_out = 0;                  ///< files that would have replaced what the first brought
    bool is_shape = false;
    bool is_made = false;                    ///< of samples that were made: no files
    bool is_recovered = false;               ///< work that was left behind: no files
    std::shared_ptr<const Session> session;  ///< if it was one; the document is the session's already
    std::string format;
    std::optional<MapDegrees> degrees;  ///< what became of longitude and latitude; none: there were none
    std::size_t samples = 0;
    std::size_t balls = 0;
    std::vector<std::string> warnings;
    std::string remark;  ///< on what was made
    std::optional<Error> error;
  };
  /// What became of the reading, once, when it has ended; nothing while it `would_lose_work`.
  std::optional<Outcome> poll();

  void start_empty();
  /// Begins to make a document of samples that were made in the program, or of a picture, as `open` does of files: it has
  /// this title, and no file holds it. `remark`: what there is to say when it is there.
  void open_made(std::shared_ptr<const SampleData> made, const std::string& title, const std::string& remark = {});
  /// Begins to make the document of work that a crash left behind, as `open` does of files: no file holds it.
  void recover(std::shared_ptr<const Session> work);
  /// Begins to write the session, or samples and balls, to the files they have. Waits for a writing under way.
  void save();
  /// The same for everything when the name ends in .json, for the balls when it ends in .wpoff, else for the samples.
  /// That is their file from then on.
  void save_as(const std::filesystem::path& file);
  /// Begins once more the saving that ended with this conflict. What is in the file now is given up, and nothing
  /// else: if the file changes again there is another conflict.
  void overwrite(const FileConflict& conflict);
  bool is_saving() const { return writing_.is_under_way(); }
  std::string saving_name() const;
  struct Saved {
    std::vector<std::filesystem::path> files;
    std::optional<Error> error;
    std::optional<FileConflict> conflict;  ///< nothing was written to this file
  };
  /// What became of the writing, once, when it has ended.
  std::optional<Saved> poll_saved();
  /// The same, and waits for it; nothing when none is under way.
  std::optional<Saved> finish_saving();
  /// What of the document no file holds as it is now.
  struct Unsaved {
    bool samples = false;
    bool balls = false;
    bool annotations = false;  ///< only sessions hold them
    bool lesson = false;       ///< and this
    bool any() const { return samples || balls || annotations || lesson; }
  };
  Unsaved unsaved() const;

  /// The file opened or saved last, if Save can write it; empty when a name must be asked for.
  const std::filesystem::path& file() const { return held_.file; }
  const std::filesystem::path& sample_file() const { return held_.sample_file; }
  const std::filesystem::path& ball_file() const { return held_.ball_file; }
  bool has_session_file() const { return !held_.session_file.empty(); }
  /// Of the window: "a.poff", "Elephant", "Untitled".
  const std::string& title() const { return held_.title; }

 private:
  /// What is asked for by `open`.
  struct Asked {
    std::vector<std::filesystem::path> files{};
    std::string title{};                         // of a shape, or of what was made
    std::shared_ptr<const SampleData> made{};    // no file
    std::string remark{};                        // on what was made
    std::shared_ptr<const Session> recovered{};  // no file
    MapDegrees degrees = MapDegrees::projected;
    std::shared_ptr<const Registry> registry{};
    Editor::Work work{};        // that there was then
    bool was_modified = false;  // so it was asked about
  };
  /// Of a reading, for the window: how far it is.
  struct Reading {
    JobControl control{};              // of the present part
    std::atomic<std::size_t> part{0};  // each file, the document, what is kept beside it
    double shown = 0.0;                // most that the window was given
    /// The control begins anew first, so that what is seen of it is never of the part before.
    void next_part() {
      control.reset_progress();
      ++part;
    }
  };
  /// What came of it, and the document that was made of that.
  struct ReadFiles {
    Outcome outcome{};  // an error: all else is empty
    std::vector<SourceFile> sources{};
    std::filesystem::path sample_file{};
    std::filesystem::path ball_file{};
    std::filesystem::path session_file{};
    std::shared_ptr<const SampleData> data{};
    Document start{};  // a successor of the editor's document, which `document` was made from
    std::unique_ptr<PreparedDocument> document{};
  };
  using ReadFilesPointer = std::shared_ptr<ReadFiles>;
  void begin(Asked asked);
  void note_work(Asked& asked) const;
  Document start() const;
  /// Makes the document once more, as the numbers left to the editor's did not last.
  void prepare_again(ReadFilesPointer read);
  Outcome take_over(ReadFiles& read);
  /// Destroys what was read on another thread, or on this one if no thread can be started.
  void drop(ReadFilesPointer read);
  static Expected<LoadedFile> read(const std::filesystem::path& file, const ReadRequest& request,
                                   JobControl& control);
  static void read(const Asked& asked, Reading& reading, ReadFiles& out);
  static void join(const Asked& asked, std::vector<LoadedFile> files, ReadFiles& out);
  static void prepare(Reading& reading, ReadFiles& out);
  /// Which files hold what.
  struct Held {
    std::filesystem::path file{};
    std::filesystem::path sample_file{};  // empty: none yet
    std::filesystem::path ball_file{};
    std::filesystem::path session_file{};
    std::uint64_t samples = 0;  // digests of what the files hold
    std::uint64_t balls = 0;
    std::shared_ptr<const Annotations> annotations = std::make_shared<const Annotations>();
    std::string title = "Untitled";
    std::map<std::filesystem::path, FileFingerprint>
        known{};  // what was in files when they were opened or saved here
  };
  struct Part {
    std::filesystem::path file;
    std::function<std::string()> text;
    std::optional<FileFingerprint> expected;
  };
  /// What is to be written, and what is true once it is.
  struct Saving {
    std::shared_ptr<const Registry> registry;  // what another program wrote to a file is read by its formats
    std::vector<Part> parts;
    Held after;
    std::uint64_t revision = 0;  // of the document that is written
    std::uint64_t lesson_revision = 0;
    bool is_whole = false;                 // the parts hold all of it
    std::shared_ptr<const SampleData> of;  // what was loaded
    std::shared_ptr<const Document> document;
    std::shared_ptr<const Session> session;  // null: not saved as one
  };
  struct Written {
    std::vector<SourceFile> files;
    std::optional<Error> error;
    std::optional<FileConflict> conflict;
    bool is_good() const { return !error && !conflict; }
  };
  void note_all_as_saved();
  void note_known(std::span<const SourceFile> files);
  /// What is held where no file is named yet, and the files hold this document.
  static Held held_by_files_of(const Document& document);
  static Held held_by_read_files(const ReadFiles& read, const std::string& title);
  void begin_saving(Held after);
  static Written write(const Saving& saving);
  Saved saved(Written written);
  static void write_part(const Saving& saving, const Part& part, Written& out);

  LiveRegistry registry_;
  Editor& editor_;
  std::function<Session()> session_now_;
  Held held_;
  std::optional<Held> contested_;         // what a saving that ended with a conflict would have led to
  Asked asked_;                           // while it is read
  ReadFilesPointer held_back_;            // what was read, while it would lose work
  std::shared_ptr<const Saving> saving_;  // while it is written
  std::shared_ptr<Reading> progress_;     // of the reading
  unsigned attempts_ = 0;                 // to make the document of it once more
  BackgroundJob<ReadFilesPointer> reading_;
  BackgroundJob<Written> writing_;
  BackgroundJob<bool> dropping_{{}};  // of the document before, which may be large
};

}  // namespace mes
