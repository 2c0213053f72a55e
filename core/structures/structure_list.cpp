// SPDX-License-Identifier: GPL-3.0-or-later
// The list of structures.
#include <memory>
#include <vector>

#include "core/graph/structure.h"
#include "core/structures/alpha/alpha_complex.h"
#include "core/structures/alpha/alpha_filtration.h"
#include "core/structures/axis/axis_nodes.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/axis_ball_union.h"
#include "core/structures/balls/axis_difference.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/ball_filtration.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/grown_complex.h"
#include "core/structures/balls/kept_union.h"
#include "core/structures/balls/precision_difference.h"
#include "core/structures/balls/scale_axis.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/crust/curve.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/delaunay/last_change.h"
#include "core/structures/density/curve_sampling.h"
#include "core/structures/density/feature_size.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/cover_dates.h"
#include "core/structures/filters/lambda_axis.h"
#include "core/structures/inputs/contours.h"
#include "core/structures/inputs/curve_source_input.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/inputs/scaled_user_balls.h"
#include "core/structures/inputs/settings_source.h"
#include "core/structures/inputs/shared_borders.h"
#include "core/structures/inputs/user_balls.h"
#include "core/structures/poles/polar_diagram.h"
#include "core/structures/poles/polar_union.h"
#include "core/structures/poles/pole_labels.h"
#include "core/structures/poles/poles.h"

namespace mes {
namespace {

/// Adds a structure whose constructor takes the given inputs, all of which are in the set already, unless a variant
/// shares it because it shares all of its inputs.
template <class S, class... Inputs>
void add(StructureSet& set) {
  if (sizeof...(Inputs) != 0 && set.is_variant() && !(set.holds(set.get<Inputs>()) || ...)) return;
  set.add(std::make_unique<S>(set.get<Inputs>()...));
}

}  // namespace

// One line a structure, inputs before consumers.
StructureSet make_structures(const StructureSet* shared, bool has_document) {
  StructureSet set(shared);
  const bool has_own = shared == nullptr || has_document;
  if (has_own) add<Samples>(set);
  add<SettingsSource>(set);
  if (has_own) add<UserBalls>(set);
  if (has_own) add<CurveSourceInput>(set);
  add<ScaledUserBalls, SettingsSource, UserBalls>(set);
  add<Contours, Samples>(set);
  add<SharedBorders, Samples>(set);
  add<Delaunay, Samples>(set);
  add<OneStepCrust, Delaunay, SharedBorders>(set);
  add<Labels, Delaunay, OneStepCrust>(set);
  add<Curve, Delaunay, OneStepCrust, Labels>(set);
  add<VoronoiVertices, Delaunay, OneStepCrust>(set);
  add<InnerBalls, Delaunay, VoronoiVertices, Labels>(set);
  add<Poles, Delaunay, VoronoiVertices>(set);
  add<MedialAxis, Delaunay, OneStepCrust, Labels, InnerBalls>(set);
  add<AxisNodes, Delaunay, InnerBalls, MedialAxis>(set);
  add<LambdaAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis>(set);
  add<AngleAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis>(set);
  add<CoverDates, Delaunay, InnerBalls>(set);
  add<CoverAxis, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis, CoverDates>(set);
  add<CurveSampling, CurveSourceInput, Samples, Delaunay, OneStepCrust>(set);
  add<FeatureSize, Delaunay, OneStepCrust, CurveSampling>(set);
  add<LastChange, Delaunay>(set);
  add<AlphaFiltration, Delaunay>(set);
  add<AlphaComplex, SettingsSource, Delaunay, AlphaFiltration>(set);
  add<AxisCertificate, Delaunay, Labels, InnerBalls>(set);
  add<AUnion, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis, AxisCertificate>(set);
  add<AxisDifference, Delaunay, OneStepCrust, InnerBalls, MedialAxis, AUnion>(set);
  add<APrecisionDifference, AUnion>(set);
  add<APowerDiagram, SettingsSource, Delaunay, Labels, InnerBalls>(set);
  add<AVDiagram, Delaunay, OneStepCrust, Labels, InnerBalls, AUnion>(set);
  add<PoleLabels, SettingsSource, Delaunay, VoronoiVertices, Labels, Poles>(set);
  add<PolarDiagram, SettingsSource, Delaunay, VoronoiVertices, Poles>(set);
  add<PowerCrust, PoleLabels, PolarDiagram>(set);
  add<VoronoiBallDiagram, SettingsSource, Delaunay, VoronoiVertices>(set);
  add<PUnion, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>(set);
  add<PPowerDiagram, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>(set);
  add<PVDiagram, PUnion>(set);
  add<PBallSampling, SettingsSource, PUnion>(set);
  add<BUnion, SettingsSource, UserBalls>(set);
  add<BPrecisionDifference, BUnion>(set);
  add<BPowerDiagram, SettingsSource, UserBalls>(set);
  add<ABallSampling, SettingsSource, AUnion>(set);
  add<BBallSampling, SettingsSource, BUnion>(set);
  add<BVDiagram, BUnion>(set);
  add<ABallFiltration, SettingsSource, Delaunay, Labels, InnerBalls>(set);
  add<AGrownComplex, SettingsSource, ABallFiltration>(set);
  add<PBallFiltration, SettingsSource, Delaunay, VoronoiVertices, Poles, PoleLabels>(set);
  add<PGrownComplex, SettingsSource, PBallFiltration>(set);
  add<BBallFiltration, SettingsSource, UserBalls>(set);
  add<BGrownComplex, SettingsSource, BBallFiltration>(set);
  add<AxisSampling, SettingsSource, Delaunay, MedialAxis>(set);
  add<ScaleUnion, SettingsSource, Delaunay, OneStepCrust, Labels, InnerBalls, MedialAxis, AxisSampling,
      AxisCertificate>(set);
  add<ScaleBallSampling, SettingsSource, ScaleUnion>(set);
  add<AScaleUnion, SettingsSource, AUnion>(set);
  add<AScaleSampling, SettingsSource, AScaleUnion>(set);
  add<ASkeletonUnion, SettingsSource, AUnion>(set);
  add<PScaleUnion, SettingsSource, PUnion>(set);
  add<PScaleSampling, SettingsSource, PScaleUnion>(set);
  add<PSkeletonUnion, SettingsSource, PUnion>(set);
  add<BScaleUnion, SettingsSource, BUnion>(set);
  add<BScaleSampling, SettingsSource, BScaleUnion>(set);
  add<BSkeletonUnion, SettingsSource, BUnion>(set);
  add<LambdaUnion, SettingsSource, Delaunay, Labels, InnerBalls, LambdaAxis>(set);
  add<AngleUnion, SettingsSource, Delaunay, Labels, InnerBalls, AngleAxis>(set);
  add<CoverUnion, SettingsSource, Delaunay, Labels, InnerBalls, CoverAxis>(set);
  return set;
}

std::span<const std::string_view> structure_ids() {
  static const std::vector<std::string_view> ids = [] {
    std::vector<std::string_view> out;
    const StructureSet set = make_structures();
    for (const auto& structure : set.all()) out.push_back(structure->id());
    return out;
  }();
  return ids;
}

}  // namespace mes
