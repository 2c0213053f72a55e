// SPDX-License-Identifier: GPL-3.0-or-later
// How documents come into the window and leave it: opening and saving, and the questions that go with it.
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
#include "app/model/refusal.h"
#include "app/model/settings.h"
#include "app/panels/dialogs.h"
#include "app/store/file_desk.h"
#include "app/store/lessons.h"
#include "app/store/sample_shapes.h"
#include "app/system/waker.h"
#include "app/window/demo_run.h"
#include "app/window/drawing_board.h"
#include "app/window/figure_flow.h"
#include "app/window/lesson_run.h"
#include "app/window/trace_flow.h"
#include "app/window/work_keeper.h"

namespace mes {

/// A picture by its name that carries no session.
bool is_picture_to_trace(const std::filesystem::path& file);

/// What it guarantees:
///  1. It never waits for a file being read or written.
///  2. Unsaved work is not lost without a question, whichever way the document is left.
///  3. Nor by a crash: a journal of what no file holds is offered at the next start.
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

  FileDesk& files() { return files_; }
  FigureFlow& figures() { return figures_; }
  const FigureFlow& figures() const { return figures_; }
  const TraceFlow& tracing() const { return tracing_; }
  /// A question about work that was left may still come up.
  /// The journal has all that was done, on the disk. Waits for the disk.
  void keep_on_disk();
  const FileDesk& files() const { return files_; }
  std::span<const SampleShape> shapes() const { return shapes_; }
  std::span<const ShippedLesson> lessons() const { return lessons_; }
  void bind(ActionBindings& actions);

  /// At the start of the program; without documents it is the first built-in shape, perhaps with a picture to trace.
  void open_first(std::vector<std::string> files);
  /// Work that was left is offered at another start: the document of this one is another program's.
  void leave_left_work() { offers_left_work_ = false; }
  /// Documents, bundles, and at most one picture, which lies underneath what the others bring. A picture alone is asked
  /// about: it becomes samples, or lies underneath what is there.
  void open(std::vector<std::string> files);
  void open_shape(const SampleShape& shape);
  /// Opens it, and presents it when it is there.
  void open_lesson(const ShippedLesson& lesson);
  /// Asks for a file for one bundle, or all.
  void ask_export(std::optional<std::size_t> bundle);
  /// Asks for a file for a table, whose name says what it is of, once nothing else is being asked or dragged; and again
  /// where the file cannot be written. A table may come while one does something else.
  void ask_table(const std::string& of, std::string csv);

  /// Once a turn, before the frame: what was read or saved meanwhile.
  void take_results();
  /// Once a frame, after the dialogs were drawn.
  void follow_dialogs();
  /// Once a frame, when all changes of it are made: notes and keeps them.
  void keep();

  /// To end the program was asked for, and what was unsaved is saved or given up.
  bool is_left() const { return is_left_; }
  /// The program ends, with or without having been asked to.
  void end();
  /// The document with its history, and all that it is looked at with.
  Session session_now() const;

 private:
  void bind_files(ActionBindings& actions);
  void bind_bundles(ActionBindings& actions);
  /// Saves what is unsaved or gives it up, as the answer is, and goes on with `then`; or does not. The question says why
  /// it is asked, if there is a reason.
  void with_saved_work(std::function<void()> then, std::string reason = {});
  void quit();
  void start_empty();
  /// What belongs to the document before alone goes.
  void leave_document();
  void start_demo();
  /// When its lesson can be presented.
  ActionBindings::Condition when_presentable() const;

  // document_opening.cpp
  void open_documents(const std::vector<std::filesystem::path>& files);
  /// The map that is open is read once more, as the settings say now what becomes of its degrees.
  void read_map_again();
  /// What is open has been saved to a file of its own since it was opened.
  bool has_own_file() const;
  MapDegrees degrees_wanted() const;
  void open_with_picture(const std::vector<std::string>& files, const std::filesystem::path& picture);
  void ask_trace();
  /// A document of its own. The question about unsaved work comes first.
  void open_made(const SampleData& data, const std::string& title);
  std::vector<std::filesystem::path> without_bundles(const std::vector<std::string>& files);
  void take_read_file();
  /// What was done while a file was read is not lost without a question either; without an answer the document stays.
  void ask_before_read_file();
  void say_opened(const FileDesk::Outcome& outcome);
  void show_as_in(const Session& session);
  void offer_left_work();
  void recover(LeftWork work);
  void take_recovered(const FileDesk::Outcome& outcome, LeftWork work);
  void say_left_work_waits();
  /// What was left and is recovered, once it is in the journal or in a file, or was given up.
  void remove_recovered();

  // document_saving.cpp
  struct Table {
    std::string name;
    std::shared_ptr<const std::string> csv;
  };
  /// `trouble`: why it is asked for again.
  void ask_for(Table table, const std::filesystem::path& folder, std::string trouble = {});
  void save();
  void ask_save_as();
  void take_saved();
  void ask_about(const FileConflict& conflict);
  void say_saved(const std::string& files);
  void say_still_unsaved(const FileDesk::Unsaved& rest);

  void report(const Error& error) { uses_.messages.problem(error.message()); }
  std::filesystem::path browse_folder() const;
  /// The same for a file that was chosen, whose folder is shown first next time.
  FileBrowser::Then remembering(FileBrowser::Then then);

  Uses uses_;
  Refusal table_refusal_{uses_.messages};
  std::deque<Table> tables_;  // for which no file was asked yet
  std::vector<SampleShape> shapes_;
  std::vector<ShippedLesson> lessons_;
  FileDesk files_;
  WorkKeeper keeper_;
  FigureFlow figures_;
  TraceFlow tracing_;
  std::function<void()> after_save_;              // what waits for a save, under a new name perhaps
  std::filesystem::path traced_with_next_;        // when what is being read is there
  std::vector<std::filesystem::path> map_files_;  // that were opened, if they had longitude and latitude
  MapDegrees map_degrees_{};                      // what became of those
  bool reads_map_again_ = false;                  // once nothing else is read
  bool presents_next_ = false;                    // what is being read
  std::optional<LeftWork> recovering_;            // what is being read
  std::vector<LeftWork> recovered_;               // whose files are still there
  bool asks_about_read_ = false;                  // whether it may take the place of what was done meanwhile
  bool had_first_file_ = false;
  bool offers_left_work_ = true;
  bool is_left_ = false;
};

}  // namespace mes
