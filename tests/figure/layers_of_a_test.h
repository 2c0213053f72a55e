// SPDX-License-Identifier: GPL-3.0-or-later
// Layers with chosen primitives, and short ways to a figure of them.
#pragma once

#include <string>
#include <vector>

#include "render/figure/figure_of.h"

namespace mes::test {

/// Three layers: 0 "plain", 1 "scalars", which have a scalar, 2 "third".
class Layers {
 public:
  /// Coordinates and, for each instance, its scalar, as in core/draw/primitives.h.
  void add(LayerIndex layer, PrimitiveKind kind, std::vector<double> instances);
  /// Shows a layer above those shown before.
  LayerStyle& show(LayerIndex layer);

  /// The square from the origin to (width, height) in units that are points.
  figure::Figure figure(double width = 200.0, double height = 100.0) const;

  std::vector<render::ColorMap> maps{render::grey_map(), render::categorical_map()};
  double scale = 1.0;

 private:
  LayerMirror mirror_;
  std::vector<render::LayerView> views_;
};

/// A camera that shows the box from the origin, with a pixel a unit.
figure::Page page_of_points(double width, double height);

/// All shapes of a layer, in drawing order.
std::vector<figure::Shape> shapes_of(const figure::FigureLayer& layer);

/// The values of an attribute of XML, in the order of the text.
std::vector<std::string> values_of(const std::string& xml, const std::string& attribute);

std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace mes::test
