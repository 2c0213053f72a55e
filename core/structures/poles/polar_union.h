// SPDX-License-Identifier: GPL-3.0-or-later
// The union of the interior polar balls: the counterpart of the union of the inner Voronoi balls for poles only.
#pragma once

#include "core/structures/balls/axis_ball_union.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/grown_complex.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

/// Rows of balls: Delaunay faces. There is no shortcut, since neighbours need not share a sample.
class PUnion final : public BallUnion {
 public:
  PUnion(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles, PoleLabels& labels);
};

class PPowerDiagram final : public PowerDiagram {
 public:
  PPowerDiagram(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
                PoleLabels& labels);
};

class PBallFiltration final : public BallFiltration {
 public:
  PBallFiltration(SettingsSource& settings, Delaunay& delaunay, VoronoiVertices& vertices, Poles& poles,
                  PoleLabels& labels);
};

class PGrownComplex final : public GrownComplex {
 public:
  PGrownComplex(SettingsSource& settings, PBallFiltration& filtration)
      : GrownComplex("p-grown-complex", settings, filtration) {}
};

class PVDiagram final : public VDiagram {
 public:
  explicit PVDiagram(PUnion& p_union) : VDiagram("p-v-diagram", {&p_union}, p_union) {}
};

class PBallSampling final : public BallSampling {
 public:
  PBallSampling(SettingsSource& settings, PUnion& balls) : BallSampling("p-ball-sampling", settings, balls) {}
};

class PScaleUnion final : public AxisBallUnion {
 public:
  PScaleUnion(SettingsSource& settings, PUnion& balls) : AxisBallUnion("p-scale-union", settings, balls) {}
};

class PScaleSampling final : public GrownBallSampling {
 public:
  PScaleSampling(SettingsSource& settings, PScaleUnion& balls)
      : GrownBallSampling("p-scale-sampling", settings, balls) {}
};

class PSkeletonUnion final : public SkeletonUnion {
 public:
  PSkeletonUnion(SettingsSource& settings, PUnion& balls) : SkeletonUnion("p-skeleton-union", settings, balls) {}
};

}  // namespace mes
