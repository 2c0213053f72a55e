// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments in the window: opened by the user, prepared, and added to the computation.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/experiments/experiment_list.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/settings/settings.h"
#include "app/system/waker.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: it never waits; document, undo, view and styles are unchanged when an experiment is added, replaced or
/// removed. Threads: the window's.
class ExperimentRun {
 public:
  struct Uses {
    Workspace& work;
    Dialogs& dialogs;
    Messages& messages;
    Settings& settings;
    /// When it returns, all work is on the disk.
    std::function<void()> keep_work;
  };
  ExperimentRun(Uses uses, const std::filesystem::path& assets, Waker wake);

  ExperimentList& list() { return list_; }
  const std::vector<std::filesystem::path>& examples() const { return examples_; }

  /// Adds a file or a folder that the user has named.
  void add(const std::filesystem::path& name);
  /// The same after a question, for a file dropped on the window.
  void ask(const std::filesystem::path& file);
  void ask_file();
  /// Opens a source with $VISUAL or the desktop, and puts "FILE:LINE" on the clipboard.
  void edit(const std::filesystem::path& file, std::uint64_t line);

  /// Called once per turn: takes prepared experiments.
  void follow();

 private:
  void say(const ExperimentList::Entry& entry);

  Uses uses_;
  std::vector<std::filesystem::path> examples_;
  ExperimentList list_;
};

}  // namespace mes
