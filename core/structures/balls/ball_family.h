// SPDX-License-Identifier: GPL-3.0-or-later
// A set of balls whose union is analysed, with the same interface for every source.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Row of a ball in its family. Each family says which table's rows these are.
using FamilySlot = Slot<struct FamilyTag>;

/// A Delaunay site on the circle of a ball.
struct TouchedSample {
  SiteSlot site;
  Vec2 position{};
};

/// The exact definition of a ball before scaling; `BallFamily::plain_disk` may be rounded.
enum class BallOrigin : std::uint8_t {
  disk,            ///< the disk as given
  circumdisk,      ///< circle through three samples
  through_sample,  ///< centre as given, and the one sample that it touches lies on its circle
};

/// Threads: const functions are safe.
class BallFamily {
 public:
  virtual ~BallFamily() = default;
  virtual std::size_t rows() const = 0;
  /// The table that these rows belong to, as in "delaunay/faces"; empty if no structure has it.
  virtual std::string_view rows_of() const { return {}; }
  /// Each real ball has one row for which this is true, or several that are equal as doubles.
  virtual bool is_ball(FamilySlot row) const = 0;
  /// The disk before scaling, rounded to doubles.
  virtual Disk plain_disk(FamilySlot row) const = 0;
  /// The scaled disk, rounded to doubles.
  Disk disk(FamilySlot row) const {
    const Disk plain = plain_disk(row);
    return {plain.center, plain.radius * scale_};
  }
  virtual bool is_from_samples() const = 0;
  /// True if these are the inner balls, which the theorem is about.
  virtual bool are_inner() const { return false; }
  /// True if balls touch samples, which give their circles and crossings exactly. False for scaled balls.
  bool touch_samples() const { return is_from_samples() && scale_ == 1.0; }
  virtual BallOrigin origin(FamilySlot) const {
    return is_from_samples() ? BallOrigin::circumdisk : BallOrigin::disk;
  }
  /// The samples of a circumdisk, counter-clockwise.
  virtual std::array<Vec2, 3> corners(FamilySlot row) const = 0;
  /// Appends every sample on the circle before scaling: more than three when samples are cocircular.
  virtual void touched_samples(FamilySlot row, std::vector<TouchedSample>& out) const = 0;
  /// True if the last update of the family's source added, changed or removed a ball.
  virtual bool has_changed() const = 0;
  /// The ball of the document in this row, or kNoSlot.
  virtual BallSlot ball_of_document(FamilySlot) const { return {}; }

  /// The factor that radii are multiplied by.
  double scale() const { return scale_; }
  void set_scale(double scale) { scale_ = scale; }

 private:
  double scale_ = 1.0;
};

}  // namespace mes
