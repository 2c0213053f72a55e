// SPDX-License-Identifier: GPL-3.0-or-later
// Births and deaths of components and holes while disks about the samples grow, or the balls of a family, as a table:
// computed from a document, looked up by place, and written as CSV.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/vec2.h"
#include "core/document/commands.h"
#include "core/document/computation_settings.h"
#include "core/draw/layer_descriptor.h"

namespace mes {

class Registry;

/// What grows: disks about the samples, or the balls of a family.
enum class GrowthOf : std::uint8_t { samples, inner, polar, own };
inline constexpr std::array kGrowths{GrowthOf::samples, GrowthOf::inner, GrowthOf::polar, GrowthOf::own};
/// "samples", "inner", "polar", "own".
std::string_view word_of(GrowthOf of);
/// "Samples", "Inner balls", "Polar balls", "Own balls".
std::string_view title_of(GrowthOf of);
/// Of a layer of an alpha complex; nothing for other layers.
std::optional<GrowthOf> growth_of(const LayerDescriptor& layer);

/// What births and deaths follow from.
struct PersistenceInput {
  SampleData data{};
  GrowthOf of = GrowthOf::samples;
  ComputationSettings settings{};  ///< scales of balls, and labels of poles
};
/// Of what follows from it: equal for documents and settings with equal births and deaths.
std::uint64_t digest_of(const Document& document, GrowthOf of, const ComputationSettings& settings);

/// Radii of births and deaths are those of disks about samples, or the growth of balls: the radius that a ball of radius 0
/// grows to. It is negative where balls as they are have what is born: there they would have to shrink first.
/// A component is born at a sample or ball and dies by an edge that joins it to an older one; a hole is born with the edge that
/// closes it and dies with the triangle that fills it.
struct PersistenceRow {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

  bool is_hole = false;
  std::uint32_t birth_rank = 0;
  std::uint32_t death_rank = kNever;  ///< `kNever`: it stays
  double birth = 0.0;                 ///< radius
  double death = 0.0;                 ///< radius; infinite: it stays
  Vec2 place{};           ///< of a component its sample or ball, of a hole the centre of the circle that fills it
  bool has_edge = false;  ///< a component that stays has none
  std::array<Vec2, 2> edge{};     ///< joins or closes
  std::uint32_t edge_number = 0;  ///< in the order in which edges come
  std::uint32_t triangle = 0;     ///< of a hole: the one that fills it

  double persistence() const { return death - birth; }
  /// When so many ranks have come.
  bool is_alive(std::uint32_t ranks) const { return birth_rank < ranks && ranks <= death_rank; }
};

/// Something that happens at a radius.
struct GrowthEvent {
  double radius = 0.0;
  std::uint32_t rank = 0;
};

/// Ranks number what comes at the same radius, in the order of the radii as real numbers. Radii of balls are rounded, up and
/// by less than a part in 10^11; so what is there at a radius is for ranks to say.
struct PersistenceTable {
  std::vector<PersistenceRow> rows;  ///< the longest first
  /// Where components are joined, holes closed and holes filled; in the order in which that happens.
  std::vector<GrowthEvent> joins, closes, fills;
  /// How many ranks have come at a radius, exactly; it is not negative.
  std::function<std::uint32_t(double radius)> ranks_within;
  /// Of the rows.
  double largest_death = 0.0;
  double least_birth = 0.0;  ///< not above 0

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

/// The edges around a hole when it is closed; none of a component.
std::vector<std::array<Vec2, 2>> outline_of(const PersistenceTable& table, const PersistenceRow& row);

/// The row whose sample or centre is nearest to the place, of those that are no farther than `reach`, or, where there is
/// none, the one whose edge is; else the longest hole of those whose last triangle holds the place.
std::optional<std::size_t> row_near(const PersistenceTable& table, Vec2 place, double reach);

/// "hole, born at 1.5, filled at 4, persistence 2.5".
std::string in_words(const PersistenceRow& row);

/// A component has the dimension 0, a hole 1; death and persistence of what stays, and its edge, are empty.
std::string persistence_as_csv(const PersistenceTable& table);

}  // namespace mes
