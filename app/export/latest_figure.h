// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a figure of the window's contents while the user chooses its settings: a preview, the bytes of its file, the
// file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/export/comparison.h"
#include "app/export/figure.h"
#include "app/settings/figure_settings.h"
#include "app/system/background_job.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/graph/live_registry.h"
#include "core/io/session/session.h"
#include "render/figure/writers.h"

namespace mes {

/// The subject of a figure, as it was when the figure was requested.
struct FigureSubject {
  SampleData data;
  ComputationSettings settings;
  ShownLayers shown;  ///< its background is the canvas
  BackgroundImage image;
  std::vector<render::ColorMap> maps;
  figure::Page view;                      ///< the view of the window; only the proportion of width and height matters
  double canvas_width = 0.0;              ///< width of the view, the main pane, in logical pixels of the window
  std::optional<PaperPlace> legend_at{};  ///< position to which the legend was dragged
  std::optional<PaperPlace> scale_bar_at{};  ///< the same for the scale bar
  Session session{};                         ///< carried by the file, if the settings say so
  /// All panes of the window, the main one first, with layers by their indices in the main computation; empty: there
  /// is only the main pane.
  std::vector<PaneRequest> panes{};
  /// The views of these panes, if they have cameras of their own; empty: all show `view`.
  std::vector<figure::Page> pane_views{};
};

/// A figure drawn with its settings. Plain data.
struct FigurePreview {
  render::Image image;
  double width = 0.0;  ///< width of the page in points
  double height = 0.0;
  struct Layer {
    std::string id;
    std::string title;
    std::size_t shapes = 0;
    bool is_picture = false;
  };
  std::vector<Layer> layers;  ///< bottom first
  std::size_t shapes = 0;     ///< total of all layers
  /// The finest and the widest line of all layers, in points; zero: there is no line.
  double finest = 0.0;
  double widest = 0.0;
  std::vector<std::string> remarks;
};

/// Guarantees:
///  1. Nothing waits for computing, drawing, or the disk: each is a call on a thread of its own, which calls `wake`.
///     A later request replaces an earlier one, whose result is dropped.
///  2. The figure shows the subject, even if the document changes meanwhile, and is computed from scratch.
///  3. The file has exactly the bytes whose size was shown, and appears complete or not at all.
///
/// Smallest use:
///     latest.begin(subject);
///     ... each frame: latest.want(settings, rasterized, 600); if (latest.follow()) show(latest.preview());
///     latest.save(file);
/// Threads: the window's.
class LatestFigure {
 public:
  LatestFigure(LiveRegistry registry, Waker wake);

  void begin(FigureSubject subject);
  /// Gives up everything but a file that is being saved.
  void end();
  bool is_open() const { return is_open_; }
  /// True if the subject has several panes.
  bool has_panes() const { return has_panes_; }

  /// Sets the wanted figure; `rasterized` are ids of layers, `preview_px` is the longest side of the preview.
  void want(const FigureSettings& settings, const std::vector<std::string>& rasterized, int preview_px);
  /// Takes finished results. Returns true if there is something new to show.
  bool follow();

  /// Null until the first preview is ready; then the last one that could be drawn.
  const FigurePreview* preview() const { return preview_ ? &*preview_ : nullptr; }
  /// Grows with each new preview.
  std::uint64_t preview_number() const { return preview_number_; }
  /// True while the preview does not show the wanted figure yet.
  bool is_drawing() const { return is_open_ && !(problem_ || (preview_ && shown_ == wanted_)); }
  /// The bytes of the wanted file, once they are known.
  const std::string* bytes() const { return bytes_ ? bytes_.get() : nullptr; }
  /// The reason why the wanted figure cannot be drawn or written.
  const std::optional<Error>& problem() const { return problem_; }

  /// Writes the wanted figure once it is drawn. An existing file is replaced.
  void save(const std::filesystem::path& file);
  bool is_saving() const { return saving_.is_under_way() || save_to_; }
  struct Saved {
    std::filesystem::path file;
    Expected<void> outcome;
  };
  /// The result of `save`, given once.
  std::optional<Saved> take_saved() { return std::exchange(saved_, std::nullopt); }

 private:
  struct Wanted {
    FigureSettings settings;
    std::vector<std::string> rasterized;
    int preview_px = 0;
    friend bool operator==(const Wanted&, const Wanted&) = default;
  };
  struct Contents;
  struct Drawn {
    Wanted wanted;
    Expected<std::pair<std::shared_ptr<const figure::Figure>, FigurePreview>> figure;
  };
  struct Written {
    Wanted wanted;
    Expected<std::string> bytes;
  };
  static Expected<std::shared_ptr<const Contents>> compute(std::shared_ptr<const Registry> registry,
                                                           const FigureSubject& subject, const std::stop_token& stop);
  static Drawn draw(const Contents& contents, const Wanted& wanted);
  static Expected<DrawnFigure> draw_figure_of(const Contents& contents, const Wanted& wanted);
  void begin_drawing();
  void begin_writing();
  void begin_saving();
  void fail(const Error& error);
  bool take_contents();
  bool take_drawn();
  bool take_written();

  LiveRegistry registry_;
  bool is_open_ = false;
  bool has_panes_ = false;
  Wanted wanted_;
  std::shared_ptr<const Contents> contents_;
  Wanted shown_;
  std::optional<FigurePreview> preview_;
  std::uint64_t preview_number_ = 0;
  std::shared_ptr<const figure::Figure> figure_;  // figure for `shown_`
  std::shared_ptr<const std::string> bytes_;      // for `wanted_`
  std::optional<Error> problem_;                  // for `wanted_`
  std::optional<std::filesystem::path> save_to_;
  std::optional<Saved> saved_;
  BackgroundJob<Expected<std::shared_ptr<const Contents>>> computing_;
  BackgroundJob<Drawn> drawing_;
  BackgroundJob<Written> writing_;
  BackgroundJob<Saved> saving_;
};

}  // namespace mes
