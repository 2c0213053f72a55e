// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "app/store/texts/internal/layer_writers.h"
#include "app/store/texts/internal/plane_layer.h"
#include "core/document/document.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

class PathText {
 public:
  /// `top` is the height of the page of a drawing, from which its y counts downwards.
  PathText(std::string& out, double top) : out_(out), top_(top) {}

  /// Draws a dot, if caps are round.
  void point(Vec2 p) {
    move_to(p);
    out_ += " h0\n";
  }
  void circle(const Disk& disk) {
    const Vec2 radius{disk.radius, 0.0};
    move_to(disk.center + radius);
    arc_to(disk.radius, false, disk.center - radius);
    arc_to(disk.radius, false, disk.center + radius);
    end(true);
  }
  /// From one end counter-clockwise to the other; a circle if they are the same.
  void arc(const Arc& arc) {
    if (arc.from == arc.to) return circle({arc.center, arc.radius});
    move_to(arc.from);
    arc_to(arc.radius, sweep_of(arc) > std::numbers::pi, arc.to);
    end(false);
  }
  void polyline(std::span<const Vec2> corners, bool is_closed) {
    chain(corners, std::vector<std::optional<Vec2>>(corners.size()), is_closed);
  }
  void chain(std::span<const Vec2> corners, std::span<const std::optional<Vec2>> controls, bool is_closed) {
    move_to(corners.front());
    for (std::size_t i = 0; i < controls.size(); ++i) {
      const bool is_last = i + 1 == corners.size();
      if (is_last && !(is_closed && controls[i])) break;
      if (controls[i]) place(" Q", *controls[i]);
      place(controls[i] ? "" : " L", corners[is_last ? 0 : i + 1]);
    }
    end(is_closed);
  }

 private:
  void move_to(Vec2 p) { place("M", p); }
  /// Draws an arc, counter-clockwise in the plane, which is against the angle of SVG.
  void arc_to(double radius, bool is_large, Vec2 p) {
    out_ += " A";
    number(radius);
    number(radius);
    out_ += is_large ? " 0 1 0" : " 0 0 0";
    place("", p);
  }
  void end(bool is_closed) { out_ += is_closed ? " Z\n" : "\n"; }
  void number(double x) {
    out_ += ' ';
    append_number(out_, x);
  }
  void place(std::string_view command, Vec2 p) {
    out_ += command;
    number(p.x);
    number(p.y == top_ ? 0.0 : top_ - p.y);
  }
  std::string& out_;
  double top_;
};

}  // namespace

Expected<LayerText> svg_path_of(const LayerGeometry& geometry) {
  LayerText out;
  const std::optional<MapPlane>& map = geometry.document.map();
  PathText path(out.text, map ? map->page.y : 0.0);
  for (const LayerIndex layer : geometry.layers) out.left_out += write_plane_layer(path, geometry, layer);
  return out;
}

}  // namespace mes
