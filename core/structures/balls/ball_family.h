// SPDX-License-Identifier: GPL-3.0-or-later
// A set of balls whose union is to be analysed, seen alike whatever it comes from.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/disk.h"
#include "core/base/vec2.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Row of a ball in its family. Each family says which table's rows these are.
using FamilySlot = Slot<struct FamilyTag>;

/// A Delaunay site on the circle of a ball.
struct TouchedSample {
  SiteSlot site;
  Vec2 position{};
};

/// What exactly a ball is before scaling; `BallFamily::plain_disk` may be rounded.
enum class BallOrigin : std::uint8_t {
  disk,            ///< the disk as it stands
  circumdisk,      ///< of three samples
  through_sample,  ///< with the centre as it stands, and the one sample it touches on its circle
};

/// Threads: const is safe.
class BallFamily {
 public:
  virtual ~BallFamily() = default;
  virtual std::size_t rows() const = 0;
  /// The table whose rows these are, as in "delaunay/faces"; empty if no structure has it.
  virtual std::string_view rows_of() const { return {}; }
  /// Each real ball has one row of which this holds, or several that are equal as doubles.
  virtual bool is_ball(FamilySlot row) const = 0;
  /// Before scaling, rounded to doubles.
  virtual Disk plain_disk(FamilySlot row) const = 0;
  /// Scaled, rounded to doubles.
  Disk disk(FamilySlot row) const {
    const Disk plain = plain_disk(row);
    return {plain.center, plain.radius * scale_};
  }
  virtual bool is_from_samples() const = 0;
  /// Every ball touches samples, which give its circle and its crossings with others exactly. False for scaled balls.
  bool touch_samples() const { return is_from_samples() && scale_ == 1.0; }
  virtual BallOrigin origin(FamilySlot) const {
    return is_from_samples() ? BallOrigin::circumdisk : BallOrigin::disk;
  }
  /// The samples of a circumdisk, counter-clockwise.
  virtual std::array<Vec2, 3> corners(FamilySlot row) const = 0;
  /// Appends every sample on the circle before scaling: more than three when samples are cocircular.
  virtual void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const = 0;
  /// A ball came, changed or went in the last update of what the family is made of.
  virtual bool has_changed() const = 0;
  /// The ball of the document that it is, or none.
  virtual BallSlot ball_of_document(FamilySlot) const { return {}; }

  /// What radii are multiplied by.
  double scale() const { return scale_; }
  void set_scale(double scale) { scale_ = scale; }

 private:
  double scale_ = 1.0;
};

}  // namespace mes
