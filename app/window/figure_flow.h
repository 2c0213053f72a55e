// SPDX-License-Identifier: GPL-3.0-or-later
// Figures leave the window: the dialog, what it shows, and the file.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/export/figure_desk.h"
#include "app/model/settings.h"
#include "app/panels/dialogs.h"
#include "app/window/drawing_board.h"

namespace mes {

/// What it guarantees: it never waits for a figure being computed, drawn or written. Needs a current OpenGL context for
/// its life. Threads: the window's; `wake` is called from others.
class FigureFlow {
 public:
  struct Uses {
    const Workspace& work;
    DrawingBoard& board;
    Screen& screen;
    Dialogs& dialogs;
    Messages& messages;
    Settings& settings;
    std::function<std::string()> title;             ///< of the document
    std::function<std::filesystem::path()> folder;  ///< where files are asked for
  };
  FigureFlow(Uses uses, std::function<void()> wake);
  ~FigureFlow();
  FigureFlow(const FigureFlow&) = delete;
  FigureFlow& operator=(const FigureFlow&) = delete;

  void bind(ActionBindings& actions);
  /// Once a turn, before the frame.
  void take_results();
  /// A figure is being drawn or written.
  bool is_busy() const {
    return (desk_.is_open() && desk_.bytes() == nullptr && !desk_.problem()) || desk_.is_saving();
  }

 private:
  void open();
  void ask_file();
  FigureSubject subject() const;
  /// Of the preview, made when it is asked for.
  ImTextureID texture();
  void forget_texture();

  Uses uses_;
  FigureDesk desk_;
  std::optional<render::TextureId> texture_;
  std::uint64_t textured_ = 0;  // number of the preview in it
};

}  // namespace mes
