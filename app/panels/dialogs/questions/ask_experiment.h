// SPDX-License-Identifier: GPL-3.0-or-later
// "This file is code that will run": the question before a dropped experiment runs.
#pragma once

#include <filesystem>
#include <functional>

#include "app/ui/dialogs/question.h"

namespace mes {

class AskExperiment final : public Question {
 public:
  void ask(std::filesystem::path file, std::function<void()> run);

  bool is_open() const override { return is_open_; }
  void cancel() override;
  void draw(const Gui& gui) override;

 private:
  bool is_open_ = false;
  std::filesystem::path file_;
  std::function<void()> run_;
};

}  // namespace mes
