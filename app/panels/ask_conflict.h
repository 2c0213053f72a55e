// SPDX-License-Identifier: GPL-3.0-or-later
// "Something else has written to this file": the question before that is overwritten.
#pragma once

#include <optional>

#include "app/store/file_conflict.h"
#include "app/ui/gui.h"

namespace mes {

class AskConflict {
 public:
  enum class Answer : std::uint8_t { none, overwrite, save_as, cancel };

  void ask(FileConflict conflict) { conflict_ = std::move(conflict); }
  bool is_open() const { return conflict_.has_value(); }
  void close() { conflict_.reset(); }
  /// Draws the question while it is open. The answer, once; it stays open until it is closed or taken.
  Answer draw(const Gui& gui);
  /// What was asked about.
  FileConflict take();

 private:
  std::optional<FileConflict> conflict_;
};

}  // namespace mes
