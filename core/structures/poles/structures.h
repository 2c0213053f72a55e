// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/poles/polar_diagram.h"
#include "core/structures/poles/polar_union.h"
#include "core/structures/poles/pole_labels.h"
#include "core/structures/poles/poles.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_pole_structures(Registry& registry) {
  registry.add_structure<Poles, Delaunay, VoronoiVertices>();
  registry.add_structure<PoleLabels, SettingsSource, Delaunay, VoronoiVertices, Labels, Poles>();
  registry.add_structure<PolarDiagram, SettingsSource, Delaunay, VoronoiVertices, Poles>();
  registry.add_structure<PowerCrust, PoleLabels, PolarDiagram>();
  registry.add_structure<PUnion, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>();
  registry.add_structure<PPowerDiagram, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>();
  registry.add_structure<PVDiagram, PUnion>();
  registry.add_structure<PBallSampling, SettingsSource, PUnion>();
  registry.add_structure<PBallFiltration, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>();
  registry.add_structure<PGrownComplex, SettingsSource, PBallFiltration>();
  registry.add_structure<PScaleUnion, SettingsSource, PUnion>();
  registry.add_structure<PScaleSampling, SettingsSource, PScaleUnion>();
  registry.add_structure<PSkeletonUnion, SettingsSource, PUnion>();
}

}  // namespace mes
