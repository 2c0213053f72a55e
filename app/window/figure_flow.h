// SPDX-License-Identifier: GPL-3.0-or-later
// Figures and geometry leave the window: dialogs, what they show, and files.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/export/figure_desk.h"
#include "app/model/settings.h"
#include "app/panels/dialogs.h"
#include "app/store/layer_text.h"
#include "app/system/background_job.h"
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
  FigureFlow(Uses uses, Waker wake);
  ~FigureFlow();
  FigureFlow(const FigureFlow&) = delete;
  FigureFlow& operator=(const FigureFlow&) = delete;

  void bind(ActionBindings& actions);
  /// Asks for a file for the geometry of these layers, which are computed afresh for it.
  void ask_geometry(std::vector<LayerIndex> layers, const LayerTextFormat& format);
  /// Once a turn, before the frame.
  void take_results();

 private:
  struct WrittenGeometry {
    std::filesystem::path file;
    Expected<std::string> remark;  ///< empty: nothing is left out
  };
  void open();
  void write_geometry(const std::filesystem::path& file, const std::vector<LayerIndex>& layers,
                      const LayerTextFormat& format);
  void take_geometry();
  std::string document_name() const;
  void ask_file();
  FigureSubject subject() const;
  /// Of the preview, made when it is asked for.
  ImTextureID texture();
  void forget_texture();

  Uses uses_;
  FigureDesk desk_;
  BackgroundJob<WrittenGeometry> writing_geometry_;
  std::optional<render::TextureId> texture_;
  std::uint64_t textured_ = 0;  // number of the preview in it
};

}  // namespace mes
