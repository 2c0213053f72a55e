// SPDX-License-Identifier: GPL-3.0-or-later
// A figure of panes side by side, as `mesecina render --compare` writes it in vector formats and the window exports
// it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/export/comparison.h"
#include "app/export/figure.h"

namespace mes {

/// The area that all panes show, and the margin around it as a share of the shorter side.
struct SeenByAll {
  Box2 box;
  double margin = 0.0;
  /// Height divided by width, within bounds.
  double proportions() const;
};
/// The area that "fit" shows for one pane.
SeenByAll seen_alone(const Comparison& comparison, std::span<const FigureSource> sources, std::size_t pane);
/// The named part, or else the area that "fit" shows for all panes.
SeenByAll seen_by_all(const Comparison& comparison, std::span<const FigureSource> sources,
                      const std::optional<Box2>& view);

/// The request for one pane, without the parts that occur once for all: the title is above all panes; a scale bar is
/// only in the first pane unless cameras are free, and so is a legend that is the same for all.
FigureRequest request_for(const FigureRequest& all, const Comparison& comparison, std::size_t pane,
                          bool are_cameras_free = false);

/// The prefixes of the ids and titles of a pane's layers on a common page: "pane-a-" and "(a) ".
std::string id_prefix_of(const Pane& pane);
std::string title_prefix_of(const Pane& pane);

/// Id of the layer of pane labels.
inline constexpr std::string_view kPaneLabels = "panes";

/// The views of panes that have their own cameras.
struct FreeCameras {
  /// One per pane if the request asks for the view of the window; empty: each pane shows all its contents.
  std::vector<figure::Page> views{};
};

/// Draws all panes on the page of the request, each with its label, at one scale unless cameras are free. Layers have
/// their usual ids after a prefix such as "pane-a-"; `rasterized` names them without it. `sources` are those of the
/// panes. Error: `usage` if the panes would be too small; as `draw_figure`. Threads: any.
Expected<DrawnFigure> draw_pane_figure(const FigureRequest& request, const Comparison& comparison,
                                       std::span<const FigureSource> sources,
                                       const std::optional<FreeCameras>& cameras = std::nullopt);

/// Error: the picture is too small for this many panes.
std::unexpected<Error> no_room_for(std::size_t panes);

}  // namespace mes
