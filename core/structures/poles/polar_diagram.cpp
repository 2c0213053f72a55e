// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/poles/polar_diagram.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/base/sum.h"

namespace mes {

PolarDiagram::PolarDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles)
    : PolarDiagram(settings, delaunay, vertices, poles, std::make_unique<PolarBalls>(delaunay, vertices, poles)) {}

PolarDiagram::PolarDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
                           std::unique_ptr<PolarBalls> family)
    : PowerDiagram("polar-diagram", {&settings, &delaunay, &vertices, &poles}, settings, std::move(family)),
      polar_balls_(static_cast<PolarBalls&>(own_family())) {}

void PolarDiagram::rebuild(JobControl& job) {
  polar_balls_.measure();
  PowerDiagram::rebuild(job);
}

PowerCrust::PowerCrust(PoleLabels& labels, PolarDiagram& diagram)
    : Structure("power-crust", {&labels, &diagram}), labels_(labels), diagram_(diagram) {}

void PowerCrust::rebuild(JobControl&) {
  const auto is_inside = [this](FamilySlot ball) {
    const FaceSlot pole = diagram_.pole_of(ball);
    return pole != kInfinitePole && labels_.is_inside(pole);
  };
  const Table<PowerEdgeSlot, PowerEdge>& edges = diagram_.edges();
  is_crust_.resize(edges.size());
  for (const PowerEdgeSlot i : edges.rows())
    is_crust_[i] = is_inside(edges[i].ball[0]) != is_inside(edges[i].ball[1]) ? 1 : 0;
}

bool PowerCrust::update(JobControl&) {
  return labels_.changes().is_empty();
}

StatList PowerCrust::statistics() const {
  const Table<PowerEdgeSlot, PowerEdge>& edges = diagram_.edges();
  DisjointSets<TriangleSlot> joined;
  std::int64_t crust = 0;
  std::int64_t unbounded = 0;
  std::int64_t loops = 0;
  Sum length;
  for (const PowerEdgeSlot i : edges.rows()) {
    if (is_crust_[i] == 0) continue;
    const PowerEdge& edge = edges[i];
    if (edge.kind != PowerEdge::Kind::segment) {
      ++unbounded;
      continue;
    }
    crust += edge.from != edge.to ? 1 : 0;
    length.add(edge.length);
    joined.grow(std::max(edge.face[0], edge.face[1]).index() + std::size_t{1});
    const TriangleSlot a = joined.root(edge.face[0]);
    const TriangleSlot b = joined.root(edge.face[1]);
    // Every vertex has two crust edges, so a curve closes just once.
    loops += a == b ? 1 : 0;
    joined.join(b, a);
  }
  return {{"edges", crust}, {"unbounded", unbounded}, {"loops", loops}, {"length", length.value()}};
}

}  // namespace mes
