// SPDX-License-Identifier: GPL-3.0-or-later
// A table of births and deaths of components and holes while disks about the samples, or the balls of a family, grow:
// computed from a document, searched by position, and written as CSV.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/document/map_plane.h"
#include "core/document/sample_data.h"
#include "core/document/settings/computation_settings.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

class Document;
class Registry;

/// The growing family: disks about the samples, or balls.
enum class GrowthOf : std::uint8_t { samples, inner, polar, own };
inline constexpr std::array kGrowths{GrowthOf::samples, GrowthOf::inner, GrowthOf::polar, GrowthOf::own};
/// "samples", "inner", "polar", "own".
std::string_view word_of(GrowthOf of);
/// "Samples", "Inner balls", "Polar balls", "Own balls".
std::string_view title_of(GrowthOf of);
/// The family of a layer of an alpha complex; nothing for other layers.
std::optional<GrowthOf> growth_of(const LayerDescriptor& layer);

/// The data that determine births and deaths.
struct PersistenceInput {
  SampleData data{};
  GrowthOf of = GrowthOf::samples;
  ComputationSettings settings{};  ///< scales of balls, and labels of poles
};
/// A digest of that data: equal for documents and settings with equal births and deaths.
std::uint64_t digest_of(const Document& document, GrowthOf of, const ComputationSettings& settings);

/// A persistence pair. Radii of births and deaths are those of disks about samples. For balls they are the growth,
/// i.e. the radius that a ball of radius 0 grows to, which is negative where the balls would have to shrink first. A
/// component is born at a sample or ball and dies by an edge that joins it to an older one; a hole is born with the
/// edge that closes it and dies with the triangle that fills it.
struct PersistenceRow {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  bool is_hole = false;
  std::uint32_t birth_rank = 0;
  std::uint32_t death_rank = kNever;  ///< `kNever`: never dies
  double birth = 0.0;                 ///< radius
  double death = 0.0;                 ///< radius; infinite: never dies
  Vec2 place{};                       ///< sample or ball of a component, or centre of the circle that fills a hole
  bool has_edge = false;              ///< a component that never dies has no edge
  std::array<Vec2, 2> edge{};         ///< the edge that joins the components or closes the hole
  std::uint32_t edge_number = 0;      ///< in filtration order
  std::uint32_t triangle = 0;         ///< for a hole: the triangle that fills it

  double persistence() const { return death - birth; }
  /// True if it exists once `ranks` filtration values have been reached.
  bool is_alive(std::uint32_t ranks) const { return birth_rank < ranks && ranks <= death_rank; }
};

/// An event at some radius.
struct GrowthEvent {
  double radius = 0.0;
  std::uint32_t rank = 0;
};

/// A rank is the index of a filtration value in the exact order of the radii. Radii of balls are rounded up, by less
/// than a part in 10^11; so compare ranks, not radii, to find what exists at a radius.
struct PersistenceTable {
  std::optional<MapPlane> map;       ///< of the data; its plane is that of all positions and lengths
  std::vector<PersistenceRow> rows;  ///< sorted by persistence, longest first
  /// The events that join components, close holes and fill holes, in filtration order.
  std::vector<GrowthEvent> joins, closes, fills;
  /// The exact number of filtration values up to a radius, which must not be negative.
  std::function<std::uint32_t(double radius)> ranks_within;
  /// The largest finite death of the rows.
  double largest_death = 0.0;
  double least_birth = 0.0;  ///< at most 0

  static constexpr std::uint32_t kOutside = 0xffffffffU;
  struct Triangle {
    std::array<Vec2, 3> corner{};
    std::array<std::uint32_t, 3> across{};  ///< the triangle opposite each corner, or `kOutside`
    std::array<std::uint32_t, 3> edge{};    ///< the number of the edge opposite each corner
  };
  std::vector<Triangle> triangles;
};

/// Throws `Cancelled`. Error: a structure failed. Cost: the triangulation and its filtration from scratch.
Expected<PersistenceTable> persistence_table_of(const Registry& registry, const PersistenceInput& input,
                                                JobControl& job);

/// Radii between which nothing is joined, closed or filled.
struct RadiusGap {
  double begin = 0.0;  ///< above 0
  double end = 0.0;
  /// The radius whose ratios to both ends are equal.
  double middle() const { return std::sqrt(begin) * std::sqrt(end); }
};
/// The gap with the largest ratio of its ends among those above the radius at which half of the joins have happened, so
/// that samples that nearly coincide do not decide. Nothing if fewer than two events remain. A radius in it is proposed
/// for the alpha complex: features below it are noise, and those above it are the shape.
std::optional<RadiusGap> widest_gap(const PersistenceTable& table);

/// The edges around a hole when it closes; empty for a component.
std::vector<std::array<Vec2, 2>> outline_of(const PersistenceTable& table, const PersistenceRow& row);

/// The row whose sample or centre is nearest to the point, within `reach`; if there is none, the row whose edge is;
/// else the longest hole whose last triangle contains the point.
std::optional<std::size_t> row_near(const PersistenceTable& table, Vec2 place, double reach);

/// "hole, born at 1.5, filled at 4, persistence 2.5"; with the unit of a map.
std::string in_words(const PersistenceRow& row, const std::optional<MapPlane>& map);

/// A component has the dimension 0, a hole 1; death and persistence of what stays, and its edge, are empty.
/// Positions are in the coordinate system of the map, radii in its unit. Error: as for `WrittenPlane`.
Expected<std::string> persistence_as_csv(const PersistenceTable& table);

}  // namespace mes
