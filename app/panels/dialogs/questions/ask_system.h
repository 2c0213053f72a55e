// SPDX-License-Identifier: GPL-3.0-or-later
// The question in which coordinate system the positions of an open file are.
#pragma once

#include <functional>
#include <string>

#include "app/ui/dialogs/name_field.h"
#include "app/ui/dialogs/question.h"
#include "core/base/error.h"

namespace mes {

class AskSystem final : public Question {
 public:
  using Read = std::function<Expected<void>(const std::string&)>;
  /// `present`: the system so far, or empty. `read` is called with the answer, empty for the system that the file names;
  /// if it returns an error, the question stays with it.
  void ask(std::string file, std::string present, Read read);

  bool is_open() const override { return is_open_; }
  void cancel() override;
  void draw(const Gui& gui) override;
  /// The other keys belong to the field.
  void press(const KeyChord& chord) override;

 private:
  bool is_open_ = false;
  std::string file_;
  std::string text_;
  std::string trouble_;
  NameField field_;
  Read read_;
};

}  // namespace mes
