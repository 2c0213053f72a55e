// SPDX-License-Identifier: GPL-3.0-or-later
// "There is unsaved work": the question before it is lost.
#pragma once

#include <functional>
#include <string>

#include "app/ui/dialogs/question.h"

namespace mes {

class AskUnsaved final : public Question {
 public:
  struct Answers {
    std::function<void()> save;
    std::function<void()> discard;
  };
  /// `reason` explains the question; empty: the user caused it.
  void ask(std::string title, Answers answers, std::string reason = {});

  bool is_open() const override { return is_open_; }
  void cancel() override;
  void draw(const Gui& gui) override;

 private:
  bool is_open_ = false;
  std::string title_;
  std::string reason_;
  Answers answers_;
};

}  // namespace mes
