// SPDX-License-Identifier: GPL-3.0-or-later
// Saves the document of the window to its files.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "app/window/files/document_flow.h"
#include "core/io/files/atomic_file.h"

namespace mes {

namespace fs = std::filesystem;

// The action that waits for the save continues when everything is in a file; parts without a file are then asked
// about.
void DocumentFlow::save() {
  uses_.lesson.end();
  if (files_.file().empty())
    ask_save_as();
  else
    files_.save();
}

void DocumentFlow::ask_save_as() {
  uses_.lesson.end();
  std::string name = fs::path(files_.title()).stem().string();
  std::ranges::replace(name, '/', '-');
  const DocumentFiles::Unsaved rest = files_.unsaved();
  const Document& document = uses_.work.document();
  const bool balls_only = document.sample_count() == 0 && document.ball_count() != 0;
  const bool wants_balls = rest.balls && !rest.samples;
  const bool wants_session = (rest.annotations || rest.lesson) && !rest.samples && !rest.balls;
  const bool has_format = !files_.file().empty() && !files_.has_session_file() && !wants_session;
  const char* const extension = !has_format ? ".json" : wants_balls || balls_only ? ".wpoff" : ".poff";
  uses_.dialogs.browser.ask_save(browse_folder(), name + extension,
                                 remembering([this](const fs::path& file) { files_.save_as(file); }));
}

// A link is made of the text, which may be long, on a thread of its own.
void DocumentFlow::share() {
  uses_.lesson.end();
  uses_.work.editor().note_layers();
  sharing_.begin([session = session_now()](const std::stop_token&) { return share_by_link(write_session(session)); });
}

void DocumentFlow::take_shared() {
  const auto link = sharing_.poll();
  if (!link) return;
  constexpr double kKilobyte = 1000.0;
  const double length = static_cast<double>(link->length) / kKilobyte;
  switch (link->kind) {
    case SharedLink::Kind::copied:
      return uses_.messages.remark(fmt::format("Copied a link of {:.1f} kB, which opens this session", length));
    case SharedLink::Kind::shown:
      return uses_.messages.remark(
          fmt::format("The address of the page is now a link of {:.1f} kB, which opens this session", length));
    case SharedLink::Kind::too_long:
      return uses_.messages.problem(
          fmt::format("This session is too large for a link: {:.1f} kB, and the limit is {:.1f} kB (\"{}\" writes it "
                      "to a file)",
                      length, static_cast<double>(link->limit) / kKilobyte, descriptor_of(ActionId::save_as).name));
  }
}

void DocumentFlow::ask_table(const std::string& of, Expected<std::string> csv) {
  if (!csv) return report(csv.error());
  std::string name = fs::path(files_.title()).stem().string() + '-' + of + ".csv";
  std::ranges::replace(name, '/', '-');
  tables_.push_back({std::move(name), std::make_shared<const std::string>(*std::move(csv))});
  uses_.screen.clock.want(1);
}

// The table may have taken hours to compute, so a full disk must not lose it.
void DocumentFlow::ask_for(Table table, const fs::path& folder, std::string trouble) {
  const std::string name = table.name;
  const auto write = [this, table = std::move(table)](const fs::path& file) {
    if (const auto written = write_file_atomically(file, *table.csv); !written) {
      table_refusal_.say(written.error());
      ask_for({file.filename().string(), table.csv}, file.parent_path(), written.error().message());
      return;
    }
    table_refusal_.forget();
    uses_.messages.remark("Exported " + file.string());
  };
  uses_.dialogs.browser.ask_save(
      folder, name, remembering(write),
      {.heading = "Export the table as CSV", .extensions = {".csv"}, .trouble = std::move(trouble)});
}

void DocumentFlow::take_saved() {
  const auto saved = files_.poll_saved();
  if (!saved) return;
  uses_.screen.clock.settle();
  if (saved->error) {
    report(*saved->error);
    after_save_ = {};
    return;
  }
  if (saved->conflict) {
    ask_about(*saved->conflict);
    return;
  }
  std::string names;
  for (const fs::path& file : saved->files) {
    names += (names.empty() ? "" : " and ") + file.string();
    remember_file(uses_.settings, file);
  }
  say_saved(names);
}

// The action that waits for the save also waits for the answer.
void DocumentFlow::ask_about(const FileConflict& conflict) {
  uses_.dialogs.conflict.ask(conflict, {.overwrite = [this](const FileConflict& of) { files_.overwrite(of); },
                                        .save_as = [this] { ask_save_as(); },
                                        .cancel = [this] { after_save_ = {}; }});
}

void DocumentFlow::say_saved(const std::string& files) {
  uses_.messages.clear_problem();
  uses_.messages.remark("Saved " + files);
  if (!uses_.work.editor().is_modified()) {
    keep();
    keeper_.note_saved();
  }
  const DocumentFiles::Unsaved rest = files_.unsaved();
  if (!rest.any()) {
    if (const auto then = std::exchange(after_save_, {})) then();
  } else if (after_save_) {
    ask_save_as();
  } else {
    say_still_unsaved(rest);
  }
}

void DocumentFlow::say_still_unsaved(const DocumentFiles::Unsaved& rest) {
  if (rest.annotations || rest.lesson) {
    const std::string what = !rest.lesson        ? "the annotations"
                             : !rest.annotations ? "the lesson"
                                                 : "the annotations and the lesson";
    uses_.messages.problem("Saved " + files_.title() + "; still unsaved: " + what +
                           " (\"Save as...\" with a name that ends in .json)");
    return;
  }
  const std::string what = rest.samples ? rest.balls ? "the samples and the balls" : "the samples" : "the balls";
  const bool has_file = !(rest.balls ? files_.ball_file() : files_.sample_file()).empty();
  const std::string way =
      has_file ? " (\"Save\" writes both files)"
               : std::string(" (\"Save as...\" with a name that ends in ") + (rest.balls ? ".wpoff)" : ".poff)");
  uses_.messages.problem("Saved " + files_.title() + "; still unsaved: " + what + way);
}

}  // namespace mes
