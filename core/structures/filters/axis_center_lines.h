// SPDX-License-Identifier: GPL-3.0-or-later
// The centre lines of the shapes as tables, and the widths of the shapes along them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/table.h"
#include "core/structures/filters/center_lines.h"
#include "core/structures/inputs/center_line_ends.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// The main lines of the lambda axis, pruned and smoothed (`center_lines_of`), and transects across them. If the user
/// asks for lines between ends, only these, but for those whose ends no line joins.
///
/// A transect joins the nearest points of both banks through the point of the axis that a station stands for. The length
/// of all lines divided by the parameter `transects` is the step between them; each line has one at its beginning.
///
/// Guarantees:
///  1. Each line stays inside the union of the inner balls (`smooth`).
///  2. The tables depend on the samples and the parameters alone, to the last bit.
///
/// Cost: a change of the axis makes all lines again, O(kept edges).
class AxisCenterLines final : public Structure {
 public:
  using LineSlot = Slot<struct CenterLineTag>;
  struct Line {
    double length = 0.0;
    Widths widths{};  ///< along it
    bool is_closed = false;
  };
  struct Piece {
    Vec2 from{}, to{};
    LineSlot line = kNoSlot;
  };
  /// Its two parts, from the banks to the axis, form an angle in bends.
  struct Transect {
    Vec2 left{}, axis{},
        right{};             ///< the nearest points of both banks, as seen along the line, and the point of the axis
    Vec2 place{};            ///< point of the line
    double station = 0.0;    ///< arc length of the line up to it
    double width = 0.0;      ///< length of both parts
    double direction = 0.0;  ///< of the line, in degrees, counter-clockwise from the x axis
    LineSlot line = kNoSlot;
  };
  using PieceSlot = Slot<struct CenterPieceTag>;
  using TransectSlot = Slot<struct TransectTag>;

  AxisCenterLines(SettingsSource& settings, Samples& samples, CenterLineEnds& ends, OneStepCrust& crust,
                  InnerBalls& balls, LambdaAxis& lambda, AngleAxis& angle);

  /// Shape by shape, that with the longest first line first.
  const Table<LineSlot, Line>& lines() const { return lines_; }
  const Table<PieceSlot, Piece>& pieces() const { return pieces_; }
  const Table<TransectSlot, Transect>& transects() const { return transects_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::vector<std::string_view> parameters() const override;

 private:
  /// The present positions of the ends. O(samples), if there are any.
  std::vector<std::pair<Vec2, Vec2>> ends() const;

  SettingsSource& settings_;
  Samples& samples_;
  CenterLineEnds& ends_;
  OneStepCrust& crust_;
  InnerBalls& balls_;
  LambdaAxis& lambda_;
  AngleAxis& angle_;
  struct Wish {
    double pruning = 0.0;
    double branches = 0.0;
    double transects = 0.0;
    friend bool operator==(const Wish&, const Wish&) = default;
  };
  Wish wanted() const;

  Wish wish_;                 // of the tables
  std::size_t unjoined_ = 0;  // pairs of ends without a line
  Table<LineSlot, Line> lines_;
  Table<PieceSlot, Piece> pieces_;
  Table<TransectSlot, Transect> transects_;
};

}  // namespace mes
