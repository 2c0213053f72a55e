// SPDX-License-Identifier: GPL-3.0-or-later
// Entities of a DXF file of release 12.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/geometry/arc.h"
#include "core/base/geometry/disk.h"

namespace mes {

/// Appends the entities of one layer. Source: AutoCAD Release 12, "Drawing interchange file formats".
class DxfText {
 public:
  /// The file up to the entities. The header has the unit of the coordinates, if DXF knows it.
  static std::string beginning(std::string_view unit);
  static constexpr std::string_view kEnd = "0\nENDSEC\n0\nEOF\n";

  DxfText(std::string& out, std::string_view layer) : out_(out), layer_(layer) {}

  void point(Vec2 p);
  void circle(const Disk& disk);
  /// From one end counter-clockwise to the other; a circle if they are the same.
  void arc(const Arc& arc);
  /// A polyline; a closed one does not repeat its first corner. With a height for each corner it is one in space.
  void polyline(std::span<const Vec2> corners, bool is_closed, std::span<const double> heights = {});

 private:
  void begin(std::string_view entity);
  void number(std::string_view code, double value);
  void place(Vec2 p, double height = 0.0);

  std::string& out_;
  std::string_view layer_;
};

}  // namespace mes
