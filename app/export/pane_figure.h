// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of panes side by side: what `mesecina render --compare` writes into a vector format, and the window exports
// of its panes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/export/comparison.h"
#include "app/export/figure.h"

namespace mes {

/// What all panes show, and the margin around it as a part of the shorter side.
struct SeenByAll {
  Box2 box;
  double margin = 0.0;
  /// Height by width, within bounds.
  double proportions() const;
};
/// What "fit" shows of one pane.
SeenByAll seen_alone(const Comparison& comparison, std::span<const FigureSource> sources, std::size_t pane);
/// The part that is named, or else what "fit" shows of each pane.
SeenByAll seen_by_all(const Comparison& comparison, std::span<const FigureSource> sources,
                      const std::optional<Box2>& view);

/// What a pane shows of the things that stand once for all: the title stands above all panes, a scale bar in the first
/// only unless cameras are free, and there too a legend that is the same in all.
FigureRequest request_for(const FigureRequest& all, const Comparison& comparison, std::size_t pane,
                          bool are_cameras_free = false);

/// What the ids and titles of the layers of a pane begin with on a page of all: "pane-a-" and "(a) ".
std::string id_prefix_of(const Pane& pane);
std::string title_prefix_of(const Pane& pane);

/// Id of the layer with their labels.
inline constexpr std::string_view kPaneLabels = "panes";

/// Where panes look when they have cameras of their own.
struct FreeCameras {
  /// Of each pane, where the request asks for the view of the window; none: each pane shows all that is in it.
  std::vector<figure::Page> views{};
};

/// All panes on the page of the request, each with its label, at one scale unless cameras are free. Layers have the ids that they have alone,
/// after "pane-a-" and so on; `rasterized` names them without that. `sources` are of the panes. Error: `usage` if the
/// panes would be too small; as `draw_figure`. Any thread.
Expected<DrawnFigure> draw_pane_figure(const FigureRequest& request, const Comparison& comparison,
                                       std::span<const FigureSource> sources,
                                       const std::optional<FreeCameras>& cameras = std::nullopt);

/// Error: the picture is too small for so many panes.
std::unexpected<Error> no_room_for(std::size_t panes);

}  // namespace mes
