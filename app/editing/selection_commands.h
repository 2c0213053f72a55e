// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on the selection besides dragging: by number, by formula, exactly, and through text.
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

/// Guarantees:
///  1. Each call is one step of undo, named after its effect, or changes nothing and returns the reason.
///  2. Samples and the centres of balls are treated alike as points, in input order, samples first.
///  3. Without a selection nothing happens.
///
/// Smallest use:
///     if (const auto done = commands.turn(30); !done) messages.problem(done.error().message());
///
/// Cost: O(selected), and O(rows) to find them; on a circle some milliseconds more. Threads: the window's. Depends on
/// no window and no OpenGL.
class SelectionCommands {
 public:
  SelectionCommands(LiveRegistry registry, Editor& editor) : registry_(std::move(registry)), editor_(editor) {}

  /// Numbers of the selection, in units of the document.
  struct Numbers {
    std::size_t samples = 0;
    std::size_t balls = 0;
    Vec2 middle{};        ///< centre of the box around all points; for one point the point itself
    double radius = 0.0;  ///< radius of the largest ball
    Box2 box{};           ///< bounding box of all points
    /// True if some of the box is visible.
    bool is_in(const Box2& view) const {
      return box.low.x <= view.high.x && view.low.x <= box.high.x && box.low.y <= view.high.y &&
             view.low.y <= box.high.y;
    }
  };
  /// O(1) while neither the selection nor the document changes.
  const Numbers& numbers() const;
  /// The map that the numbers are positions and lengths of.
  const std::optional<MapPlane>& map() const { return editor_.document().map(); }

  Expected<void> move_middle_to(Vec2 place);
  Expected<void> move_by(Vec2 step);
  /// Sets the radius of all selected balls.
  Expected<void> set_radius(double radius);
  /// Turns about the middle, counter-clockwise.
  Expected<void> turn(double degrees);
  /// Scales about the middle and multiplies radii, too. Error: a factor that is not above zero.
  Expected<void> scale(double factor);
  /// Swaps left and right, or above and below, about the middle.
  Expected<void> mirror(Axis coordinate);
  Expected<void> align(Alignment where);
  Expected<void> distribute(Axis coordinate);

  /// Formulas (core/formula/formula.h) for new coordinates and radii, evaluated for each point. An empty formula
  /// leaves its number unchanged. Formulas may use x, y, r of the point (r of a sample is 0), its index i from 0, the
  /// number n of points, and the middle cx, cy.
  struct EachFormula {
    std::string x{};
    std::string y{};
    std::string r{};
  };
  Expected<void> place_each(const EachFormula& formulas);

  /// Moves the points onto one line, or onto one circle, exactly (core/edit/degenerate_places.h). Returns a sentence
  /// on the effect with the largest shift.
  Expected<std::string> put_on_line();
  Expected<std::string> put_on_circle();
  /// Adds a ball whose circle passes through the three selected points, and selects it.
  Expected<void> add_circle();

  /// The selection as text that any reader of tables takes: a line "x <tab> y" per sample; balls alone as WPOFF; both
  /// as a session. Every double can be read back exactly.
  std::string text() const;
  struct Pasted {
    std::vector<std::string> warnings;  ///< warnings of the reader, one line each
    std::string without;  ///< contents of the text that were left out: "their order along 1 contour"; or empty
  };
  /// Adds the contents of the text, in any format that can be opened, and selects them. If one of their positions is
  /// taken, all are moved by as many `step`s as are needed to find free ones. Curve order and annotations of the text
  /// are left out. `degrees` applies to maps. Error: that of the reader, or an empty clipboard.
  Expected<Pasted> paste(std::string_view text, Vec2 step, MapDegrees degrees = MapDegrees::projected);
  /// True if the document is empty and the text is a session, a map, or has curves, contours or annotations: it is then
  /// better opened as a document of its own, which keeps them. Cost: reads the text.
  bool begins_document(std::string_view text, MapDegrees degrees) const;
  /// Adds a copy of the selection, moved by a step, and selects it. Completely selected contours are copied, too.
  Expected<void> duplicate(Vec2 step);

 private:
  Expected<LoadedFile> read(std::string_view text, MapDegrees degrees) const;
  struct Places {
    std::vector<SampleId> samples;
    std::vector<BallId> balls;
    std::vector<Vec2> at;        // positions of samples, then of balls
    std::vector<double> radius;  // radii of balls
  };
  Places places() const;
  Expected<void> put(const Places& from, std::vector<Vec2> at, const std::string& verb);
  Expected<void> put(const Places& from, std::vector<Vec2> at, std::vector<double> radius, const std::string& verb);
  /// `contours` are added; they refer to the new samples by index in `samples`.
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
