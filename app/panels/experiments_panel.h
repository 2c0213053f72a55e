// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of the user: what they add, what the compiler says of them, and how to get more.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/experiments/experiment_desk.h"
#include "app/ui/gui.h"

namespace mes {

struct ExperimentsPanel {
  const Gui& gui;
  ExperimentDesk& desk;
  std::vector<std::filesystem::path> examples;  ///< that come with the program
  const std::vector<std::string>& recent;
  std::string& compiler;  ///< of the settings
  std::function<void()> ask_file;
  std::function<void(const std::filesystem::path& file)> add;
  /// Shows a place in a file where one edits it.
  std::function<void(const std::filesystem::path& file, std::uint64_t line)> edit;

  void draw() const;

 private:
  void draw_more() const;
  void draw_entry(std::size_t index) const;
  void draw_message(const CompilerMessage& message) const;
};

}  // namespace mes
