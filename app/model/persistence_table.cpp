// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/model/persistence_table.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "app/model/samples_alone.h"
#include "core/io/text_numbers.h"
#include "core/structures/alpha/alpha_filtration.h"

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

void add_triangles(const Delaunay& delaunay, const AlphaFiltration& filtration,
                   const Table<EdgeSlot, std::uint32_t>& number_of_edge, PersistenceTable& out,
                   Table<FaceSlot, std::uint32_t>& number_of_face) {
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
}

PersistenceTable table_of(const Delaunay& delaunay, const AlphaFiltration& filtration) {
  PersistenceTable out;
  Table<EdgeSlot, std::uint32_t> number_of_edge(delaunay.edge_rows(), 0);
  for (std::uint32_t i = 0; i < filtration.edges().size(); ++i) number_of_edge[filtration.edges()[i]] = i;
  Table<FaceSlot, std::uint32_t> number_of_face(delaunay.face_rows(), PersistenceTable::kOutside);
  add_triangles(delaunay, filtration, number_of_edge, out, number_of_face);
  out.rows.reserve(filtration.classes().size());
  for (const AlphaFiltration::Class& one : filtration.classes()) {
    PersistenceRow row;
    row.is_hole = one.is_hole;
    row.birth = filtration.radius(one.birth);
    const bool stays = one.death == AlphaFiltration::kNever;
    row.death = stays ? std::numeric_limits<double>::infinity() : filtration.radius(one.death);
    if (one.edge != kNoSlot) {
      row.has_edge = true;
      const SiteSlot* const end = delaunay.edge(one.edge).v;
      row.edge = {delaunay.site_position(end[0]), delaunay.site_position(end[1])};
      if (lexicographically_less(row.edge[1], row.edge[0])) std::swap(row.edge[0], row.edge[1]);
      row.edge_number = number_of_edge[one.edge];
    }
    if (one.is_hole) {
      row.place = delaunay.circumcenter(one.face);
      row.triangle = number_of_face[one.face];
      out.closes.push_back(row.birth);
      out.fills.push_back(row.death);
    } else {
      row.place = delaunay.site_position(one.site);
      if (!stays) out.joins.push_back(row.death);
    }
    if (!stays) out.largest_death = std::max(out.largest_death, row.death);
    out.rows.push_back(row);
  }
  for (std::vector<double>* const radii : {&out.joins, &out.closes, &out.fills}) std::ranges::sort(*radii);
  std::ranges::stable_sort(
      out.rows, [](const PersistenceRow& a, const PersistenceRow& b) { return a.persistence() > b.persistence(); });
  return out;
}

}  // namespace

Expected<PersistenceTable> persistence_table_of(const SampleData& data, JobControl& job) {
  Graph graph;
  if (auto good = compute_samples_alone(graph, data.positions, "alpha-edges", job); !good)
    return std::unexpected(good.error());
  return table_of(graph.structures().get<Delaunay>(), graph.structures().get<AlphaFiltration>());
}

// The hole is what can be reached from its last triangle without passing edges that are there when it is closed.
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
  // No end of an edge is nearer than the edge.
  for (std::size_t i = 0, found = out ? 1 : 0; i < table.rows.size() && found == 0; ++i)
    if (table.rows[i].has_edge) look_at(i, distance_to_segment(table.rows[i].edge, place));
  for (std::size_t i = 0; i < table.rows.size() && !out; ++i)
    if (table.rows[i].is_hole && holds(table.triangles[table.rows[i].triangle], place)) out = i;
  return out;
}

std::string in_words(const PersistenceRow& row) {
  if (std::isinf(row.death)) return fmt::format("component, born at {:.4g}, stays", row.birth);
  return fmt::format("{}, born at {:.4g}, {} at {:.4g}, persistence {:.4g}", row.is_hole ? "hole" : "component",
                     row.birth, row.is_hole ? "filled" : "joined", row.death, row.persistence());
}

std::string persistence_as_csv(const PersistenceTable& table) {
  std::string out = "dimension,birth,death,persistence,x,y,edge_x1,edge_y1,edge_x2,edge_y2\n";
  const auto add = [&out](double x) {
    out += ',';
    if (std::isfinite(x)) append_number(out, x);
  };
  for (const PersistenceRow& row : table.rows) {
    out += row.is_hole ? '1' : '0';
    for (const double x : {row.birth, row.death, row.persistence(), row.place.x, row.place.y}) add(x);
    for (const Vec2 end : row.edge)
      for (const double x : {end.x, end.y}) add(row.has_edge ? x : std::numeric_limits<double>::infinity());
    out += '\n';
  }
  return out;
}

}  // namespace mes
