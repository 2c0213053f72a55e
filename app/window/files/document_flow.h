// SPDX-License-Identifier: GPL-3.0-or-later
// Brings documents into the window and out of it: opening and saving, with the questions involved.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/actions/refusal.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/settings/settings.h"
#include "app/store/document_files.h"
#include "app/store/lessons.h"
#include "app/store/sample_shapes.h"
#include "app/system/background_job.h"
#include "app/system/session_link.h"
#include "app/system/waker.h"
#include "app/window/files/figure_flow.h"
#include "app/window/files/trace_flow.h"
#include "app/window/runs/demo_run.h"
#include "app/window/runs/lesson_run.h"
#include "app/window/work/drawing_board.h"
#include "app/window/work/work_keeper.h"

namespace mes {

/// True for a picture, by its file name, that carries no session.
bool is_picture_to_trace(const std::filesystem::path& file);

/// Guarantees:
///  1. It never waits for a file being read or written.
///  2. Unsaved work is not lost without a question, however the document is left.
///  3. A crash does not lose it either: the journal of unsaved work is offered at the next start.
///
/// Threads: the window's; `wake` is called from others.
class DocumentFlow {
 public:
  struct Uses {
    Workspace& work;
    DrawingBoard& board;
    DemoRun& demo;
    LessonRun& lesson;
    Dialogs& dialogs;
    Messages& messages;
    Settings& settings;
    Screen& screen;
  };
  DocumentFlow(Uses uses, const std::filesystem::path& assets, const Waker& wake);

  DocumentFiles& files() { return files_; }
  FigureFlow& figures() { return figures_; }
  const FigureFlow& figures() const { return figures_; }
  const TraceFlow& tracing() const { return tracing_; }
  /// Waits until the journal on the disk has all work done so far.
  void keep_on_disk();
  const DocumentFiles& files() const { return files_; }
  std::span<const SampleShape> shapes() const { return shapes_; }
  std::span<const ShippedLesson> lessons() const { return lessons_; }
  void bind(ActionBindings& actions);

  /// Called at the start of the program; without documents it opens the first built-in shape, perhaps with a picture
  /// to trace. `presents`: the lesson of the documents.
  void open_first(std::vector<std::string> files, bool presents);
  /// Offers left work only at another start, because the document of this window belongs to another program.
  void leave_left_work() { offers_left_work_ = false; }
  /// Opens documents, bundles, and at most one picture, which is placed below the other files. If a picture comes
  /// alone, the user decides whether it becomes samples or is placed below the present drawing.
  void open(std::vector<std::string> files);
  void open_shape(const SampleShape& shape);
  /// Opens a text in any format as a document of its own, after the question about unsaved work.
  void open_text(std::string text);
  /// Opens the lesson, and presents it once it is loaded.
  void open_lesson(const ShippedLesson& lesson);
  /// Asks for a file for one bundle, or for all.
  void ask_export(std::optional<std::size_t> bundle);
  /// Asks for a file for a table, with a proposed name that contains `of`. Waits until nothing else is being asked or
  /// dragged, and asks again if the file cannot be written. A table may arrive while the user is busy.
  void ask_table(const std::string& of, Expected<std::string> csv);

  /// Called once per turn before the frame: takes finished readings and saves.
  void take_results();
  /// Called once per frame after the dialogs were drawn.
  void follow_dialogs();
  /// Called once per frame after all its changes: notes and keeps them.
  void keep();

  /// True once the user has asked to end the program, and unsaved work is saved or given up.
  bool is_left() const { return is_left_; }
  /// The program ends, requested or not.
  void end();
  /// The document with its history, and with the layers, settings and view that show it.
  Session session_now() const;

 private:
  void bind_files(ActionBindings& actions);
  void bind_bundles(ActionBindings& actions);
  /// Asks whether to save unsaved work or give it up, and then calls `then` unless the user cancels. The question
  /// includes the reason, if there is one.
  void with_saved_work(std::function<void()> then, std::string reason = {});
  void quit();
  void start_empty();
  /// Discards what belongs only to the previous document.
  void leave_document();
  void start_demo();
  void open_from_before_demo();
  /// The condition under which its lesson can be presented.
  ActionBindings::Condition when_presentable() const;

  // document_opening.cpp
  void open_documents(const std::vector<std::filesystem::path>& files, const std::string& system = {});
  /// Reads the open map again, with the present setting for its degrees.
  void read_map_again();
  void ask_system();
  /// The condition under which the open files can be read again.
  ActionBindings::Condition when_readable_again() const;
  /// True if the document has been saved to a file of its own since it was opened.
  bool has_own_file() const;
  MapDegrees degrees_wanted() const;
  void open_with_picture(const std::vector<std::string>& files, const std::filesystem::path& picture);
  void ask_trace();
  /// Opens a new document of its own, after the question about unsaved work.
  void open_made(const SampleData& data, const std::string& title);
  std::vector<std::filesystem::path> without_bundles(const std::vector<std::string>& files);
  void take_read_file();
  /// Edits made while a file was read are not lost without a question either; without an answer the document stays.
  void ask_before_read_file();
  void say_opened(const DocumentFiles::Outcome& outcome);
  void show_as_in(const Session& session);
  void offer_left_work();
  void recover(LeftWork work);
  void take_recovered(const DocumentFiles::Outcome& outcome, LeftWork work);
  void say_left_work_waits();
  /// Deletes the files of recovered work once it is in the journal or in a file, or was given up.
  void remove_recovered();

  // document_saving.cpp
  struct Table {
    std::string name;
    std::shared_ptr<const std::string> csv;
  };
  /// `trouble`: why the question is repeated.
  void ask_for(Table table, const std::filesystem::path& folder, std::string trouble = {});
  void save();
  void ask_save_as();
  void share();
  void take_shared();
  void take_saved();
  void ask_about(const FileConflict& conflict);
  void say_saved(const std::string& files);
  void say_still_unsaved(const DocumentFiles::Unsaved& rest);

  void report(const Error& error) { uses_.messages.problem(error.message()); }
  std::filesystem::path browse_folder() const;
  /// The same for a chosen file; the next dialog shows its folder first.
  FileBrowser::Then remembering(FileBrowser::Then then);

  Uses uses_;
  Refusal table_refusal_{uses_.messages};
  std::deque<Table> tables_;  // tables that still need a file
  std::vector<SampleShape> shapes_;
  std::vector<ShippedLesson> lessons_;
  DocumentFiles files_;
  WorkKeeper keeper_;
  FigureFlow figures_;
  TraceFlow tracing_;
  BackgroundJob<SharedLink> sharing_;
  std::function<void()> after_save_;              // waits for a save, perhaps under a new name
  std::filesystem::path traced_with_next_;        // the picture to trace once the present reading ends
  std::vector<std::filesystem::path> map_files_;  // files that were opened, and can be read again in another way
  std::optional<MapDegrees> map_degrees_;         // treatment of their longitude and latitude
  std::string map_system_;                        // the system that was named for them
  /// The files of a document; one file if it is a shape of this title.
  struct Opened {
    std::vector<std::filesystem::path> files;
    std::string shape;
  };
  Opened opened_;
  Opened before_demo_;
  bool reads_map_again_ = false;        // waits until nothing else is being read
  bool presents_next_ = false;          // the lesson being read is presented next
  std::optional<LeftWork> recovering_;  // the work being read
  std::vector<LeftWork> recovered_;     // recovered works whose files still exist
  bool asks_about_read_ = false;        // asked whether the read file may replace new work
  bool had_first_file_ = false;
  bool offers_left_work_ = true;
  bool is_left_ = false;
};

}  // namespace mes
