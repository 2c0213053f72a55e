// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/axis_ball_union.h"
#include "core/structures/balls/axis_difference.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/grown_complex.h"
#include "core/structures/balls/internal/growth/ball_filtration.h"
#include "core/structures/balls/kept_union.h"
#include "core/structures/balls/precision_difference.h"
#include "core/structures/balls/scale_axis.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/lambda_axis.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/inputs/user_balls.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_ball_structures(Registry& registry) {
  registry.add_structure<AUnion, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis,
                         AxisCertificate>();
  registry.add_structure<AxisDifference, Delaunay, OneStepCrust, InnerBalls, MedialAxis, AUnion>();
  registry.add_structure<APrecisionDifference, AUnion>();
  registry.add_structure<APowerDiagram, SettingsSource, Delaunay, Labels, InnerBalls>();
  registry.add_structure<AVDiagram, Delaunay, OneStepCrust, Labels, InnerBalls, AUnion>();
  registry.add_structure<VoronoiBallDiagram, SettingsSource, Delaunay, VoronoiVertices>();
  registry.add_structure<BUnion, SettingsSource, UserBalls>();
  registry.add_structure<BPrecisionDifference, BUnion>();
  registry.add_structure<BPowerDiagram, SettingsSource, UserBalls>();
  registry.add_structure<ABallSampling, SettingsSource, AUnion>();
  registry.add_structure<BBallSampling, SettingsSource, BUnion>();
  registry.add_structure<BVDiagram, BUnion>();
  registry.add_structure<ABallFiltration, SettingsSource, Delaunay, Labels, InnerBalls>();
  registry.add_structure<AGrownComplex, SettingsSource, ABallFiltration>();
  registry.add_structure<BBallFiltration, SettingsSource, UserBalls>();
  registry.add_structure<BGrownComplex, SettingsSource, BBallFiltration>();
  registry.add_structure<AxisSampling, SettingsSource, Delaunay, MedialAxis>();
  registry.add_structure<ScaleUnion, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis,
                         AxisSampling, AxisCertificate>();
  registry.add_structure<ScaleBallSampling, SettingsSource, ScaleUnion>();
  registry.add_structure<AScaleUnion, SettingsSource, AUnion>();
  registry.add_structure<AScaleSampling, SettingsSource, AScaleUnion>();
  registry.add_structure<ASkeletonUnion, SettingsSource, AUnion>();
  registry.add_structure<BScaleUnion, SettingsSource, BUnion>();
  registry.add_structure<BScaleSampling, SettingsSource, BScaleUnion>();
  registry.add_structure<BSkeletonUnion, SettingsSource, BUnion>();
  registry.add_structure<LambdaUnion, SettingsSource, Delaunay, Labels, InnerBalls, LambdaAxis>();
  registry.add_structure<AngleUnion, SettingsSource, Delaunay, Labels, InnerBalls, AngleAxis>();
  registry.add_structure<CoverUnion, SettingsSource, Delaunay, Labels, InnerBalls, CoverAxis>();
}

}  // namespace mes
