// SPDX-License-Identifier: GPL-3.0-or-later
// Exports figures, geometry and lessons from the window: the dialogs, their contents, and the files.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/export/latest_figure.h"
#include "app/insight/center_line_run.h"
#include "app/panels/dialogs/dialogs.h"
#include "app/recording/lesson_export.h"
#include "app/settings/settings.h"
#include "app/store/texts/layer_text.h"
#include "app/system/background_job.h"
#include "app/window/work/drawing_board.h"

namespace mes {

/// Guarantees: it never waits for a figure or a lesson to be computed, drawn or written. Needs a current OpenGL context
/// for its whole life. Threads: the window's; `wake` is called from others.
class FigureFlow {
 public:
  struct Uses {
    const Workspace& work;
    DrawingBoard& board;
    Screen& screen;
    Dialogs& dialogs;
    Messages& messages;
    Settings& settings;
    std::function<std::string()> title;             ///< title of the document
    std::function<std::filesystem::path()> folder;  ///< the folder that file dialogs show first
    std::function<Session()> session;               ///< the document as it is saved
  };
  FigureFlow(Uses uses, Waker wake);
  ~FigureFlow();
  FigureFlow(const FigureFlow&) = delete;
  FigureFlow& operator=(const FigureFlow&) = delete;

  void bind(ActionBindings& actions);
  /// Asks for a file for the geometry of those of these layers that the format can hold. They are computed again for it.
  void ask_geometry(std::vector<LayerIndex> layers, const LayerTextFormat& format);
  /// Asks for a file for the lines of the layer `center-lines`, or, if two samples are selected, for the line between
  /// the ends of the axis nearest to them. The extension of the file chooses the format.
  void ask_center_lines();
  void ask_cells();
  /// Asks for a file for the lesson, which its extension gives a format.
  void ask_lesson();
  LessonExport& lesson() { return lesson_; }
  /// Called once per turn before the frame.
  void take_results();

 private:
  struct GeometryText {
    std::string text;
    std::string remark{};  ///< what was left out, or else empty
    std::string totals{};
  };
  struct WrittenGeometry {
    std::filesystem::path file;
    Expected<std::string> remark;  ///< what was left out, or else empty
    std::string totals{};
  };
  void open();
  /// Asks for a file named after the document and `suffix`, with the first of the extensions unless the user chooses
  /// another one of them.
  void ask_file_for(const std::string& heading, const std::string& suffix, const std::vector<std::string>& extensions,
                    std::function<void(const std::filesystem::path&)> write);
  using Compute = std::function<Expected<GeometryText>(const Registry&, const SampleData&, const std::stop_token&)>;
  /// Computes the file from the present document and writes it, on another thread. `contents` are words for errors.
  void write_aside(const std::filesystem::path& file, std::string_view contents, Compute compute);
  void write_geometry(const std::filesystem::path& file, const std::vector<LayerIndex>& layers,
                      const LayerTextFormat& format);
  void write_center_lines(const std::filesystem::path& file, const CenterLineWish& wish);
  void write_cells(const std::filesystem::path& file);
  void take_geometry();
  void take_lesson();
  std::string document_name() const;
  void ask_figure();
  FigureSubject subject() const;
  /// Texture of the preview, created on demand.
  ImTextureID texture();
  void forget_texture();

  Uses uses_;
  LatestFigure latest_;
  BackgroundJob<WrittenGeometry> writing_geometry_;
  LessonExport lesson_;
  std::optional<render::TextureId> texture_;
  std::uint64_t textured_ = 0;  // number of the preview in the texture
};

}  // namespace mes
