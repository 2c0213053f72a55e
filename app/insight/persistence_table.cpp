// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/insight/persistence_table.h"

#include <fmt/core.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "app/layers/words/length_words.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"
#include "core/structures/alpha/alpha_filtration.h"
#include "core/structures/poles/polar_union.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

double distance_to_segment(const std::array<Vec2, 2>& edge, Vec2 p) {
  const Vec2 along = edge[1] - edge[0];
  const double size = dot(along, along);
  const double t = size > 0.0 ? std::clamp(dot(p - edge[0], along) / size, 0.0, 1.0) : 0.0;
  return distance(p, edge[0] + t * along);
}

bool holds(const PersistenceTable::Triangle& triangle, Vec2 p) {
  const auto& c = triangle.corner;
  return cross(c[1] - c[0], p - c[0]) >= 0.0 && cross(c[2] - c[1], p - c[1]) >= 0.0 &&
         cross(c[0] - c[2], p - c[2]) >= 0.0;
}

/// Reads positions and radii of births and deaths from the rows of some filtration.
struct Reading {
  std::function<double(std::uint32_t rank)> radius;
  std::function<Vec2(std::size_t corner)> corner;
  std::function<std::array<std::size_t, 2>(std::size_t edge)> ends;
  std::function<Vec2(std::size_t triangle)> center;
};

/// `Class` is a class of a filtration; the numbers of edges and triangles are those of the table.
template <class Class>
void add_rows(const std::vector<Class>& classes, const Reading& read, auto corner_of, auto edge_of, auto triangle_of,
              PersistenceTable& out) {
  out.rows.reserve(classes.size());
  for (const Class& one : classes) {
    PersistenceRow row;
    row.is_hole = one.is_hole;
    row.birth_rank = one.birth;
    row.death_rank = one.death;
    row.birth = read.radius(one.birth);
    const bool stays = one.death == PersistenceRow::kNever;
    row.death = stays ? std::numeric_limits<double>::infinity() : read.radius(one.death);
    if (one.edge != kNoSlot) {
      row.has_edge = true;
      row.edge_number = edge_of(one);
      const auto ends = read.ends(row.edge_number);
      row.edge = {read.corner(ends[0]), read.corner(ends[1])};
      if (lexicographically_less(row.edge[1], row.edge[0])) std::swap(row.edge[0], row.edge[1]);
    }
    if (one.is_hole) {
      row.triangle = triangle_of(one);
      row.place = read.center(row.triangle);
      out.closes.push_back({row.birth, one.birth});
      out.fills.push_back({row.death, one.death});
    } else {
      row.place = read.corner(corner_of(one));
      if (!stays) out.joins.push_back({row.death, one.death});
    }
    if (!stays) out.largest_death = std::max(out.largest_death, row.death);
    out.least_birth = std::min(out.least_birth, row.birth);
    out.rows.push_back(row);
  }
  for (std::vector<GrowthEvent>* const events : {&out.joins, &out.closes, &out.fills})
    std::ranges::sort(*events, {}, &GrowthEvent::rank);
  std::ranges::stable_sort(
      out.rows, [](const PersistenceRow& a, const PersistenceRow& b) { return a.persistence() > b.persistence(); });
}

PersistenceTable table_of(const Delaunay& delaunay, const AlphaFiltration& filtration) {
  PersistenceTable out;
  Table<EdgeSlot, std::uint32_t> number_of_edge(delaunay.edge_rows(), 0);
  for (std::uint32_t i = 0; i < filtration.edges().size(); ++i) number_of_edge[filtration.edges()[i]] = i;
  Table<FaceSlot, std::uint32_t> number_of_face(delaunay.face_rows(), PersistenceTable::kOutside);
  for (std::uint32_t i = 0; i < filtration.faces().size(); ++i) number_of_face[filtration.faces()[i]] = i;
  out.triangles.reserve(filtration.faces().size());
  for (const FaceSlot face : filtration.faces()) {
    const FaceRow& row = delaunay.face(face);
    PersistenceTable::Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corner[i] = delaunay.site_position(row.v[i]);
      triangle.across[i] = number_of_face[row.n[i]];
      triangle.edge[i] = number_of_edge[row.e[i]];
    }
    out.triangles.push_back(triangle);
  }
  const Reading read{[&](std::uint32_t rank) { return filtration.radius(rank); },
                     [&](std::size_t site) { return delaunay.site_position(SiteSlot(site)); },
                     [&](std::size_t edge) {
                       const SiteSlot* const end = delaunay.edge(filtration.edges()[edge]).v;
                       return std::array<std::size_t, 2>{end[0].index(), end[1].index()};
                     },
                     [&](std::size_t triangle) { return delaunay.circumcenter(filtration.faces()[triangle]); }};
  using Class = AlphaFiltration::Class;
  add_rows(
      filtration.classes(), read, [](const Class& one) { return one.site.index(); },
      [&](const Class& one) { return number_of_edge[one.edge]; },
      [&](const Class& one) { return number_of_face[one.face]; }, out);
  std::vector<double> radii(filtration.rank_count());
  for (std::uint32_t rank = 0; rank < radii.size(); ++rank) radii[rank] = filtration.radius(rank);
  // The radii are rounded up to the next double, so no double lies between the exact radius and its rounding.
  out.ranks_within = [radii = std::make_shared<const std::vector<double>>(std::move(radii))](double radius) {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(*radii, radius) - radii->begin());
  };
  return out;
}

PersistenceTable table_of(const BallFiltration& filtration) {
  PersistenceTable out;
  const auto center = [&](GrownCornerSlot corner) { return filtration.disk(corner).center; };
  out.triangles.reserve(filtration.triangles().size());
  for (const BallBirths::Triangle& row : filtration.triangles()) {
    PersistenceTable::Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corner[i] = center(row.v[i]);
      triangle.across[i] = row.n[i] == kNoSlot ? PersistenceTable::kOutside : row.n[i].index();
      triangle.edge[i] = row.e[i].index();
    }
    out.triangles.push_back(triangle);
  }
  const Reading read{
      [&](std::uint32_t rank) { return filtration.growth(rank); },
      [&](std::size_t corner) { return center(GrownCornerSlot(corner)); },
      [&](std::size_t edge) {
        const auto& v = filtration.edges()[GrownEdgeSlot(edge)].v;
        return std::array<std::size_t, 2>{v[0].index(), v[1].index()};
      },
      [&](std::size_t triangle) { return filtration.triangles()[GrownTriangleSlot(triangle)].center; }};
  using Class = BallFiltration::Class;
  add_rows(
      filtration.classes(), read, [](const Class& one) { return one.corner.index(); },
      [](const Class& one) { return one.edge.index(); }, [](const Class& one) { return one.triangle.index(); }, out);
  out.ranks_within = [ranks = filtration.ranks()](double radius) { return ranks->within(radius); };
  return out;
}

constexpr std::array<std::string_view, kGrowths.size()> kFiltrations{"alpha-filtration", "a-ball-filtration",
                                                                     "p-ball-filtration", "b-ball-filtration"};

}  // namespace

std::string_view word_of(GrowthOf of) {
  constexpr std::array<std::string_view, kGrowths.size()> kWords{"samples", "inner", "polar", "own"};
  return kWords[static_cast<std::size_t>(of)];
}
std::string_view title_of(GrowthOf of) {
  switch (of) {
    case GrowthOf::samples: return "Samples";
    case GrowthOf::inner: return title_of(LayerGroup::union_a);
    case GrowthOf::polar: return title_of(LayerGroup::union_p);
    case GrowthOf::own: break;
  }
  return title_of(LayerGroup::union_b);
}

/// The structure that holds the complex of the growing balls.
std::string_view complex_of(GrowthOf of) {
  constexpr std::array<std::string_view, kGrowths.size()> kComplexes{"alpha-complex", "a-grown-complex",
                                                                     "p-grown-complex", "b-grown-complex"};
  return kComplexes[static_cast<std::size_t>(of)];
}

std::optional<GrowthOf> growth_of(const LayerDescriptor& layer) {
  for (const GrowthOf of : kGrowths)
    if (std::ranges::find(layer.structures, complex_of(of)) != layer.structures.end()) return of;
  return std::nullopt;
}

std::uint64_t digest_of(const Document& document, GrowthOf of, const ComputationSettings& settings) {
  const auto with = [](std::uint64_t digest, double value) {
    return (digest ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
  };
  const auto value = [&](const Parameter& parameter) { return settings[parameter]; };
  switch (of) {
    case GrowthOf::samples: break;
    case GrowthOf::inner: return with(document.sample_digest() + 1, value(Parameter::a_scale));
    case GrowthOf::polar:
      return with(
          with(with(document.sample_digest() + 2, value(Parameter::p_scale)), value(Parameter::pole_propagation)),
          static_cast<double>(settings.precision));
    case GrowthOf::own: return with(document.ball_digest() + 3, value(Parameter::b_scale));
  }
  return document.sample_digest();
}

Expected<PersistenceTable> persistence_table_of(const Registry& registry, const PersistenceInput& input,
                                                JobControl& job) {
  Workbench bench(registry, {.keeps_document = false});
  bench.choose(input.settings);
  bench.need({kFiltrations[static_cast<std::size_t>(input.of)]});
  const SampleData alone = input.of == GrowthOf::own ? SampleData{.balls = input.data.balls}
                                                     : SampleData{.positions = input.data.positions};
  if (auto good = bench.load(alone); !good) return std::unexpected(good.error());
  if (auto good = bench.run_or_throw(job); !good) return std::unexpected(good.error());
  const auto table = [&] {
    switch (input.of) {
      case GrowthOf::samples: break;
      case GrowthOf::inner: return table_of(bench.get<ABallFiltration>());
      case GrowthOf::polar: return table_of(bench.get<PBallFiltration>());
      case GrowthOf::own: return table_of(bench.get<BBallFiltration>());
    }
    return table_of(bench.get<Delaunay>(), bench.get<AlphaFiltration>());
  };
  PersistenceTable out = table();
  out.map = input.data.map;
  return out;
}

// The hole is the set of triangles reachable from its last one without crossing edges that exist when it closes.
std::optional<RadiusGap> widest_gap(const PersistenceTable& table) {
  double least = 0.0;
  if (!table.joins.empty()) least = table.joins[(table.joins.size() - 1) / 2].radius;
  std::vector<double> radii;
  for (const std::vector<GrowthEvent>* const events : {&table.joins, &table.closes, &table.fills})
    for (const GrowthEvent& event : *events)
      if (event.radius > 0.0 && event.radius >= least) radii.push_back(event.radius);
  std::ranges::sort(radii);
  std::optional<RadiusGap> out;
  for (std::size_t i = 1; i < radii.size(); ++i) {
    const RadiusGap gap{radii[i - 1], radii[i]};
    if (gap.end > gap.begin && (!out || gap.end / gap.begin > out->end / out->begin)) out = gap;
  }
  return out;
}

std::vector<std::array<Vec2, 2>> outline_of(const PersistenceTable& table, const PersistenceRow& row) {
  std::vector<std::array<Vec2, 2>> out;
  if (!row.is_hole) return out;
  std::vector<bool> is_inside(table.triangles.size(), false);
  std::vector<std::uint32_t> inside{row.triangle};
  is_inside[row.triangle] = true;
  for (std::size_t at = 0; at < inside.size(); ++at) {
    const PersistenceTable::Triangle& triangle = table.triangles[inside[at]];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t across = triangle.across[i];
      if (triangle.edge[i] <= row.edge_number || across == PersistenceTable::kOutside || is_inside[across]) continue;
      is_inside[across] = true;
      inside.push_back(across);
    }
  }
  for (const std::uint32_t number : inside) {
    const PersistenceTable::Triangle& triangle = table.triangles[number];
    for (std::size_t i = 0; i < 3; ++i)
      if (triangle.across[i] == PersistenceTable::kOutside || !is_inside[triangle.across[i]])
        out.push_back({triangle.corner[(i + 1) % 3], triangle.corner[(i + 2) % 3]});
  }
  return out;
}

std::optional<std::size_t> row_near(const PersistenceTable& table, Vec2 place, double reach) {
  std::optional<std::size_t> out;
  double least = reach;
  const auto look_at = [&](std::size_t i, double here) {
    if (here > least || (here == least && out)) return;
    least = here;
    out = i;
  };
  for (std::size_t i = 0; i < table.rows.size(); ++i) look_at(i, distance(table.rows[i].place, place));
  // Edges are searched only now: an edge is never farther than its ends and would always win.
  for (std::size_t i = 0, found = out ? 1 : 0; i < table.rows.size() && found == 0; ++i)
    if (table.rows[i].has_edge) look_at(i, distance_to_segment(table.rows[i].edge, place));
  for (std::size_t i = 0; i < table.rows.size() && !out; ++i)
    if (table.rows[i].is_hole && holds(table.triangles[table.rows[i].triangle], place)) out = i;
  return out;
}

std::string in_words(const PersistenceRow& row, const std::optional<MapPlane>& map) {
  const std::string birth = length_words(row.birth, map);
  if (std::isinf(row.death)) return fmt::format("component, born at {}, stays", birth);
  return fmt::format("{}, born at {}, {} at {}, persistence {}", row.is_hole ? "hole" : "component", birth,
                     row.is_hole ? "filled" : "joined", length_words(row.death, map),
                     length_words(row.persistence(), map));
}

Expected<std::string> persistence_as_csv(const PersistenceTable& table) {
  const auto written = WrittenPlane::of(table.map);
  if (!written) return std::unexpected(written.error());
  std::string out = "dimension,birth,death,persistence,x,y,edge_x1,edge_y1,edge_x2,edge_y2\n";
  const auto add = [&out](double x) {
    out += ',';
    if (std::isfinite(x)) append_number(out, x);
  };
  for (const PersistenceRow& row : table.rows) {
    out += row.is_hole ? '1' : '0';
    for (const double x : {row.birth, row.death, row.persistence()}) add(written->length(x));
    const auto add_position = [&](Vec2 p) {
      const Vec2 place = written->position(p);
      for (const double x : {place.x, place.y}) add(x);
    };
    add_position(row.place);
    if (row.has_edge)
      for (const Vec2 end : row.edge) add_position(end);
    else
      out += ",,,,";
    out += '\n';
  }
  return out;
}

}  // namespace mes
