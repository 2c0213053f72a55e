// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done to what is selected, besides dragging it: by number, by formula, exactly, and by way of text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "core/edit/arrangement.h"
#include "core/graph/live_registry.h"
#include "core/io/format.h"

namespace mes {

/// What it guarantees:
///  1. Each call is one step of undo, named after what it does, or changes nothing and says why.
///  2. Samples and the centres of balls are places alike, in input order, samples first.
///  3. Nothing selected: nothing happens.
///
/// Smallest use:
///     if (const auto done = desk.turn(30); !done) messages.problem(done.error().message());
///
/// Cost: O(selected), and O(rows) to find them; on a circle some milliseconds more. Threads: the window's. It knows no
/// window and no OpenGL.
class SelectionDesk {
 public:
  SelectionDesk(LiveRegistry registry, Editor& editor) : registry_(std::move(registry)), editor_(editor) {}

  /// In units of the document.
  struct Numbers {
    std::size_t samples = 0;
    std::size_t balls = 0;
    Vec2 middle{};        ///< of the box around all places; of one its own place
    double radius = 0.0;  ///< of the largest ball
    Box2 box{};           ///< around all places
    /// Some of the box is seen.
    bool is_in(const Box2& view) const {
      return box.low.x <= view.high.x && view.low.x <= box.high.x && box.low.y <= view.high.y &&
             view.low.y <= box.high.y;
    }
  };
  /// O(1) while neither the selection nor the document changes.
  const Numbers& numbers() const;

  Expected<void> move_middle_to(Vec2 place);
  Expected<void> move_by(Vec2 step);
  /// Of all selected balls.
  Expected<void> set_radius(double radius);
  /// About the middle, counter-clockwise.
  Expected<void> turn(double degrees);
  /// About the middle; radii are multiplied, too. Error: a factor that is not above zero.
  Expected<void> scale(double factor);
  /// Left and right, or above and below, change places about the middle.
  Expected<void> mirror(Axis coordinate);
  Expected<void> align(Alignment where);
  Expected<void> distribute(Axis coordinate);

  /// Formulas (core/formula/formula.h) of new coordinates and radii, for each place by itself. Empty ones leave what they
  /// are about. They may use x, y, r, which are those of the place (r of a sample is 0), i, its number from 0, n, how
  /// many there are, and cx, cy, the middle.
  struct EachFormula {
    std::string x{};
    std::string y{};
    std::string r{};
  };
  Expected<void> place_each(const EachFormula& formulas);

  /// Moves the places onto one line, or onto one circle, exactly (core/edit/degenerate_places.h). What was done, with the
  /// largest shift.
  Expected<std::string> put_on_line();
  Expected<std::string> put_on_circle();
  /// A new ball whose circle goes through the three places that are selected, and is then selected.
  Expected<void> add_circle();

  /// What is selected as text that any reader of tables takes: a line "x <tab> y" a sample; balls alone as WPOFF; both as
  /// a session. Every double reads back.
  std::string text() const;
  struct Pasted {
    std::vector<std::string> warnings;  ///< of the reader, a line each
    std::string without;  ///< what the text has besides and was left out: "their order along 1 contour"; or empty
  };
  /// Adds what the text holds, in any format that can be opened, and selects it. Where one of its places is taken, all of
  /// it is moved by as many `step`s as it takes to find a free one. Curve order and annotations of the text are left out.
  /// `degrees` of a map. Error: that of the reader, or an empty clipboard.
  Expected<Pasted> paste(std::string_view text, Vec2 step, MapDegrees degrees = MapDegrees::projected);
  /// Adds the same once more, moved by a step, and selects it. Contours that are selected as a whole are there twice, too.
  Expected<void> duplicate(Vec2 step);

 private:
  struct Places {
    std::vector<SampleId> samples;
    std::vector<BallId> balls;
    std::vector<Vec2> at;        // of samples, then of balls
    std::vector<double> radius;  // of balls
  };
  Places places() const;
  Expected<void> put(const Places& from, std::vector<Vec2> at, const std::string& verb);
  Expected<void> put(const Places& from, std::vector<Vec2> at, std::vector<double> radius, const std::string& verb);
  /// `contours` are added, of the new samples by their places in `samples`.
  Expected<void> add(std::vector<Vec2> samples, std::vector<Disk> balls, Vec2 shift, const std::string& verb,
                     const std::vector<SampleData::Contour>& contours = {});
  Expected<void> add_contours(const std::vector<SampleData::Contour>& contours, const std::vector<SampleSlot>& rows,
                              const std::string& name);

  LiveRegistry registry_;
  Editor& editor_;
  mutable Numbers numbers_;
  mutable std::pair<std::uint64_t, std::uint64_t> numbers_of_{~std::uint64_t{0}, 0};  // revisions
};

}  // namespace mes
