// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/document_flow.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/store/own_font.h"
#include "core/io/carried_session.h"
#include "core/io/format.h"
#include "core/raster/picture_decoder.h"
#include "render/image/picture_file.h"

namespace mes {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> picture_extensions() {
  return {std::begin(kPictureExtensions), std::end(kPictureExtensions)};
}

}  // namespace

bool is_picture_to_trace(const fs::path& file) {
  return render::is_picture_file(file) && !is_picture_with_session(file);
}

DocumentFlow::DocumentFlow(Uses uses, const fs::path& assets, const Waker& wake)
    : uses_(uses),
      shapes_(read_sample_shapes(assets)),
      lessons_(read_shipped_lessons(assets)),
      files_(
          uses_.work.live_registry(), uses_.work.editor(),
          [this] {
            uses_.work.editor().note_layers();
            return session_now();
          },
          wake),
      keeper_(
          uses_.work, uses_.messages, [this] { return session_now(); }, [this] { return files_.kept_in(); }, wake),
      figures_(
          {uses_.work, uses_.board, uses_.screen, uses_.dialogs, uses_.messages, uses_.settings,
           [this] { return files_.title(); }, [this] { return browse_folder(); }, [this] { return session_now(); }},
          wake),
      tracing_({uses_.work.live_registry(), uses_.board, uses_.dialogs, uses_.messages,
                [this](std::function<void()> then) { with_saved_work(std::move(then)); },
                [this](TraceJob::Samples samples, const std::string& title) {
                  traced_with_next_.clear();
                  files_.open_made(std::make_shared<const SampleData>(std::move(samples.data)), title,
                                   samples.remark);
                }},
               wake),
      sharing_(wake) {
  const auto make = [this](const SampleData& data, const std::string& name) { open_made(data, name); };
  uses_.dialogs.shape.set_uses(uses_.work.live_registry(), make, wake);
  uses_.dialogs.text.set_uses(make, wake);
  if (auto font = own_font(assets)) uses_.dialogs.text.set_own_font(*std::move(font));
}

void DocumentFlow::bind(ActionBindings& actions) {
  bind_files(actions);
  bind_bundles(actions);
  figures_.bind(actions);
}

void DocumentFlow::bind_files(ActionBindings& actions) {
  actions.bind(ActionId::new_document, {[this] {
                 with_saved_work([this] {
                   start_empty();
                   uses_.messages.clear();
                 });
               }});
  // The question about unsaved work comes with the chosen file: a picture asks it when it is traced.
  actions.bind(ActionId::open, {[this] {
                 uses_.board.canvas().cancel_gesture();
                 uses_.lesson.end();
                 uses_.dialogs.browser.ask_open(browse_folder(),
                                                remembering([this](const fs::path& file) { open({file.string()}); }));
               }});
  actions.bind(ActionId::keep_degrees, {[this] {
                                          bool& keeps = uses_.settings.keep_degrees;
                                          keeps = !keeps;
                                          read_map_again();
                                        },
                                        {},
                                        [this] { return uses_.settings.keep_degrees; }});
  actions.bind(ActionId::map_system, {[this] { ask_system(); }, when_readable_again()});
  actions.bind(ActionId::trace_picture, {[this] {
                 uses_.dialogs.browser.ask_open(
                     browse_folder(), remembering([this](const fs::path& file) { uses_.board.traced().trace(file); }),
                     {.heading = "Picture underneath", .extensions = picture_extensions()});
               }});
  actions.bind(ActionId::picture_to_samples, {[this] { ask_trace(); }});
  actions.bind(ActionId::make_shape, {[this] {
                 uses_.board.canvas().cancel_gesture();
                 uses_.dialogs.shape.open();
               }});
  actions.bind(ActionId::write_text, {[this] {
                 uses_.board.canvas().cancel_gesture();
                 uses_.dialogs.text.open();
               }});
  actions.bind(ActionId::save, {[this] { save(); }});
  actions.bind(ActionId::save_as, {[this] { ask_save_as(); }});
  if (may_share()) actions.bind(ActionId::share, {[this] { share(); }});
  actions.bind(ActionId::quit, {[this] { with_saved_work([this] { quit(); }); }});
  actions.bind(ActionId::present_lesson, {[this] {
                                            uses_.demo.end(true);
                                            uses_.lesson.start(session_now());
                                          },
                                          when_presentable(), [this] { return uses_.lesson.is_running(); }});
  actions.bind(ActionId::export_lesson, {[this] { figures_.ask_lesson(); }, when_presentable()});
  actions.bind(ActionId::demo, {[this] { with_saved_work([this] { start_demo(); }); }});
}

void DocumentFlow::open_made(const SampleData& data, const std::string& title) {
  with_saved_work([this, made = std::make_shared<const SampleData>(data), title] {
    traced_with_next_.clear();
    files_.open_made(made, title);
  });
}

void DocumentFlow::open_text(std::string text) {
  with_saved_work([this, text = std::move(text)] {
    traced_with_next_.clear();
    files_.open_text(text, "Clipboard", degrees_wanted());
  });
}

void DocumentFlow::ask_trace() {
  uses_.dialogs.browser.ask_open(browse_folder(), remembering([this](const fs::path& file) { tracing_.open(file); }),
                                 {.heading = "Trace a picture", .extensions = picture_extensions()});
}

void DocumentFlow::bind_bundles(ActionBindings& actions) {
  actions.bind(ActionId::import_bundles, {[this] {
                 uses_.dialogs.browser.ask_open(
                     browse_folder(), remembering([this](const fs::path& file) { uses_.work.import_bundles(file); }),
                     {.heading = "Import bundles"});
               }});
  actions.bind(ActionId::export_bundles,
               {[this] { ask_export({}); },
                {[this] { return !uses_.work.bundles().bundles().empty(); }, "there are no bundles"}});
}

void DocumentFlow::ask_export(std::optional<std::size_t> bundle) {
  std::string name = bundle ? uses_.work.bundles().bundles()[*bundle].name : "bundles";
  std::ranges::replace(name, '/', '-');
  uses_.dialogs.browser.ask_save(browse_folder(), name + ".json", remembering([this, bundle](const fs::path& file) {
                                   uses_.work.export_bundles(file, bundle);
                                 }),
                                 {.heading = bundle ? "Export the bundle" : "Export all bundles"});
}

fs::path DocumentFlow::browse_folder() const {
  std::error_code error;
  if (!files_.file().empty()) return files_.file().parent_path();
  const std::string& last = uses_.settings.last_folder;
  return !last.empty() && fs::is_directory(last, error) ? fs::path(last) : fs::current_path(error);
}

FileBrowser::Then DocumentFlow::remembering(FileBrowser::Then then) {
  return [this, then = std::move(then)](const fs::path& file) {
    uses_.settings.last_folder = file.parent_path().string();
    then(file);
  };
}

void DocumentFlow::with_saved_work(std::function<void()> then, std::string reason) {
  uses_.board.canvas().cancel_gesture();
  uses_.lesson.end();
  if (files_.is_saving()) {
    after_save_ = [this, then = std::move(then), reason = std::move(reason)] { with_saved_work(then, reason); };
    return;
  }
  if (!uses_.work.editor().is_modified()) {
    then();
    return;
  }
  const auto save_first = [this, then] {
    after_save_ = then;
    save();
  };
  uses_.dialogs.unsaved.ask(files_.title(), {.save = save_first, .discard = then}, std::move(reason));
}

// A table that waits for its file is asked about next.
void DocumentFlow::quit() {
  if (tables_.empty())
    is_left_ = true;
  else
    uses_.messages.remark("Not closed: choose a file for the table first, or cancel it");
}

void DocumentFlow::start_empty() {
  uses_.demo.end(true);
  files_.start_empty();
  leave_document();
  uses_.board.note_new_document();
}

void DocumentFlow::leave_document() {
  uses_.work.leave_document();
  uses_.board.traced().give_up();
  opened_ = {};
  map_files_.clear();
  map_degrees_.reset();
  map_system_.clear();
}

// A reading or a save refers to the document that the lesson would put aside.
ActionBindings::Condition DocumentFlow::when_presentable() const {
  return {{[this] { return !uses_.lesson.is_running(); }, "a lesson is being presented"},
          {[this] { return !files_.is_reading(); }, "a file is being read"},
          {[this] { return !files_.is_saving(); }, "a file is being saved"},
          {[this] { return !uses_.work.editor().timeline().lesson().steps.empty(); }, "the session holds no lesson"}};
}

ActionBindings::Condition DocumentFlow::when_readable_again() const {
  return {{[this] { return !files_.is_reading(); }, "a file is being read"},
          {[this] { return !map_files_.empty() && !has_own_file(); }, "no map, table or drawing is open"}};
}

void DocumentFlow::start_demo() {
  uses_.demo.end(true);
  const auto session = demo_of(uses_.work.registry(), shapes_);
  if (!session) {
    report(session.error());
    return;
  }
  before_demo_ = opened_;
  if (!files_.file().empty()) before_demo_ = {{files_.file()}, {}};
  if (!files_.has_session_file() && !files_.sample_file().empty() && !files_.ball_file().empty())
    before_demo_ = {{files_.sample_file(), files_.ball_file()}, {}};
  start_empty();
  uses_.messages.clear();
  uses_.demo.start(*session);
  // The selection and the clicked elements belong to another document.
  uses_.board.provenance().clear();
  uses_.screen.clock.settle();
}

void DocumentFlow::open_from_before_demo() {
  const Opened before = std::exchange(before_demo_, {});
  if (before.files.empty()) return;
  if (before.shape.empty())
    open_documents(before.files);
  else
    files_.open_shape(before.files.front(), before.shape);
}

void DocumentFlow::take_results() {
  if (uses_.demo.take_finished()) open_from_before_demo();
  take_read_file();
  ask_before_read_file();
  uses_.dialogs.recover.set_waits(recovering_.has_value());
  uses_.dialogs.follow();
  if (reads_map_again_ && !files_.is_reading()) read_map_again();
  take_saved();
  take_shared();
  figures_.take_results();
  tracing_.take_results();
  offer_left_work();
  remove_recovered();
}

void DocumentFlow::follow_dialogs() {
  const bool is_asking = uses_.dialogs.browser.is_open() || uses_.dialogs.conflict.is_open();
  if (!is_asking && !files_.is_saving()) after_save_ = {};
  // The save under way may need another file name, or the name of a related file.
  if (tables_.empty() || files_.is_saving() || after_save_) return;
  if (!uses_.dialogs.open().empty() || uses_.board.canvas().has_pointer()) return;
  Table table = std::move(tables_.front());
  tables_.pop_front();
  ask_for(std::move(table), browse_folder());
}

// While a lesson is presented, the document to keep is put aside.
void DocumentFlow::keep() {
  if (uses_.lesson.is_running()) return;
  const bool controls = !ImGui::IsAnyItemActive();
  const bool all = controls && uses_.board.is_at_rest() && !files_.is_reading();
  keeper_.follow({.controls = controls, .all = all}, uses_.board.view().free_box());
}

void DocumentFlow::keep_on_disk() {
  keep();
  keeper_.flush();
}

// After a request, the user has saved the old work or given it up. A signal makes no request: its journal stays, and
// is complete before anything that may take longer than a signal waits.
void DocumentFlow::end() {
  if (is_left_) {
    keeper_.discard();
    for (LeftWork& work : recovered_) work.remove();
    return;
  }
  keep_on_disk();
  remove_recovered();
}

}  // namespace mes
