// SPDX-License-Identifier: GPL-3.0-or-later
// The user's experiments: their contents, the compiler's messages, and buttons to add more.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/experiments/experiment_list.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct ExperimentsPanel {
  const Gui& gui;
  ExperimentList& list;
  std::vector<std::filesystem::path> examples;  ///< examples that come with the program
  const std::vector<std::string>& recent;
  std::string& compiler;  ///< the compiler in the settings
  std::function<void()> ask_file;
  std::function<void(const std::filesystem::path& file)> add;
  /// Opens a file at a line in the user's editor.
  std::function<void(const std::filesystem::path& file, std::uint64_t line)> edit;

  void draw() const;

 private:
  void draw_more() const;
  void draw_entry(std::size_t index) const;
  void draw_message(const CompilerMessage& message) const;
};

}  // namespace mes
