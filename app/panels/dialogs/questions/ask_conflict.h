// SPDX-License-Identifier: GPL-3.0-or-later
// "Something else has written to this file": the question before overwriting such a file.
#pragma once

#include <functional>
#include <optional>

#include "app/store/file_conflict.h"
#include "app/ui/dialogs/question.h"

namespace mes {

class AskConflict final : public Question {
 public:
  struct Answers {
    std::function<void(const FileConflict&)> overwrite;
    std::function<void()> save_as;
    std::function<void()> cancel;
  };
  void ask(FileConflict conflict, Answers answers);

  bool is_open() const override { return conflict_.has_value(); }
  void cancel() override;
  void draw(const Gui& gui) override;

 private:
  void draw_facts(const Gui& gui, float width) const;

  std::optional<FileConflict> conflict_{};
  Answers answers_{};
};

}  // namespace mes
