// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the document, and knows which files belong to it.
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
#include "core/base/jobs/job_control.h"
#include "core/graph/live_registry.h"
#include "core/io/format.h"
#include "core/io/session/session.h"

namespace mes {

/// Guarantees:
///  1. Reading a file, and making a document from it, happen on a thread of their own. Until both have ended well,
///     the document stays as it is; a file that cannot be read changes nothing. `poll` takes the new document over in
///     O(1). The document may be edited meanwhile. Unsaved edits are not lost without asking: if `would_lose_work`,
///     `poll` waits for `give_up_work` or `cancel_reading`.
///  2. Saving is atomic, and writes a session, POFF or WPOFF, whatever format was read. A session holds everything. A
///     POFF file holds samples and a WPOFF file balls, so a document of both has two files; it counts as modified
///     until both files hold what it holds.
///  3. Writing happens on a thread of its own too, and saves the document as it was at the call. If a file cannot be
///     written, names and marks stay as they were. The destructor waits until all writing is done.
///  4. Samples made in the program or traced from a picture are a document of their own, never the content of the
///     file that was open.
///  5. A file that another program has written to since it was opened or saved here is not overwritten: saving ends
///     with a conflict, which `overwrite` resolves.
///
/// Smallest use:
///     files.open("a.poff");
///     ... each frame: if (auto outcome = files.poll()) show(*outcome);
///
/// Threads: the window's; `wake` is called from the reader's.
class DocumentFiles {
 public:
  /// `session_now` returns the content for a session file. Files are read by the formats of the registry.
  DocumentFiles(LiveRegistry registry, Editor& editor, std::function<Session()> session_now, Waker wake);
  ~DocumentFiles();

  /// Begins to read, and gives up a reading under way. Several files are opened together if each adds different data:
  /// a file of samples and a file of balls are one document again. `degrees` applies to maps among them, and `system` is
  /// as `ReadRequest::system`.
  void open(const std::vector<std::filesystem::path>& files, MapDegrees degrees = MapDegrees::projected,
            const std::string& system = {});
  void open(const std::filesystem::path& file) { open(std::vector{file}); }
  /// The same for a built-in shape, which has a title; saving it asks for a file.
  void open_shape(const std::filesystem::path& file, const std::string& title);
  void cancel_reading();
  /// True from `open` until `poll` delivers the outcome.
  bool is_reading() const { return reading_.is_under_way() || held_back_; }
  /// True if the reading thread has ended.
  bool has_read() const { return reading_.has_ended() || held_back_; }
  /// True if something was read, but the present document has edits since `open` that no file holds.
  bool would_lose_work() const;
  /// Agrees to lose this work. Work done after this call is not included.
  void give_up_work() { note_work(asked_); }
  std::string reading_name() const;
  /// Progress of the reading, from 0 to 1, by bytes of the present file; 0 if nothing is being read. Never decreases
  /// during a reading.
  double reading_progress() const;

  struct Outcome {
    std::filesystem::path file;                ///< the first one, or the one that caused the error
    std::vector<std::filesystem::path> files;  ///< all files that were opened
    std::size_t left_out = 0;                  ///< number of files that would have replaced data of the first
    bool is_shape = false;
    bool is_made = false;                    ///< made from generated samples: no files
    bool is_recovered = false;               ///< recovered after a crash: no files
    std::shared_ptr<const Session> session;  ///< if it was one; the document is already the session's
    std::string format;
    std::optional<MapDegrees> degrees;  ///< the treatment of longitude and latitude; nothing if there were none
    std::string system;                 ///< the coordinate system that was asked for; may be empty
    std::size_t samples = 0;
    std::size_t balls = 0;
    bool has_added_samples = false;  ///< between the vertices of curves
    std::vector<std::string> warnings;
    std::string remark;  ///< a remark about made samples
    std::optional<Error> error;
  };
  /// The outcome of the reading, given once when it has ended; nothing while it `would_lose_work`.
  std::optional<Outcome> poll();

  void start_empty();
  /// Begins to make a document of generated samples or of a picture, as `open` does of files. It has this title, and
  /// no file holds it. `remark` is delivered with the outcome.
  void open_made(std::shared_ptr<const SampleData> made, const std::string& title, const std::string& remark = {});
  /// Begins to make a document of a text in any format that can be opened, as `open` does of files. It has this title,
  /// unless it is a session with one, and no file holds it.
  void open_text(std::string text, const std::string& title, MapDegrees degrees);
  /// Begins to make the document of work left behind by a crash, as `open` does of files. It is unsaved, and is saved
  /// in `file` if that still has the content given.
  void recover(std::shared_ptr<const Session> work, const std::optional<SourceFile>& file = {});
  /// Begins to write the session, or samples and balls, to their files. Waits for a writing under way.
  void save();
  /// The same for everything if the name ends in .json, for the balls if it ends in .wpoff, else for the samples.
  /// From then on the file belongs to them.
  void save_as(const std::filesystem::path& file);
  /// Repeats the saving that ended with this conflict, and overwrites the file's present content. If the file changes
  /// again, there is another conflict.
  void overwrite(const FileConflict& conflict);
  bool is_saving() const { return writing_.is_under_way(); }
  std::string saving_name() const;
  struct Saved {
    std::vector<std::filesystem::path> files;
    std::optional<Error> error;
    std::optional<FileConflict> conflict;  ///< nothing was written to this file
  };
  /// The outcome of the writing, given once when it has ended.
  std::optional<Saved> poll_saved();
  /// The same, but waits for the end; nothing if no writing is under way.
  std::optional<Saved> finish_saving();
  /// The parts of the document whose present state no file holds.
  struct Unsaved {
    bool samples = false;
    bool balls = false;
    bool annotations = false;  ///< only sessions hold them
    bool lesson = false;       ///< only sessions hold it
    bool any() const { return samples || balls || annotations || lesson; }
  };
  Unsaved unsaved() const;

  /// The file opened or saved last, if Save can write it; empty when a name must be asked for.
  const std::filesystem::path& file() const { return held_.file; }
  /// Returns the file in which the document is saved, and its content when read or saved; nothing if there is not just
  /// one file, or if its ending does not tell what is saved in it.
  std::optional<SourceFile> kept_in() const;
  const std::filesystem::path& sample_file() const { return held_.sample_file; }
  const std::filesystem::path& ball_file() const { return held_.ball_file; }
  bool has_session_file() const { return !held_.session_file.empty(); }
  /// The title of the window: "a.poff", "Elephant", "Untitled".
  const std::string& title() const { return held_.title; }

 private:
  /// A request made by `open` or one of its relatives.
  struct Asked {
    std::vector<std::filesystem::path> files{};
    std::string title{};                         // title of a shape or of made samples
    std::shared_ptr<const SampleData> made{};    // set instead of files
    std::string remark{};                        // about made samples
    std::shared_ptr<const std::string> text{};   // set instead of files
    std::shared_ptr<const Session> recovered{};  // set instead of files
    std::optional<SourceFile> kept_in{};         // of recovered work
    MapDegrees degrees = MapDegrees::projected;
    std::string system{};
    std::shared_ptr<const Registry> registry{};
    Editor::Work work{};        // the editor's work at that time
    bool was_modified = false;  // if so, the user was asked about it
  };
  /// The progress of a reading, for the window.
  struct Reading {
    JobControl control{};              // control of the present part
    std::atomic<std::size_t> part{0};  // each file, then the document, then the data beside it
    double shown = 0.0;                // largest value given to the window
    /// Resets the control first, so that the window never takes the previous part's progress for this part's.
    void next_part() {
      control.reset_progress();
      ++part;
    }
  };
  /// The result of the read, and the document built from it.
  struct ReadFiles {
    Outcome outcome{};  // on an error, all other members are empty
    std::vector<SourceFile> sources{};
    std::filesystem::path sample_file{};
    std::filesystem::path ball_file{};
    std::filesystem::path session_file{};
    std::shared_ptr<const SampleData> data{};
    Document start{};  // a successor of the editor's document, from which `document` was made
    std::unique_ptr<PreparedDocument> document{};
  };
  using ReadFilesPointer = std::shared_ptr<ReadFiles>;
  void begin(Asked asked);
  void note_work(Asked& asked) const;
  Document start() const;
  /// Makes the document again after the editor's document has used up the ids left free for it.
  void prepare_again(ReadFilesPointer read);
  Outcome take_over(ReadFiles& read);
  /// Destroys the data that was read on another thread, or on this one if no thread can be started.
  void drop(ReadFilesPointer read);
  static Expected<LoadedFile> read(const std::filesystem::path& file, const ReadRequest& request,
                                   JobControl& control);
  static void read(const Asked& asked, Reading& reading, ReadFiles& out);
  static void read_text(const Asked& asked, Reading& reading, ReadFiles& out);
  static void join(const Asked& asked, std::vector<LoadedFile> files, ReadFiles& out);
  static void prepare(Reading& reading, ReadFiles& out);
  /// The files of the document and their contents.
  struct Held {
    std::filesystem::path file{};
    std::filesystem::path sample_file{};  // empty: none yet
    std::filesystem::path ball_file{};
    std::filesystem::path session_file{};
    std::uint64_t samples = 0;  // digests of the contents of the files
    std::uint64_t balls = 0;
    std::shared_ptr<const Annotations> annotations = std::make_shared<const Annotations>();
    std::string title = "Untitled";
    std::map<std::filesystem::path, FileFingerprint> known{};  // contents of the files when opened or saved here
  };
  struct Part {
    std::filesystem::path file;
    std::function<std::string()> text;
    std::optional<FileFingerprint> expected;
  };
  /// The parts to write, and the state that holds once they are written.
  struct Saving {
    std::shared_ptr<const Registry> registry;  // its formats read a file that another program wrote
    std::vector<Part> parts;
    Held after;
    std::uint64_t revision = 0;  // revision of the written document
    std::uint64_t lesson_revision = 0;
    bool is_whole = false;                 // the parts hold all of the document
    std::shared_ptr<const SampleData> of;  // the data that the document was loaded from
    std::shared_ptr<const Document> document;
    std::shared_ptr<const Session> session;  // null: not saved as a session
  };
  struct Written {
    std::vector<SourceFile> files;
    std::optional<Error> error;
    std::optional<FileConflict> conflict;
    bool is_good() const { return !error && !conflict; }
  };
  void note_all_as_saved();
  void note_known(std::span<const SourceFile> files);
  /// Chooses the file for what `after` holds, by its ending.
  static void keep_in(const std::filesystem::path& file, Held& after);
  /// The state before any file is named, in which the document counts as saved.
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
  std::optional<Held> contested_;         // state after a saving that ended with a conflict, had it succeeded
  Asked asked_;                           // while it is being read
  ReadFilesPointer held_back_;            // the result of a reading that would lose work
  std::shared_ptr<const Saving> saving_;  // while it is being written
  std::shared_ptr<Reading> progress_;     // progress of the reading
  unsigned attempts_ = 0;                 // number of repeated attempts to make the document
  BackgroundJob<ReadFilesPointer> reading_;
  BackgroundJob<Written> writing_;
  BackgroundJob<bool> dropping_{{}};  // destroys the previous document, which may be large
};

/// In messages that begin with the file: names it without its folders, and in the first of them only unless there is a
/// line number.
void name_briefly(std::vector<std::string>& messages, const std::filesystem::path& file);

}  // namespace mes
